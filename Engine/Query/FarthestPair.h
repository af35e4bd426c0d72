// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The two corners of a hull that are farthest from each other: branch and bound over pairs of
/// boxes.
///
/// Two bounds keep pairs of boxes away. One is the distance of the boxes' far corners. The other is
/// the law of the parallelogram: for vectors a, b from any centre, |a - b|^2 = 2|a|^2 + 2|b|^2 -
/// |a + b|^2, and a + b leads from the mirror image of b to a. So where a sphere's points all are
/// nearly as far from some other, boxes that are not opposite each other are let go at once.
///
/// Bounds and distances are rounded, with a margin. What lies within it of the longest is compared
/// exactly.
#ifndef flipflop_FarthestPair_h
#define flipflop_FarthestPair_h

#include "Points/Vertex.h"
#include "Support/Monitor.h"

#include <cstdint>

namespace flipflop
{

/// The lower corner first.
struct CornerPair
{
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

/// Of all farthest pairs the lexicographically least.
/// @param corners, count 1 or more, all different
/// @param isWide  they need wide integers
/// @throw Error   OutOfMemory, Aborted
CornerPair farthestPair(const Vertex* corners, std::uint32_t count, bool isWide, Monitor& monitor);

}

#endif
