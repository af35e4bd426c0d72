// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The border of some cells as closed polylines, as maps have it.
#ifndef flipflop_CellBoundary_h
#define flipflop_CellBoundary_h

#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>

#include <cstdint>

namespace flipflop
{

/// Closed polylines, each a simple ring: no corner is in it twice. Cells are on the left, so a ring
/// around cells is counter-clockwise, and one around a hole is clockwise. Rings may share corners,
/// but do not cross. Each starts at its lowest corner; rings are in lexicographic order.
struct CellBoundary
{
  /// The corners of all rings, one ring after another: indices into the complex's pointIds. The
  /// first corner of a ring is not repeated at its end.
  Buffer<std::int64_t> connectivity;

  /// Where each ring begins in connectivity, ascending from 0; then the size of connectivity.
  Buffer<std::int64_t> offsets;

  /// How many rings there are.
  std::int64_t ringCount() const
  {
    return this->offsets.empty() ? 0 : static_cast<std::int64_t>(this->offsets.size()) - 1;
  }
};

/// The border of a complex's cells: the edges that only one cell has. Two cells that meet in a
/// corner alone have a ring each. A hole that touches the outer border in a corner has a ring of
/// its own, as maps want it (OGC Simple Features: the inside of a polygon is connected, and its
/// rings are simple).
/// @param cells   of a triangulation in the plane, some of which may be missing; in triangles or
///                polygons. Below dimension 2 there is no border.
/// @param options only the threads and the progress function are used
/// @return        the rings
/// @throw Error   BadArgument (a complex that has not the form which CellComplex promises; a
///                dimension of 3; more than two cells at an edge, or two on the same side),
///                TooManyPoints, OutOfMemory, Aborted
CellBoundary cellBoundary(const CellComplex& cells, const Options& options = Options());

}

#endif
