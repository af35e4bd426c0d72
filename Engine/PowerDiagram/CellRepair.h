// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Repair of cells that rounding has broken: it may turn a thin cell over, or move a corner across
/// an edge.
///
/// Corners a few units apart are merged, tips are cut off, and what has no inside goes to a
/// neighbour. Each step keeps the pairing of edges: every edge inside the domain is there once in
/// either direction. Cells that pair so sum to the domain wherever their corners are. So once each
/// is simple and counter-clockwise (PlanarRings.h, exact signs), they fill the domain without gap
/// or overlap. Where all rounded cells are convex, nothing is changed.
#ifndef flipflop_CellRepair_h
#define flipflop_CellRepair_h

#include "Support/Monitor.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

/// Polygons that fill a domain edge to edge, but for the rounding of their corners: every edge is
/// there once in either direction, or lies on its border.
struct RoundedCells
{
  std::vector<double> positions;      ///< two for each corner, no position twice
  std::vector<std::uint32_t> corners; ///< of every cell: indices of positions (pairs)
  std::vector<std::int64_t> ends;     ///< where cells begin in corners; one more than cells
  std::vector<std::int64_t> ids;      ///< of the cells' sites
};

/// Is every cell convex, so that nothing is to be mended?
/// @param cells    as rounded; those around them may be missing
/// @param polygon  as for repairCells
bool areConvex(const RoundedCells& cells, const std::vector<double>& polygon, Monitor& monitor);

/// Make every cell a simple polygon, counter-clockwise, so that the cells fill the polygon; for the
/// means see PowerDiagram. Where every cell is convex already, nothing changes; else corners are
/// renumbered, in order of first use.
///
/// @param cells    as rounded, also those without an inside
/// @param polygon  what the cells fill (domainCorners()): its corners stay. Its sides are rounded:
///                 a cell without an inside that no other can take is omitted
/// @param monitor  is polled
void repairCells(RoundedCells& cells, const std::vector<double>& polygon, Monitor& monitor);

}

#endif
