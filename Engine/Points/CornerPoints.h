// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points nearest to the corners of a bounding box, in the sum of their coordinates: of boxes
/// and grids they are the corners.
#ifndef flipflop_CornerPoints_h
#define flipflop_CornerPoints_h

#include "Points/PointSource.h"
#include "Support/Monitor.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

/// For each of the eight corners the lowest id of the furthest points: ascending ids.
/// @param source finite points
std::vector<std::uint32_t> cornerPoints(const PointSource& source, Monitor& monitor);

}

#endif
