// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells linked by their corners alone: whatever asks which sides run along one edge, or which
/// cells are around a vertex, asks here.
///
/// A side leads from a corner of a cell to its next one. All sides are sorted by the vertex that
/// they leave. Then what runs between a vertex and its neighbours is in one slice, leaving by its
/// sides and coming in by those before them, and each star is linked for itself, in the cache, by
/// any thread:
///
///                 what comes in from u is followed by what leaves to u,
///        u        counter-clockwise around v; at the border, one side
///       / \       that leaves follows none, and one that comes in is
///      v---       followed by none.
///
/// There is no twin at the border: NoIndex. A virtual vertex is for surfaces that must be closed
/// (CellMesh.h), and is put there from these sides without a twin.
#ifndef flipflop_VertexStars_h
#define flipflop_VertexStars_h

#include "Mesh/Mesh.h"
#include "Support/BucketSort.h"
#include "Support/Parallel.h"
#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// The sides of a complex: a side is the index of its corner in the connectivity. All indices must
/// be in range, and below NoIndex.
class CellSides
{
public:
  /// @param cells it must live on
  explicit CellSides(const CellComplex& cells)
    : complex(cells)
    , cellOf(cells.cellSize > 0 ? 0 : cells.connectivity.size())
  {
    constexpr std::size_t CellsPerTask = 1 << 13;
    eachChunk(cells.cellSize > 0 ? 0 : static_cast<std::size_t>(cells.cellCount()), CellsPerTask,
      [this](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t c = begin; c < end; ++c)
        {
          const auto cell = static_cast<std::int64_t>(c);
          std::fill(this->cellOf.begin() + this->complex.cellBegin(cell),
            this->cellOf.begin() + this->complex.cellBegin(cell + 1),
            static_cast<std::uint32_t>(c));
        }
      });
  }

  std::size_t size() const { return this->complex.connectivity.size(); }
  std::size_t vertexCount() const { return this->complex.pointIds.size(); }
  std::uint32_t at(std::size_t i) const { return static_cast<std::uint32_t>(i); }
  bool areCorners() const { return this->complex.dimension < 2; }

  std::uint32_t cell(std::uint32_t side) const
  {
    return this->complex.cellSize > 0 ? side / static_cast<std::uint32_t>(this->complex.cellSize)
                                      : this->cellOf[side];
  }
  std::uint32_t origin(std::uint32_t side) const
  {
    return static_cast<std::uint32_t>(this->complex.connectivity[side]);
  }
  std::uint32_t next(std::uint32_t side) const
  {
    const std::int64_t c = this->cell(side);
    const std::int64_t after = side + std::int64_t(1);
    return static_cast<std::uint32_t>(
      after == this->complex.cellBegin(c + 1) ? this->complex.cellBegin(c) : after);
  }
  std::uint32_t previous(std::uint32_t side) const
  {
    const std::int64_t c = this->cell(side);
    return static_cast<std::uint32_t>(
      (side == this->complex.cellBegin(c) ? this->complex.cellBegin(c + 1) : side) - 1);
  }

private:
  const CellComplex& complex;
  Buffer<std::uint32_t> cellOf; ///< by side, where cells' sizes differ
};

/// The sides of triangles: their half-edges.
class TriangleSides
{
public:
  TriangleSides(const Triangle* givenTriangles, std::size_t triangleCount, std::size_t vertices)
    : triangles(givenTriangles)
    , count(triangleCount)
    , vertexNumber(vertices)
  {
  }

  std::size_t size() const { return 3 * this->count; }
  std::size_t vertexCount() const { return this->vertexNumber; }
  static constexpr bool areCorners() { return false; }
  std::uint32_t at(std::size_t i) const
  {
    return halfEdge(static_cast<std::uint32_t>(i / 3), static_cast<int>(i % 3));
  }

  std::uint32_t cell(std::uint32_t side) const { return triangleOf(side); }
  std::uint32_t origin(std::uint32_t side) const
  {
    return this->triangles[triangleOf(side)].v[cornerOf(side)];
  }
  std::uint32_t next(std::uint32_t side) const { return nextHalfEdge(side); }
  std::uint32_t previous(std::uint32_t side) const { return previousHalfEdge(side); }

private:
  const Triangle* triangles;
  std::size_t count;
  std::size_t vertexNumber;
};

