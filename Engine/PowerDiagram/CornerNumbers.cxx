// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Several facets may have their centers at one position, and several cells a corner there that the
/// box made. One of these corners stands for all. Which, depends on the threads, and tells nothing.
/// But their first use is known once all threads have passed, and its order gives the number.
#include "PowerDiagram/CornerNumbers.h"

#include "Points/Vertex.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace flipflop
{
namespace
{

using Index = std::uint32_t;

/// Corners by their position: a hash table with open addressing, which any thread adds to.
class PositionTable
{
public:
  explicit PositionTable(std::size_t corners)
  {
    std::size_t size = 64;
    while (size < corners + corners / 2)
    {
      size *= 2;
    }
    this->slots = std::vector<std::atomic<Index>>(size);
  }

  /// The corner that stands for all at the position of @p corner.
  /// @param positionOf Position (corner)
  template <class PositionOf>
  Index find(Index corner, const PositionOf& positionOf)
  {
    const Position x = positionOf(corner);
    const std::size_t mask = this->slots.size() - 1;
    for (std::size_t i = hash(x) & mask;; i = (i + 1) & mask)
    {
      Index there = this->slots[i].load(std::memory_order_relaxed);
      if (there == Empty &&
        this->slots[i].compare_exchange_strong(there, corner + 1, std::memory_order_relaxed))
      {
        return corner;
      }
      if (positionOf(there - 1) == x)
      {
        return there - 1;
      }
    }
  }

private:
  static constexpr Index Empty = 0; ///< else a corner and one

  static std::size_t hash(const Position& x)
  {
    std::uint64_t a, b;
    std::memcpy(&a, &x[0], sizeof(a));
    std::memcpy(&b, &x[1], sizeof(b));
    a = (a ^ (b << 32 | b >> 32)) * 0x9e3779b97f4a7c15u;
    a = (a ^ (a >> 29) ^ b) * 0xbf58476d1ce4e5b9u;
    return a ^ (a >> 32);
  }

  std::vector<std::atomic<Index>> slots;
};

/// Where each run's share begins, and after them all the end.
template <class SizeOf>
std::vector<std::size_t> beginsOf(const std::vector<CellChunk>& chunks, const SizeOf& sizeOf)
{
  std::vector<std::size_t> begins{ 0 };
  for (const CellChunk& chunk : chunks)
  {
    begins.push_back(begins.back() + sizeOf(chunk));
  }
  return begins;
}

}

void CellChunk::add(std::int64_t id, CellPolygon& cell)
{
  const auto same = [](const CellCorner& a, const CellCorner& b)
  { return a.x[0] == b.x[0] && a.x[1] == b.x[1]; };
  cell.erase(std::unique(cell.begin(), cell.end(), same), cell.end());
  while (cell.size() > 1 && same(cell.front(), cell.back()))
  {
    cell.pop_back();
  }
  if (cell.size() < 3)
  {
    return;
  }
  for (const CellCorner& corner : cell)
  {
    if (corner.facet != NoIndex)
    {
      this->corners.push_back(corner.facet);
      continue;
    }
    this->corners.push_back(static_cast<Index>(this->facetCount + this->cut.size()));
    this->cut.push_back({ corner.x[0] + 0.0, corner.x[1] + 0.0 }); // -0 is 0
  }
  this->sizes.push_back(static_cast<Index>(cell.size()));
  this->ids.push_back(id);
}

RoundedCells numberCorners(
  std::vector<CellChunk>& chunks, const Buffer<Position>& centers, Monitor& monitor)
{
  const std::size_t facets = centers.size();
  const auto cells = beginsOf(chunks, [](const CellChunk& chunk) { return chunk.ids.size(); });
  const auto uses = beginsOf(chunks, [](const CellChunk& chunk) { return chunk.corners.size(); });
  const auto cuts = beginsOf(chunks, [](const CellChunk& chunk) { return chunk.cut.size(); });
  if (facets + cuts.back() >= NoIndex)
  {
    throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(facets + cuts.back()));
  }
  const auto eachChunkOfCells = [&](const auto& use)
  {
    eachTask(chunks.size(),
      [&](std::size_t r)
      {
        monitor.poll();
        use(r, chunks[r]);
      });
  };
  Buffer<Position> cut(cuts.back());
  eachChunkOfCells([&](std::size_t r, CellChunk& chunk)
    { std::copy(chunk.cut.begin(), chunk.cut.end(), cut.begin() + cuts[r]); });
  const auto positionOf = [&](Index corner)
  { return corner < facets ? centers[corner] : cut[corner - facets]; };

  // For each corner that stands for others: how many uses were left, with that one, when they were
  // first used. So the greatest is the earliest, and 0 means never. Later: their number.
  std::vector<std::atomic<std::uint64_t>> first(facets + cuts.back());
  {
    PositionTable table(first.size());
    std::vector<std::atomic<Index>> known(facets); // the corner that stands for it, and one
    eachChunkOfCells(
      [&](std::size_t r, CellChunk& chunk)
      {
        std::uint64_t remaining = uses.back() - uses[r] + 1;
        for (Index& corner : chunk.corners)
        {
          Index stands;
          if (corner >= facets)
          {
            stands = table.find(corner + static_cast<Index>(cuts[r]), positionOf);
          }
          else if (const Index stored = known[corner].load(std::memory_order_relaxed))
          {
            stands = stored - 1;
          }
          else
          {
            stands = table.find(corner, positionOf);
            known[corner].store(stands + 1, std::memory_order_relaxed);
          }
          corner = stands;
          --remaining;
          std::atomic<std::uint64_t>& of = first[stands];
          std::uint64_t was = of.load(std::memory_order_relaxed);
          while (
            was < remaining && !of.compare_exchange_weak(was, remaining, std::memory_order_relaxed))
          {
          }
        }
      });
  }

  std::vector<std::vector<Index>> firsts(chunks.size());
  eachChunkOfCells(
    [&](std::size_t r, const CellChunk& chunk)
    {
      std::uint64_t remaining = uses.back() - uses[r] + 1;
      for (const Index corner : chunk.corners)
      {
        if (first[corner].load(std::memory_order_relaxed) == --remaining)
        {
          firsts[r].push_back(corner);
        }
      }
    });
  std::vector<std::size_t> numbers{ 0 };
  for (const std::vector<Index>& list : firsts)
  {
    numbers.push_back(numbers.back() + list.size());
  }
  RoundedCells result;
  result.positions.resize(2 * numbers.back());
  eachChunkOfCells(
    [&](std::size_t r, const CellChunk&)
    {
      std::size_t number = numbers[r];
      for (const Index corner : firsts[r])
      {
        const Position x = positionOf(corner);
        std::copy(x.begin(), x.end(), result.positions.begin() + 2 * number);
        first[corner].store(number++, std::memory_order_relaxed);
      }
    });

  result.corners.resize(uses.back());
  result.ids.resize(cells.back());
  result.ends.resize(cells.back() + 1);
  eachChunkOfCells(
    [&](std::size_t r, const CellChunk& chunk)
    {
      std::transform(chunk.corners.begin(), chunk.corners.end(), result.corners.begin() + uses[r],
        [&first](Index corner)
        { return static_cast<Index>(first[corner].load(std::memory_order_relaxed)); });
      std::copy(chunk.ids.begin(), chunk.ids.end(), result.ids.begin() + cells[r]);
      std::size_t end = uses[r];
      for (std::size_t c = 0; c < chunk.sizes.size(); ++c)
      {
        end += chunk.sizes[c];
        result.ends[cells[r] + c + 1] = static_cast<std::int64_t>(end);
      }
    });
  return result;
}

}
