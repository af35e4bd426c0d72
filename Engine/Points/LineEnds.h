// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points on few lines along an axis, such as those of a cylinder or an extruded outline, or on few
/// positions: only the two ends of each line can be extreme.
#ifndef flipflop_LineEnds_h
#define flipflop_LineEnds_h

#include "Points/PointSource.h"
#include "Support/Monitor.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

/// The ends of the lines that the points are on, by the lowest ids; ascending. Empty where a sample
/// shows many lines along each axis.
/// @param most lines, up to 2048
std::vector<std::uint32_t> lineEnds(
  const PointSource& source, std::uint32_t most, bool checkFinite, Monitor& monitor);

}

#endif
