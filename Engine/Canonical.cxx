// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Canonical.h"

#include "Measure.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
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
      const std::uint32_t a = this->root(d.first);
      const std::uint32_t b = this->root(d.second);
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

/// Ids as a set of bits that knows how many of them are below one.
class IdSet
{
public:
  explicit IdSet(std::uint32_t limit)
    : bits((static_cast<std::size_t>(limit) + 63) / 64)
    , before(this->bits.size())
  {
  }

  void insert(std::uint32_t id) { this->bits[id / 64] |= std::uint64_t(1) << (id % 64); }

  /// After all are inserted; the ids in ascending order go to @p sorted.
  void count(std::int64_t* sorted)
  {
    std::uint32_t total = 0;
    for (std::size_t word = 0; word < this->bits.size(); ++word)
    {
      this->before[word] = total;
      for (std::uint64_t rest = this->bits[word]; rest; rest &= rest - 1)
      {
        // The lowest bit's place is the number of bits below it.
        sorted[total++] = static_cast<std::int64_t>(64 * word + bitCount((rest & -rest) - 1));
      }
    }
  }

  std::uint32_t rank(std::uint32_t id) const
  {
    const std::uint64_t lower = this->bits[id / 64] & ((std::uint64_t(1) << (id % 64)) - 1);
    return this->before[id / 64] + bitCount(lower);
  }

private:
  static std::uint32_t bitCount(std::uint64_t word)
  {
    word -= (word >> 1) & 0x5555555555555555ull;
    word = (word & 0x3333333333333333ull) + ((word >> 2) & 0x3333333333333333ull);
    word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0Full;
    return static_cast<std::uint32_t>(word * 0x0101010101010101ull >> 56);
  }

  std::vector<std::uint64_t> bits;
  std::vector<std::uint32_t> before;
};

bool isPoint(const Vertex& vertex)
{
  return (vertex.flags & (VertexAlive | VertexVirtual)) == VertexAlive;
}

/// The rank of every vertex among the result's points, by its lowest id; the ids themselves.
Buffer<std::uint32_t> rankVertices(const Polyhedron& polyhedron,
  const std::vector<Duplicate>& duplicates, std::uint32_t pointCount,
  Buffer<std::int64_t>& pointIds)
{
  const std::uint32_t slots = polyhedron.vertexCount();
  Buffer<std::uint32_t> rank(slots); // until then the lowest id
  LowestIds lowest(duplicates);
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < slots; ++v)
  {
    rank[v] = NoIndex;
    if (isPoint(polyhedron.vertices[v]))
    {
      rank[v] = lowest.of(polyhedron.vertices[v].id);
      ++count;
    }
  }
  pointIds.allocate(count);

  // A result that is a small part of the input is sorted; else no sort is needed.
  if (count < pointCount / 64)
  {
    std::size_t n = 0;
    for (const std::uint32_t id : rank)
    {
      if (id != NoIndex)
      {
        pointIds[n++] = id;
      }
    }
    std::sort(pointIds.begin(), pointIds.end());
    for (std::uint32_t& id : rank)
    {
      id = id == NoIndex
        ? NoIndex
        : static_cast<std::uint32_t>(
            std::lower_bound(pointIds.begin(), pointIds.end(), id) - pointIds.begin());
    }
    return rank;
  }
  IdSet set(pointCount);
  for (const std::uint32_t id : rank)
  {
    if (id != NoIndex)
    {
      set.insert(id);
    }
  }
  set.count(pointIds.data());
  tbb::parallel_for(std::size_t(0), runCount(slots),
    [&](std::size_t run)
    {
      for (std::size_t v = run * Run; v < std::min<std::size_t>(slots, (run + 1) * Run); ++v)
      {
        rank[v] = rank[v] == NoIndex ? NoIndex : set.rank(rank[v]);
      }
    });
  return rank;
}

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
  CellSort(std::size_t pointCount, std::size_t pieceCount)
    : shift(12)
  {
    while (pointCount >> this->shift > 512)
    {
      ++this->shift;
    }
    this->bucketCount = (pointCount >> this->shift) + 1;
    this->next.assign(this->bucketCount * pieceCount, 0);
  }

  void count(std::size_t piece, std::uint32_t first) { ++this->cursor(piece, first); }

  void endCounting()
  {
    std::uint32_t total = 0;
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
    this->cells.allocate(total);
  }

  void put(std::size_t piece, const Cell& cell)
  {
    this->cells[this->cursor(piece, cell.corner[0])++] = cell;
  }

  /// After all are put.
  const Buffer<Cell>& sort()
  {
    tbb::parallel_for(
      std::size_t(0), this->bucketCount, [&](std::size_t bucket) { this->sortBucket(bucket); });
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
    std::vector<std::uint32_t> place((std::size_t(1) << this->shift) + 1);
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

  int shift; ///< a bucket has 2^shift first corners
  std::size_t bucketCount;
  std::vector<std::uint32_t>
    next; ///< by piece, then bucket: how many cells, then where the next goes
  std::vector<std::uint32_t> bucketBegin;
  Buffer<Cell> cells;
};

}

