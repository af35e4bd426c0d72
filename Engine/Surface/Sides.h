// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The edges of cells, found by sorting: the sides that run along one edge meet.
#ifndef flipflop_Sides_h
#define flipflop_Sides_h

#include "Support/Parallel.h"
#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// One side of a cell, from a corner to the next.
struct CellSide
{
  std::uint32_t low, high; ///< ends, the lower one first
  std::uint32_t index;     ///< of the side, in any numbering

  CellSide() = default;
  CellSide(std::uint32_t from, std::uint32_t to, std::uint32_t index)
    : low(std::min(from, to))
    , high(std::max(from, to))
    , index(index)
  {
  }
};

/// The sides of all cells, placed as in the connectivity: a side leads from its corner to the
/// cell's next one. Below dimension 2 it is a corner alone.
/// @param cellOf the cell of each side
inline Buffer<CellSide> sidesOf(const CellComplex& complex, Buffer<std::uint32_t>& cellOf)
{
  constexpr std::size_t CellsPerTask = 1 << 13;
  Buffer<CellSide> sides(complex.connectivity.size());
  cellOf.allocate(complex.connectivity.size());
  eachChunk(static_cast<std::size_t>(complex.cellCount()), CellsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t cell = begin; cell < end; ++cell)
      {
        const std::int64_t from = complex.cellBegin(static_cast<std::int64_t>(cell));
        const std::int64_t to = complex.cellBegin(static_cast<std::int64_t>(cell) + 1);
        for (std::int64_t k = from; k < to; ++k)
        {
          const auto corner = static_cast<std::uint32_t>(complex.connectivity[k]);
          const auto next =
            static_cast<std::uint32_t>(complex.connectivity[k + 1 < to ? k + 1 : from]);
          sides[k] =
            CellSide(corner, complex.dimension < 2 ? corner : next, static_cast<std::uint32_t>(k));
          cellOf[k] = static_cast<std::uint32_t>(cell);
        }
      }
    });
  return sides;
}

/// use (const CellSide* begin, const CellSide* end) for each edge: the sides that run along it, by
/// index.
template <class Use>
void eachEdge(Buffer<CellSide>& sides, Use&& use)
{
  threads::sort(sides.begin(), sides.end(),
    [](const CellSide& a, const CellSide& b)
    {
      return a.low != b.low ? a.low < b.low
        : a.high != b.high  ? a.high < b.high
                            : a.index < b.index;
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
