// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which points are exactly on which segments.
#ifndef flipflop_PointsOnSegments_h
#define flipflop_PointsOnSegments_h

#include "Constraints/Position.h"
#include "Points/PointSource.h"
#include "Support/Monitor.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

struct PositionOnSegment
{
  std::uint32_t segment;
  Position position; ///< inside it
};

/// The positions of points inside segments, each once: by segments, and along each.
/// @param segments      from their lower positions; it takes the least memory if no two overlap
/// @param pointsPerTask how many are searched for together
/// @throw Error         TooManyPoints, Aborted
std::vector<PositionOnSegment> pointsOnSegments(const std::vector<Position>& positions,
  const std::vector<PositionSegment>& segments, const PointSource& source, Monitor& monitor,
  std::size_t pointsPerTask = std::size_t(1) << 16);

}

#endif
