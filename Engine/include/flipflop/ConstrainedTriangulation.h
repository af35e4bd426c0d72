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
  /// The last so many are sides of polygons: see PolygonRule. They close: at each position, an even
  /// number of them ends.
  std::int64_t sides = 0;

  /// No constraint.
  ConstraintView() = default;

  /// @p n constraints, by the ids of their ends; the last @p polygonSides are sides of polygons.
  ConstraintView(const std::int64_t* ids, std::int64_t n, std::int64_t polygonSides = 0)
    : ends(ids)
    , count(n)
    , sides(polygonSides)
  {
  }
};

/// The constraints along a chain of points, in the order in which all layers number them: between
/// consecutive ids; last, of a ring, from its last id to its first, unless they are the same.
/// @param ids    of the points, with operator[]
/// @param count  how many
/// @param isRing whether the chain is one
/// @param use    void (std::int64_t from, std::int64_t to)
template <class Ids, class Use>
void eachConstraintAlong(const Ids& ids, std::int64_t count, bool isRing, const Use& use)
{
  for (std::int64_t i = 1; i < count; ++i)
  {
    use(ids[i - 1], ids[i]);
  }
  if (isRing && count > 0 && ids[count - 1] != ids[0])
  {
    use(ids[count - 1], ids[0]);
  }
}

/// A triangulation that has its constraints as edges. As polygons, a cell is all points of one
/// circle that no constraint parts.
struct ConstrainedTriangulation : Triangulation
{
  /// The edges that constraints run along, two corners each: indices into pointIds, the lower one
  /// first. In lexicographic order.
  Buffer<std::int64_t> fixedEdges;

  /// For each of these edges the first constraint that runs along it.
  Buffer<std::int64_t> constraintOf;

  /// For each of these edges, how many sides of polygons run along it from its lower corner to the
  /// other, less those that run back. In dimension 1, where nothing is inside, 0.
  Buffer<std::int64_t> balance;

  /// For each of these edges the first constraint that is a side of a polygon and runs along it the
  /// way of which there are more; -1 where the balance is 0.
  Buffer<std::int64_t> sideOf;

  /// How many constraints are sides of polygons.
  std::int64_t sides = 0;
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
/// @param constraints in any order and direction, none of which changes the triangulation. Sides of
///                    polygons do not either: cellsInside finds what is inside
/// @param options     see Options
/// @return the triangulation in its canonical form, which is the same for any number of threads;
///         without constraints, that of regularTriangulation
/// @throw Error       ConstraintPoint, ConstraintsCross, NonFinite, TooManyPoints, OutOfMemory,
///                    Aborted, BadArgument
ConstrainedTriangulation constrainedTriangulation(
  const PointView& points, const ConstraintView& constraints, const Options& options = Options());

/// Which cells are inside the polygons whose sides were among the constraints. Without polygons,
/// and where all points are on one line, all cells are inside.
///
/// By PolygonRule::EvenOdd, a way from outside of the convex hull to a cell that is inside crosses
/// an odd number of sides, whatever their direction. So a polygon keeps its inside, and one in it
/// is a hole, to any depth. Each side counts, so a polygon that is there twice keeps nothing, and
/// two that share a side are as one. See also cellsInsideFeatures.
///
/// By PolygonRule::Direction, as vtkDelaunay2D has it, what is on the left of a side is inside,
/// what is on its right is not. So a counter-clockwise polygon keeps its inside, and a clockwise
/// one in it is a hole, to any depth; and a clockwise one alone is a hole in all. Edges with a
/// balance of 0 part nothing.
///
/// @param triangulation as constrainedTriangulation gave it
/// @param inside        space for one byte a cell: 1 if it is inside
/// @param options       see Options; only the rule, the threads and the progress count
/// @return              how many cells are inside
/// @throw Error         PolygonsDisagree (by direction), BadArgument (no array for the results,
///                      indices out of range, sides that do not close), OutOfMemory, Aborted
std::int64_t cellsInside(const ConstrainedTriangulation& triangulation, std::uint8_t* inside,
  const Options& options = Options());

/// Which cells are inside the union of features: inside one of them or more, each by the even-odd
/// rule for its own sides alone. So features that overlap, or that are there twice, do not cancel.
///
/// @param triangulation as constrainedTriangulation gave it
/// @param points        which it was given
/// @param constraints   which it was given; their ends are the lowest ids of their positions, as in
///                      JoinedLines, and in SplitConstraints of these
/// @param featureOf     for each side of a polygon the feature that it is of, by any number
/// @param inside        space for one byte a cell: 1 if it is inside
/// @param options       see Options; only the threads and the progress count
/// @return              how many cells are inside
/// @throw Error         BadArgument (no array for the features or the results, constraints or
///                      points of another triangulation, an end that is not the lowest id of its
///                      position (index: it), sides of a feature that do not close), OutOfMemory,
///                      Aborted
std::int64_t cellsInsideFeatures(const ConstrainedTriangulation& triangulation,
  const PointView& points, const ConstraintView& constraints, const std::int64_t* featureOf,
  std::uint8_t* inside, const Options& options = Options());

}

#endif
