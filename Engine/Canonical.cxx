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

/// The true facets of two and more triangles, as polygons of ranks, lowest first.
class Polygons
{
public:
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
  const std::uint32_t* first(std::size_t p) const { return this->corners.data() + this->begin[p]; }
  std::size_t size(std::size_t p) const { return this->begin[p + 1] - this->begin[p]; }

private:
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> begin{ 0 };
};

/// Brings the facets into their order.
class Writer
{
public:
  Writer(const Polyhedron& polyhedron, Ranking&& ranking, bool anyFlat)
    : polyhedron(polyhedron)
    , ranking(std::move(ranking))
    , polygons(anyFlat ? new Polygons(polyhedron, this->ranking) : nullptr)
  {
  }

  void writeCells(FacetMode facets, int threads, Hull& hull) const
  {
    const bool fans = facets == FacetMode::Triangles;
    SortedCells sorted(this->vertexCount(), threads > 1);
    const auto eachCell = [&](auto&& use)
    {
      this->eachTriangle(
        [&](const Triangle& t, int e)
        {
          use(Cell{ { this->ranking.rank[t.v[e]], this->ranking.rank[t.v[nextCorner(e)]],
            this->ranking.rank[t.v[previousCorner(e)]] } });
        });
      fans ? this->eachFanTriangle(use) : this->eachPolygon(use);
    };
    eachCell([&](const Cell& cell) { sorted.count(cell.corner[0]); });
    sorted.endCounting();
    eachCell([&](const Cell& cell) { sorted.put(cell); });
    sorted.sort();
    if (fans || !this->polygons)
    {
      writeTriangles(sorted.get(), hull);
    }
    else
    {
      this->writeMixed(sorted.get(), hull);
    }
  }

  /// Both facet modes measure the same triangles.
  void writeMeasure(const CoordinateRange& range, int exponent, Hull& hull) const
  {
    Measure total(range, exponent, this->position(0));
    std::vector<Measure> parts(runCount(this->polyhedron.triangleCount()), total);
    const Vertex* v = this->polyhedron.vertices.data();
    this->eachTriangle(
      [&](const Triangle& t, int e)
      {
        const auto index = static_cast<std::size_t>(&t - this->polyhedron.triangles.data());
        parts[index / Run].addTriangle(
          v[t.v[e]].x, v[t.v[nextCorner(e)]].x, v[t.v[previousCorner(e)]].x);
      });
    for (const Measure& part : parts)
    {
      total.add(part);
    }
    this->eachFanTriangle(
      [&](const Cell& cell)
      {
        total.addTriangle(this->position(cell.corner[0]), this->position(cell.corner[1]),
          this->position(cell.corner[2]));
      });
    total.write(hull);
  }

private:
  std::uint32_t vertexCount() const { return this->polyhedron.vertexCount(); }

  const double* position(std::uint32_t rank) const
  {
    return this->polyhedron.vertices[this->ranking.vertex[rank]].x;
  }

  /// Facets that are one triangle: use(triangle, corner of lowest rank), in parallel by runs.
  template <class Use>
  void eachTriangle(Use&& use) const
  {
    const std::uint32_t count = this->polyhedron.triangleCount();
    tbb::parallel_for(std::size_t(0), runCount(count),
      [&](std::size_t run)
      {
        const auto begin = static_cast<std::uint32_t>(run) * Run;
        for (std::uint32_t t = begin; t < std::min(count, begin + Run); ++t)
        {
          const Triangle& triangle = this->polyhedron.triangles[t];
          if (triangle.index == 0)
          {
            const std::uint32_t a = this->ranking.rank[triangle.v[0]];
            const std::uint32_t b = this->ranking.rank[triangle.v[1]];
            const std::uint32_t c = this->ranking.rank[triangle.v[2]];
            use(triangle, a < b ? (a < c ? 0 : 2) : (b < c ? 1 : 2));
          }
        }
      });
  }

  /// The other facets: use(their first two corners and their number).
  template <class Use>
  void eachPolygon(Use&& use) const
  {
    for (std::size_t p = 0; this->polygons && p < this->polygons->count(); ++p)
    {
      const std::uint32_t* corner = this->polygons->first(p);
      use(Cell{ { corner[0], corner[1], this->vertexCount() + static_cast<std::uint32_t>(p) } });
    }
  }

  template <class Use>
  void eachFanTriangle(Use&& use) const
  {
    for (std::size_t p = 0; this->polygons && p < this->polygons->count(); ++p)
    {
      const std::uint32_t* corner = this->polygons->first(p);
      for (std::size_t i = 2; i < this->polygons->size(p); ++i)
      {
        use(Cell{ { corner[0], corner[i - 1], corner[i] } });
      }
    }
  }

  static void writeTriangles(const Buffer<Cell>& cells, Hull& hull)
  {
    hull.cellSize = 3;
    hull.connectivity.allocate(3 * cells.size());
    tbb::parallel_for(std::size_t(0), runCount(cells.size()),
      [&](std::size_t run)
      {
        const std::size_t end = std::min(cells.size(), (run + 1) * Run);
        for (std::size_t i = run * Run; i < end; ++i)
        {
          std::copy(cells[i].corner, cells[i].corner + 3, hull.connectivity.begin() + 3 * i);
        }
      });
  }

  void writeMixed(const Buffer<Cell>& cells, Hull& hull) const
  {
    const auto isPolygon = [this](const Cell& cell)
    { return cell.corner[2] >= this->vertexCount(); };
    const auto number = [this](const Cell& cell) { return cell.corner[2] - this->vertexCount(); };
    hull.cellSize = 0;
    hull.offsets.allocate(cells.size() + 1);
    std::size_t at = 0;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      hull.offsets[i] = static_cast<std::int64_t>(at);
      at += isPolygon(cells[i]) ? this->polygons->size(number(cells[i])) : 3;
    }
    hull.offsets[cells.size()] = static_cast<std::int64_t>(at);
    hull.connectivity.allocate(at);
    std::int64_t* out = hull.connectivity.data();
    for (const Cell& cell : cells)
    {
      const std::uint32_t* first =
        isPolygon(cell) ? this->polygons->first(number(cell)) : cell.corner;
      out =
        std::copy(first, first + (isPolygon(cell) ? this->polygons->size(number(cell)) : 3), out);
    }
  }

  const Polyhedron& polyhedron;
  const Ranking ranking;
  const std::unique_ptr<const Polygons> polygons; ///< null: no edge is flat
};

}

void writeCanonical(const Polyhedron& polyhedron, bool anyFlat,
  const std::vector<Duplicate>& duplicates, std::uint32_t pointCount, const CoordinateRange& range,
  int exponent, FacetMode facets, int threads, Hull& hull)
{
  hull.dimension = 3;
  const Writer writer(
    polyhedron, rankVertices(polyhedron, duplicates, pointCount, hull.pointIds), anyFlat);
  writer.writeCells(facets, threads, hull);
  writer.writeMeasure(range, exponent, hull);
}

}
