// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangulations of which some cells are left out: inside polygons, in alpha complexes; and the
/// borders of such.
#include "Calls.h"
#include "Constrained.h"
#include "Results.h"
#include "State.h"
#include "Views.h"

#include <flipflop/AlphaComplex.h>
#include <flipflop/CellBoundary.h>
#include <flipflop/ClosedLines.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/ConstraintCrossings.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/JoinedLines.h>
#include <flipflop/Validate.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

using Mask = nb::ndarray<const std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

ConstraintView constraintView(const EndsArray& ends, std::int64_t sides)
{
  return { ends.data(), static_cast<std::int64_t>(ends.shape(0)), sides };
}

/// A part of a run, which reports its progress as that of the whole run.
class Part
{
public:
  Part(const Options& options, double from, double to)
    : whole(options)
    , begin(from)
    , length(to - from)
  {
  }

  Options options()
  {
    Options part = this->whole;
    part.progress = [](double fraction, void* context)
    {
      const Part& self = *static_cast<const Part*>(context);
      return self.whole.progress(self.begin + fraction * self.length, self.whole.progressContext);
    };
    part.progressContext = this;
    return part;
  }

private:
  Options whole;
  double begin;
  double length;
};

/// A copy that has some cells alone, and all points.
Triangulation withCells(const Triangulation& given, const std::uint8_t* kept)
{
  Triangulation some = cellsOf(given);
  some.hiddenIds = copyOf(given.hiddenIds);
  some.statistics = given.statistics;
  keepCells(some, kept);
  return some;
}

/// @param features for each side of a polygon what it is of: their union is inside
Constrained constrained(const InputArray& points, const EndsArray& ends, std::int64_t polygonSides,
  bool byDirection, const std::optional<IdArray>& features, const Settings& settings)
{
  if (features && static_cast<std::int64_t>(features->size()) != polygonSides)
  {
    throw nb::value_error("there must be a feature for each side of a polygon");
  }
  const PointView sites = pointView(points, 2);
  const ConstraintView constraints = constraintView(ends, polygonSides);
  return settings.run(
    [&](const Options& given)
    {
      Options options = given;
      options.polygons = byDirection ? PolygonRule::Direction : PolygonRule::EvenOdd;
      const double shareOfInside = polygonSides > 0 ? 0.2 : 0.0;
      Part making(options, 0.0, 1.0 - shareOfInside);
      Constrained made;
      made.whole = std::make_shared<const ConstrainedTriangulation>(
        constrainedTriangulation(sites, constraints, making.options()));
      made.inside = { made.whole };
      if (polygonSides > 0)
      {
        Part choosing(options, 1.0 - shareOfInside, 1.0);
        const std::int64_t cells = made.whole->cellCount();
        Buffer<std::uint8_t> inside(static_cast<std::size_t>(cells));
        const std::int64_t kept = features
          ? cellsInsideFeatures(
              *made.whole, sites, constraints, features->data(), inside.data(), choosing.options())
          : cellsInside(*made.whole, inside.data(), choosing.options());
        if (kept < cells)
        {
          made.inside = handleOf(withCells(*made.whole, inside.data()));
        }
      }
      return made;
    });
}

/// The whole; and what is inside, None if it is the same.
nb::tuple constrainedState(const Constrained& self)
{
  const auto only = [](const auto& result)
  {
    return stateOf(
      1, [&](std::size_t) -> const auto& { return result; });
  };
  return nb::make_tuple(only(*self.whole),
    self.inside.result == self.whole ? nb::none() : nb::object(only(*self.inside.result)));
}

Constrained restoredConstrained(const std::tuple<State, std::optional<State>>& state)
{
  Constrained self;
  self.whole = std::make_shared<const ConstrainedTriangulation>(
    restoredResult<ConstrainedTriangulation>(std::get<0>(state)));
  self.inside = { self.whole };
  if (std::get<1>(state))
  {
    self.inside = handleOf(restoredResult<Triangulation>(*std::get<1>(state)));
  }
  return self;
}

