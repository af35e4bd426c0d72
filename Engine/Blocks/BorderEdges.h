// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The edges of the border of a triangulation.
#ifndef flipflop_BorderEdges_h
#define flipflop_BorderEdges_h

#include "Surface/Sides.h"
#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Edges that have a cell on their left alone: use (from, to), as indices of the complex' points.
///
/// Of a corner whose cells go all around, each neighbour is the next in one cell and the one before
/// in another. So the sums of both are equal there, and differ at the border, where one neighbour
/// of each kind is left over. Only edges between such corners are examined.
template <class Use>
void eachBorderEdge(const CellComplex& complex, const Use& use)
{
  std::vector<std::int64_t> balance(complex.pointIds.size(), 0);
  const auto eachSide = [&](const auto& visit)
  {
    for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
    {
      const std::int64_t begin = complex.cellBegin(cell);
      const std::int64_t end = complex.cellBegin(cell + 1);
      for (std::int64_t k = begin; k < end; ++k)
      {
        const std::int64_t next = k + 1 < end ? k + 1 : begin;
        visit(static_cast<std::size_t>(complex.connectivity[static_cast<std::size_t>(k)]),
          static_cast<std::size_t>(complex.connectivity[static_cast<std::size_t>(next)]));
      }
    }
  };
  eachSide(
    [&](std::size_t from, std::size_t to)
    {
      balance[from] += static_cast<std::int64_t>(to);
      balance[to] -= static_cast<std::int64_t>(from);
    });
  std::vector<std::array<std::uint32_t, 2>> openSides; // sides, each in its direction
  eachSide(
    [&](std::size_t from, std::size_t to)
    {
      if (balance[from] != 0 && balance[to] != 0)
      {
        openSides.push_back({ static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to) });
      }
    });
  Buffer<CellSide> sides(openSides.size());
  for (std::size_t i = 0; i < openSides.size(); ++i)
  {
    sides[i] = CellSide(openSides[i][0], openSides[i][1], static_cast<std::uint32_t>(i));
  }
  eachEdge(sides,
    [&](const CellSide* begin, const CellSide* end)
    {
      if (end - begin == 1)
      {
        use(openSides[begin->index][0], openSides[begin->index][1]);
      }
    });
}

}

#endif
