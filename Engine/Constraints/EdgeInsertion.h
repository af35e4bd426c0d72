// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constraints as edges of a Delaunay triangulation, one after another, and the flips that make the
/// rest constrained Delaunay again.
///
/// A new edge changes nothing but the triangles that it crosses (J. R. Shewchuk, B. C. Brown, "Fast
/// segment insertion and incremental construction of constrained Delaunay triangulations", 2015):
/// they are triangulated again (Cavity.h), and flipped by the V-criterion, which needs no labels
/// here, for no point is hidden. Signs are without the perturbation. Ties stay as they are, and the
/// finish joins the triangles of one circle: between constraints they form convex polygons, since
/// all their corners are on it, and an edge parts the circle. So the result is unique.
#ifndef flipflop_EdgeInsertion_h
#define flipflop_EdgeInsertion_h

#include "Constraints/Cavity.h"
#include "Constraints/FixedEdge.h"
#include "Mesh/Polyhedron.h"
#include "Support/Monitor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace flipflop
{

class EdgeInsertion
{
public:
  using Geometry = LiftedGeometry<false>;

  /// @param surface of the Delaunay triangulation, with the virtual vertex and flat edges marked;
  ///                no two vertices are at one position
  EdgeInsertion(const Geometry& geometry, Polyhedron& surface, Monitor& monitor);

  /// Make the segment from vertex @p u to vertex @p v one or more edges.
  /// @param isSide of a polygon
  /// @throw Error ConstraintsCross, Aborted
  void insert(std::uint32_t u, std::uint32_t v, std::uint32_t constraint, bool isSide);

  /// Mark again which edges are flat, where triangles have changed. A fixed edge is not.
  /// @return whether there is a flat one among these
  bool markFlatEdges();

  /// The edges that constraints run along, by vertices, some more than once.
  std::vector<FixedEdge>& fixedEdges();

  std::int64_t flipCount() const { return this->flips; }
  std::int64_t checkCount() const { return this->checks; }

private:
  /// How a line leaves a vertex.
  struct Exit
  {
    std::uint32_t along;  ///< a half-edge of the edge that it takes; NoIndex: there is none
    std::uint32_t end;    ///< of that edge
    std::uint32_t across; ///< else the half-edge opposite to the vertex that it crosses
  };

  /// The edges of a constraint that runs through points.
  struct Chain
  {
    std::uint32_t from;       ///< where it begins
    std::size_t begin, count; ///< of its records
    SidesAlong again;         ///< of constraints between the same two vertices that came later
  };

  static std::uint64_t keyOf(std::uint32_t u, std::uint32_t v)
  {
    return std::uint64_t(std::min(u, v)) << 32 | std::max(u, v);
  }

  const Vertex& vertex(std::uint32_t v) const { return this->mesh.vertices[v]; }

  Exit exitOf(std::uint32_t u, std::uint32_t v);
  bool isAgain(std::uint32_t u, std::uint32_t v, const SidesAlong& sides);
  bool hasSmallerStar(std::uint32_t v, std::uint32_t u);
  void fix(std::uint32_t h);
  void makeDelaunay();
  bool isCocircular(std::uint32_t h) const;
  /// Of the fixed edges, after joinRecords.
  std::uint32_t firstAlong(std::uint32_t h) const;

  const Geometry& geometry;
  const Mesh mesh;
  StepPoll poll;
  LeavingHalfEdges leaving;
  Cavity cavity;
  std::vector<FixedEdge> fixed;
  std::unordered_map<std::uint64_t, Chain> chains; ///< by their two ends
  std::vector<std::uint32_t> waiting;              ///< half-edges to be checked
  std::vector<std::uint32_t> changed;              ///< triangles, some more than once
  std::int64_t flips = 0;
  std::int64_t checks = 0;
};

}

#endif
