// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Many point sets in one call: each gets the result that a call of its own would give.
#ifndef flipflop_Batch_h
#define flipflop_Batch_h

#include <flipflop/Error.h>
#include <flipflop/Hull.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Sets of points that lie one behind the other in an array: set i has the points from offsets[i]
/// up to offsets[i + 1], the latter not included. A set may be empty. Points before the first
/// offset and from the last one on are in no set.
struct SetView
{
  /// One more than there are sets, ascending, from 0 up to the number of points; may be null where
  /// there is no set.
  const std::int64_t* offsets = nullptr;
  std::int64_t count = 0; ///< sets
};

/// What went wrong with one set of a batch.
struct SetError
{
  std::size_t set; ///< its number
  Error error; ///< what a call on this set alone throws: index() counts from the set's first point
};

/// What came of a batch.
///
/// A result each, not the sets' cells in common arrays: a result's arrays can be handed on without
/// a copy, and are what all else here takes and gives.
/// @tparam Result Hull or Triangulation
template <class Result>
struct Batch
{
  /// One for each set, with ids from 0 on in each. That of a set at fault is as of no point.
  std::vector<Result> results;
  std::vector<SetError> errors; ///< the sets at fault, ascending; empty: there is none
};

/// convexHull() for each of many sets.
///
/// Sets with more than a thread's share of all points, and enough for several threads, are run one
/// after another, each by as many as it is worth; then the others side by side, each by one. The
/// results' bits are those of calls for each set alone, for any number of threads.
///
/// @param points  of all sets: any number of them, up to 2^32 - 2 in a set
/// @param sets    see SetView
/// @param options for each set. Progress is that of the whole batch, by points, told on the calling
///                thread only. A request to stop is heeded by all threads, but waits where the
///                calling thread has no set left and others still run theirs.
/// @return a result for each set, and the errors of those at fault: NonFinite (by policy),
///         TooManyPoints, OutOfMemory, Internal. They do not touch other sets' results.
/// @throw Error BadArgument (index(): the first set whose offsets descend or leave the array; -1
///              where it is another argument), WeightCount, OutOfMemory (there is no room for a
///              result each), Aborted: then there are no results
Batch<Hull> convexHulls(
  const PointView& points, const SetView& sets, const Options& options = Options());

/// The same for triangulations, whose points may have weights.
/// @param points, sets, options as for hulls
/// @param weights one for each of the points, whether they are in a set or not; or none
Batch<Triangulation> regularTriangulations(const PointView& points, const SetView& sets,
  const WeightView& weights = WeightView(), const Options& options = Options());

}

#endif
