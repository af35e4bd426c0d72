// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Finish/Canonical.h"

#include "Finish/CellSort.h"
#include "Finish/FacetPolygons.h"
#include "Finish/Measure.h"
#include "Support/BitCount.h"
#include "Support/LowestOf.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>

namespace flipflop
{

namespace
{

constexpr std::uint32_t ItemsPerTask = 1 << 14; ///< slots or cells

/// Ids as a set of bits that knows how many of them are below one.
class IdSet
{
public:
  explicit IdSet(std::uint32_t limit)
    : bits((static_cast<std::size_t>(limit) + 63) / 64)
    , before(this->bits.size())
  {
  }

  /// By any thread.
  void insert(std::uint32_t id)
  {
    this->bits[id / 64].fetch_or(std::uint64_t(1) << (id % 64), std::memory_order_relaxed);
  }

  /// After all are inserted; the ids in ascending order go to @p sorted.
  void count(std::int64_t* sorted, Monitor& monitor)
  {
    std::vector<std::uint32_t> counts(runCount(this->bits.size(), WordsPerTask));
    eachRun(this->bits.size(), WordsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t run)
      {
        monitor.poll();
        std::uint32_t count = 0;
        for (std::size_t word = begin; word < end; ++word)
        {
          this->before[word] = count;
          count += bitCount(this->word(word));
        }
        counts[run] = count;
      });
    std::uint32_t total = 0;
    for (std::uint32_t& n : counts)
    {
      total += std::exchange(n, total);
    }
    eachRun(this->bits.size(), WordsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t run)
      {
        monitor.poll();
        for (std::size_t word = begin; word < end; ++word)
        {
          this->before[word] += counts[run];
          std::int64_t* out = sorted + this->before[word];
          for (std::uint64_t rest = this->word(word); rest; rest &= rest - 1)
          {
            // The lowest bit's place is the number of bits below it.
            *out++ = static_cast<std::int64_t>(64 * word + bitCount((rest & -rest) - 1));
          }
        }
      });
  }

  std::uint32_t rank(std::uint32_t id) const
  {
    return this->before[id / 64] + bitCountBelow(this->word(id / 64), id % 64);
  }

private:
  static constexpr std::size_t WordsPerTask = 1 << 12;

  std::uint64_t word(std::size_t i) const { return this->bits[i].load(std::memory_order_relaxed); }

  std::vector<std::atomic<std::uint64_t>> bits;
  std::vector<std::uint32_t> before;
};

bool isPoint(const Vertex& vertex)
{
  return (vertex.flags & (VertexAlive | VertexVirtual)) == VertexAlive;
}

/// use(vertex) for every slot of the vertex array, in parallel by runs.
template <class Use>
void eachSlot(std::uint32_t slots, Monitor& monitor, Use&& use)
{
  eachRun(slots, ItemsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t run)
    {
      monitor.poll();
      for (std::size_t v = begin; v < end; ++v)
      {
        use(v, run);
      }
    });
}

