// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Canonical.h"

#include "Measure.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <utility>

namespace flipflop
{

namespace
{

constexpr std::uint32_t Run = 1 << 14;

std::size_t runCount(std::size_t n)
{
  return (n + Run - 1) / Run;
}

/// The lowest id at a vertex's position, from pairs of ids at one position.
class LowestIds
{
public:
  explicit LowestIds(const std::vector<Duplicate>& duplicates)
  {
    for (const Duplicate& d : duplicates)
    {
      const std::uint32_t a = this->root(d.vertexId);
      const std::uint32_t b = this->root(d.id);
      if (a != b)
      {
        this->parent[std::max(a, b)] = std::min(a, b);
      }
    }
  }

  std::uint32_t of(std::uint32_t id) { return this->parent.empty() ? id : this->root(id); }

private:
  std::uint32_t root(std::uint32_t id)
  {
    std::uint32_t top = id;
    for (auto it = this->parent.find(top); it != this->parent.end(); it = this->parent.find(top))
    {
      top = it->second;
    }
    while (id != top)
    {
      std::uint32_t& up = this->parent[id];
      id = std::exchange(up, top);
    }
    return top;
  }

  std::unordered_map<std::uint32_t, std::uint32_t> parent; ///< to a lower id, roots left out
};

/// The polyhedron's vertices in the order of the hull's points.
struct Ranking
{
  Buffer<std::uint32_t> rank;   ///< by vertex
  Buffer<std::uint32_t> vertex; ///< by rank
};

Ranking rankVertices(const Polyhedron& polyhedron, const std::vector<Duplicate>& duplicates,
  std::uint32_t pointCount, Buffer<std::int64_t>& pointIds)
{
  const std::uint32_t count = polyhedron.vertexCount();
  Ranking ranking;
  ranking.rank.allocate(count);
  ranking.vertex.allocate(count);
  pointIds.allocate(count);

  Buffer<std::uint32_t> id(count);
  LowestIds lowest(duplicates);
  for (std::uint32_t v = 0; v < count; ++v)
  {
    id[v] = lowest.of(polyhedron.vertices[v].id);
  }

  // A bit for every id, and how many bits are set before each word: ranks without a sort, unless
  // the hull is a small part of the input.
  if (count >= pointCount / 64)
  {
    const std::size_t words = (static_cast<std::size_t>(pointCount) + 63) / 64;
    std::vector<std::uint64_t> bits(words);
    std::vector<std::uint32_t> before(words);
    for (const std::uint32_t i : id)
    {
      bits[i / 64] |= std::uint64_t(1) << (i % 64);
    }
    const auto bitCount = [](std::uint64_t word)
    {
      word -= (word >> 1) & 0x5555555555555555ull;
      word = (word & 0x3333333333333333ull) + ((word >> 2) & 0x3333333333333333ull);
      word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0Full;
      return static_cast<std::uint32_t>(word * 0x0101010101010101ull >> 56);
    };
    std::uint32_t total = 0;
    for (std::size_t w = 0; w < words; ++w)
    {
      before[w] = total;
      total += bitCount(bits[w]);
    }
    tbb::parallel_for(std::size_t(0), runCount(count),
      [&](std::size_t run)
      {
        const auto begin = static_cast<std::uint32_t>(run) * Run;
        for (std::uint32_t v = begin; v < std::min(count, begin + Run); ++v)
        {
          const std::uint32_t i = id[v];
          const std::uint64_t lower = bits[i / 64] & ((std::uint64_t(1) << (i % 64)) - 1);
          ranking.rank[v] = before[i / 64] + bitCount(lower);
        }
      });
  }
  else
  {
    std::vector<std::uint32_t> order(count);
    for (std::uint32_t v = 0; v < count; ++v)
    {
      order[v] = v;
    }
    std::sort(order.begin(), order.end(),
      [&id](std::uint32_t a, std::uint32_t b) { return id[a] < id[b]; });
    for (std::uint32_t r = 0; r < count; ++r)
    {
      ranking.rank[order[r]] = r;
    }
  }
  for (std::uint32_t v = 0; v < count; ++v)
  {
    ranking.vertex[ranking.rank[v]] = v;
    pointIds[ranking.rank[v]] = id[v];
  }
  return ranking;
}

/// A triangle, lowest corner first; or a polygon's first two corners and, past all corners, its
/// number.
struct Cell
{
  std::uint32_t corner[3];
};

/// Cells in lexicographic order. A directed edge is in one cell only, so the first two corners
/// tell.
class SortedCells
{
public:
  SortedCells(std::uint32_t vertexCount, bool atomic)
    : atomic(atomic)
    , begin(std::size_t(vertexCount) + 1)
  {
  }