/// The ends of the constraints along chains of ids, and the chain of each.
/// @param offsets where each chain begins, ascending; then how many ids there are
nb::tuple constraintsAlong(const IdArray& offsets, const IdArray& ids, bool areRings)
{
  const auto ends = std::make_shared<std::vector<std::int64_t>>();
  const auto chainOf = std::make_shared<std::vector<std::int64_t>>();
  for (std::size_t chain = 0; chain + 1 < offsets.shape(0); ++chain)
  {
    const std::int64_t begin = offsets.data()[chain], end = offsets.data()[chain + 1];
    if (begin < 0 || end < begin || end > static_cast<std::int64_t>(ids.shape(0)))
    {
      throw nb::value_error("offsets have to ascend");
    }
    eachConstraintAlong(ids.data() + begin, end - begin, areRings,
      [&](std::int64_t from, std::int64_t to)
      {
        ends->insert(ends->end(), { from, to });
        chainOf->push_back(static_cast<std::int64_t>(chain));
      });
  }
  using Owner = std::shared_ptr<const std::vector<std::int64_t>>;
  const std::size_t count = chainOf->size();
  return nb::make_tuple(arrayOf(ends->data(), { count, 2 }, Owner(ends)),
    arrayOf(chainOf->data(), { count }, Owner(chainOf)));
}

/// The pieces, the constraint of each, how many are sides of polygons, and the new positions.
nb::tuple splitOf(const InputArray& points, const EndsArray& ends, std::int64_t polygonSides,
  const Settings& settings)
{
  const PointView sites = pointView(points, 2);
  const ConstraintView constraints = constraintView(ends, polygonSides);
  SplitConstraints found = settings.run(
    [&](const Options& options) { return splitCrossings(sites, constraints, options); });
  const std::size_t pieces = found.constraintOf.size();
  const auto count = static_cast<std::size_t>(found.newPointCount());
  return nb::make_tuple(arrayOf(std::move(found.ends), { pieces, 2 }),
    arrayOf(std::move(found.constraintOf)), found.sides,
    arrayOf(std::move(found.positions), { count, 2 }));
}

/// Lines with points of their own, joined to points, and split where they cross.
struct Joined
{
  std::shared_ptr<const JoinedLines> lines;
  std::shared_ptr<const SplitConstraints> split;
};

/// The pieces, the constraint of each, how many are sides of polygons; the positions of the points
/// that lines add, then of crossings; which of the lines' points the former are; the first
/// constraint that crosses at each of the latter; and what heights need.
/// @param split whether lines are split where they cross; if not, all pieces are whole
nb::tuple joinedOf(const InputArray& points, const InputArray& linePoints, const EndsArray& ends,
  std::int64_t polygonSides, bool split, const Settings& settings)
{
  const PointView sites = pointView(points, 2);
  const PointView others = pointView(linePoints, 2);
  const ConstraintView constraints = constraintView(ends, polygonSides);
  const Joined joined = settings.run(
    [&](const Options& options)
    {
      Part joining(options, 0.0, split ? 0.4 : 1.0);
      Part splitting(options, 0.4, 1.0);
      Joined made;
      made.lines = std::make_shared<const JoinedLines>(
        joinLines(sites, others, constraints, joining.options()));
      made.split = std::make_shared<const SplitConstraints>(split
          ? splitCrossings(made.lines->points(), made.lines->view(), splitting.options())
          : SplitConstraints());
      return made;
    });
  const Buffer<double>& positions = joined.lines->positions;
  const Buffer<double>& crossings = joined.split->positions;
  const auto given = 2 * static_cast<std::size_t>(sites.count);
  Buffer<double> added(positions.size() - given + crossings.size());
  std::copy(crossings.begin(), crossings.end(),
    std::copy(positions.begin() + given, positions.end(), added.begin()));
  Buffer<std::int64_t> firsts(crossings.size() / 2);
  for (std::size_t k = 0; k < firsts.size(); ++k)
  {
    firsts[k] = joined.split->crossing[static_cast<std::size_t>(joined.split->offsets[k])];
  }
  Buffer<std::int64_t> pieces = copyOf(split ? joined.split->ends : joined.lines->ends);
  Buffer<std::int64_t> pieceOf = copyOf(joined.split->constraintOf);
  if (!split)
  {
    pieceOf.allocate(pieces.size() / 2);
    std::iota(pieceOf.begin(), pieceOf.end(), std::int64_t(0));
  }
  const std::size_t count = added.size() / 2, pieceCount = pieceOf.size();
  return nb::make_tuple(arrayOf(std::move(pieces), { pieceCount, 2 }), arrayOf(std::move(pieceOf)),
    split ? joined.split->sides : joined.lines->sides, arrayOf(std::move(added), { count, 2 }),
    arrayOf(joined.lines->added, joined.lines), arrayOf(std::move(firsts)), joined);
}

