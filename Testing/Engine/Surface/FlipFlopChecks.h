// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of convexify() share: its expected hull, and exact facts about surfaces.
#ifndef flipflop_test_FlipFlopChecks_h
#define flipflop_test_FlipFlopChecks_h

#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/Inputs/Surfaces.h"

namespace flipflop
{
namespace test
{

/// The hull of the points that triangles use, by their ids.
ReferenceHull hullOfUsed(const Surface& surface);

/// convexify() in every variant (threads, facets, V-biased, both orientations, kernel given or
/// found, float where the points are) is that hull. @return one of them, triangles, not V-biased.
Hull expectFlipFlop(const Surface& surface, const Point& kernel = { 0, 0, 0 });

/// The triangles that the kernel does not strictly see from inside. Exactly.
std::vector<std::int64_t> unseen(const Surface& surface, const Point& kernel);
inline bool seesAll(const Surface& surface, const Point& kernel = { 0, 0, 0 })
{
  return unseen(surface, kernel).empty();
}

}
}

#endif