/// The sides that run along one edge, those of the lowest cells first.
struct LinkedEdge
{
  std::uint32_t low, high; ///< its ends
  const std::uint32_t* sides;
  std::size_t count;
  bool isTurned; ///< two sides run in the same direction

  /// The second of two sides; NoIndex at the border.
  std::uint32_t other() const { return this->count > 1 ? this->sides[1] : NoIndex; }

  /// use(side, its twin) for its one or two sides. In a crowd none is another's twin.
  template <class Use>
  void link(const Use& use) const
  {
    if (this->count <= 2)
    {
      use(this->sides[0], this->other());
    }
    if (this->count == 2)
    {
      use(this->sides[1], this->sides[0]);
    }
  }
};

/// A vertex and the cells around it.
struct Star
{
  std::vector<std::uint32_t> leaving; ///< sides that leave the vertex, ascending
  /// The same in the order of their cells, if these are one fan: from the lowest side on or, at the
  /// border, from the first. Else fewer.
  std::vector<std::uint32_t> ring;
  bool isClosed = false; ///< the fan ends where it began

  bool isFan() const { return !this->ring.empty() && this->ring.size() == this->leaving.size(); }

private:
  template <class Sides>
  friend class VertexStars;

  /// The index in leaving of the side that leads to @p u; NoIndex: none does.
  std::uint32_t leadingTo(std::uint32_t u) const
  {
    if (!this->ends.empty())
    {
      const auto found =
        std::lower_bound(this->ends.begin(), this->ends.end(), std::uint64_t(u) << 32);
      const auto isThere = [&](auto at) { return at != this->ends.end() && *at >> 32 == u; };
      return !isThere(found) ? NoIndex
        : isThere(found + 1) ? Several
                             : static_cast<std::uint32_t>(*found);
    }
    std::uint32_t found = NoIndex;
    std::uint32_t times = 0;
    for (std::uint32_t i = 0; i < this->to.size(); ++i)
    {
      const bool isThere = this->to[i] == u;
      times += isThere ? 1 : 0;
      found = isThere ? i : found;
    }
    return times > 1 ? Several : found;
  }

  static constexpr std::uint32_t Several = NoIndex - 1;

  std::vector<std::uint32_t> to;        ///< by index in leaving: where the side leads
  std::vector<std::uint32_t> from;      ///< and where the one before it comes from
  std::vector<std::uint64_t> ends;      ///< neighbours and indices, ascending
  std::vector<std::uint32_t> following; ///< in leaving: the next around the vertex
  std::vector<std::uint8_t> follows;
  std::vector<std::uint32_t> along; ///< one edge
};

/// @tparam Sides CellSides or TriangleSides
template <class Sides>
class VertexStars
{
public:
  explicit VertexStars(Sides ofCells)
    : sides(std::move(ofCells))
    , begins(sides.vertexCount() + 1)
  {
    // Some hundred chunks at most, for the sort counts in each.
    const std::size_t size = std::max(SidesPerTask, this->sides.size() >> 9);
    BucketSort<Leaving, VertexOf> sort(
      this->sides.vertexCount(), chunkCount(this->sides.size(), size));
    this->eachSide(size,
      [&](std::size_t chunk, std::uint32_t side) { sort.count(chunk, this->sides.origin(side)); });
    sort.endCounting(Buffer<Leaving>());
    this->eachSide(size,
      [&](std::size_t chunk, std::uint32_t side) {
        sort.put(chunk, { this->sides.origin(side), side });
      });
    this->leaving =
      sort.sort([this](std::uint32_t v, const Leaving*, const Leaving*, std::size_t first)
        { this->begins[v] = static_cast<std::uint32_t>(first); });
    this->begins[this->sides.vertexCount()] = static_cast<std::uint32_t>(this->leaving.size());
  }

  const Sides& of() const { return this->sides; }

  /// Sides are numbered by the vertices that they leave: those of @p v from here to begin(v + 1).
  std::uint32_t begin(std::uint32_t v) const { return this->begins[v]; }
  std::uint32_t side(std::uint32_t number) const { return this->leaving[number].side; }

