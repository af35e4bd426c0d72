// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which cells are next to which.
#ifndef flipflop_Neighbors_h
#define flipflop_Neighbors_h

#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>

#include <cstdint>

namespace flipflop
{

/// The neighbour of each cell across each of its edges. The result has an entry for each entry k of
/// the complex's connectivity: the cell on the other side of the edge that leads from this corner
/// to the cell's next one (after the last, to the first). -1: there is none, as at the border of a
/// triangulation, or around the polygon of a flat hull.
///
/// Below dimension 2, cells meet in corners: the entry is the other segment that ends at this
/// corner. -1: there is none.
/// @param complex a hull or a triangulation, in triangles or polygons; cells may be missing
/// @param options threads, progress
/// @throw Error   BadArgument (a complex that has not the form which CellComplex promises; index:
///                the first cell with an edge that more than one other cell shares), TooManyPoints
///                (more corners than 32-bit indices can name), OutOfMemory, Aborted
Buffer<std::int64_t> cellNeighbors(const CellComplex& complex, const Options& options = Options());

}

#endif
