// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The extension vtkflipflop._core: the engine's calls for NumPy's arrays. What users see is
/// Package/arrays.py.
#include "Calls.h"
#include "Results.h"
#include "State.h"
#include "Views.h"

#include "../../Filters/FFErrorTexts.h"
#include <flipflop/Batch.h>
#include <flipflop/Convexify.h>
#include <flipflop/Engines.h>
#include <flipflop/FurthestSite.h>
#include <flipflop/PlaneFit.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/SurfacePolygons.h>
#include <flipflop/Validate.h>
#include <flipflop/Weights.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

using PlaneArray = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using Corners = nb::ndarray<const std::int64_t, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

Handle<Hull> hullOf(const InputArray& points, const Settings& settings)
{
  const SpacePoints input(points);
  return handleOf(settings.run([&](const Options& options)
    { return convexHull(input.view(), options, settings.engineOptions(), settings.report); }));
}

Handle<Triangulation> triangulationOf(
  const InputArray& points, const std::optional<InputArray>& weights, const Settings& settings)
{
  PointView positions = pointView(points, 2);
  WeightView weighted = weightView(weights);
  positions.deviceData = deviceMemory(settings.pointsMemory);
  weighted.deviceData = deviceMemory(settings.weightsMemory);
  return handleOf(settings.run(
    [&](const Options& options)
    {
      return regularTriangulation(
        positions, weighted, options, settings.engineOptions(), settings.report);
    }));
}

Handle<Hull> convexified(const InputArray& points, const Corners& triangles,
  const std::optional<std::array<double, 3>>& kernel, const Settings& settings)
{
  const PointView positions = pointView(points, 3);
  TriangleView surface;
  surface.corners = triangles.data();
  surface.count = static_cast<std::int64_t>(triangles.shape(0));
  return handleOf(settings.run([&](const Options& options)
    { return convexify(positions, surface, kernel ? kernel->data() : nullptr, options); }));
}

/// Polygons as triangles: the corners of these, and the polygon of each.
nb::tuple trianglesOf(const InputArray& points, const IdArray& offsets, const IdArray& corners,
  const Settings& settings)
{
  const SpacePoints input(points);
  PolygonView polygons;
  polygons.corners = corners.data();
  polygons.offsets = offsets.data();
  polygons.count = std::max<std::int64_t>(0, static_cast<std::int64_t>(offsets.shape(0)) - 1);
  // Offsets that leave the corners would be read where there is nothing.
  const auto size = static_cast<std::int64_t>(corners.shape(0));
  if (polygons.count > 0 && offsets.data()[polygons.count] > size)
  {
    throw badArgument(
      "the last offset must not exceed the number of corners", -1, offsets.data()[polygons.count]);
  }
  PolygonTriangles found = settings.run(
    [&](const Options& options) { return triangulatePolygons(input.view(), polygons, options); });
  const std::size_t rows = found.polygonIds.size();
  return nb::make_tuple(
    arrayOf(std::move(found.corners), { rows, 3 }), arrayOf(std::move(found.polygonIds)));
}

/// The plane that fits points best, and their positions in it.
nb::tuple positionsInBestPlane(const InputArray& points, const Settings& settings)
{
  const SpacePoints input(points);
  FittedPlane plane;
  Buffer<double> positions = settings.run(
    [&](const Options& options)
    {
      plane = fitPlane(input.view(), options);
      return positionsInPlane(input.view(), plane, options);
    });
  const std::size_t rows = positions.size() / 2;
  return nb::make_tuple(plane, arrayOf(std::move(positions), { rows, 2 }));
}

/// The positions of other points in a plane.
OutputArray<double> positionsInThatPlane(
  const FittedPlane& plane, const InputArray& points, const Settings& settings)
{
  const SpacePoints input(points);
  Buffer<double> positions = settings.run(
    [&](const Options& options) { return positionsInPlane(input.view(), plane, options); });
  const std::size_t rows = positions.size() / 2;
  return arrayOf(std::move(positions), { rows, 2 });
}

