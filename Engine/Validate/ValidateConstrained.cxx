// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The oracle for constrained triangulations. It uses nothing of the insertion of constraints: all
/// positions have a corner, the triangles fill the hull once, each edge is fixed or locally
/// Delaunay, which makes all of them constrained Delaunay; and walks along the fixed edges find all
/// constraints.
#include <flipflop/Validate.h>

#include "Geometry/LiftedLocator.h"
#include "Geometry/LiftedStart.h"
#include "Points/ConstraintInput.h"
#include "Run/TriangulationRun.h"
#include "Support/EngineCall.h"
#include "Validate/ValidateStructure.h"
#include "Validate/ValidateSurface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

class ConstrainedChecker : private SurfaceChecker<LiftedGeometry<false>>
{
public:
  using Geometry = LiftedGeometry<false>;

  ConstrainedChecker(TriangulationRun<false>& toUse, const ConstraintView& given,
    const ConstrainedTriangulation& judged)
    : SurfaceChecker<Geometry>(toUse, toUse.geometry, judged)
    , run(toUse)
    , constraints(given)
    , result(judged)
  {
  }

  Validation check()
  {
    for (const auto& step :
      { &ConstrainedChecker::checkFixedStructure, &ConstrainedChecker::checkPoints,
        &ConstrainedChecker::checkPlane, &ConstrainedChecker::checkConstraints })
    {
      const Validation found = (this->*step)();
      if (!found)
      {
        return found;
      }
    }
    return Validation();
  }

private:
  using Edge = std::pair<std::int64_t, std::int64_t>; ///< corners, the lower one first
  using Position = std::pair<double, double>;

  /// The first constraint, the balance, and the side that decides.
  using Along = std::array<std::int64_t, 3>;

  /// What runs along an edge.
  struct Stretches
  {
    explicit Stretches(std::int64_t constraint)
      : first(constraint)
    {
    }

    std::int64_t first;
    std::int64_t sides[2] = { 0, 0 };       ///< from the lower corner, and back
    std::int64_t firstSide[2] = { -1, -1 }; ///< likewise

    Along along() const
    {
      const std::int64_t balance = this->sides[0] - this->sides[1];
      return { this->first, balance, balance == 0 ? -1 : this->firstSide[balance < 0] };
    }
  };

  static Position positionOf(const Vertex& v) { return { v.x[0], v.x[1] }; }

  Edge fixedEdge(std::size_t i) const
  {
    return { this->result.fixedEdges[2 * i], this->result.fixedEdges[2 * i + 1] };
  }

  Validation checkFixedStructure()
  {
    const std::size_t count = this->result.constraintOf.size();
    const auto points = static_cast<std::int64_t>(this->corner.size());
    if (this->result.fixedEdges.size() != 2 * count || this->result.balance.size() != count ||
      this->result.sideOf.size() != count || this->result.sides != this->constraints.sides)
    {
      return faultAt(Fault::Structure, -1);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const Edge edge = this->fixedEdge(i);
      if (edge.first < 0 || edge.first >= edge.second || edge.second >= points ||
        (i > 0 && this->fixedEdge(i - 1) >= edge))
      {
        return faultAt(Fault::Structure, -1);
      }
      this->fixed.emplace(edge,
        Along{ this->result.constraintOf[i], this->result.balance[i], this->result.sideOf[i] });
    }
    return this->checkFinite();
  }

  /// The lowest id of each position appears, and all others are hidden.
  Validation checkPoints()
  {
    const Buffer<std::int64_t>& visible = this->result.pointIds;
    const Buffer<std::int64_t>& hidden = this->result.hiddenIds;
    std::size_t v = 0;
    std::size_t h = 0;
    for (std::uint32_t id = 0; id < this->run.source.count(); ++id)
    {
      const Vertex p = this->run.source.vertex(id);
      if (!isFinite(p.x))
      {
        continue;
      }
      if (this->cornerAt.emplace(positionOf(p), static_cast<std::int64_t>(v)).second)
      {
        if (v == visible.size() || visible[v] != id)
        {
          return faultAt(Fault::PointOutside, id);
        }
        ++v;
      }
      else if (h == hidden.size() || hidden[h++] != id)
      {
        return faultAt(Fault::Structure, id);
      }
    }
    return v == visible.size() && h == hidden.size() ? Validation() : faultAt(Fault::Structure, -1);
  }