  void count(std::uint32_t first) { this->add(first + 1); }

  void endCounting()
  {
    for (std::size_t v = 1; v < this->begin.size(); ++v)
    {
      this->begin[v] += this->begin[v - 1];
    }
    this->cells.allocate(this->begin.back());
  }

  void put(const Cell& cell) { this->cells[this->add(cell.corner[0])] = cell; }

  /// After all are put, begin[v] is the end of v's cells.
  void sort()
  {
    tbb::parallel_for(std::size_t(0), runCount(this->begin.size() - 1),
      [&](std::size_t run)
      {
        const std::size_t last = std::min(this->begin.size() - 1, (run + 1) * Run);
        for (std::size_t v = run * Run; v < last; ++v)
        {
          const std::size_t from = v ? this->begin[v - 1] : 0;
          std::sort(this->cells.begin() + from, this->cells.begin() + this->begin[v],
            [](const Cell& a, const Cell& b) { return a.corner[1] < b.corner[1]; });
        }
      });
  }

  const Buffer<Cell>& get() const { return this->cells; }

private:
  std::uint32_t add(std::size_t i)
  {
    std::uint32_t& value = this->begin[i];
    return this->atomic ? __atomic_fetch_add(&value, 1u, __ATOMIC_RELAXED) : value++;
  }

  bool atomic;
  std::vector<std::uint32_t> begin;
  Buffer<Cell> cells;
};

/// Corners a, b, c, turned so that the lowest is first.
Cell lowestFirst(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  if (b < a && b < c)
  {
    return { { b, c, a } };
  }
  if (c < a && c < b)
  {
    return { { c, a, b } };
  }
  return { { a, b, c } };
}

/// The true facets of two and more triangles, as polygons of ranks, lowest first.
class Polygons
{
public:
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> begin{ 0 };

  Polygons(const Polyhedron& polyhedron, const Ranking& ranking)
  {
    std::vector<std::uint8_t> visited(polyhedron.triangleCount());
    const auto isFlat = [&](std::uint32_t h)
    { return (polyhedron.triangles[triangleOf(h)].index >> cornerOf(h) & 1) != 0; };
    for (std::uint32_t t = 0; t < polyhedron.triangleCount(); ++t)
    {
      for (int e = 0; e < 3; ++e)
      {
        if (polyhedron.triangles[t].index == 0 || isFlat(halfEdge(t, e)) || (visited[t] >> e & 1))
        {
          continue;
        }
        const std::size_t first = this->corners.size();
        const std::uint32_t start = halfEdge(t, e);
        std::uint32_t h = start;
        do
        {
          const Triangle& triangle = polyhedron.triangles[triangleOf(h)];
          visited[triangleOf(h)] |= static_cast<std::uint8_t>(1 << cornerOf(h));
          this->corners.push_back(ranking.rank[triangle.v[cornerOf(h)]]);
          h = nextHalfEdge(h);
          while (isFlat(h))
          {
            h = nextHalfEdge(polyhedron.triangles[triangleOf(h)].twin[cornerOf(h)]);
          }
        } while (h != start);
        std::rotate(this->corners.begin() + first,
          std::min_element(this->corners.begin() + first, this->corners.end()),
          this->corners.end());
        this->begin.push_back(this->corners.size());
      }
    }
  }

