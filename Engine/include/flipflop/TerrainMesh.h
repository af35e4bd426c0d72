// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From points with heights to a small mesh within a tolerance: a constrained Delaunay
/// triangulation of some of the points, from which none of the others is farther, vertically, than
/// the tolerance (M. Garland, P. S. Heckbert, "Fast polygonal approximation of terrains and height
/// fields", 1995).
#ifndef flipflop_TerrainMesh_h
#define flipflop_TerrainMesh_h

#include <flipflop/Buffer.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>

namespace flipflop
{

/// When a mesh is fine enough.
struct TerrainMeshOptions
{
  double tolerance = 0;         ///< the greatest vertical distance, in units of heights: 0 or more
  std::int64_t maxVertices = 0; ///< insert no point once there are so many; 0: no limit
  bool isFraction = false;      ///< the tolerance is in units of the range of heights
};

/// The triangulation of the points that were kept, bit for bit what constrainedTriangulation() of
/// these alone gives, with the ids of the input. The points that were not kept are its hidden ones.
/// Its cells are triangles, or a chain where all points are on one line.
struct TerrainMesh : ConstrainedTriangulation
{
  /// For each point given: its height less the surface's at its position, the true value rounded to
  /// the nearest double. 0 where it is a vertex; NaN where it was left out.
  Buffer<double> errors;

  double tolerance = 0;     ///< the tolerance, in units of heights; 0 if there is no point
  double greatestError = 0; ///< the greatest magnitude among them; 0 if there is no point

  std::int64_t beyond = 0; ///< how many points are farther from the surface than the tolerance

  /// How many of these are at the position of a vertex, whose height differs by more: no insertion
  /// reaches them.
  std::int64_t unreachable = 0;

  /// Is every point within the tolerance? Exact.
  bool isWithinTolerance() const { return this->beyond == 0; }
};

/// The mesh by greedy insertion. It starts with the corners of the convex hull (in x and y) and the
/// ends of the constraints. As long as points are beyond the tolerance, the one that is farthest
/// from the surface becomes a vertex, of several the one of the lowest id, and the surface is the
/// constrained Delaunay triangulation again. Distances are rounded where they only choose this
/// order; whether one exceeds the tolerance is decided exactly, for finite numbers of any
/// magnitude.
///
/// Constraints are fixed edges, parted where a vertex is on them. Points at which constraints cross
/// are kept, too. At a position with several points, the vertex is that of the lowest id; another
/// one there may then be unreachable.
///
/// Insertions are one after another, so more threads help with the rest alone.
///
/// @param points      x and y are read; z where there are no heights
/// @param heights     one for each point; no data: z of the points
/// @param constraints as for constrainedTriangulation(); none: ConstraintView()
/// @param terrain     when to stop: where both are set, at the first
/// @param options     see Options; facets do not count. A point whose height is NaN or infinite is
///                    treated like one with such a coordinate; Statistics::nonFinite counts both
/// @return            the mesh, the same for any number of threads
/// @throw Error       BadArgument (a tolerance that is negative or NaN, a negative number of
///                    vertices, heights that are not as many as points), ConstraintPoint,
///                    ConstraintsCross, NonFinite, TooManyPoints, OutOfMemory, Aborted
TerrainMesh terrainMesh(const PointView& points, const WeightView& heights,
  const ConstraintView& constraints, const TerrainMeshOptions& terrain,
  const Options& options = Options());

}

#endif
