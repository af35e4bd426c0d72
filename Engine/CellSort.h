// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The order of cells in a result.
#ifndef flipflop_CellSort_h
#define flipflop_CellSort_h

#include "Buffer.h"
#include "Parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// A triangle, lowest corner first; or a polygon's first two corners and, past all corners, its
/// number.
struct Cell
{
  std::uint32_t corner[3];
};

/// Brings cells into lexicographic order. A directed edge is in one cell only, so the first two
/// corners tell.
///
/// Two passes over the cells, by pieces that may run in parallel: the first counts, the second
/// moves each cell to a bucket of neighbouring first corners. A bucket then is sorted in the cache.
class CellSort
{
public:
  CellSort(std::size_t cornerCount, std::size_t pieceCount)
    : pointCount(cornerCount)
    , shift(12)
  {
    while (this->pointCount >> this->shift > 512)
    {
      ++this->shift;
    }
    this->bucketCount = (this->pointCount >> this->shift) + 1;
    this->next.assign(this->bucketCount * pieceCount, 0);
  }

  void count(std::size_t piece, std::uint32_t first) { ++this->cursor(piece, first); }

  /// @param memory for the cells, where it is enough
  template <class Any>
  void endCounting(Buffer<Any>&& memory)
  {
    std::uint32_t total = 0;
    this->bucketBegin.reserve(this->bucketCount + 1);
    for (std::size_t bucket = 0; bucket < this->bucketCount; ++bucket)
    {
      this->bucketBegin.push_back(total);
      for (std::size_t at = bucket; at < this->next.size(); at += this->bucketCount)
      {
        const std::uint32_t n = this->next[at];
        this->next[at] = total;
        total += n;
      }
    }
    this->bucketBegin.push_back(total);
    this->cells = Buffer<Cell>::recycle(std::move(memory), total);
  }

  void put(std::size_t piece, const Cell& cell)
  {
    this->cells[this->cursor(piece, cell.corner[0])++] = cell;
  }

  /// After all are put.
  const Buffer<Cell>& sort()
  {
    eachTask(this->bucketCount, [&](std::size_t bucket) { this->sortBucket(bucket); });
    return this->cells;
  }

private:
  std::uint32_t& cursor(std::size_t piece, std::uint32_t first)
  {
    return this->next[piece * this->bucketCount + (first >> this->shift)];
  }

  void sortBucket(std::size_t bucket)
  {
    const std::size_t lowest = bucket << this->shift;
    Cell* const begin = this->cells.begin() + this->bucketBegin[bucket];
    Cell* const end = this->cells.begin() + this->bucketBegin[bucket + 1];
    const std::vector<Cell> unsorted(begin, end);
    const std::size_t corners =
      std::min(std::size_t(1) << this->shift, this->pointCount - lowest); // first ones, that is
    std::vector<std::uint32_t> place(corners + 1);
    for (const Cell& cell : unsorted)
    {
      ++place[cell.corner[0] - lowest + 1];
    }
    for (std::size_t v = 1; v < place.size(); ++v)
    {
      place[v] += place[v - 1];
    }
    for (const Cell& cell : unsorted)
    {
      begin[place[cell.corner[0] - lowest]++] = cell;
    }
    std::uint32_t from = 0;
    for (const std::uint32_t to : place)
    {
      std::sort(begin + from, begin + std::max(from, to),
        [](const Cell& a, const Cell& b) { return a.corner[1] < b.corner[1]; });
      from = to;
    }
  }

  std::size_t pointCount;
  int shift; ///< a bucket has 2^shift first corners
  std::size_t bucketCount;
  std::vector<std::uint32_t>
    next; ///< by piece, then bucket: how many cells, then where the next goes
  std::vector<std::uint32_t> bucketBegin;
  Buffer<Cell> cells;
};

}

#endif
