// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The edges of the border of a triangulation.
#ifndef flipflop_BorderEdges_h
#define flipflop_BorderEdges_h

#include <flipflop/CellComplex.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
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
  std::vector<std::pair<std::size_t, std::size_t>> found;
  eachSide(
    [&](std::size_t from, std::size_t to)
    {
      if (balance[from] != 0 && balance[to] != 0)
      {
        found.emplace_back(from, to);
      }
    });
  std::sort(found.begin(), found.end());
  for (const auto& [from, to] : found)
  {
    if (!std::binary_search(found.begin(), found.end(), std::make_pair(to, from)))
    {
      use(static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to));
    }
  }
}

}

#endif