/// The positions in space of positions in a plane.
OutputArray<double> positionsInSpace(const FittedPlane& plane, const PlaneArray& inPlane)
{
  const std::size_t rows = inPlane.shape(0);
  Buffer<double> positions(3 * rows);
  for (std::size_t i = 0; i < rows; ++i)
  {
    const auto position = positionOf(plane, inPlane(i, 0), inPlane(i, 1));
    std::copy(position.begin(), position.end(), positions.data() + 3 * i);
  }
  return arrayOf(std::move(positions), { rows, 3 });
}

/// The positions of points by x and y; None if they can be read where they are.
std::optional<OutputArray<double>> positionsByXY(const InputArray& points, const Settings& settings)
{
  const PointView view = pointView(points, 3);
  Buffer<double> positions =
    settings.run([&](const Options& options) { return positionsInXY(view, options); });
  if (positions.empty())
  {
    return std::nullopt;
  }
  const std::size_t rows = positions.size() / 2;
  return arrayOf(std::move(positions), { rows, 2 });
}

/// The weights that the rule makes of numbers; None if these are the weights.
std::optional<OutputArray<double>> weightsByRule(
  const InputArray& numbers, bool areRadii, double factor)
{
  const WeightRule rule{ areRadii, factor };
  if (rule.isIdentity())
  {
    return std::nullopt;
  }
  const WeightView view = weightView(numbers);
  Buffer<double> weights;
  {
    const nb::gil_scoped_release free;
    weights = computeWeights(view, rule);
  }
  return arrayOf(std::move(weights));
}

Handle<PowerDiagram> diagramOf(const InputArray& points, const std::optional<InputArray>& weights,
  const Handle<Triangulation>& triangulation, const std::optional<DomainArray>& domain,
  const Settings& settings)
{
  const PointView positions = pointView(points, 2);
  const WeightView weighted = weightView(weights);
  const Triangulation& facets = *triangulation.result;
  if (!domain && facets.dimension < 0)
  {
    return handleOf(PowerDiagram()); // no point has a box
  }
  std::array<double, 4> box{};
  if (!domain)
  {
    box = powerDiagramBox(positions, facets);
  }
  const ConvexDomain within = domain ? domainOf(*domain) : ConvexDomain(box.data());
  return handleOf(settings.run([&](const Options& options)
    { return powerDiagram(positions, weighted, facets, within, options); }));
}

/// @throw nb::value_error if that is no state of a diagram
PowerDiagram restoredDiagram(const std::tuple<Figures, IdArray, IdArray, IdArray>& state)
{
  const auto& [corners, connectivity, offsets, sites] = state;
  const auto copyOf = [](const auto& from, auto& to)
  {
    to.allocate(from.shape(0));
    std::copy_n(from.data(), to.size(), to.begin());
  };
  PowerDiagram diagram;
  copyOf(corners, diagram.corners);
  copyOf(connectivity, diagram.connectivity);
  copyOf(offsets, diagram.offsets);
  copyOf(sites, diagram.siteIds);
  const auto positions = static_cast<std::int64_t>(diagram.corners.size() / 2);
  const auto corner = diagram.connectivity.size();
  const Buffer<std::int64_t>& begins = diagram.offsets;
  const bool isSound = std::all_of(diagram.connectivity.begin(), diagram.connectivity.end(),
                         [positions](std::int64_t i) { return i >= 0 && i < positions; }) &&
    (begins.empty() ? corner == 0 && diagram.siteIds.empty()
                    : begins.size() == diagram.siteIds.size() + 1 && begins[0] == 0 &&
          begins[begins.size() - 1] == static_cast<std::int64_t>(corner) &&
          std::is_sorted(begins.begin(), begins.end()));
  if (!isSound)
  {
    throw nb::value_error("this is no state of a power diagram of this version");
  }
  return diagram;
}

/// Many results that Python takes out one by one.
template <class Result>
struct Results
{
  std::shared_ptr<const Batch<Result>> batch;
};

template <class Result>
Results<Result> resultsOf(Batch<Result>&& batch)
{
  return { std::make_shared<const Batch<Result>>(std::move(batch)) };
}