/// The true facets of two and more triangles, as polygons of vertices, the one of lowest rank
/// first.
class FacetPolygons
{
public:
  FacetPolygons(const Polyhedron& polyhedron, const Buffer<std::uint32_t>& rank)
  {
    std::vector<std::uint8_t> visited(polyhedron.triangleCount());
    const auto isFlat = [&](std::uint32_t h)
    { return (polyhedron.triangles[triangleOf(h)].index >> cornerOf(h) & 1) != 0; };
    const auto trace = [&](std::uint32_t start)
    {
      const std::size_t first = this->corners.size();
      std::uint32_t h = start;
      do
      {
        visited[triangleOf(h)] |= static_cast<std::uint8_t>(1 << cornerOf(h));
        this->corners.push_back(polyhedron.triangles[triangleOf(h)].v[cornerOf(h)]);
        h = nextHalfEdge(h);
        while (isFlat(h))
        {
          h = nextHalfEdge(polyhedron.triangles[triangleOf(h)].twin[cornerOf(h)]);
        }
      } while (h != start);
      const auto begin = this->corners.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = this->corners.end();
      if (std::any_of(begin, end, [&rank](std::uint32_t v) { return rank[v] == NoIndex; }))
      {
        this->corners.resize(first);
        return;
      }
      std::rotate(begin,
        std::min_element(
          begin, end, [&rank](std::uint32_t a, std::uint32_t b) { return rank[a] < rank[b]; }),
        end);
      this->begin.push_back(this->corners.size());
    };
    for (const Piece& piece : polyhedron.pieces)
    {
      for (std::uint32_t t = piece.begin; t < piece.end; ++t)
      {
        const Triangle& triangle = polyhedron.triangles[t];
        const bool joined = !(triangle.flags & TriangleDead) && triangle.index != 0;
        for (int e = 0; joined && e < 3; ++e)
        {
          if (!isFlat(halfEdge(t, e)) && !(visited[t] >> e & 1))
          {
            trace(halfEdge(t, e));
          }
        }
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

namespace
{

void writeTriangles(const Buffer<Cell>& cells, CellComplex& complex)
{
  complex.cellSize = 3;
  complex.connectivity.allocate(3 * cells.size());
  tbb::parallel_for(std::size_t(0), runCount(cells.size()),
    [&](std::size_t run)
    {
      const std::size_t end = std::min(cells.size(), (run + 1) * Run);
      for (std::size_t i = run * Run; i < end; ++i)
      {
        std::copy(cells[i].corner, cells[i].corner + 3, complex.connectivity.begin() + 3 * i);
      }
    });
}

void writeMixed(const Buffer<Cell>& cells, const Buffer<std::uint32_t>& rank,
  const FacetPolygons& polygons, std::uint32_t pointCount, CellComplex& complex)
{
  const auto isPolygon = [&](const Cell& cell) { return cell.corner[2] >= pointCount; };
  const auto number = [&](const Cell& cell) { return cell.corner[2] - pointCount; };
  complex.cellSize = 0;
  complex.offsets.allocate(cells.size() + 1);
  std::size_t at = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    complex.offsets[i] = static_cast<std::int64_t>(at);
    at += isPolygon(cells[i]) ? polygons.size(number(cells[i])) : 3;
  }
  complex.offsets[cells.size()] = static_cast<std::int64_t>(at);
  complex.connectivity.allocate(at);
  std::int64_t* out = complex.connectivity.data();
  for (const Cell& cell : cells)
  {
    if (!isPolygon(cell))
    {
      out = std::copy(cell.corner, cell.corner + 3, out);
      continue;
    }
    const std::uint32_t* first = polygons.first(number(cell));
    out = std::transform(first, first + polygons.size(number(cell)), out,
      [&rank](std::uint32_t v) { return static_cast<std::int64_t>(rank[v]); });
  }
}

}

CanonicalForm::CanonicalForm(const Polyhedron& mesh, bool anyFlat,
  const std::vector<Duplicate>& duplicates, std::uint32_t pointCount,
  Buffer<std::int64_t>& pointIds)
  : polyhedron(mesh)
  , rank(rankVertices(mesh, duplicates, pointCount, pointIds))
  , polygons(anyFlat ? new FacetPolygons(mesh, this->rank) : nullptr)
{
}

CanonicalForm::~CanonicalForm() = default;

/// Facets that are one triangle: use(its vertices, the one of lowest rank first, piece), in
/// parallel.
template <class Use>
void CanonicalForm::eachTriangle(Use&& use) const
{
  this->polyhedron.eachTriangle(
    [&](std::uint32_t t, std::size_t piece)
    {
      const Triangle& triangle = this->polyhedron.triangles[t];
      if (triangle.index == 0)
      {
        const std::uint32_t* v = triangle.v;
        const std::uint32_t a = this->rank[v[0]];
        const std::uint32_t b = this->rank[v[1]];
        const std::uint32_t c = this->rank[v[2]];
        if (a == NoIndex || b == NoIndex || c == NoIndex)
        {
          return;
        }
        const int e = a < b ? (a < c ? 0 : 2) : (b < c ? 1 : 2);
        use(v[e], v[nextCorner(e)], v[previousCorner(e)], piece);
      }
    });
}

/// The other facets' fans: use(vertices, number of pieces), one after another.
template <class Use>
void CanonicalForm::eachFanTriangle(Use&& use) const
{
  for (std::size_t p = 0; this->polygons && p < this->polygons->count(); ++p)
  {
    const std::uint32_t* corner = this->polygons->first(p);
    for (std::size_t i = 2; i < this->polygons->size(p); ++i)
    {
      use(corner[0], corner[i - 1], corner[i], this->polyhedron.pieces.size());
    }
  }
}

void CanonicalForm::writeCells(FacetMode facets, Monitor& monitor, CellComplex& complex) const
{
  const bool fans = facets == FacetMode::Triangles;
  const auto pointCount = static_cast<std::uint32_t>(complex.pointIds.size());
  const auto eachCell = [&](auto&& use)
  {
    const auto useTriangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c,
                               std::size_t piece) {
      use(piece, Cell{ { this->rank[a], this->rank[b], this->rank[c] } });
    };
    this->eachTriangle(useTriangle);
    if (fans)
    {
      this->eachFanTriangle(useTriangle);
      return;
    }
    for (std::size_t p = 0; this->polygons && p < this->polygons->count(); ++p)
    {
      const std::uint32_t* corner = this->polygons->first(p);
      use(this->polyhedron.pieces.size(),
        Cell{ { this->rank[corner[0]], this->rank[corner[1]],
          pointCount + static_cast<std::uint32_t>(p) } });
    }
  };
  CellSort sort(pointCount, this->polyhedron.pieces.size() + 1);
  eachCell([&](std::size_t piece, const Cell& cell) { sort.count(piece, cell.corner[0]); });
  sort.endCounting();
  monitor.poll();
  eachCell([&](std::size_t piece, const Cell& cell) { sort.put(piece, cell); });
  monitor.poll();
  const Buffer<Cell>& cells = sort.sort();
  monitor.poll();
  if (fans || !this->polygons)
  {
    writeTriangles(cells, complex);
  }
  else
  {
    writeMixed(cells, this->rank, *this->polygons, pointCount, complex);
  }
}

void CanonicalForm::writeMeasure(const CoordinateRange& range, int exponent, Hull& hull) const
{
  const Buffer<Vertex>& vertices = this->polyhedron.vertices;
  const auto first = std::find(this->rank.begin(), this->rank.end(), 0u) - this->rank.begin();
  Measure total(range, exponent, vertices[static_cast<std::size_t>(first)].x);
  std::vector<Measure> parts(this->polyhedron.pieces.size() + 1, total);
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t part)
  { parts[part].addTriangle(vertices[a].x, vertices[b].x, vertices[c].x); };
  this->eachTriangle(add);
  this->eachFanTriangle(add);
  for (const Measure& part : parts)
  {
    total.add(part);
  }
  total.write(hull);
}

}
