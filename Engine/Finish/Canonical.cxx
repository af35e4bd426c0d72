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
  const int lower = r[1] < r[0] ? 1 : 0;
  return r[2] < r[lower] ? 2 : lower;
}

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
    this->polygons.emplace(this->surface, this->rank, facetMode == FacetMode::Polygons, monitor);
  }
}

// A facet is of one of three kinds:
// - one triangle;
// - a pair of triangles, where triangles are asked for. Grids are full of them, and they need
//   no walk around the facet. They become two triangles again, from the corner of lowest rank;
// - a polygon (FacetPolygons): of more triangles, or of a pair where polygons are asked for. As
//   triangles it is a fan from its corner of lowest rank.
// A facet with a corner that is no point of the result (at the virtual vertex) is left out.

/// use(vertices, cell, piece) for each cell of the facets that are one triangle or a pair: three
/// vertices, that of lowest rank first, and their ranks.
template <class Surface>
template <class Use>
void CanonicalForm<Surface>::eachSimpleCell(Use&& use) const
{
  this->surface.eachTriangle(
    [&](std::uint32_t t, std::size_t piece)
    {
      if (this->polygons && this->surface.flatEdges(t) != 0)
      {
        if (this->facets == FacetMode::Triangles)
        {
          this->usePair(t, [&](const std::uint32_t* v, const Cell& cell) { use(v, cell, piece); });
        }
        return;
      }
      const std::uint32_t* const v = this->surface.triangles[t].v;
      const std::uint32_t r[3] = { this->rank[v[0]], this->rank[v[1]], this->rank[v[2]] };
      if (r[0] != NoIndex && r[1] != NoIndex && r[2] != NoIndex)
      {
        const int e = lowestOf(r);
        const int f = nextCorner(e);
        const int g = previousCorner(e);
        const std::uint32_t vertices[3] = { v[e], v[f], v[g] };
        use(vertices, Cell{ { r[e], r[f], r[g] } }, piece);
      }
    });
}

/// use(vertices, cell) for the two cells of a facet that is a pair, if t is the lower one of such.
template <class Surface>
template <class Use>
void CanonicalForm<Surface>::usePair(std::uint32_t t, Use&& use) const
{
  const std::uint32_t other = otherOfPair(this->surface, t);
  if (other == NoIndex || other < t)
  {
    return;
  }
  // The flat edge is ab; around the facet: a, d, b, c.
  const auto& triangle = this->surface.triangles[t];
  const int e = onlyFlatEdge(this->surface, t);
  const std::uint32_t d =
    this->surface.triangles[other].v[previousCorner(cornerOf(triangle.twin[e]))];
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
  std::uint32_t v[4];
  std::uint32_t r[4];
  for (int i = 0; i < 4; ++i)
  {
    v[i] = ring[(lowest + i) % 4];
    r[i] = this->rank[v[i]];
  }
  use(v, Cell{ { r[0], r[1], r[2] } });
  v[1] = v[2];
  v[2] = v[3];
  use(v, Cell{ { r[0], r[2], r[3] } });
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
/// polygon, which has the polygon's number, behind all ranks, for its third corner.
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
        use(Cell{ { this->rank[corner[0]], this->rank[corner[1]],
              pointCount + static_cast<std::uint32_t>(p) } },
          piece);
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
  this->eachSimpleCell(
    [&](const std::uint32_t* v, const Cell& cell, std::size_t piece)
    {
      useToo(v, piece);
      sort.count(piece, cell.corner[0]);
    });
  this->eachPolygonCell(
    pointCount, [&](const Cell& cell, std::size_t piece) { sort.count(piece, cell.corner[0]); });
  this->eachFanTriangle(useToo);
  monitor.poll();

  // Second pass: put the cells where the counts say.
  sort.endCounting(std::move(this->surface.vertices));
  this->eachSimpleCell(
    [&](const std::uint32_t*, const Cell& cell, std::size_t piece) { sort.put(piece, cell); });
  this->eachPolygonCell(
    pointCount, [&](const Cell& cell, std::size_t piece) { sort.put(piece, cell); });
  monitor.poll();

  if (this->facets == FacetMode::Polygons && this->polygons && this->polygons->count() > 0)
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