/// The rank of every vertex among the result's points, by its lowest id; the ids themselves.
Buffer<std::uint32_t> rankVertices(const Polyhedron& polyhedron,
  const std::vector<Duplicate>& duplicates, std::uint32_t pointCount, Monitor& monitor,
  Buffer<std::int64_t>& pointIds)
{
  StepPoll poll(monitor);
  const std::uint32_t slots = polyhedron.vertexCount();
  Buffer<std::uint32_t> rank(slots); // until then the lowest id
  std::vector<std::uint32_t> counts(runCount(slots, ItemsPerTask));
  eachSlot(slots, monitor,
    [&](std::size_t v, std::size_t run)
    {
      const Vertex& vertex = polyhedron.vertices[v];
      ensure(!isPoint(vertex) || !(vertex.flags & VertexLabelled)); // or a flip is missing
      rank[v] = isPoint(vertex) ? vertex.id : NoIndex;
      counts[run] += isPoint(vertex) ? 1 : 0;
    });
  if (!duplicates.empty())
  {
    LowestOf<std::less<std::uint32_t>> lowest{ std::less<std::uint32_t>() };
    for (const Duplicate& d : duplicates)
    {
      poll.step();
      lowest.join(d.first, d.second);
    }
    for (std::uint32_t& id : rank)
    {
      poll.step();
      id = id == NoIndex ? NoIndex : lowest(id);
    }
  }
  const std::uint32_t count = std::accumulate(counts.begin(), counts.end(), 0u);
  pointIds.allocate(count);
  if (count == pointCount && duplicates.empty())
  {
    eachRun(count, ItemsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        monitor.poll();
        std::iota(
          pointIds.begin() + begin, pointIds.begin() + end, static_cast<std::int64_t>(begin));
      });
    return rank; // each is its id
  }

  // A result that is a small part of the input is sorted; else no sort is needed.
  if (count < pointCount / 64)
  {
    std::size_t n = 0;
    for (const std::uint32_t id : rank)
    {
      poll.step();
      if (id != NoIndex)
      {
        pointIds[n++] = id;
      }
    }
    std::sort(pointIds.begin(), pointIds.end());
    for (std::uint32_t& id : rank)
    {
      poll.step();
      id = id == NoIndex
        ? NoIndex
        : static_cast<std::uint32_t>(
            std::lower_bound(pointIds.begin(), pointIds.end(), id) - pointIds.begin());
    }
    return rank;
  }
  IdSet set(pointCount);
  eachSlot(slots, monitor,
    [&](std::size_t v, std::size_t)
    {
      if (rank[v] != NoIndex)
      {
        set.insert(rank[v]);
      }
    });
  set.count(pointIds.data(), monitor);
  eachSlot(slots, monitor,
    [&](std::size_t v, std::size_t)
    { rank[v] = rank[v] == NoIndex ? NoIndex : set.rank(rank[v]); });
  return rank;
}

/// @param memory for the connectivity, where it is enough
void writeTriangles(const Buffer<Cell>& cells, Buffer<Triangle>&& memory, CellComplex& complex)
{
  complex.cellSize = 3;
  complex.connectivity = Buffer<std::int64_t>::recycle(std::move(memory), 3 * cells.size());
  eachRun(cells.size(), ItemsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        std::copy(cells[i].corner, cells[i].corner + 3, complex.connectivity.begin() + 3 * i);
      }
    });
}

void writeMixed(const Buffer<Cell>& cells, const Buffer<std::uint32_t>& rank,
  const FacetPolygons& polygons, std::uint32_t pointCount, Monitor& monitor, CellComplex& complex)
{
  const auto isPolygon = [&](const Cell& cell) { return cell.corner[2] >= pointCount; };
  const auto number = [&](const Cell& cell) { return cell.corner[2] - pointCount; };
  std::vector<std::size_t> next(
    runCount(cells.size(), ItemsPerTask)); // where each run's corners go
  eachRun(cells.size(), ItemsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t run)
    {
      monitor.poll();
      for (std::size_t i = begin; i < end; ++i)
      {
        next[run] += isPolygon(cells[i]) ? polygons.size(number(cells[i])) : 3;
      }
    });
  std::size_t total = 0;
  for (std::size_t& at : next)
  {
    total += std::exchange(at, total);
  }
  complex.cellSize = 0;
  complex.offsets.allocate(cells.size() + 1);
  complex.offsets[cells.size()] = static_cast<std::int64_t>(total);
  complex.connectivity.allocate(total);
  eachRun(cells.size(), ItemsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t run)
    {
      monitor.poll();
      std::int64_t* const all = complex.connectivity.data();
      std::int64_t* out = all + next[run];
      for (std::size_t i = begin; i < end; ++i)
      {
        complex.offsets[i] = out - all;
        if (!isPolygon(cells[i]))
        {
          out = std::copy(cells[i].corner, cells[i].corner + 3, out);
          continue;
        }
        const std::uint32_t* first = polygons.first(number(cells[i]));
        out = std::transform(first, first + polygons.size(number(cells[i])), out,
          [&rank](std::uint32_t v) { return static_cast<std::int64_t>(rank[v]); });
      }
    });
}

/// The corner of lowest rank.
int lowestOf(const std::uint32_t* r)
{
  return r[0] < r[1] ? (r[0] < r[2] ? 0 : 2) : (r[1] < r[2] ? 1 : 2);
}

