// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lines that have points of their own, such as breaklines, joined to the points to triangulate.
///
/// First joinLines: what comes out are the points to triangulate, and constraints by their ids.
/// Then splitCrossings, if lines may cross, and constrainedTriangulation. Last lineHeights, if
/// points and lines have heights: the heights of the points that were added, and where those that
/// were given for one position differ.
#ifndef flipflop_JoinedLines_h
#define flipflop_JoinedLines_h

#include <flipflop/Buffer.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/ConstraintCrossings.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>

namespace flipflop
{

/// Points, and after them those of lines that are at other positions.
struct JoinedLines
{
  /// For each point of the lines the id of the joined point at its position; -1 if no constraint
  /// ends there.
  Buffer<std::int64_t> pointOf;

  /// For each added point the first of the lines' points that is there, ascending. Added point k
  /// has the id k plus the number of given points.
  Buffer<std::int64_t> added;

  /// x and y of all joined points: those given, then those added.
  Buffer<double> positions;

  /// The constraints by ids of joined points, two for each.
  Buffer<std::int64_t> ends;

  /// How many constraints, the last ones, are sides of polygons.
  std::int64_t sides = 0;

  /// The joined points; valid as long as their memory.
  PointView points() const
  {
    return PointView(
      this->positions.data(), static_cast<std::int64_t>(this->positions.size() / 2), 2);
  }

  /// The constraints between them; valid as long as their memory.
  ConstraintView view() const
  {
    return { this->ends.data(), static_cast<std::int64_t>(this->ends.size() / 2), this->sides };
  }
};

/// Join lines to points. A line's point at the x and y of a given point is that point, the lowest
/// id there; points of lines at one position are one. Points that no constraint names are not
/// joined.
///
/// The result does not depend on the number of threads, nor on the direction of the constraints.
///
/// @param points      as for constrainedTriangulation: only x and y are read
/// @param linePoints  x and y of the lines' points
/// @param constraints by the ids of the lines' points
/// @param options     see Options; facets do not count. Points that are not finite are by its
///                    policy; lines' points have to be finite
/// @return            the joined points and constraints
/// @throw Error       ConstraintPoint (index: the constraint, count: the lines' point, which is out
///                    of range or not finite), NonFinite, TooManyPoints, OutOfMemory, Aborted,
///                    BadArgument
JoinedLines joinLines(const PointView& points, const PointView& linePoints,
  const ConstraintView& constraints, const Options& options = Options());

/// Heights of joined points.
struct LineHeights
{
  /// Of each point after the given ones: those that lines added, then those of crossings. At a
  /// line's point its own; where several are at one position, that of the first. At a crossing that
  /// of the first constraint that was split there.
  Buffer<double> added;

  /// Of each joined point, then of each crossing, the lowest and the highest of all heights that
  /// are given there: by a point, and by each line that ends there or runs through. NaN counts only
  /// where there is no other.
  Buffer<double> ranges;

  /// At how many of these points the two differ.
  std::int64_t differing = 0;
};

/// The heights of joined points. A constraint's height at a point inside it is linear between those
/// of its ends, rounded to the nearest double: at a share of the way that is exact, along x or y,
/// in which it is longer.
///
/// @param points        x, y and height of the given points
/// @param linePoints    x, y and height of the lines' points
/// @param constraints   as joinLines was given them
/// @param joined        what it gave
/// @param split         what splitCrossings made of that; as it is by default, with no pieces, if
///                      it was not called
/// @param triangulation of these points with these constraints: which points lines run through
/// @param options       see Options; only the progress counts
/// @return              the heights
/// @throw Error         BadArgument (numbers of points and constraints that do not fit each other),
///                      OutOfMemory, Aborted
LineHeights lineHeights(const PointView& points, const PointView& linePoints,
  const ConstraintView& constraints, const JoinedLines& joined, const SplitConstraints& split,
  const ConstrainedTriangulation& triangulation, const Options& options = Options());

}

#endif