SetView setView(const IdArray& offsets)
{
  SetView sets;
  sets.offsets = offsets.data();
  sets.count = std::max<std::int64_t>(0, static_cast<std::int64_t>(offsets.shape(0)) - 1);
  return sets;
}

template <class Result>
nb::class_<Results<Result>> bindResults(nb::module_& module, const char* name)
{
  using Self = const Results<Result>&;
  return nb::class_<Results<Result>>(module, name)
    .def("__len__", [](Self self) { return self.batch->results.size(); })
    .def("__getitem__",
      [](Self self, std::size_t set)
      {
        if (set >= self.batch->results.size())
        {
          throw nb::index_error();
        }
        return Handle<Result>{ std::shared_ptr<const Result>(
          self.batch, &self.batch->results[set]) };
      })
    .def("__getstate__",
      [](Self self)
      {
        const std::vector<Result>& results = self.batch->results;
        return stateOf(results.size(), [&](std::size_t i) -> const Result& { return results[i]; });
      })
    // Without the errors, which Python keeps.
    .def("__setstate__",
      [](Results<Result>& self, const State& state)
      {
        Batch<Result> batch;
        batch.results = restoredResults<Result>(state);
        new (&self) Results<Result>(resultsOf(std::move(batch)));
      })
    .def("errors",
      [](Self self)
      {
        nb::list found;
        for (const SetError& error : self.batch->errors)
        {
          found.append(nb::make_tuple(error.set, static_cast<int>(error.error.code()),
            error.error.what(), error.error.index(), error.error.count()));
        }
        return found;
      });
}

/// An array with one value for each set.
template <class Result, class Get>
auto eachResult(const Results<Result>& self, const Get& get)
{
  const std::vector<Result>& results = self.batch->results;
  Buffer<std::decay_t<decltype(get(results[0]))>> values(results.size());
  std::transform(results.begin(), results.end(), values.begin(), get);
  return arrayOf(std::move(values), { results.size() });
}

/// Raises what that function of _errors.py makes.
template <class... Arguments>
void raise(const char* maker, Arguments... arguments)
{
  const nb::object made = nb::module_::import_("vtkflipflop._errors").attr(maker)(arguments...);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
}

/// An array of another library's, in any memory, as DLPack tells of it.
struct DeviceArray
{
  explicit DeviceArray(nb::ndarray<nb::ro> given)
    : array(std::move(given))
  {
  }
  nb::ndarray<nb::ro> array;
};

/// A tuple with one value for each axis.
template <class Get>
nb::tuple eachAxis(const nb::ndarray<nb::ro>& array, const Get& get)
{
  nb::list values;
  for (std::size_t axis = 0; axis < array.ndim(); ++axis)
  {
    values.append(get(axis));
  }
  return nb::tuple(values);
}

/// NumPy's letter for a kind of numbers.
const char* kindOf(nb::dlpack::dtype type)
{
  switch (static_cast<nb::dlpack::dtype_code>(type.code))
  {
    case nb::dlpack::dtype_code::Float:
      return "f";
    case nb::dlpack::dtype_code::Int:
      return "i";
    case nb::dlpack::dtype_code::UInt:
      return "u";
    case nb::dlpack::dtype_code::Bool:
      return "b";
    case nb::dlpack::dtype_code::Complex:
      return "c";
    default:
      return "V"; // of no type that NumPy has
  }
}

}

}

