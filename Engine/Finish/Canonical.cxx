// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Finish/Canonical.h"

#include "Finish/CellSort.h"
#include "Finish/Measure.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace flipflop
{

namespace
{

constexpr std::uint32_t ItemsPerTask = 1 << 14; ///< cells

template <class Surface>
void writeMixed(const Buffer<Cell>& cells, const VertexRanks& rank,
  const FacetPolygons<Surface>& polygons, std::uint32_t pointCount, Monitor& monitor,
  CellComplex& complex)
{
  const auto isPolygon = [&](const Cell& cell) { return cell.corner[2] >= pointCount; };
  const auto number = [&](const Cell& cell) { return cell.corner[2] - pointCount; };
  std::vector<std::size_t> next(
    chunkCount(cells.size(), ItemsPerTask)); // where each run's corners go
  eachChunk(cells.size(), ItemsPerTask,
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
  eachChunk(cells.size(), ItemsPerTask,
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

/// Turns three corners such that the one of lowest rank is the first: by masks, since nothing could
/// predict a branch.
class Rotation
{
public:
  explicit Rotation(const Cell& ranks)
  {
    const std::uint32_t* const r = ranks.corner;
    const std::uint32_t low = std::min(std::min(r[0], r[1]), r[2]);
    this->toSecond = 0u - static_cast<std::uint32_t>(low == r[1]);
    this->toThird = 0u - static_cast<std::uint32_t>(low == r[2]);
    this->toFirst = ~(this->toSecond | this->toThird);
  }

  Cell operator()(const Cell& cell) const
  {
    const std::uint32_t* const x = cell.corner;
    return { { this->choose(x[0], x[1], x[2]), this->choose(x[1], x[2], x[0]),
      this->choose(x[2], x[0], x[1]) } };
  }

private:
  std::uint32_t choose(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
  {
    return (a & this->toFirst) | (b & this->toSecond) | (c & this->toThird);
  }

  std::uint32_t toFirst, toSecond, toThird;
};

}

template <class Surface>
CanonicalForm<Surface>::CanonicalForm(Surface& surfaceToWrite, bool anyFlat,
  const std::vector<Duplicate>& duplicates, std::uint32_t pointCount, FacetMode facetMode,
  Monitor& monitor, Buffer<std::int64_t>& pointIds)
  : facets(facetMode)
  , surface(surfaceToWrite)
  , rank(surfaceToWrite.vertices, duplicates, pointCount, monitor, pointIds)
{
  if (anyFlat)
  {
    this->polygons.emplace(this->surface, this->rank, facetMode == FacetMode::Triangles, monitor);
  }
}

// A facet is one triangle or a polygon (FacetPolygons). As triangles, a polygon is a fan from its
// corner of lowest rank. A facet with a corner that is no point of the result (at the virtual
// vertex) is omitted.

/// use(vertices, cell, piece) for each facet that is one triangle: three vertices, that of lowest
/// rank first, and their ranks.
template <class Surface>
template <class Use>
void CanonicalForm<Surface>::eachTriangle(Use&& use) const
{
  const bool anyFlat = this->polygons.has_value();
  this->surface.eachTriangle(
    [&](std::uint32_t t, std::size_t piece)
    {
      if (anyFlat && this->surface.flatEdges(t) != 0)
      {
        return;
      }
      const std::uint32_t* const corner = this->surface.triangles[t].v;
      const Cell vertices{ { corner[0], corner[1], corner[2] } };
      const Cell cell{ { this->rank[corner[0]], this->rank[corner[1]], this->rank[corner[2]] } };
      if (std::max(std::max(cell.corner[0], cell.corner[1]), cell.corner[2]) != NoIndex)
      {
        const Rotation rotation(cell);
        use(rotation(vertices).corner, rotation(cell), piece);
      }
    });
}

/// use(vertices, piece) for each triangle of the polygons' fans.
template <class Surface>
template <class Use>
void CanonicalForm<Surface>::eachFanTriangle(Use&& use) const
{
  if (!this->polygons)
  {
    return;
  }
  this->polygons->each(
    [&](std::size_t p, std::size_t piece)
    {
      const std::uint32_t* const corner = this->polygons->first(p);
      for (std::size_t i = 2; i < this->polygons->size(p); ++i)
      {
        const std::uint32_t vertices[3] = { corner[0], corner[i - 1], corner[i] };
        use(vertices, piece);
      }
    });
}

/// use(cell, piece) for each cell that the polygons become: their fans' triangles; or one for a
/// polygon of four corners or more, which has the polygon's number, behind all ranks, for its third
/// corner.
template <class Surface>
template <class Use>
void CanonicalForm<Surface>::eachPolygonCell(std::uint32_t pointCount, Use&& use) const
{
  if (this->facets == FacetMode::Triangles)
  {
    this->eachFanTriangle(
      [&](const std::uint32_t* v, std::size_t piece) {
        use(Cell{ { this->rank[v[0]], this->rank[v[1]], this->rank[v[2]] } }, piece);
      });
  }
  else if (this->polygons)
  {
    this->polygons->each(
      [&](std::size_t p, std::size_t piece)
      {
        const std::uint32_t* const corner = this->polygons->first(p);
        const std::uint32_t third = this->polygons->size(p) == 3
          ? this->rank[corner[2]]
          : pointCount + static_cast<std::uint32_t>(p);
        use(Cell{ { this->rank[corner[0]], this->rank[corner[1]], third } }, piece);
      });
  }
}

/// @param useToo void (vertices, number of the piece), of every triangle of the result
template <class Surface>
template <class Use>
void CanonicalForm<Surface>::write(Monitor& monitor, CellComplex& complex, Use&& useToo)
{
  const auto pointCount = static_cast<std::uint32_t>(complex.pointIds.size());
  CellSort sort(pointCount, this->surface.pieceCount());

  // First pass: count.
  this->eachTriangle(
    [&](const std::uint32_t* v, const Cell& cell, std::size_t piece)
    {
      useToo(v, piece);
      sort.count(piece, cell.corner[0]);
    });
  this->eachPolygonCell(
    pointCount, [&](const Cell& cell, std::size_t piece) { sort.count(piece, cell.corner[0]); });
  this->eachFanTriangle(useToo);
  monitor.poll();

  // Second pass: put the cells at the indices that the counts give.
  sort.endCounting(std::move(this->surface.vertices));
  this->eachTriangle(
    [&](const std::uint32_t*, const Cell& cell, std::size_t piece) { sort.put(piece, cell); });
  this->eachPolygonCell(
    pointCount, [&](const Cell& cell, std::size_t piece) { sort.put(piece, cell); });
  monitor.poll();

  if (this->facets == FacetMode::Polygons && this->polygons && !this->polygons->areTriangles())
  {
    const Buffer<Cell> cells = sort.sort();
    monitor.poll();
    writeMixed(cells, this->rank, *this->polygons, pointCount, monitor, complex);
    return;
  }
  complex.cellSize = 3;
  complex.connectivity =
    Buffer<std::int64_t>::recycle(std::move(this->surface.triangles), 3 * sort.size());
  sort.sortTriangles(complex.connectivity.data());
  monitor.poll();
}

template <class Surface>
void CanonicalForm<Surface>::writeCells(Monitor& monitor, CellComplex& complex)
{
  this->write(monitor, complex, [](const std::uint32_t*, std::size_t) {});
}

template <class Surface>
void CanonicalForm<Surface>::writeHull(
  const CoordinateRange& range, int exponent, Monitor& monitor, Hull& hull)
{
  if constexpr (std::is_same_v<Surface, Polyhedron>)
  {
    const Buffer<Vertex>& vertices = this->surface.vertices;
    std::uint32_t first = 0;
    while (this->rank[first] != 0)
    {
      ++first;
    }
    const double* const origin = vertices[first].x;
    const Measure measure(range, exponent);
    std::vector<MeasureSums> parts(this->surface.pieceCount());
    this->write(monitor, hull,
      [&](const std::uint32_t* v, std::size_t part)
      {
        measure.addTriangle(
          origin, vertices[v[0]].x, vertices[v[1]].x, vertices[v[2]].x, parts[part]);
      });
    MeasureSums total;
    for (const MeasureSums& part : parts)
    {
      total.add(part);
    }
    measure.write(total, hull);
  }
}

template class CanonicalForm<Polyhedron>;
template class CanonicalForm<PlanePolyhedron>;

}
