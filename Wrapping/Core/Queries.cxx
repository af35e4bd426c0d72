// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Queries of results, at positions.
#include "Calls.h"
#include "Constrained.h"
#include "Results.h"
#include "State.h"
#include "Views.h"

#include <flipflop/Certificate.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/HullQueries.h>
#include <flipflop/Measures.h>
#include <flipflop/TriangulationQueries.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

/// Questions to a triangulation, which knows how many points it was given.
struct Sites
{
  TriangulationQueries queries;
  std::int64_t points;
};

using Values =
  nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>; ///< a row for each point

/// One result for each position.
template <class T, class Query>
auto resultsOf(const PointView& positions, const Settings& settings, const Query& query)
{
  Buffer<T> found(static_cast<std::size_t>(positions.count));
  settings.run(
    [&](const Options& options)
    {
      query(positions, found.data(), options);
      return 0;
    });
  return arrayOf(std::move(found));
}

/// Values between the points' values.
template <class Query>
auto interpolated(const Values& values, const InputArray& positions, std::int64_t points,
  const Settings& settings, const Query& query)
{
  const PointView view = pointView(positions, 2);
  const std::size_t components = values.shape(1);
  if (static_cast<std::int64_t>(values.shape(0)) != points)
  {
    throw nb::value_error("there are not as many values as points");
  }
  Buffer<double> found(static_cast<std::size_t>(view.count) * components);
  settings.run(
    [&](const Options& options)
    {
      query(values.data(), static_cast<std::int64_t>(components), view, found.data(), options);
      return 0;
    });
  return arrayOf(std::move(found), { static_cast<std::size_t>(view.count), components });
}

/// Values at the pixels of an image: of shape (rows, columns, components).
/// @param grid  x and y of the pixel (0, 0), and from a column and from a row to the next
/// @param first the column and the row of the first pixel
template <class T>
auto imageOf(const Sites& self, Interpolation method, const Values& values,
  const std::array<double, 4>& grid, const std::array<std::int64_t, 2>& first, std::int64_t rows,
  std::int64_t columns, double fill, const Settings& settings)
{
  if (static_cast<std::int64_t>(values.shape(0)) != self.points)
  {
    throw nb::value_error("there are not as many values as points");
  }
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  const auto components = static_cast<std::int64_t>(values.shape(1));
  if (rows < 1 || columns < 1 || components < 1 ||
    columns > most / static_cast<std::int64_t>(sizeof(T)) / components / rows)
  {
    throw Error(ErrorCode::OutOfMemory, -1, most);
  }
  Buffer<T> found(static_cast<std::size_t>(rows * columns * components));
  settings.run(
    [&](const Options& options)
    {
      const ImageGrid pixels{ { grid[0], grid[1] }, { grid[2], grid[3] }, { columns, rows },
        { first[0], first[1] } };
      self.queries.interpolateImage(
        method, values.data(), components, pixels, ImageView(found.data()), fill, options);
      return 0;
    });
  return nb::cast(arrayOf(std::move(found),
    { static_cast<std::size_t>(rows), static_cast<std::size_t>(columns), values.shape(1) }));
}

/// Areas and centroids, by a call that writes them.
template <class Measure>
nb::tuple measured(std::int64_t cells, const Measure& measure)
{
  Buffer<double> areas(static_cast<std::size_t>(cells));
  Buffer<double> centroids(2 * areas.size());
  {
    const nb::gil_scoped_release free;
    measure(areas.data(), centroids.data());
  }
  const std::size_t size = areas.size();
  return nb::make_tuple(
    arrayOf(std::move(areas), { size }), arrayOf(std::move(centroids), { size, 2 }));
}

Interpolation methodOf(const std::string& name)
{
  return name == "natural"    ? Interpolation::Natural
    : name == "laplace"       ? Interpolation::Laplace
    : name == "clough-tocher" ? Interpolation::CloughTocher
                              : Interpolation::Linear;
}

/// Where the shares of each position begin, and their ids and numbers.
nb::tuple sharesOf(const Sites& self, const std::string& method, const InputArray& positions,
  const Settings& settings)
{
  const PointView view = pointView(positions, 2);
  SiteShares found = settings.run(
    [&](const Options& options) { return self.queries.shares(methodOf(method), view, options); });
  return nb::make_tuple(arrayOf(std::move(found.offsets)), arrayOf(std::move(found.ids)),
    arrayOf(std::move(found.shares)));
}

