// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact constrained Delaunay triangulation in the plane.
///
/// Constraints are segments between points. The triangulation has them as edges, and all its other
/// edges are Delaunay as far as the constraints let points see each other (L. P. Chew, "Constrained
/// Delaunay triangulations", 1989): no point that can be seen from inside a triangle lies inside
/// its circumcircle.
#ifndef flipflop_ConstrainedTriangulation_h
#define flipflop_ConstrainedTriangulation_h

#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <cstdint>

namespace flipflop
{

/// A read-only view of @c count constraints. Constraint i joins the points of ids ends[2 * i] and
/// ends[2 * i + 1].
struct ConstraintView
{
  const std::int64_t* ends = nullptr; ///< null only if count is 0
  std::int64_t count = 0;             ///< constraints

  /// No constraint.
  ConstraintView() = default;

  /// @p n constraints, by the ids of their ends.
  ConstraintView(const std::int64_t* ids, std::int64_t n)
    : ends(ids)
    , count(n)
  {
  }
};

/// A triangulation that has its constraints as edges. As polygons, a cell is all points of one
/// circle that no constraint parts.
struct ConstrainedTriangulation : Triangulation
{
  /// The edges that constraints run along, two corners each: indices into pointIds, the lower one
  /// first. In lexicographic order.
  Buffer<std::int64_t> fixedEdges;

  /// For each of these edges the first constraint that runs along it.
  Buffer<std::int64_t> constraintOf;
};

/// The constrained Delaunay triangulation of all points, whatever their number and position.
///
/// A constraint through points is parted there. One that ends at a duplicate ends at the lowest id
/// of that position. One between two points of one position has no effect; nor has one that is
/// there again, or reversed. Points on a line have their chain, which has all constraints.
///
/// There are no weights: a constraint could then part a hidden point from what hides it, and the
/// flips that should bring it back would have to insert it.
///
/// @param points      as for regularTriangulation
/// @param constraints in any order and direction, none of which changes the triangulation
/// @param options     see Options
/// @return the triangulation in its canonical form, which is the same for any number of threads;
///         without constraints, that of regularTriangulation
/// @throw Error       ConstraintPoint, ConstraintsCross, NonFinite, TooManyPoints, OutOfMemory,
///                    Aborted, BadArgument
ConstrainedTriangulation constrainedTriangulation(
  const PointView& points, const ConstraintView& constraints, const Options& options = Options());

}

#endif