  std::uint32_t destination(std::uint32_t side) const
  {
    return this->sides.origin(this->sides.next(side));
  }

  /// Where the side before @p side comes from.
  std::uint32_t source(std::uint32_t side) const
  {
    return this->sides.origin(this->sides.previous(side));
  }

  /// Find the star of a vertex.
  void link(std::uint32_t v, Star& star) const
  {
    this->find(v, star);
    const auto count = static_cast<std::uint32_t>(star.leaving.size());
    constexpr std::uint32_t Few = 16; // without being sorted they are searched sooner
    star.ends.clear();
    for (std::uint32_t i = 0; count > Few && i < count; ++i)
    {
      star.ends.push_back(std::uint64_t(star.to[i]) << 32 | i);
    }
    std::sort(star.ends.begin(), star.ends.end());
    star.following.assign(count, NoIndex);
    star.follows.assign(count, 0);
    star.ring.clear();
    star.isClosed = false;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const std::uint32_t next = star.leadingTo(star.from[i]);
      if (next == Star::Several || (next != NoIndex && star.follows[next]))
      {
        return; // a crowd
      }
      if (next != NoIndex)
      {
        star.following[i] = next;
        star.follows[next] = 1;
      }
    }
    const auto border = std::find(star.follows.begin(), star.follows.end(), 0);
    star.isClosed = border == star.follows.end();
    const std::uint32_t first =
      star.isClosed ? 0 : static_cast<std::uint32_t>(border - star.follows.begin());
    std::uint32_t i = count ? first : NoIndex;
    while (i != NoIndex && (star.ring.empty() || i != first))
    {
      star.ring.push_back(star.leaving[i]);
      i = star.following[i];
    }
  }

  /// use(side, its twin) for the sides that come in to the vertex of a fan; NoIndex: it has none.
  template <class Use>
  void eachTwin(const Star& star, const Use& use) const
  {
    const std::size_t count = star.ring.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      use(this->sides.previous(star.ring[i]),
        i + 1 < count     ? star.ring[i + 1]
          : star.isClosed ? star.ring[0]
                          : NoIndex);
    }
  }

  /// use(v, Star) for all vertices, in parallel.
  /// @param poll void (): before each task; it may throw
  template <class Poll, class Use>
  void eachStar(const Poll& poll, const Use& use) const
  {
    this->eachVertex(poll,
      [&](std::uint32_t v, Star& star)
      {
        this->link(v, star);
        use(v, star);
      });
  }

  /// use(LinkedEdge) for all edges, in parallel.
  template <class Poll, class Use>
  void eachEdgeOnThreads(const Poll& poll, const Use& use) const
  {
    this->eachVertex(poll,
      [&](std::uint32_t v, Star& star)
      {
        this->find(v, star);
        this->eachEdge(v, star, use);
      });
  }

  /// use(LinkedEdge) for all edges in lexicographic order, by the caller's thread.
  template <class Use>
  void eachEdge(const Use& use) const
  {
    Star star;
    for (std::uint32_t v = 0; v < this->sides.vertexCount(); ++v)
    {
      this->find(v, star);
      this->eachEdge(v, star, use);
    }
  }

  /// use(LinkedEdge) for the edges from @p v to higher vertices, in their order. Below dimension 2
  /// cells meet in corners: @p v itself is what they share.
  template <class Use>
  void eachEdge(std::uint32_t v, Star& star, const Use& use) const
  {
    if (this->sides.areCorners())
    {
      if (!star.leaving.empty())
      {
        use(LinkedEdge{ v, v, star.leaving.data(), star.leaving.size(), false });
      }
      return;
    }
    const auto count = static_cast<std::uint32_t>(star.leaving.size());
    star.ends.resize(2 * std::size_t(count));
    std::size_t size = 0;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      star.ends[size] = std::uint64_t(star.from[i]) << 32 | 2 * i;
      size += star.from[i] > v ? 1 : 0;
      star.ends[size] = std::uint64_t(star.to[i]) << 32 | (2 * i + 1);
      size += star.to[i] > v ? 1 : 0;
    }
    star.ends.resize(size);
    std::sort(star.ends.begin(), star.ends.end());
    for (std::size_t begin = 0, end = 0; begin < star.ends.size(); begin = end)
    {
      const std::uint64_t other = star.ends[begin] >> 32;
      star.along.clear();
      for (; end < star.ends.size() && star.ends[end] >> 32 == other; ++end)
      {
        const std::uint32_t side = star.leaving[static_cast<std::uint32_t>(star.ends[end]) >> 1];
        star.along.push_back(star.ends[end] & 1 ? side : this->sides.previous(side));
      }
      const bool isTurned =
        end - begin == 2 && (star.ends[begin] & 1) == (star.ends[begin + 1] & 1);
      use(LinkedEdge{
        v, static_cast<std::uint32_t>(other), star.along.data(), star.along.size(), isTurned });
    }
  }

