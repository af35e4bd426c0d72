// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of convexify() share: its expected hull, and exact facts about surfaces.
#ifndef flipflop_test_FlipFlopChecks_h
#define flipflop_test_FlipFlopChecks_h

#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Surfaces.h"

#include <optional>

namespace flipflop
{
namespace test
{

/// The hull of the points that triangles use, by their ids.
ReferenceHull hullOfUsed(const Surface& surface);

/// convexify() in every variant (threads, facets, V-biased, both orientations, kernel given or
/// found, float where the points are) is that hull. @return one of them, triangles, not V-biased.
Hull expectFlipFlop(const Surface& surface, const double* kernel);

/// Does the kernel strictly see the inside of every triangle? Exactly.
bool seesAll(const Surface& surface, const double* kernel);

/// The triangles that it does not see from inside.
std::vector<std::int64_t> unseen(const Surface& surface, const double* kernel);

/// A point that sees all, from the corners of the intersection of all half-spaces in rationals:
/// for few triangles.
/// @return false when no point sees all. Throws when one does, but no double was found that does.
bool findKernel(const Surface& surface, double* kernel);

/// Turn edges at random, @p times, as long as the surface stays star-shaped from the kernel.
Surface scrambled(Surface surface, const double* kernel, int times, std::uint64_t seed);

/// Flipping by the V-criterion alone, edges in random order.
struct VFlips
{
  int flips = 0;  ///< made
  int reflex = 0; ///< reflex edges left
};
VFlips flipByVAlone(const Surface& surface, const double* kernel, std::uint64_t seed);

/// The error that convexify() throws; none if it does not throw.
std::optional<ErrorCode> codeOf(const Surface& surface, const double* kernel);

}
}

#endif