NB_MODULE(_core, module)
{
  using namespace flipflop;

  nb::set_leak_warnings(false); // at exit, users' globals may still hold results
  nb::register_exception_translator(
    [](const std::exception_ptr& thrown, void*)
    {
      try
      {
        std::rethrow_exception(thrown);
      }
      catch (const BadWeight& error)
      {
        raise("at_points", error.what(), "bad_argument", error.index(), error.count());
      }
      catch (const Error& error)
      {
        raise(
          "of_engine", static_cast<int>(error.code()), error.what(), error.index(), error.count());
      }
    });

  nb::class_<Settings>(module, "Settings")
    .def(
      "__init__",
      [](Settings* self, int threads, bool polygons, bool ignore, int engine, nb::object progress)
      {
        new (self) Settings;
        self->threads = threads;
        self->polygons = polygons;
        self->ignoreNonFinite = ignore;
        self->engine = engine;
        self->progress = std::move(progress);
      },
      "threads"_a, "polygons"_a, "ignore_non_finite"_a, "engine"_a, "progress"_a.none())
    .def_rw("cuda_from", &Settings::cudaFrom)
    .def_rw("v_biased", &Settings::vBiased)
    .def_prop_ro(
      "engine_used", [](const Settings& self) { return static_cast<int>(self.report.used); })
    .def_prop_ro("engine_reason", [](const Settings& self) { return self.report.reason; })
    .def_rw("points_memory", &Settings::pointsMemory)
    .def_rw("weights_memory", &Settings::weightsMemory);

  auto hullClass = bindCells<Hull>(module, "Hull");
  bindState(hullClass);
  hullClass.def_prop_ro("volume", [](const Handle<Hull>& self) { return self.result->volume; })
    .def_prop_ro("area", [](const Handle<Hull>& self) { return self.result->area; });
  auto triangulationClass = bindCells<Triangulation>(module, "Triangulation");
  bindState(triangulationClass);
  triangulationClass.def("hidden",
    [](const Handle<Triangulation>& self) { return arrayOf(self.result->hiddenIds, self.result); });
  nb::class_<Handle<PowerDiagram>>(module, "PowerDiagram")
    .def("vertices",
      [](const Handle<PowerDiagram>& self)
      {
        const Buffer<double>& corners = self.result->corners;
        return arrayOf(corners.data(), { corners.size() / 2, 2 }, self.result);
      })
    .def("connectivity",
      [](const Handle<PowerDiagram>& self)
      { return arrayOf(self.result->connectivity, self.result); })
    .def("offsets",
      [](const Handle<PowerDiagram>& self)
      {
        static const std::int64_t nothing = 0;
        const Buffer<std::int64_t>& offsets = self.result->offsets;
        return offsets.empty() ? arrayOf(&nothing, { 1 }, self.result)
                               : arrayOf(offsets, self.result);
      })
    .def("sites",
      [](const Handle<PowerDiagram>& self) { return arrayOf(self.result->siteIds, self.result); })
    .def("__getstate__",
      [](const Handle<PowerDiagram>& self)
      {
        const PowerDiagram& diagram = *self.result;
        return nb::make_tuple(arrayOf(diagram.corners, self.result),
          arrayOf(diagram.connectivity, self.result), arrayOf(diagram.offsets, self.result),
          arrayOf(diagram.siteIds, self.result));
      })
    .def("__setstate__",
      [](Handle<PowerDiagram>& self, const std::tuple<Figures, IdArray, IdArray, IdArray>& state)
      { new (&self) Handle<PowerDiagram>(handleOf(restoredDiagram(state))); });
  bindResults<Hull>(module, "Hulls")
    .def("volumes",
      [](const Results<Hull>& self)
      { return eachResult(self, [](const Hull& hull) { return hull.volume; }); })
    .def("areas",
      [](const Results<Hull>& self)
      { return eachResult(self, [](const Hull& hull) { return hull.area; }); });
  bindResults<Triangulation>(module, "Triangulations");

  bindQueries(module);
  bindComplexes(module);
  bindTerrain(module);
  bindRefine(module);
  bindHalfSpaces(module);
  bindEdits(module);
  bindStream(module);
  bindTransport(module);

  module.def("convex_hull", &hullOf);
  module.def(
    "regular_triangulation", &triangulationOf, "points"_a, "weights"_a.none(), "settings"_a);
  module.def("furthest_site_triangulation",
    [](const InputArray& points, const Settings& settings)
    {
      const PointView positions = pointView(points, 2);
      return handleOf(settings.run(
        [&](const Options& options) { return furthestSiteTriangulation(positions, options); }));
    });
  module.def("convexify", &convexified, "points"_a, "triangles"_a, "kernel"_a.none(), "settings"_a);
  module.def("triangulate_polygons", &trianglesOf);
  nb::class_<FittedPlane>(module, "FittedPlane")
    .def("positions", &positionsInSpace)
    .def("projected", &positionsInThatPlane)
    .def_prop_ro(
      "axes", [](const FittedPlane& self) { return nb::make_tuple(self.first, self.second); });
  module.def("to_best_fitting_plane", &positionsInBestPlane);
  module.def("to_xy_plane", &positionsByXY);
  module.def("height_below",
    [](const InputArray& points, const Handle<Triangulation>& triangulation)
    { return heightBelow(pointView(points, 3), *triangulation.result); });
  module.def("compute_weights", &weightsByRule);
  module.def("triangulation_box",
    [](const InputArray& points, const Handle<Triangulation>& triangulation)
    { return powerDiagramBox(pointView(points, 2), *triangulation.result); });
  module.def("power_diagram", &diagramOf, "points"_a, "weights"_a.none(), "triangulation"_a,
    "domain"_a.none(), "settings"_a);

  module.def("convex_hulls",
    [](const InputArray& points, const IdArray& offsets, const Settings& settings)
    {
      const SpacePoints input(points);
      return resultsOf(settings.run([&](const Options& options)
        { return convexHulls(input.view(), setView(offsets), options); }));
    });
  module.def(
    "regular_triangulations",
    [](const InputArray& points, const IdArray& offsets, const std::optional<InputArray>& weights,
      const Settings& settings)
    {
      const PointView positions = pointView(points, 2);
      const WeightView weighted = weightView(weights);
      return resultsOf(settings.run([&](const Options& options)
        { return regularTriangulations(positions, setView(offsets), weighted, options); }));
    },
    "points"_a, "offsets"_a, "weights"_a.none(), "settings"_a);

  module.def("validate_hull",
    [](const InputArray& points, const Handle<Hull>& hull, int threads)
    {
      const SpacePoints input(points);
      return checkedBy([&] { return validate(input.view(), *hull.result, threads); });
    });
  module.def(
    "validate_triangulation",
    [](const InputArray& points, const std::optional<InputArray>& weights,
      const Handle<Triangulation>& triangulation, int threads)
    {
      const PointView positions = pointView(points, 2);
      const WeightView weighted = weightView(weights);
      return checkedBy(
        [&] { return validate(positions, weighted, *triangulation.result, threads); });
    },
    "points"_a, "weights"_a.none(), "triangulation"_a, "threads"_a);

  nb::class_<DeviceArray>(module, "DeviceArray")
    .def(nb::init<nb::ndarray<nb::ro>>())
    .def_prop_ro("pointer",
      [](const DeviceArray& self) { return reinterpret_cast<std::uintptr_t>(self.array.data()); })
    .def_prop_ro("shape",
      [](const DeviceArray& self)
      { return eachAxis(self.array, [&](std::size_t axis) { return self.array.shape(axis); }); })
    .def_prop_ro("strides",
      [](const DeviceArray& self)
      { return eachAxis(self.array, [&](std::size_t axis) { return self.array.stride(axis); }); })
    .def_prop_ro("kind", [](const DeviceArray& self) { return kindOf(self.array.dtype()); })
    .def_prop_ro("size", [](const DeviceArray& self) { return self.array.itemsize(); });
  module.def("copy_from_device",
    [](std::uintptr_t address, std::size_t bytes)
    {
      Buffer<std::uint8_t> copy(bytes);
      {
        const nb::gil_scoped_release free;
        copyFromDevice(copy.data(), deviceMemory(address), bytes);
      }
      return arrayOf(std::move(copy));
    });
  // Of an error's code: what filters say of it, and the kind.
  module.def("require_memory", [](std::size_t bytes) { Buffer<char> some(bytes); });
  module.def("filter_errors",
    []
    {
      nb::list found;
      for (const FFErrorText& text : FFErrorTexts)
      {
        found.append(
          nb::make_tuple(static_cast<int>(text.Code), text.Text, static_cast<int>(text.Kind)));
      }
      return found;
    });
  module.def("cuda_status",
    []
    {
      const CudaStatus& status = cudaStatus();
      return nb::make_tuple(status.built, status.present, status.device, status.problem);
    });
}
