// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Several facets may have their centers at one position, and several cells a corner there that a
/// cut made. One of these corners stands for all. Which one depends on the threads.
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

/// Where each chunk begins, and after them all the end.
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
  const auto same = [](const CellCorner& a, const CellCorner& b) { return a.x == b.x; };
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

namespace
{

/// Numbers the corners of the cells of all chunks: those at one position are one, in the order of
/// their first use.
class CornerNumbering
{
public:
  /// @throw Error TooManyPoints
  CornerNumbering(
    std::vector<CellChunk>& all, const Buffer<Position>& facetCenters, Monitor& monitorToUse)
    : chunks(all)
    , centers(facetCenters)
    , monitor(monitorToUse)
    , cells(beginsOf(all, [](const CellChunk& chunk) { return chunk.ids.size(); }))
    , uses(beginsOf(all, [](const CellChunk& chunk) { return chunk.corners.size(); }))
    , cuts(beginsOf(all, [](const CellChunk& chunk) { return chunk.cut.size(); }))
  {
    const std::size_t count = centers.size() + this->cuts.back();
    if (count >= NoIndex)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
    }
    this->first = std::vector<std::atomic<std::uint64_t>>(count);
  }

  RoundedCells run()
  {
    this->gatherCut();
    this->joinEqual();
    RoundedCells result;
    this->writePositions(result);
    this->writeCells(result);
    return result;
  }

private:
  template <class Use>
  void eachChunkOfCells(const Use& use)
  {
    eachTask(this->chunks.size(),
      [&](std::size_t r)
      {
        this->monitor.poll();
        use(r, this->chunks[r]);
      });
  }

  Position positionOf(Index corner) const
  {
    return corner < this->centers.size() ? this->centers[corner]
                                         : this->cut[corner - this->centers.size()];
  }

  void gatherCut()
  {
    this->cut.allocate(this->cuts.back());
    this->eachChunkOfCells([&](std::size_t r, CellChunk& chunk)
      { std::copy(chunk.cut.begin(), chunk.cut.end(), this->cut.begin() + this->cuts[r]); });
  }

  /// Replace each corner by the one that stands for all at its position.
  void joinEqual()
  {
    PositionTable table(this->first.size());
    std::vector<std::atomic<Index>> known(this->centers.size()); // what stands for it, and one
    const auto positionAt = [this](Index corner) { return this->positionOf(corner); };
    this->eachChunkOfCells(
      [&](std::size_t r, CellChunk& chunk)
      {
        std::uint64_t remaining = this->uses.back() - this->uses[r] + 1;
        for (Index& corner : chunk.corners)
        {
          Index stands;
          if (corner >= this->centers.size())
          {
            stands = table.find(corner + static_cast<Index>(this->cuts[r]), positionAt);
          }
          else if (const Index stored = known[corner].load(std::memory_order_relaxed))
          {
            stands = stored - 1;
          }
          else
          {
            stands = table.find(corner, positionAt);
            known[corner].store(stands + 1, std::memory_order_relaxed);
          }
          corner = stands;
          --remaining;
          std::atomic<std::uint64_t>& of = this->first[stands];
          std::uint64_t was = of.load(std::memory_order_relaxed);
          while (
            was < remaining && !of.compare_exchange_weak(was, remaining, std::memory_order_relaxed))
          {
          }
        }
      });
  }

  /// Number the corners in the order of their first use, and write their positions.
  void writePositions(RoundedCells& result)
  {
    std::vector<std::vector<Index>> firsts(this->chunks.size());
    this->eachChunkOfCells(
      [&](std::size_t r, const CellChunk& chunk)
      {
        std::uint64_t remaining = this->uses.back() - this->uses[r] + 1;
        for (const Index corner : chunk.corners)
        {
          if (this->first[corner].load(std::memory_order_relaxed) == --remaining)
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
    result.positions.resize(2 * numbers.back());
    this->eachChunkOfCells(
      [&](std::size_t r, const CellChunk&)
      {
        std::size_t number = numbers[r];
        for (const Index corner : firsts[r])
        {
          const Position x = this->positionOf(corner);
          std::copy(x.begin(), x.end(), result.positions.begin() + 2 * number);
          this->first[corner].store(number++, std::memory_order_relaxed);
        }
      });
  }

  void writeCells(RoundedCells& result)
  {
    result.corners.resize(this->uses.back());
    result.ids.resize(this->cells.back());
    result.ends.resize(this->cells.back() + 1);
    this->eachChunkOfCells(
      [&](std::size_t r, const CellChunk& chunk)
      {
        std::transform(chunk.corners.begin(), chunk.corners.end(),
          result.corners.begin() + this->uses[r],
          [this](Index corner)
          { return static_cast<Index>(this->first[corner].load(std::memory_order_relaxed)); });
        std::copy(chunk.ids.begin(), chunk.ids.end(), result.ids.begin() + this->cells[r]);
        std::size_t end = this->uses[r];
        for (std::size_t c = 0; c < chunk.sizes.size(); ++c)
        {
          end += chunk.sizes[c];
          result.ends[this->cells[r] + c + 1] = static_cast<std::int64_t>(end);
        }
      });
  }

  std::vector<CellChunk>& chunks;
  const Buffer<Position>& centers;
  Monitor& monitor;
  const std::vector<std::size_t> cells; ///< of each chunk, where its own begin among all
  const std::vector<std::size_t> uses;
  const std::vector<std::size_t> cuts;
  Buffer<Position> cut; ///< of all chunks

  /// Of each corner that stands for others: how many uses remained, with that one, at the first. So
  /// the greatest is the earliest, and 0 means never. Later: its number.
  std::vector<std::atomic<std::uint64_t>> first;
};

}

RoundedCells numberCorners(
  std::vector<CellChunk>& chunks, const Buffer<Position>& centers, Monitor& monitor)
{
  return CornerNumbering(chunks, centers, monitor).run();
}

}
