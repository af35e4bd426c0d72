// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The corner at which a cell in a box starts.
///
/// Before it is cut, a cell starts at a known position of its border. If that is not in the box,
/// the start moves along the border, counter-clockwise, to where this comes between the two sides
/// of x, and from there to where it comes between those of y.
#ifndef flipflop_StartInBox_h
#define flipflop_StartInBox_h

#include "Points/Vertex.h"
#include "PowerDiagram/CellRing.h"
#include "PowerDiagram/CornerNumbers.h"

#include <array>
#include <cstddef>

namespace flipflop
{

/// @param ring    what is left of the cell; the box is a polygon from boxCorners()
/// @param box     x least, x greatest, y least, y greatest
/// @param from    where the cell starts before it is cut, rounded
/// @param isEntry bool (side, x): does the border come in over that side of the box at @p x?
/// @return NoIndex: @p from is within the box, and no corner
template <class IsEntry>
CellRing::Index startInBox(const CellRing& ring, const std::array<double, 4>& box,
  const Position& from, const IsEntry& isEntry)
{
  constexpr std::size_t Bottom = 0, Right = 1, Top = 2, Left = 3;
  std::array<CellRing::Index, 4> ends = { NoIndex, NoIndex, NoIndex, NoIndex };
  CellRing::Index found = NoIndex;
  ring.eachFrom(ring.first(),
    [&](CellRing::Index i)
    {
      const RingCorner& corner = ring[i];
      if (corner.line < 0)
      {
        ends[static_cast<std::size_t>(sideLine(corner.line))] = corner.after;
      }
      found = corner.x[0] == from[0] && corner.x[1] == from[1] ? i : found;
    });
  if (found != NoIndex)
  {
    return found;
  }
  const std::size_t across = from[0] < box[0] ? Left : Right;
  if ((from[0] < box[0] || from[0] > box[1]) && ends[across] != NoIndex)
  {
    // At a corner of the box, the border came in beyond it, unless just there.
    const RingCorner& end = ring[ends[across]];
    const std::size_t next = (across + 1) % 4;
    const bool isCorner = end.line == sideLine(static_cast<std::int64_t>(next));
    return ends[isCorner && !isEntry(across, end.x) ? next : across];
  }
  // If it came in between the sides of x, that was beyond the side of y that it started beyond. A
  // position that was rounded to a side may be beyond it, too.
  const std::array<bool, 4> isBeyond = { from[1]<box[2], false, from[1]> box[3], false };
  const std::array<bool, 4> isOn = { from[1] == box[2], from[0] == box[1], from[1] == box[3],
    from[0] == box[0] };
  for (const std::array<bool, 4>& sides : { isBeyond, isOn })
  {
    for (const std::size_t side : { Bottom, Right, Top, Left })
    {
      if (sides[side] && ends[side] != NoIndex)
      {
        return ends[side];
      }
    }
  }
  return NoIndex;
}

}

#endif
