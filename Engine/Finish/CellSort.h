// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The order of cells in a result.
#ifndef flipflop_CellSort_h
#define flipflop_CellSort_h

#include "Support/BucketSort.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// A triangle, lowest corner first; or a polygon's first two corners and, past all corners, its
/// number.
struct Cell
{
  std::uint32_t corner[3];

  struct First
  {
    std::uint32_t operator()(const Cell& cell) const { return cell.corner[0]; }
  };
};

/// Brings cells into lexicographic order. A directed edge is in one cell only, so the first two
/// corners show.
class CellSort : public BucketSort<Cell, Cell::First>
{
public:
  using BucketSort::BucketSort;

  /// After all are put.
  Buffer<Cell> sort()
  {
    return BucketSort::sort(
      [](std::uint32_t, Cell* begin, Cell* end, std::size_t) { orderBySecond(begin, end); });
  }

  /// The same of triangles.
  /// @param connectivity their corners go there, in order
  void sortTriangles(std::int64_t* connectivity)
  {
    BucketSort::sort(
      [connectivity](std::uint32_t, Cell* begin, Cell* end, std::size_t first)
      {
        constexpr std::ptrdiff_t Few = 16;
        std::int64_t* const out = connectivity + 3 * first;
        const std::ptrdiff_t count = end - begin;
        if (count > Few)
        {
          orderBySecond(begin, end);
        }
        // Two or three are usual, in random order: to count those before each is faster than to
        // branch on what is unpredictable.
        for (std::ptrdiff_t i = 0; i < count; ++i)
        {
          std::ptrdiff_t rank = i;
          if (count <= Few)
          {
            rank = 0;
            for (std::ptrdiff_t k = 0; k < count; ++k)
            {
              rank += begin[k].corner[1] < begin[i].corner[1] ? 1 : 0;
            }
          }
          std::copy(begin[i].corner, begin[i].corner + 3, out + 3 * rank);
        }
      });
  }

private:
  static void orderBySecond(Cell* begin, Cell* end)
  {
    std::sort(begin, end, [](const Cell& a, const Cell& b) { return a.corner[1] < b.corner[1]; });
  }
};

}

#endif
