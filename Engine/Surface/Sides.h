// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The edges of cells, found by sorting: the sides that run along one edge meet.
#ifndef flipflop_Sides_h
#define flipflop_Sides_h

#include "Support/Parallel.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cstdint>

namespace flipflop
{

/// One side of a cell, from a corner to the next.
struct CellSide
{
  std::uint32_t low, high; ///< ends, the lower one first
  std::uint32_t place;     ///< of the side, in any numbering

  CellSide() = default;
  CellSide(std::uint32_t from, std::uint32_t to, std::uint32_t place)
    : low(std::min(from, to))
    , high(std::max(from, to))
    , place(place)
  {
  }
};

/// use (const CellSide* begin, const CellSide* end) for each edge: the sides that run along it, by
/// place.
template <class Use>
void eachEdge(Buffer<CellSide>& sides, Use&& use)
{
  threads::sort(sides.begin(), sides.end(),
    [](const CellSide& a, const CellSide& b)
    {
      return a.low != b.low ? a.low < b.low
        : a.high != b.high  ? a.high < b.high
                            : a.place < b.place;
    });
  for (const CellSide* side = sides.begin(); side != sides.end();)
  {
    const CellSide* end = side + 1;
    while (end != sides.end() && side->low == end->low && side->high == end->high)
    {
      ++end;
    }
    use(side, end);
    side = end;
  }
}

}

#endif
