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

  /// use(side, its twin) for its one or two sides.
  template <class Use>
  void link(const Use& use) const
  {
    use(this->sides[0], this->other());
    if (this->count > 1)
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
  /// border, from the first. Else only a part.
  std::vector<std::uint32_t> ring;
  bool isClosed = false; ///< the fan ends where it began

  bool isFan() const { return !this->ring.empty() && this->ring.size() == this->leaving.size(); }

private:
  template <class Sides>
  friend class VertexStars;

  std::vector<std::uint64_t> ends; ///< a neighbour, an index in leaving, does the side lead there?
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
    const std::uint32_t count = this->begin(v + 1) - this->begin(v);
    star.leaving.clear();
    star.ends.clear();
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const std::uint32_t side = this->side(this->begin(v) + i);
      star.leaving.push_back(side);
      star.ends.push_back(std::uint64_t(this->source(side)) << 32 | 2 * i);
      star.ends.push_back(std::uint64_t(this->destination(side)) << 32 | (2 * i + 1));
    }
    std::sort(star.ends.begin(), star.ends.end());
    star.following.assign(count, NoIndex);
    star.follows.assign(count, 0);
    eachGroup(star,
      [&star](const std::uint64_t* begin, const std::uint64_t* end)
      {
        if (end - begin == 2 && leads(begin[0]) != leads(begin[1]))
        {
          const bool swapped = leads(begin[0]);
          star.following[indexOf(begin[swapped])] = indexOf(begin[!swapped]);
          star.follows[indexOf(begin[!swapped])] = 1;
        }
      });
    const auto border = std::find(star.follows.begin(), star.follows.end(), 0);
    star.isClosed = border == star.follows.end();
    const std::uint32_t first =
      star.isClosed ? 0 : static_cast<std::uint32_t>(border - star.follows.begin());
    star.ring.clear();
    std::uint32_t i = count ? first : NoIndex;
    while (i != NoIndex && (star.ring.empty() || i != first))
    {
      star.ring.push_back(star.leaving[i]);
      i = star.following[i];
    }
  }

  /// use(v, Star) for all vertices, in parallel.
  /// @param poll void (): before each task; it may throw
  template <class Poll, class Use>
  void eachStar(const Poll& poll, const Use& use) const
  {
    constexpr std::size_t VerticesPerTask = 1 << 12;
    eachChunk(this->sides.vertexCount(), VerticesPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        poll();
        Star star;
        for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
        {
          this->link(v, star);
          use(v, star);
        }
      });
  }

  /// use(LinkedEdge) for all edges in lexicographic order, by the caller's thread.
  template <class Use>
  void eachEdge(const Use& use) const
  {
    Star star;
    for (std::uint32_t v = 0; v < this->sides.vertexCount(); ++v)
    {
      this->link(v, star);
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
    eachGroup(star,
      [&](const std::uint64_t* begin, const std::uint64_t* end)
      {
        const auto other = static_cast<std::uint32_t>(*begin >> 32);
        if (other <= v)
        {
          return;
        }
        star.along.clear();
        for (const std::uint64_t* at = begin; at != end; ++at)
        {
          const std::uint32_t side = star.leaving[indexOf(*at)];
          star.along.push_back(leads(*at) ? side : this->sides.previous(side));
        }
        use(LinkedEdge{ v, other, star.along.data(), star.along.size(),
          end - begin == 2 && leads(begin[0]) == leads(begin[1]) });
      });
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

  static bool leads(std::uint64_t end) { return (end & 1) != 0; }
  static std::uint32_t indexOf(std::uint64_t end) { return static_cast<std::uint32_t>(end) >> 1; }

  /// use(begin, end) for each neighbour.
  template <class Use>
  static void eachGroup(const Star& star, const Use& use)
  {
    const std::uint64_t* const last = star.ends.data() + star.ends.size();
    for (const std::uint64_t* begin = star.ends.data(); begin != last;)
    {
      const std::uint64_t* end = begin + 1;
      while (end != last && *end >> 32 == *begin >> 32)
      {
        ++end;
      }
      use(begin, end);
      begin = end;
    }
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

  std::int64_t count() const { return this->number.load(); } ///< of edges, or of vertices
  std::int64_t first() const { return this->lowest.load(); } ///< if there is one

private:
  std::atomic<std::int64_t> number{ 0 };
  std::atomic<std::uint32_t> lowest{ NoIndex };
};

/// Each edge, and each vertex, by the lowest of its cells.
struct LinkFaults
{
  FaultyCells crowded; ///< edges of more than two sides
  FaultyCells open;    ///< edges of one side
  FaultyCells turned;  ///< edges of two sides that run in the same direction
  FaultyCells parted;  ///< vertices whose cells are not one fan
};

/// link(side, its twin) for all sides of edges that are not crowded, in parallel; NoIndex: it has
/// none. A side that ends where it began, in a cell that has a corner twice, has no edge.
/// @param poll   void (): before each task; it may throw
/// @param faults it is for the caller to say which of them are
template <class Sides, class Poll, class Link>
void linkTwins(
  const VertexStars<Sides>& stars, const Poll& poll, const Link& link, LinkFaults& faults)
{
  stars.eachStar(poll,
    [&](std::uint32_t v, Star& star)
    {
      if (!star.leaving.empty() && !star.isFan())
      {
        faults.parted.add(stars.of().cell(star.leaving.front()));
      }
      stars.eachEdge(v, star,
        [&](const LinkedEdge& edge)
        {
          const std::uint32_t cell = stars.of().cell(edge.sides[0]);
          if (edge.count > 2)
          {
            faults.crowded.add(cell);
            return;
          }
          edge.link(link);
          if (edge.count == 1)
          {
            faults.open.add(cell);
          }
          else if (edge.isTurned)
          {
            faults.turned.add(cell);
          }
        });
    });
}

}

#endif