/// By x and by y for each point and component; NaN of hidden points.
auto gradientsOf(const Sites& self, const Values& values, const Settings& settings)
{
  const std::size_t components = values.shape(1);
  if (static_cast<std::int64_t>(values.shape(0)) != self.points)
  {
    throw nb::value_error("there are not as many values as points");
  }
  Buffer<double> found(2 * values.shape(0) * components);
  std::fill(found.begin(), found.end(), std::numeric_limits<double>::quiet_NaN());
  if (components > 0)
  {
    settings.run(
      [&](const Options& options)
      {
        self.queries.siteGradients(
          values.data(), static_cast<std::int64_t>(components), found.data(), options);
        return 0;
      });
  }
  return arrayOf(std::move(found), { values.shape(0), components, 2 });
}

/// Which cells of the whole are inside; both are in one order.
Buffer<std::uint8_t> insideOf(const CellComplex& whole, const CellComplex& inside)
{
  Buffer<std::uint8_t> mask(static_cast<std::size_t>(whole.cellCount()));
  std::int64_t next = 0;
  for (std::int64_t c = 0; c < whole.cellCount(); ++c)
  {
    const auto corners = [](const CellComplex& cells, std::int64_t cell)
    { return cells.connectivity.begin() + cells.cellBegin(cell); };
    const bool same = next < inside.cellCount() &&
      std::equal(
        corners(whole, c), corners(whole, c + 1), corners(inside, next), corners(inside, next + 1));
    mask[static_cast<std::size_t>(c)] = same ? 1 : 0;
    next += same ? 1 : 0;
  }
  if (next != inside.cellCount())
  {
    throw nb::value_error("the cells inside are not of the whole");
  }
  return mask;
}

/// @param cells some of the triangulation's, in their order; none: all of them
Sites sitesOf(const InputArray& points, const std::optional<InputArray>& weights,
  const Handle<Triangulation>& triangulation, const Settings& settings,
  const std::optional<Handle<Triangulation>>& cells)
{
  const PointView positions = pointView(points, 2);
  const WeightView weighted = weightView(weights);
  const Triangulation& whole = *triangulation.result;
  return settings.run(
    [&](const Options& options)
    {
      const Buffer<std::uint8_t> mask =
        cells ? insideOf(whole, *cells->result) : Buffer<std::uint8_t>();
      return Sites{ TriangulationQueries(
                      positions, weighted, whole, cells ? mask.data() : nullptr, options),
        positions.count };
    });
}

/// Questions to what is inside, whose cells are numbered as triangles.
/// @param cells some of these triangles, in their order; none: all of them
Sites constrainedSites(const InputArray& points, const Constrained& triangulation,
  const Settings& settings, const std::optional<Handle<Triangulation>>& cells)
{
  const PointView sites = pointView(points, 2);
  const bool areTriangles =
    triangulation.whole->dimension < 2 || triangulation.whole->cellSize == 3;
  std::shared_ptr<const ConstrainedTriangulation> whole = triangulation.whole;
  Handle<Triangulation> inside = cells ? *cells : triangulation.inside;
  if (!areTriangles)
  {
    auto fans = std::make_shared<ConstrainedTriangulation>(fansOf(*whole));
    fans->fixedEdges = copyOf(whole->fixedEdges);
    whole = std::move(fans);
    inside = cells ? inside : handleOf(fansOf(*inside.result));
  }
  return settings.run(
    [&](const Options& options)
    {
      const Buffer<std::uint8_t> mask = insideOf(*whole, *inside.result);
      return Sites{ TriangulationQueries(sites, *whole, mask.data(), options), sites.count };
    });
}

}

