// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A constrained Delaunay triangulation that takes one vertex after another, in its canonical form
/// at each step.
///
/// A new vertex replaces the triangles whose circles it is in, as far as fixed edges let it see
/// them, by a fan around it: what Lawson's flips end at. Of four points on one circle, the diagonal
/// at the lowest id is the edge: as if the lower its id, the more a point were lowered in the lift.
/// So the points of one circle form the fan from the lowest of them, as the finish of
/// constrainedTriangulation() cuts them.
#ifndef flipflop_TerrainTriangulation_h
#define flipflop_TerrainTriangulation_h

#include "Geometry/LiftedGeometry.h"
#include "Mesh/Mesh.h"
#include "Terrain/SurfacePlane.h"
#include <flipflop/ConstrainedTriangulation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

class TerrainTriangulation
{
public:
  using Geometry = LiftedGeometry<false>;

  /// @param points   that may become vertices; the third coordinate is not read as a weight
  /// @param start    in triangles
  /// @param vertexOf of each of its points, the number in @p points
  TerrainTriangulation(const Geometry& signs, const Vertex* points, std::uint32_t pointCount,
    const ConstrainedTriangulation& start, const std::vector<std::uint32_t>& vertexOf);

  std::size_t cellCount() const { return this->triangles.size(); }

  SurfaceCorners corners(std::uint32_t t) const
  {
    const std::uint32_t* const v = this->triangles[t].v;
    return { this->vertices + v[0], this->vertices + v[1], this->vertices + v[2] };
  }

  /// Insert point @p v, which is in triangle @p t, its border included, but at no vertex.
  /// @throw Error TooManyPoints
  void insert(std::uint32_t v, std::uint32_t t);

  /// Of the last insertion: the triangles that were replaced.
  const std::vector<std::uint32_t>& replaced() const { return this->cavity; }

  /// And those in their place, counter-clockwise around the new vertex; some have the same numbers.
  const std::vector<std::uint32_t>& parts() const { return this->fan; }

  /// Which of these holds a point of those that were replaced.
  /// @param hint where the search begins
  std::size_t partOf(std::uint32_t p, std::size_t hint) const
  {
    const Vertex& center = this->vertices[this->centerOfFan];
    const auto isLeftOf = [&](std::size_t spoke)
    {
      return this->geometry.orient(
               center, this->vertices[this->sides[spoke].from], this->vertices[p]) >= 0;
    };
    const std::size_t count = this->sides.size();
    std::size_t i = hint;
    if (isLeftOf(i))
    {
      for (;;)
      {
        const std::size_t next = i + 1 < count ? i + 1 : 0;
        if ((next == 0 && this->isOpen) || !isLeftOf(next))
        {
          return i;
        }
        i = next;
      }
    }
    do
    {
      i = i > 0 ? i - 1 : count - 1;
    } while (!isLeftOf(i));
    return i;
  }

  std::int64_t checkCount() const { return this->checks; }
  std::int64_t exactCalls() const { return this->geometry.predicateCounts().exact; }

private:
  /// An edge around the cavity, which is on its left.
  struct Side
  {
    std::uint32_t from, to;
    std::uint32_t outer; ///< the opposite half-edge; NoIndex: there is none
    bool isFixed;
  };

  /// Where a new vertex is on an edge.
  struct Split
  {
    std::uint32_t from = NoIndex, to = NoIndex; ///< its ends
    bool isBorder = false;
    bool isFixed = false;

    bool isAlong(std::uint32_t a, std::uint32_t b) const
    {
      return (a == this->from && b == this->to) || (a == this->to && b == this->from);
    }
    bool hasEnd(std::uint32_t v) const { return v == this->from || v == this->to; }
  };

  Mesh mesh()
  {
    Mesh result;
    result.triangles = this->triangles.data();
    return result;
  }
  void fixEdges(const ConstrainedTriangulation& start, const std::vector<std::uint32_t>& vertexOf);
  Split openCavity(std::uint32_t v, std::uint32_t t);
  void addToCavity(std::uint32_t t);
  bool isInConflict(std::uint32_t h, std::uint32_t v) const;
  void findSides(const Split& split);
  void fillCavity(std::uint32_t v, const Split& split);

  const Geometry geometry;
  const Vertex* const vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> sideFrom; ///< by vertex: which of the sides leaves it
  std::vector<std::uint32_t> cavity;
  std::vector<Side> found; ///< sides, in any order
  std::vector<Side> sides; ///< counter-clockwise
  std::vector<std::uint32_t> fan;
  std::uint32_t centerOfFan = 0;
  bool isOpen = false;     ///< the fan: its center is on the border
  std::int64_t checks = 0; ///< of edges
};

}

#endif
