// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The oracle for constrained triangulations. It uses nothing of the insertion of constraints: all
/// positions have a corner, the triangles fill the hull once, each edge is fixed or locally
/// Delaunay, which makes all of them constrained Delaunay; and walks along the fixed edges find all
/// constraints.
#include <flipflop/Validate.h>

#include "Points/ConstraintInput.h"
#include "Support/EngineCall.h"
#include "Validate/GivenTriangulation.h"

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

class ConstrainedChecker : private GivenTriangulation
{
public:
  ConstrainedChecker(TriangulationRun<true>& pointsRun, const ConstraintView& constraintsGiven,
    const ConstrainedTriangulation& triangulation)
    : GivenTriangulation(pointsRun, triangulation)
    , constraints(constraintsGiven)
    , result(triangulation)
  {
  }

  Validation check()
  {
    for (const auto& step :
      { &ConstrainedChecker::checkFixedStructure, &ConstrainedChecker::checkPoints,
        &ConstrainedChecker::checkCells, &ConstrainedChecker::checkConstraints })
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
    const auto points = static_cast<std::int64_t>(this->corners.size());
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
    return checkFinite(this->corners);
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

  /// All positions have a corner, so a chain joins each to the next along the line.
  Validation checkCells()
  {
    const bool isAny = this->result.dimension > 0;
    const Validation found = isAny ? this->checkMesh(&this->result.fixedEdges) : Validation();
    return found ? this->checkFixedAreEdges() : found;
  }

  Validation checkFixedAreEdges() const
  {
    std::size_t found = 0;
    const auto count = [&](std::int64_t a, std::int64_t b)
    { found += this->fixed.count(std::minmax(a, b)); };
    const Buffer<std::int64_t>& corners = this->result.connectivity;
    for (std::size_t i = 0; this->result.dimension == 1 && i < corners.size(); i += 2)
    {
      count(corners[i], corners[i + 1]);
    }
    for (const Triangle& triangle : this->mesh.triangles)
    {
      for (int e = 0; e < 3; ++e)
      {
        // Within, the side that goes up counts.
        const std::uint32_t from = triangle.v[e];
        const std::uint32_t to = triangle.v[nextCorner(e)];
        if (from < to || triangle.twin[e] == NoIndex)
        {
          count(from, to);
        }
      }
    }
    return found == this->fixed.size() ? Validation() : faultAt(Fault::NotFixed, -1);
  }

  /// The first constraint along each fixed edge, derived from the constraints.
  Validation checkConstraints()
  {
    std::vector<std::vector<std::int64_t>> neighbours(this->corners.size());
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
    { return this->corners[static_cast<std::size_t>(i)]; };
    const Position from = positionOf(at(a)), on = positionOf(at(p)), to = positionOf(at(b));
    return local.orient(at(a), at(p), at(b)) == 0 &&
      (from < to ? from < on && on <= to : to <= on && on < from);
  }

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
      requireValid(points, 2);
      requireValid(constraints, points.count);
      return validateTriangulation(points, WeightView(), triangulation, threads,
        [&](TriangulationRun<true>& run)
        {
          requireFinite(constraints, run.source, run.checkFinite);
          return ConstrainedChecker(run, constraints, triangulation).check();
        });
    });
}

}