/// For each line 1 if it is of a ring, -1 if it also runs against its first line; else 0. Polygons
/// come after the lines.
/// @param dimensions in which points are compared
OutputArray<std::int8_t> closedOf(const InputArray& points, const IdArray& offsets,
  std::int64_t polygons, int dimensions, const Settings& settings)
{
  LineView lines;
  lines.points = pointView(points, dimensions);
  lines.offsets = offsets.data();
  lines.polygons = polygons;
  lines.lines = static_cast<std::int64_t>(offsets.size()) - 1 - polygons;
  return arrayOf(
    settings.run([&](const Options& options) { return closedLines(lines, dimensions, options); }));
}

/// The heights of the points that were added, the lowest and the highest at each, and how many
/// differ.
nb::tuple heightsOf(const InputArray& points, const InputArray& linePoints, const EndsArray& ends,
  std::int64_t polygonSides, const Joined& joined, const Constrained& triangulation,
  const Settings& settings)
{
  const PointView sites = pointView(points, 3);
  const PointView others = pointView(linePoints, 3);
  LineHeights found = settings.run(
    [&](const Options& options)
    {
      return lineHeights(sites, others, constraintView(ends, polygonSides), *joined.lines,
        *joined.split, *triangulation.whole, options);
    });
  const std::size_t count = found.ranges.size() / 2;
  return nb::make_tuple(arrayOf(std::move(found.added)),
    arrayOf(std::move(found.ranges), { count, 2 }), found.differing);
}

/// What of a triangulation is in its alpha complex: cells, and if asked for edges and points of
/// none of these, by their ids.
nb::tuple complexOf(const InputArray& points, const std::optional<InputArray>& weights,
  const Handle<Triangulation>& triangulation, double alpha, const Settings& settings, bool singular)
{
  const PointView sites = pointView(points, 2);
  const WeightView weighted = weightView(weights);
  const Triangulation& cells = *triangulation.result;
  AlphaComplex found = settings.run([&](const Options& options)
    { return alphaComplex(sites, weighted, cells, alpha, singular, options); });
  const std::size_t edges = found.edgeAlphas.size();
  return nb::make_tuple(arrayOf(std::move(found.cells)),
    arrayOf(idsOf(cells, found.edges), { edges, 2 }), arrayOf(std::move(found.edgeAlphas)),
    arrayOf(idsOf(cells, found.vertices)), arrayOf(std::move(found.vertexAlphas)));
}

/// Edges of points by their ids, as cells.
Handle<Triangulation> edgesOf(const EndsArray& ends)
{
  const std::int64_t* const begin = ends.data();
  const std::size_t size = 2 * ends.shape(0);
  std::vector<std::int64_t> ids(begin, begin + size);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  Triangulation edges;
  edges.dimension = 1;
  edges.cellSize = 2;
  edges.pointIds.allocate(ids.size());
  std::copy(ids.begin(), ids.end(), edges.pointIds.begin());
  edges.connectivity.allocate(size);
  std::transform(begin, begin + size, edges.connectivity.begin(),
    [&](std::int64_t id) { return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin(); });
  return handleOf(std::move(edges));
}

