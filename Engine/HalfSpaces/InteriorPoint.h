// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Is there a position strictly inside of half-spaces, and is their intersection bounded? Exact.
#ifndef flipflop_InteriorPoint_h
#define flipflop_InteriorPoint_h

#include "Support/Monitor.h"
#include <flipflop/HalfSpaces.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// Half-spaces of space, normal . x <= bound: four numbers each. Those of the plane have 0 for the
/// third.
using HalfSpaceRows = std::vector<double>;

/// The first half-space that does not hold c strictly inside; -1: there is none.
std::int64_t firstNotHolding(const HalfSpaceRows& rows, const double* c, Monitor& monitor);

/// Seek the position that is furthest inside, in units of the normals' largest numbers, by linear
/// programming: rounded, which exact signs accept; else exact, over the constraints that matter.
/// @param c receives it; the third coordinate is 0 in the plane
/// @return Flat or Empty, exactly; else Bounded, whether it is or not
/// @throw Error BadArgument: there is an inside, but no double was found in it; Aborted
Intersection findInterior(const HalfSpaceRows& rows, int dimension, double* c, Monitor& monitor);

/// Is the origin strictly inside the hull of the normals? Then an intersection that is not empty is
/// bounded. Exact.
/// @throw Error the errors of convexHull
bool areNormalsAllAround(const HalfSpaceRows& rows, int threads);

}

#endif
