// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// ffHull: the exact convex hull of points in R3.
#ifndef flipflop_ConvexHull_h
#define flipflop_ConvexHull_h

#include "Hull.h"
#include "Options.h"
#include "PointView.h"

namespace flipflop
{

/// The exact convex hull of @p points (paper, Algorithm 2), for every finite input: no tolerance
/// decides anything. Duplicates are one point, their lowest id; points inside a facet or an edge
/// are not part.
///
/// At most 2^32 - 2 points; hulls with more than about 5e8 vertices are beyond 32-bit half-edges.
///
/// @throw Error NonFinite (by policy), TooManyPoints, OutOfMemory, Aborted, BadArgument.
Hull convexHull(const PointView& points, const Options& options = Options());

}

#endif
