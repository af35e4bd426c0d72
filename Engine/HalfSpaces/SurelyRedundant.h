// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Half-spaces that are redundant by more than rounding can matter: most of many are.
#ifndef flipflop_SurelyRedundant_h
#define flipflop_SurelyRedundant_h

#include "Support/Monitor.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

/// Those of which the dual point, a little further from the origin, is inside the hull of some
/// others' (HullQueries).
///
/// Rounded dual points are off by a share of 2^-52 at most, so hulls by that of the longest, L.
/// With r for the hull's least height above the origin, a point p for which (1 + s) p is in the
/// hull of rounded points is at least s / (1 + s) r inside of each of its planes: more than both
/// errors, if s r is more than 2^-50 L.
/// @param duals dual points of half-spaces, three coordinates each, rounded to nearest
/// @return ids, ascending
/// @throw Error OutOfMemory, Aborted
std::vector<std::uint32_t> surelyRedundant(
  const std::vector<double>& duals, int threads, Monitor& monitor);

}

#endif
