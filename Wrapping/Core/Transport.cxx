// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells whose sites are centroids, and cells of prescribed areas.
#include "Calls.h"
#include "Results.h"
#include "Views.h"

#include <flipflop/CentroidalCells.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/PrescribedAreas.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

/// What is given, or else the box.
ConvexDomain domainOr(const std::optional<DomainArray>& given, const std::array<double, 4>& box)
{
  return given ? domainOf(*given) : ConvexDomain(box.data());
}

Handle<CentroidalCells> centered(const InputArray& points, const std::optional<InputArray>& weights,
  const std::optional<DomainArray>& domain, std::int64_t iterations, double tolerance,
  const Settings& settings)
{
  const PointView positions = pointView(points, 2);
  const WeightView weighted = weightView(weights);
  const std::array<double, 4> box = powerDiagramBox(positions);
  const ConvexDomain within = domainOr(domain, box);
  return handleOf(settings.run([&](const Options& options)
    { return centroidalCells(positions, weighted, within, iterations, tolerance, options); }));
}

Handle<PrescribedAreas> fitted(const InputArray& points, const std::optional<InputArray>& areas,
  const std::optional<DomainArray>& domain, double tolerance, std::int64_t iterations,
  const Settings& settings)
{
  const PointView positions = pointView(points, 2);
  const WeightView shares = weightView(areas);
  const std::array<double, 4> box = powerDiagramBox(positions);
  const ConvexDomain within = domainOr(domain, box);
  return handleOf(settings.run([&](const Options& options)
    { return prescribedAreas(positions, shares, within, tolerance, iterations, options); }));
}

/// Rows of x and y.
template <class Owner>
auto rowsOf(const Buffer<double>& buffer, const std::shared_ptr<const Owner>& owner)
{
  return arrayOf(buffer.data(), { buffer.size() / 2, 2 }, owner);
}

}

void bindTransport(nb::module_& module)
{
  using Centered = const Handle<CentroidalCells>&;
  nb::class_<Handle<CentroidalCells>>(module, "CentroidalCells")
    .def("sites", [](Centered self) { return rowsOf(self.result->sites, self.result); })
    .def("areas", [](Centered self) { return arrayOf(self.result->areas, self.result); })
    .def("centroids", [](Centered self) { return rowsOf(self.result->centroids, self.result); })
    .def("cells",
      [](Centered self)
      {
        return Handle<PowerDiagram>{ std::shared_ptr<const PowerDiagram>(
          self.result, &self.result->cells) };
      })
    .def_prop_ro("iterations", [](Centered self) { return self.result->iterations; })
    .def_prop_ro("last_move", [](Centered self) { return self.result->lastMove; })
    .def_prop_ro("converged", [](Centered self) { return self.result->converged; })
    .def_prop_ro("without_cell", [](Centered self) { return self.result->withoutCell; })
    .def_prop_ro("statistics", [](Centered self) { return dictOf(self.result->statistics); });

  using Fitted = const Handle<PrescribedAreas>&;
  nb::class_<Handle<PrescribedAreas>>(module, "PrescribedAreas")
    .def("weights", [](Fitted self) { return arrayOf(self.result->weights, self.result); })
    .def("areas", [](Fitted self) { return arrayOf(self.result->areas, self.result); })
    .def("centroids", [](Fitted self) { return rowsOf(self.result->centroids, self.result); })
    .def_prop_ro("iterations", [](Fitted self) { return self.result->iterations; })
    .def_prop_ro("error", [](Fitted self) { return self.result->error; })
    .def_prop_ro("converged", [](Fitted self) { return self.result->converged; })
    .def_prop_ro("statistics",
      [](Fitted self)
      {
        nb::dict found = dictOf(self.result->statistics);
        found["secondsTriangulating"] = self.result->secondsTriangulating;
        found["secondsMeasuring"] = self.result->secondsMeasuring;
        found["secondsSolving"] = self.result->secondsSolving;
        return found;
      });

  module.def("centroidal_cells", &centered, "points"_a, "weights"_a.none(), "domain"_a.none(),
    "iterations"_a, "tolerance"_a, "settings"_a);
  module.def("prescribed_areas", &fitted, "points"_a, "areas"_a.none(), "domain"_a.none(),
    "tolerance"_a, "iterations"_a, "settings"_a);
}

}