  Validation checkPlane()
  {
    const std::vector<std::uint32_t> ids = this->cornerIds();
    const Span span = this->run.spanOf(ids.data(), static_cast<std::uint32_t>(ids.size()));
    if (span.dimension != this->result.dimension)
    {
      return faultAt(Fault::WrongDimension, -1);
    }
    if (span.dimension < 2)
    {
      return this->checkChain();
    }
    const Validation mesh = this->makeMesh(true);
    if (!mesh)
    {
      return mesh;
    }
    startingTetrahedron(this->run.geometry, this->run.source, span.ids); // sets the kernel point
    const Validation star = this->checkStar();
    return star ? this->checkEdges() : star;
  }

  /// One corner; or cells from each position along the line to the next.
  Validation checkChain() const
  {
    std::vector<Edge> cells;
    auto last = this->cornerAt.begin();
    for (auto next = std::next(last); next != this->cornerAt.end(); last = next++)
    {
      cells.push_back(std::minmax(last->second, next->second));
    }
    std::sort(cells.begin(), cells.end());
    const Buffer<std::int64_t>& found = this->result.connectivity;
    bool same = this->result.dimension == 0 ? found.size() == 1 : found.size() == 2 * cells.size();
    for (std::size_t i = 0; same && i < cells.size(); ++i)
    {
      same = found[2 * i] == cells[i].first && found[2 * i + 1] == cells[i].second;
    }
    return same ? Validation() : faultAt(Fault::NotClosed, -1);
  }

  /// Each edge is fixed, at the border, or locally Delaunay. Triangles of one circle that no fixed
  /// edge parts are one polygon, or the fan from their lowest corner.
  Validation checkEdges() const
  {
    const Geometry local = this->run.geometry;
    const bool merged = this->run.options.facets == FacetMode::Polygons;
    const Triangle* const triangles = this->polyhedron.triangles.data();
    const Vertex* const v = this->polyhedron.vertices.data();
    for (std::uint32_t t = 0; t < this->polyhedron.triangleCount(); ++t)
    {
      const std::uint32_t* const own = triangles[t].v;
      for (int e = 0; e < 3; ++e)
      {
        const std::uint32_t twin = triangles[t].twin[e];
        const std::uint32_t* const other = triangles[triangleOf(twin)].v;
        const int sign =
          local.above(v[own[0]], v[own[1]], v[own[2]], v[other[previousCorner(cornerOf(twin))]]);
        const std::int64_t cell = this->cellOf[t];
        const std::int64_t neighbour = this->cellOf[triangleOf(twin)];
        const bool within = cell == neighbour && cell >= 0;
        const bool isFixed =
          this->fixed.count(std::minmax<std::int64_t>(own[e], own[nextCorner(e)])) != 0;
        if (isFixed ? within
                    : sign > 0 || (within && sign != 0) ||
              (merged && !within && cell >= 0 && neighbour >= 0 && sign == 0))
        {
          return faultAt(Fault::NotConvex, std::max(cell, neighbour));
        }
        if (!merged && !isFixed && sign == 0 && cell >= 0 && neighbour >= 0 &&
          (own[0] != other[0] || e == 1))
        {
          return faultAt(Fault::Structure, cell);
        }
      }
    }
    return this->checkFixedAreEdges();
  }

  Validation checkFixedAreEdges() const
  {
    std::size_t found = 0;
    for (std::uint32_t t = 0; t < this->polyhedron.triangleCount(); ++t)
    {
      const std::uint32_t* const corners = this->polyhedron.triangles[t].v;
      for (int e = 0; e < 3; ++e)
      {
        // Each edge has one side that goes up.
        const Edge side(corners[e], corners[nextCorner(e)]);
        found += side.first < side.second ? this->fixed.count(side) : 0;
      }
    }
    return found == this->fixed.size() ? Validation() : faultAt(Fault::NotFixed, -1);
  }

