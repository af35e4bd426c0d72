// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which of many segments cross.
///
/// A tree of boxes is joined with itself: where two boxes meet, their halves are examined, down to
/// the segments. A long segment would widen all boxes that it is in, so segments are taken in parts
/// no longer than the mean, at most twice as many as there are segments. Where most segments run
/// nearly the same way, boxes have a third side, across it (SegmentBundle.h): boxes along the axes
/// alone would all meet. Boxes are rounded outwards; what decides is an exact sign.
#ifndef flipflop_CrossingPairs_h
#define flipflop_CrossingPairs_h

#include "Constraints/Position.h"
#include "Support/Monitor.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// Its ends: indices of positions, which differ where the indices do.
struct PositionSegment
{
  std::uint32_t from, to;
};

/// All pairs of segments that cross (see doCross), the lower index first, in lexicographic order.
/// @param comparisons where not null: how often two boxes were compared
/// @throw Error TooManyPoints, Aborted
std::vector<std::pair<std::uint32_t, std::uint32_t>> crossingPairs(
  const std::vector<Position>& positions, const std::vector<PositionSegment>& segments,
  Monitor& monitor, std::int64_t* comparisons = nullptr);

}

#endif
