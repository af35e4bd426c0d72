// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The box of least volume around a hull, as far as a search finds it.
///
/// A least box has two sides next to each other that each run along an edge (J. O'Rourke, 1985). On
/// small hulls all pairs of edges are tried, and the box turned about each. Besides, boxes with one
/// axis given are found exactly, by the least rectangle around the projection: along facets'
/// normals and, where these are few, edges and directions all around. The best of these are
/// improved by turns: each axis of the box is kept in turn, and the two others are chosen again.
#ifndef flipflop_MinimalBox_h
#define flipflop_MinimalBox_h

#include "Query/PreparedHull.h"
#include "Support/Monitor.h"
#include <flipflop/HullQueries.h>

namespace flipflop
{

/// @param hull  of dimension 0 or more
/// @throw Error OutOfMemory, Aborted
OrientedBox minimalBoxOf(const PreparedHull& hull, Monitor& monitor);

}

#endif