/// Are all corners points of the result?
bool isCell(const std::uint32_t* r)
{
  return r[0] != NoIndex && r[1] != NoIndex && r[2] != NoIndex;
}

}

CanonicalForm::CanonicalForm(Polyhedron& mesh, bool anyFlat,
  const std::vector<Duplicate>& duplicates, std::uint32_t pointCount, FacetMode facetMode,
  Monitor& monitor, Buffer<std::int64_t>& pointIds)
  : facets(facetMode)
  , polyhedron(mesh)
  , rank(rankVertices(mesh, duplicates, pointCount, monitor, pointIds))
  , polygons(anyFlat
        ? new FacetPolygons(mesh, this->rank, facetMode == FacetMode::Polygons, monitor)
        : nullptr)
{
}

CanonicalForm::~CanonicalForm() = default;

// A facet is of one of three kinds:
// - one triangle;
// - a pair of triangles, where triangles are asked for. Grids are full of them, and they need
//   no walk around the facet. They become two triangles again, from the corner of lowest rank;
// - a polygon (FacetPolygons): of more triangles, or of a pair where polygons are asked for. As
//   triangles it is a fan from its corner of lowest rank.
// A facet with a corner that is no point of the result (at the virtual vertex) is left out.

/// The other triangle of a facet that is a pair; NoIndex: the facet is of another kind.
std::uint32_t CanonicalForm::otherOf(std::uint32_t t) const
{
  return this->facets == FacetMode::Triangles ? otherOfPair(this->polyhedron, t) : NoIndex;
}

/// use(triangle, vertices) for a facet that is one triangle; the vertex of lowest rank is the
/// first.
template <class Use>
void CanonicalForm::useSingle(std::uint32_t t, Use&& use) const
{
  const std::uint32_t* const v = this->polyhedron.triangles[t].v;
  const std::uint32_t r[3] = { this->rank[v[0]], this->rank[v[1]], this->rank[v[2]] };
  if (isCell(r))
  {
    const int e = lowestOf(r);
    use(t, v[e], v[nextCorner(e)], v[previousCorner(e)]);
  }
}

/// The same, twice, for the pair of triangle t and @p other.
template <class Use>
void CanonicalForm::usePair(std::uint32_t t, std::uint32_t other, Use&& use) const
{
  // The flat edge is ab; around the facet: a, d, b, c.
  const Triangle& triangle = this->polyhedron.triangles[t];
  const int e = onlyFlatEdge(triangle);
  const std::uint32_t d =
    this->polyhedron.triangles[other].v[previousCorner(cornerOf(triangle.twin[e]))];
  const std::uint32_t ring[4] = { triangle.v[e], d, triangle.v[nextCorner(e)],
    triangle.v[previousCorner(e)] };
  int lowest = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (this->rank[ring[i]] == NoIndex)
    {
      return;
    }
    lowest = this->rank[ring[i]] < this->rank[ring[lowest]] ? i : lowest;
  }
  const auto at = [&](int i) { return ring[(lowest + i) % 4]; };
  use(t, at(0), at(1), at(2));
  use(other, at(0), at(2), at(3));
}

/// use(vertices) for each triangle of the polygons' fans, one after another.
template <class Use>
void CanonicalForm::eachFanTriangle(Use&& use) const
{
  for (std::size_t p = 0; this->polygons && p < this->polygons->count(); ++p)
  {
    const std::uint32_t* corner = this->polygons->first(p);
    for (std::size_t i = 2; i < this->polygons->size(p); ++i)
    {
      use(corner[0], corner[i - 1], corner[i]);
    }
  }
}

/// use(cell) for each cell that the polygons become: their fans' triangles; or one for a polygon,
/// which has the polygon's number, behind all ranks, for its third corner.
template <class Use>
void CanonicalForm::eachPolygonCell(std::uint32_t pointCount, Use&& use) const
{
  if (this->facets == FacetMode::Triangles)
  {
    this->eachFanTriangle(
      [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        use(Cell{ { this->rank[a], this->rank[b], this->rank[c] } });
      });
    return;
  }
  for (std::size_t p = 0; this->polygons && p < this->polygons->count(); ++p)
  {
    const std::uint32_t* corner = this->polygons->first(p);
    use(Cell{ { this->rank[corner[0]], this->rank[corner[1]],
      pointCount + static_cast<std::uint32_t>(p) } });
  }
}

