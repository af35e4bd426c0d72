// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Many point sets in one call: each gets the result that a separate call would give.
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

/// Sets of points that lie one after another in an array: set i has the points from offsets[i]
/// up to offsets[i + 1], the latter not included. A set may be empty. Points before the first
/// offset, and points from the last offset on, are in no set.
struct SetView
{
  /// Number of sets plus one, ascending, from 0 up to the number of points; may be null if there is
  /// no set.
  const std::int64_t* offsets = nullptr;
  std::int64_t count = 0; ///< sets
};

/// What went wrong with one set of a batch.
struct SetError
{
  std::size_t set; ///< its number
  Error error; ///< what a call on this set alone throws: index() counts from the set's first point
};

/// What a batch gives.
///
/// There is a separate result for each set: its arrays can be handed on without a copy, and have
/// the form that all other functions here take and give.
/// @tparam Result Hull or Triangulation
template <class Result>
struct Batch
{
  /// One for each set; ids count from 0 in each set. A set at fault has the result of no point.
  std::vector<Result> results;
  std::vector<SetError> errors; ///< the sets at fault, ascending; empty if there is none
};

/// convexHull() for each of many sets.
///
/// Large sets come first: those with more than a thread's share of all points, and enough points
/// for several threads. They run one after another, each on as many threads as it can use. Then the
/// other sets run side by side, each on one thread. The results have the bits of separate calls for
/// each set, for any number of threads.
///
/// @param points  the points of all sets: any number, up to 2^32 - 2 in a set
/// @param sets    see SetView
/// @param options for each set. Progress is that of the whole batch, by points, reported on the
///                calling thread only. All threads obey a request to stop. It is delayed while the
///                calling thread has no set left and others still run theirs.
/// @return a result for each set, and the errors of the sets at fault: NonFinite (by policy),
///         TooManyPoints, OutOfMemory, Internal. They do not affect other sets' results.
/// @throw Error BadArgument (index(): the first set whose offsets descend or leave the array; -1
///              for another argument), WeightCount, OutOfMemory (no memory for the list of
///              results), Aborted: then there are no results
Batch<Hull> convexHulls(
  const PointView& points, const SetView& sets, const Options& options = Options());

/// regularTriangulation() for each of many sets. Points may have weights.
/// @param points, sets, options as for hulls
/// @param weights one for each of the points, whether it is in a set or not; or none
Batch<Triangulation> regularTriangulations(const PointView& points, const SetView& sets,
  const WeightView& weights = WeightView(), const Options& options = Options());

}

#endif