  /// The first constraint along each fixed edge, derived from the constraints.
  Validation checkConstraints()
  {
    std::vector<std::vector<std::int64_t>> neighbours(this->corner.size());
    for (const auto& edge : this->fixed)
    {
      neighbours[static_cast<std::size_t>(edge.first.first)].push_back(edge.first.second);
      neighbours[static_cast<std::size_t>(edge.first.second)].push_back(edge.first.first);
    }
    const Geometry local = this->run.geometry;
    const bool isPlane = this->result.dimension == 2; // else no polygon has an inside
    std::map<Edge, Stretches> wanted;
    for (std::int64_t c = 0; c < this->constraints.count; ++c)
    {
      std::int64_t at = this->standsFor(this->constraints.ends[2 * c]);
      const std::int64_t end = this->standsFor(this->constraints.ends[2 * c + 1]);
      while (at != end)
      {
        const std::vector<std::int64_t>& near = neighbours[static_cast<std::size_t>(at)];
        const auto next = std::find_if(
          near.begin(), near.end(), [&](std::int64_t p) { return this->leads(local, at, p, end); });
        if (next == near.end())
        {
          return faultAt(Fault::NotFixed, c);
        }
        Stretches& stretches = wanted.emplace(std::minmax(at, *next), Stretches(c)).first->second;
        if (isPlane && c >= this->constraints.count - this->constraints.sides)
        {
          const bool isBack = *next < at;
          stretches.firstSide[isBack] =
            stretches.sides[isBack]++ == 0 ? c : stretches.firstSide[isBack];
        }
        at = *next;
      }
    }
    const auto isSame = [](const auto& given, const auto& edge)
    { return given.first == edge.first && given.second == edge.second.along(); };
    return std::equal(this->fixed.begin(), this->fixed.end(), wanted.begin(), wanted.end(), isSame)
      ? Validation()
      : faultAt(Fault::NotFixed, -1);
  }

  std::int64_t standsFor(std::int64_t id) const
  {
    return this->cornerAt.at(positionOf(this->run.source.vertex(static_cast<std::uint32_t>(id))));
  }

  /// Is p on the segment from a to b, and not a?
  bool leads(const Geometry& local, std::int64_t a, std::int64_t p, std::int64_t b) const
  {
    const auto at = [this](std::int64_t i) -> const Vertex&
    { return this->corner[static_cast<std::size_t>(i)]; };
    const Position from = positionOf(at(a)), on = positionOf(at(p)), to = positionOf(at(b));
    return local.orient(at(a), at(p), at(b)) == 0 &&
      (from < to ? from < on && on <= to : to <= on && on < from);
  }

  TriangulationRun<false>& run;
  const ConstraintView constraints;
  const ConstrainedTriangulation& result;
  std::map<Edge, Along> fixed;
  std::map<Position, std::int64_t> cornerAt; ///< along a line, in its order
};

}

Validation validate(const PointView& points, const ConstraintView& constraints,
  const ConstrainedTriangulation& triangulation, int threads)
{
  return engineCall(
    [&]
    {
      Options options;
      options.threads = threads;
      options.nonFinite = NonFinitePolicy::Ignore;
      options.facets = triangulation.cellSize == 3 ? FacetMode::Triangles : FacetMode::Polygons;
      TriangulationRun<false> run(points, WeightView(), options);
      requireValid(constraints, points.count);
      Validation result = checkStructure(points.count, triangulation, 2);
      if (!result)
      {
        return result;
      }
      run.execute<Triangulation>(
        [&](Triangulation& scratch)
        {
          if (!run.inspect(scratch.statistics))
          {
            result =
              triangulation.dimension == -1 ? Validation() : faultAt(Fault::WrongDimension, -1);
            return;
          }
          requireFinite(constraints, run.source, run.checkFinite);
          result = triangulation.dimension == -1
            ? faultAt(Fault::WrongDimension, 0)
            : ConstrainedChecker(run, constraints, triangulation).check();
        });
      return result;
    });
}

}
