// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which of many segments cross: a tree of their boxes (SegmentTree.h) is joined with itself. Where
/// two boxes meet, their halves are examined, down to the segments, of which an exact sign decides.
#ifndef flipflop_CrossingPairs_h
#define flipflop_CrossingPairs_h

#include "Constraints/Position.h"
#include "Support/Monitor.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

using CrossingPair = std::pair<std::uint32_t, std::uint32_t>;

/// All pairs of segments that cross (see doCross), the lower index first, in lexicographic order.
/// @param comparisons where not null: how often two boxes were compared
/// @throw Error TooManyPoints, Aborted
std::vector<CrossingPair> crossingPairs(const std::vector<Position>& positions,
  const std::vector<PositionSegment>& segments, Monitor& monitor,
  std::int64_t* comparisons = nullptr);

}

#endif
