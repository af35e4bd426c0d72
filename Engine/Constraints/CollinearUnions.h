// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The unions of segments that overlap on a line. What is found along a union is found once for
/// all its segments, however many of them are nested.
#ifndef flipflop_CollinearUnions_h
#define flipflop_CollinearUnions_h

#include "Constraints/Position.h"
#include "Support/Monitor.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

struct CollinearUnions
{
  std::vector<PositionSegment> unions; ///< from their lower positions
  std::vector<std::uint32_t> unionOf;  ///< by segment
};

/// Unions of segments that have more than an end in common. Lines are compared exactly.
/// @param segments from their lower positions
/// @throw Error Aborted
CollinearUnions collinearUnions(const std::vector<Position>& positions,
  const std::vector<PositionSegment>& segments, Monitor& monitor);

}

#endif
