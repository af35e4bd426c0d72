// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// ffHull: the exact convex hull of points in R3.
#ifndef flipflop_ConvexHull_h
#define flipflop_ConvexHull_h

#include <flipflop/Hull.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

namespace flipflop
{

/// The exact convex hull of @p points (paper, Algorithm 2), for every finite input: no tolerance
/// decides anything. Duplicates are one point, with their lowest id. Points inside a facet or an
/// edge are not part of the hull.
///
/// @param points  any number up to 2^32 - 2. About 5e8 of them may be vertices of the hull, since
///                half-edges are 32-bit
/// @param options see Options
/// @return the hull in its canonical form, which is the same for any number of threads
/// @throw Error   NonFinite (by policy), TooManyPoints, OutOfMemory, Aborted, BadArgument
Hull convexHull(const PointView& points, const Options& options = Options());

}

#endif
