// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells of the plane without long edges.
#ifndef flipflop_EdgeLengths_h
#define flipflop_EdgeLengths_h

#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>

namespace flipflop
{

/// Which cells of a triangulation have no edge longer than a limit. That is decided exactly, at
/// every range: an edge as long as the limit is not longer. The edges of a polygon are those of its
/// border; a cell of one corner has none.
/// @param points        as they were triangulated; x and y are read
/// @param triangulation of these points; dimension -1 to 2, in triangles or polygons
/// @param limit         a length, 0 or more; infinity: no edge is longer
/// @param within        receives 1 for each cell without a longer edge, 0 for each other
/// @param options       only the threads and the progress function are used
/// @return              how many cells have no longer edge
/// @throw Error         BadArgument (a limit that is negative or NaN, no array for the results, a
///                      dimension of 3, an index or id out of range, a corner that is not finite),
///                      TooManyPoints, OutOfMemory, Aborted
std::int64_t cellsWithinEdgeLength(const PointView& points, const CellComplex& triangulation,
  double limit, std::uint8_t* within, const Options& options = Options());

/// Leave cells out. The others stay in their order, and all points stay.
/// @param complex of any cells
/// @param kept    one for each cell; 0: it goes
void keepCells(CellComplex& complex, const std::uint8_t* kept);

}

#endif