/// Where each ring begins, and the ids of all.
nb::tuple boundaryOf(const Handle<Triangulation>& triangulation, const Settings& settings)
{
  const Triangulation& cells = *triangulation.result;
  CellBoundary rings =
    settings.run([&](const Options& options) { return cellBoundary(cells, options); });
  if (rings.offsets.empty())
  {
    rings.offsets.allocate(1);
    rings.offsets[0] = 0;
  }
  return nb::make_tuple(
    arrayOf(std::move(rings.offsets)), arrayOf(idsOf(cells, rings.connectivity)));
}

}

void bindComplexes(nb::module_& module)
{
  nb::class_<Constrained>(module, "ConstrainedTriangulation")
    .def_prop_ro("dropped",
      [](const Constrained& self)
      { return self.whole->cellCount() - self.inside.result->cellCount(); })
    .def("inside", [](const Constrained& self) { return self.inside; })
    .def("fixed_edges",
      [](const Constrained& self)
      {
        const ConstrainedTriangulation& whole = *self.whole;
        return arrayOf(idsOf(whole, whole.fixedEdges), { whole.constraintOf.size(), 2 });
      })
    .def("constraint_of",
      [](const Constrained& self) { return arrayOf(self.whole->constraintOf, self.whole); })
    .def("__getstate__", &constrainedState)
    .def("__setstate__",
      [](Constrained& self, const std::tuple<State, std::optional<State>>& state)
      { new (&self) Constrained(restoredConstrained(state)); });
  module.def("constrained_triangulation", &constrained, "points"_a, "ends"_a, "sides"_a,
    "by_direction"_a, "features"_a.none(), "settings"_a);
  module.def("constraints_along", &constraintsAlong);
  module.def("split_crossings", &splitOf);
  nb::class_<Joined>(module, "JoinedLines");
  module.def("closed_lines", &closedOf);
  module.def("join_lines", &joinedOf);
  module.def("line_heights", &heightsOf);
  module.def("validate_constrained",
    [](const InputArray& points, const EndsArray& ends, std::int64_t polygonSides,
      const Constrained& triangulation, int threads)
    {
      const PointView sites = pointView(points, 2);
      return checkedBy(
        [&] {
          return validate(sites, constraintView(ends, polygonSides), *triangulation.whole, threads);
        });
    });

  module.def(
    "cell_alphas",
    [](const InputArray& points, const std::optional<InputArray>& weights,
      const Handle<Triangulation>& triangulation, const Settings& settings)
    {
      const PointView sites = pointView(points, 2);
      const WeightView weighted = weightView(weights);
      Buffer<double> alphas(static_cast<std::size_t>(triangulation.result->cellCount()));
      settings.run([&](const Options& options)
        { cellAlphas(sites, weighted, *triangulation.result, alphas.data(), options); });
      return arrayOf(std::move(alphas));
    },
    "points"_a, "weights"_a.none(), "triangulation"_a, "settings"_a);
  module.def("alpha_complex", &complexOf, "points"_a, "weights"_a.none(), "triangulation"_a,
    "alpha"_a, "settings"_a, "singular"_a = true);
  module.def("with_cells",
    [](const Handle<Triangulation>& triangulation, const Mask& kept)
    {
      if (static_cast<std::int64_t>(kept.shape(0)) != triangulation.result->cellCount())
      {
        throw nb::value_error("there are not as many answers as cells");
      }
      return handleOf(withCells(*triangulation.result, kept.data()));
    });
  module.def("edges_of", &edgesOf);
  module.def("cell_boundary", &boundaryOf);
}

}