/// @param useToo void (vertices, number of the piece), of every triangle of the result;
///               polygons are measured as fans, in a piece of their own
template <class Use>
void CanonicalForm::write(Monitor& monitor, CellComplex& complex, Use&& useToo)
{
  const auto pointCount = static_cast<std::uint32_t>(complex.pointIds.size());
  const std::size_t polygonPiece = this->polyhedron.pieces.size();
  Buffer<Triangle>& triangles = this->polyhedron.triangles;
  CellSort sort(pointCount, polygonPiece + 1);

  // First pass: count. A triangle's corners are replaced by its cell's ranks, so that the second
  // pass need not look them up again; triangles that become no cell are dead to it. The lower
  // triangle of a pair writes both.
  this->polyhedron.eachTriangle(
    [&](std::uint32_t t, std::size_t piece)
    {
      bool used = false;
      const auto replace = [&](
                             std::uint32_t slot, std::uint32_t a, std::uint32_t b, std::uint32_t c)
      {
        useToo(a, b, c, piece);
        std::uint32_t* const v = triangles[slot].v;
        v[0] = this->rank[a];
        v[1] = this->rank[b];
        v[2] = this->rank[c];
        sort.count(piece, v[0]);
        used = true;
      };
      if (flatEdges(triangles[t]) == 0)
      {
        this->useSingle(t, replace);
      }
      else if (const std::uint32_t other = this->otherOf(t); other != NoIndex && t < other)
      {
        this->usePair(t, other, replace);
      }
      triangles[t].flags = used ? 0 : TriangleDead;
    });
  this->eachPolygonCell(
    pointCount, [&](const Cell& cell) { sort.count(polygonPiece, cell.corner[0]); });
  this->eachFanTriangle(
    [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { useToo(a, b, c, polygonPiece); });
  monitor.poll();

  // Second pass: put the cells where the counts say.
  sort.endCounting(std::move(this->polyhedron.vertices));
  this->polyhedron.eachTriangle(
    [&](std::uint32_t t, std::size_t piece)
    {
      const auto put = [&](std::uint32_t slot)
      {
        const std::uint32_t* v = triangles[slot].v;
        sort.put(piece, Cell{ { v[0], v[1], v[2] } });
      };
      put(t);
      if (flatEdges(triangles[t]) != 0)
      {
        put(this->otherOf(t));
      }
    });
  this->eachPolygonCell(pointCount, [&](const Cell& cell) { sort.put(polygonPiece, cell); });
  monitor.poll();

  const Buffer<Cell> cells = sort.sort();
  monitor.poll();
  const bool anyPolygon = this->polygons && this->polygons->count() > 0;
  if (anyPolygon && this->facets == FacetMode::Polygons)
  {
    writeMixed(cells, this->rank, *this->polygons, pointCount, monitor, complex);
  }
  else
  {
    writeTriangles(cells, std::move(triangles), complex);
  }
}

void CanonicalForm::writeCells(Monitor& monitor, CellComplex& complex)
{
  this->write(monitor, complex, [](std::uint32_t, std::uint32_t, std::uint32_t, std::size_t) {});
}

void CanonicalForm::writeHull(
  const CoordinateRange& range, int exponent, Monitor& monitor, Hull& hull)
{
  const Buffer<Vertex>& vertices = this->polyhedron.vertices;
  const auto first = std::find(this->rank.begin(), this->rank.end(), 0u) - this->rank.begin();
  const double* const origin = vertices[static_cast<std::size_t>(first)].x;
  const Measure measure(range, exponent);
  std::vector<MeasureSums> parts(this->polyhedron.pieces.size() + 1);
  this->write(monitor, hull,
    [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t part)
    { measure.addTriangle(origin, vertices[a].x, vertices[b].x, vertices[c].x, parts[part]); });
  MeasureSums total;
  for (const MeasureSums& part : parts)
  {
    total.add(part);
  }
  measure.write(total, hull);
}

}