  std::size_t count() const { return this->begin.size() - 1; }
};

/// Cells of three and of more corners.
void writeMixed(
  const Buffer<Cell>& cells, const Polygons& polygons, std::uint32_t vertexCount, Hull& hull)
{
  hull.cellSize = 0;
  hull.offsets.allocate(cells.size() + 1);
  std::int64_t at = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    hull.offsets[i] = at;
    const std::uint32_t third = cells[i].corner[2];
    const std::size_t p = third - vertexCount;
    at += third < vertexCount
      ? 3
      : static_cast<std::int64_t>(polygons.begin[p + 1] - polygons.begin[p]);
  }
  hull.offsets[cells.size()] = at;
  hull.connectivity.allocate(static_cast<std::size_t>(at));
  std::int64_t* out = hull.connectivity.data();
  for (const Cell& cell : cells)
  {
    if (cell.corner[2] < vertexCount)
    {
      out = std::copy(cell.corner, cell.corner + 3, out);
    }
    else
    {
      const std::size_t p = cell.corner[2] - vertexCount;
      out = std::copy(polygons.corners.begin() + polygons.begin[p],
        polygons.corners.begin() + polygons.begin[p + 1], out);
    }
  }
}

}

void writeCanonical(const Polyhedron& polyhedron, bool anyFlat,
  const std::vector<Duplicate>& duplicates, std::uint32_t pointCount, const CoordinateRange& range,
  int exponent, FacetMode facets, int threads, Hull& hull)
{
  hull.dimension = 3;
  const Ranking ranking = rankVertices(polyhedron, duplicates, pointCount, hull.pointIds);
  const std::uint32_t vertexCount = polyhedron.vertexCount();
  const std::uint32_t triangleCount = polyhedron.triangleCount();

  const std::unique_ptr<const Polygons> polygons(
    anyFlat ? new Polygons(polyhedron, ranking) : nullptr);
  const bool fans = facets == FacetMode::Triangles;
  const auto eachPolygonCell = [&](auto&& use)
  {
    for (std::size_t p = 0; polygons && p < polygons->count(); ++p)
    {
      const std::uint32_t* corner = polygons->corners.data() + polygons->begin[p];
      const std::size_t size = polygons->begin[p + 1] - polygons->begin[p];
      if (!fans)
      {
        use(Cell{ { corner[0], corner[1], vertexCount + static_cast<std::uint32_t>(p) } });
        continue;
      }
      for (std::size_t i = 2; i < size; ++i)
      {
        use(Cell{ { corner[0], corner[i - 1], corner[i] } });
      }
    }
  };
  const auto eachTriangle = [&](auto&& use)
  {
    tbb::parallel_for(std::size_t(0), runCount(triangleCount),
      [&](std::size_t run)
      {
        const auto begin = static_cast<std::uint32_t>(run) * Run;
        for (std::uint32_t t = begin; t < std::min(triangleCount, begin + Run); ++t)
        {
          const Triangle& triangle = polyhedron.triangles[t];
          if (triangle.index == 0)
          {
            use(lowestFirst(ranking.rank[triangle.v[0]], ranking.rank[triangle.v[1]],
              ranking.rank[triangle.v[2]]));
          }
        }
      });
  };

  SortedCells sorted(vertexCount, threads > 1);
  eachTriangle([&](const Cell& cell) { sorted.count(cell.corner[0]); });
  eachPolygonCell([&](const Cell& cell) { sorted.count(cell.corner[0]); });
  sorted.endCounting();
  eachTriangle([&](const Cell& cell) { sorted.put(cell); });
  eachPolygonCell([&](const Cell& cell) { sorted.put(cell); });
  sorted.sort();

  const Buffer<Cell>& cells = sorted.get();
  if (!polygons || fans)
  {
    hull.cellSize = 3;
    hull.connectivity.allocate(3 * cells.size());
    tbb::parallel_for(std::size_t(0), runCount(cells.size()),
      [&](std::size_t run)
      {
        for (std::size_t i = run * Run; i < std::min(cells.size(), (run + 1) * Run); ++i)
        {
          for (std::size_t k = 0; k < 3; ++k)
          {
            hull.connectivity[3 * i + k] = cells[i].corner[k];
          }
        }
      });
  }
  else
  {
    writeMixed(cells, *polygons, vertexCount, hull);
  }
  measure([&](std::int64_t point) { return polyhedron.vertices[ranking.vertex[point]].x; }, range,
    exponent, hull);
}

}