void bindQueries(nb::module_& module)
{
  nb::class_<HullQueries>(module, "HullQueries")
    .def("contains",
      [](const HullQueries& self, const InputArray& positions, const Settings& settings)
      {
        return resultsOf<std::int8_t>(SpacePoints(positions).view(), settings,
          [&](const PointView& view, std::int8_t* found, const Options& options)
          { self.contains(view, found, options); });
      })
    .def("distance",
      [](const HullQueries& self, const InputArray& positions, const Settings& settings)
      {
        return resultsOf<double>(SpacePoints(positions).view(), settings,
          [&](const PointView& view, double* found, const Options& options)
          { self.distance(view, found, options); });
      })
    .def("support",
      [](const HullQueries& self, const InputArray& directions, const Settings& settings)
      {
        return resultsOf<std::int64_t>(SpacePoints(directions).view(), settings,
          [&](const PointView& view, std::int64_t* found, const Options& options)
          { self.support(view, found, options); });
      })
    .def("diameter",
      [](const HullQueries& self, const Settings& settings)
      {
        const Diameter found =
          settings.run([&](const Options& options) { return self.diameter(options); });
        return nb::make_tuple(found.first, found.second, found.length);
      })
    .def("minimal_box",
      [](const HullQueries& self, const Settings& settings)
      {
        const OrientedBox box =
          settings.run([&](const Options& options) { return self.minimalBox(options); });
        Buffer<double> positions(15); // the center, the axes, the lengths
        std::copy_n(box.center, 3, positions.data());
        std::copy_n(box.axes[0], 9, positions.data() + 3);
        std::copy_n(box.lengths, 3, positions.data() + 12);
        return nb::make_tuple(arrayOf(std::move(positions)), box.volume, box.lowerBound);
      });
  module.def("hull_queries",
    [](const InputArray& points, const Handle<Hull>& hull, const Settings& settings)
    {
      const SpacePoints input(points);
      const PointSpace space = points.shape(1) == 2 ? PointSpace::Plane : PointSpace::Space;
      return settings.run([&](const Options& options)
        { return HullQueries(input.view(), *hull.result, options, space); });
    });
  module.def("facet_planes",
    [](const InputArray& points, const Handle<Hull>& hull, const Settings& settings)
    {
      const SpacePoints input(points);
      Buffer<double> planes = settings.run(
        [&](const Options& options) { return facetPlanes(input.view(), *hull.result, options); });
      const std::size_t rows = planes.size() / 4;
      return arrayOf(std::move(planes), { rows, 4 });
    });

  // The same of facets that are given by their corners.
  module.def("planes_of_facets",
    [](const InputArray& points, const IdArray& offsets, const IdArray& corners)
    {
      const SpacePoints input(points);
      const auto copyOf = [](const IdArray& from, Buffer<std::int64_t>& to)
      {
        to.allocate(from.shape(0));
        std::copy_n(from.data(), to.size(), to.begin());
      };
      Hull hull;
      hull.dimension = 3;
      hull.pointIds.allocate(static_cast<std::size_t>(input.view().count));
      std::iota(hull.pointIds.begin(), hull.pointIds.end(), std::int64_t(0));
      copyOf(corners, hull.connectivity);
      copyOf(offsets, hull.offsets);
      if (!isSound(hull))
      {
        throw nb::value_error("these are no facets of the points");
      }
      Buffer<double> planes = facetPlanes(input.view(), hull);
      const std::size_t rows = planes.size() / 4;
      return arrayOf(std::move(planes), { rows, 4 });
    });

  module.def("hull_certificate",
    [](const InputArray& points, const Handle<Hull>& hull, const Settings& settings)
    {
      const SpacePoints input(points);
      Certificate found = settings.run(
        [&](const Options& options) { return certificate(input.view(), *hull.result, options); });
      const std::size_t rows = found.apex.size() / 3;
      return nb::make_tuple(
        arrayOf(std::move(found.cells)), arrayOf(std::move(found.apex), { rows, 3 }));
    });

  nb::class_<Sites>(module, "TriangulationQueries")
    .def("locate",
      [](const Sites& self, const InputArray& positions, const Settings& settings)
      {
        return resultsOf<std::int64_t>(pointView(positions, 2), settings,
          [&](const PointView& view, std::int64_t* found, const Options& options)
          { self.queries.locate(view, found, options); });
      })
    .def("nearest",
      [](const Sites& self, const InputArray& positions, const Settings& settings)
      {
        return resultsOf<std::int64_t>(pointView(positions, 2), settings,
          [&](const PointView& view, std::int64_t* found, const Options& options)
          { self.queries.nearest(view, found, options); });
      })
    .def("interpolate_linear",
      [](const Sites& self, const Values& values, const InputArray& positions,
        const Settings& settings)
      {
        return interpolated(values, positions, self.points, settings,
          [&](auto... arguments) { self.queries.interpolateLinear(arguments...); });
      })
    .def("interpolate_natural",
      [](const Sites& self, const Values& values, const InputArray& positions,
        const Settings& settings)
      {
        return interpolated(values, positions, self.points, settings,
          [&](auto... arguments) { self.queries.interpolateNatural(arguments...); });
      })
    .def("interpolate_laplace",
      [](const Sites& self, const Values& values, const InputArray& positions,
        const Settings& settings)
      {
        return interpolated(values, positions, self.points, settings,
          [&](auto... arguments) { self.queries.interpolateLaplace(arguments...); });
      })
    .def("shares", &sharesOf)
    .def("gradients", &gradientsOf)
    .def("interpolate_clough_tocher",
      [](const Sites& self, const Values& values, const InputArray& positions,
        const Settings& settings)
      {
        return interpolated(values, positions, self.points, settings,
          [&](auto... arguments) { self.queries.interpolateCloughTocher(arguments...); });
      })
    .def(
      "image",
      [](const Sites& self, const std::string& method, const Values& values,
        const std::array<double, 4>& grid, std::int64_t rows, std::int64_t columns, double fill,
        bool isSingle, const Settings& settings, const std::array<std::int64_t, 2>& first)
      {
        const Interpolation by = methodOf(method);
        return isSingle
          ? imageOf<float>(self, by, values, grid, first, rows, columns, fill, settings)
          : imageOf<double>(self, by, values, grid, first, rows, columns, fill, settings);
      },
      "method"_a, "values"_a, "grid"_a, "rows"_a, "columns"_a, "fill"_a, "single"_a, "settings"_a,
      "first"_a = std::array<std::int64_t, 2>{});
  module.def("triangulation_queries", &sitesOf, "points"_a, "weights"_a.none(), "triangulation"_a,
    "settings"_a, "cells"_a.none() = nb::none());
  module.def("constrained_queries", &constrainedSites, "points"_a, "triangulation"_a, "settings"_a,
    "cells"_a.none() = nb::none());

  module.def("triangle_measures",
    [](const InputArray& points, const Handle<Triangulation>& triangulation)
    {
      const PointView positions = pointView(points, 2);
      return measured(triangulation.result->cellCount(),
        [&](double* areas, double* centroids)
        { cellMeasures(positions, *triangulation.result, areas, centroids); });
    });
  module.def(
    "facet_centers",
    [](const InputArray& points, const std::optional<InputArray>& weights,
      const Handle<Triangulation>& triangulation, const Settings& settings)
    {
      const PointView positions = pointView(points, 2);
      const WeightView given = weightView(weights);
      const auto cells = static_cast<std::size_t>(triangulation.result->cellCount());
      Buffer<double> centers(2 * cells);
      settings.run([&](const Options& options)
        { facetCenters(positions, given, *triangulation.result, centers.data(), options); });
      return arrayOf(std::move(centers), { cells, std::size_t(2) });
    },
    "points"_a, "weights"_a.none(), "triangulation"_a, "settings"_a);
  module.def("cells_within_edge_length",
    [](const InputArray& points, const Handle<Triangulation>& triangulation, double limit,
      const Settings& settings)
    {
      const PointView positions = pointView(points, 2);
      const auto cells = static_cast<std::size_t>(triangulation.result->cellCount());
      Buffer<std::uint8_t> within(cells);
      settings.run(
        [&](const Options& options) {
          return cellsWithinEdgeLength(
            positions, *triangulation.result, limit, within.data(), options);
        });
      return arrayOf(std::move(within));
    });
  module.def("power_cell_measures",
    [](const Handle<PowerDiagram>& diagram)
    {
      return measured(static_cast<std::int64_t>(diagram.result->siteIds.size()),
        [&](double* areas, double* centroids) { cellMeasures(*diagram.result, areas, centroids); });
    });
}

}