private:
  static constexpr std::size_t SidesPerTask = 1 << 14;

  struct Leaving
  {
    std::uint32_t vertex;
    std::uint32_t side;
  };
  struct VertexOf
  {
    std::uint32_t operator()(const Leaving& leaving) const { return leaving.vertex; }
  };

  /// The sides at a vertex.
  void find(std::uint32_t v, Star& star) const
  {
    const std::size_t count = this->begin(v + 1) - this->begin(v);
    star.leaving.resize(count);
    star.to.resize(count);
    star.from.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::uint32_t side = this->leaving[this->begin(v) + i].side;
      star.leaving[i] = side;
      star.to[i] = this->destination(side);
      star.from[i] = this->source(side);
    }
  }

  template <class Poll, class Use>
  void eachVertex(const Poll& poll, const Use& use) const
  {
    constexpr std::size_t VerticesPerTask = 1 << 12;
    eachChunk(this->sides.vertexCount(), VerticesPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        poll();
        Star star;
        for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
        {
          use(v, star);
        }
      });
  }

  /// use(number of the chunk, side) for chunks in parallel.
  template <class Use>
  void eachSide(std::size_t size, const Use& use) const
  {
    eachChunk(this->sides.size(), size,
      [&](std::size_t begin, std::size_t end, std::size_t chunk)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          use(chunk, this->sides.at(i));
        }
      });
  }

  Sides sides;
  Buffer<std::uint32_t> begins; ///< by vertex, in leaving
  Buffer<Leaving> leaving;      ///< vertex by vertex, ascending sides
};

/// Cells at fault, found by any task.
class FaultyCells
{
public:
  void add(std::uint32_t cell)
  {
    this->number.fetch_add(1, std::memory_order_relaxed);
    std::uint32_t seen = this->lowest.load(std::memory_order_relaxed);
    while (cell < seen && !this->lowest.compare_exchange_weak(seen, cell))
    {
    }
  }

  std::int64_t count() const { return this->number.load(); } ///< of faults
  std::int64_t first() const { return this->lowest.load(); } ///< if there is one

private:
  std::atomic<std::int64_t> number{ 0 };
  std::atomic<std::uint32_t> lowest{ NoIndex };
};

/// Each edge by the lowest of its cells.
struct LinkFaults
{
  FaultyCells crowded; ///< more than two sides
  FaultyCells open;    ///< one side
  FaultyCells turned;  ///< two sides that run in the same direction

  void add(const LinkedEdge& edge, std::uint32_t cell)
  {
    if (edge.count != 2 || edge.isTurned)
    {
      (edge.count > 2 ? this->crowded : edge.count == 1 ? this->open : this->turned).add(cell);
    }
  }
};

/// link(side, its twin) for all sides of edges that are not crowded, in parallel; NoIndex: it has
/// none. A side that ends where it began, in a cell that has a corner twice, has no edge.
/// @param poll   void (): before each task; it may throw
/// @param faults it is for the caller to say which of them are
template <class Sides, class Poll, class Link>
void linkTwins(
  const VertexStars<Sides>& stars, const Poll& poll, const Link& link, LinkFaults& faults)
{
  stars.eachEdgeOnThreads(poll,
    [&](const LinkedEdge& edge)
    {
      faults.add(edge, stars.of().cell(edge.sides[0]));
      edge.link(link);
    });
}

}

#endif
