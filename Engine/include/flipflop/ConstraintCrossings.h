// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constraints that cross, split where they do.
///
/// constrainedTriangulation takes no constraints that cross between points. Here they are cut into
/// pieces that do not, with new points where they cross.
///
/// Constraints that cross are first divided at the points that are exactly on them, so all of these
/// stay on them: between two neighbouring ones, a constraint may bend.
///
/// A crossing is seldom at a position that doubles can represent. So a new point is the crossing
/// with each coordinate rounded to the nearest double, and constraints bend there, by half a unit
/// in the last place at most. What is bent may pass on the other side of a point that is as near
/// to it, and so cross what it did not cross before. Pieces that cross again are split again, in as
/// many rounds as it takes: at an end of one of them, if that is within two units of the other,
/// else at their own crossing, rounded. Nearly all inputs take one round, a few two. The rounds
/// come to an end: all pieces of a constraint climb or fall along either axis as it does, so each
/// split leaves two that are shorter, in units of their coordinates.
#ifndef flipflop_ConstraintCrossings_h
#define flipflop_ConstraintCrossings_h

#include <flipflop/Buffer.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>

namespace flipflop
{

/// Constraints in pieces that do not cross, and the points that this takes.
struct SplitConstraints
{
  /// The ids of both ends of each piece: the pieces of the first constraint, in its direction, then
  /// those of the next. An end of a constraint keeps its id. New point k has the id k plus the
  /// number of given points.
  Buffer<std::int64_t> ends;

  /// For each piece the constraint that it is of. Each constraint has one piece or more.
  Buffer<std::int64_t> constraintOf;

  /// The last so many pieces are of sides of polygons.
  std::int64_t sides = 0;

  /// x and y of each new point. They are in lexicographic order, all at different positions, none
  /// at that of a given point.
  Buffer<double> positions;

  /// For each new point the constraints that were split there, two or more, ascending; one point
  /// after another.
  Buffer<std::int64_t> crossing;

  /// Where those of each new point begin in crossing, ascending from 0; then the size of crossing.
  Buffer<std::int64_t> offsets;

  /// How often pieces were found to cross, and were split: 0 if no constraints cross; more than 1
  /// only where rounding made pieces cross again.
  std::int64_t rounds = 0;

  /// How many points are new.
  std::int64_t newPointCount() const
  {
    return static_cast<std::int64_t>(this->positions.size()) / 2;
  }

  /// The pieces, for constrainedTriangulation; valid as long as their memory.
  ConstraintView view() const
  {
    return { this->ends.data(), static_cast<std::int64_t>(this->constraintOf.size()), this->sides };
  }
};

/// Split constraints where they cross. Two cross where they meet in one position inside both. A
/// common end, an end of one inside the other, and overlaps along a line are no crossings:
/// constrainedTriangulation has them as they are.
///
/// In the first round all positions are those of the given constraints, correctly rounded. Where
/// one is, as rounded, the position of a given point, the constraints are split at this point, the
/// lowest id there; it is not new. A constraint that bends between two points on it is split at
/// these, too; at the others on it, constrainedTriangulation parts it.
///
/// The time is near-linear in the constraints and their crossings where constraints are short, or
/// few are long. The result does not depend on the number of threads, nor on the order and the
/// direction of the constraints, but for their numbers and the direction of their pieces. The
/// triangulation of the given points, and after them the new ones, with the pieces has no crossing.
///
/// @param points      as for constrainedTriangulation: only x and y are read
/// @param constraints as for constrainedTriangulation
/// @param options     see Options; facets do not count
/// @return            the pieces and the new points
/// @throw Error       ConstraintPoint, NonFinite, TooManyPoints (also of pieces, count: how many),
///                    OutOfMemory, Aborted, BadArgument
SplitConstraints splitCrossings(
  const PointView& points, const ConstraintView& constraints, const Options& options = Options());

}

#endif
