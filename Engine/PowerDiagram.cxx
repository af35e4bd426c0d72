// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The diagram is read off the triangulation: a facet is a corner, the ring of facets around a site
/// is its cell, and a border edge is a ray along its outward normal, which ends in a corner at
/// infinity. Of that corner only the signs of its direction matter.
#include "PowerDiagram.h"

#include "CellClipper.h"
#include "CellRepair.h"
#include "FacetRings.h"
#include "Monitor.h"
#include "PointSource.h"
#include "PowerCorners.h"
#include "TypedErrors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace flipflop
{
namespace
{

using Index = std::uint32_t;

[[noreturn]] void refuse(std::int64_t index = -1)
{
  throw Error(ErrorCode::BadArgument, index);
}

// ---- The input ---------------------------------------------------------------------------------

/// The visible sites, by their index in the triangulation.
Buffer<PowerSite> loadSites(
  const PointView& points, const WeightView& weights, const Triangulation& triangulation)
{
  requireValid(points, 2);
  requireValid(weights, points.count);
  const PointSource source(points, weights);
  Buffer<PowerSite> sites(triangulation.pointIds.size());
  std::int64_t last = -1;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const std::int64_t id = triangulation.pointIds[i];
    if (id <= last || id >= points.count)
    {
      refuse(id);
    }
    last = id;
    double x[3];
    source.load(static_cast<std::uint32_t>(id), x);
    if (!isFinite(x))
    {
      refuse(id);
    }
    sites[i] = { { x[0], x[1] }, x[2] };
  }
  return sites;
}

/// The cells' corners are in range, and each cell has @p least to @p most of them.
void checkCells(const Triangulation& t, std::int64_t least, std::int64_t most)
{
  const std::int64_t size = static_cast<std::int64_t>(t.connectivity.size());
  if (t.cellSize < 0 || (t.cellSize > 0 && size % t.cellSize != 0) ||
    (t.cellSize == 0 && t.offsets.empty() && size > 0) || size >= NoIndex)
  {
    refuse();
  }
  const std::int64_t cells = t.cellCount();
  std::int64_t end = 0;
  for (std::int64_t c = 0; c < cells; ++c)
  {
    const std::int64_t begin = t.cellBegin(c);
    const std::int64_t next = t.cellBegin(c + 1);
    if (begin != end || next - begin < least || next - begin > most || next > size)
    {
      refuse();
    }
    end = next;
  }
  if (end != size)
  {
    refuse();
  }
  for (const std::int64_t corner : t.connectivity)
  {
    if (corner < 0 || corner >= static_cast<std::int64_t>(t.pointIds.size()))
    {
      refuse();
    }
  }
}

/// The power center of a facet: from the widest triangle of its fan, though any would give the
/// same.
void facetCenter(
  const Triangulation& t, const Buffer<PowerSite>& sites, std::int64_t facet, double* center)
{
  const std::int64_t begin = t.cellBegin(facet);
  const std::int64_t end = t.cellBegin(facet + 1);
  const auto corner = [&](std::int64_t h) -> const PowerSite&
  { return sites[static_cast<std::size_t>(t.connectivity[static_cast<std::size_t>(h)])]; };
  const PowerSite& a = corner(begin);
  std::int64_t best = begin + 1;
  double most = 0.0;
  for (std::int64_t h = begin + 1; end - begin > 3 && h + 1 < end; ++h)
  {
    const PowerSite& b = corner(h);
    const PowerSite& c = corner(h + 1);
    const double area =
      (b.x[0] - a.x[0]) * (c.x[1] - a.x[1]) - (b.x[1] - a.x[1]) * (c.x[0] - a.x[0]);
    if (area > most)
    {
      most = area;
      best = h;
    }
  }
  powerCenter(a, corner(best), corner(best + 1), center);
}

// ---- The output --------------------------------------------------------------------------------

/// Takes the cells one after another, and numbers positions in order of first use.
class Diagram
{
public:
  explicit Diagram(std::size_t facets)
    : numbers(facets)
  {
    std::fill(this->numbers.begin(), this->numbers.end(), NoIndex);
    this->positions.reserve(2 * facets);
    std::size_t slots = 64;
    while (slots < facets + facets / 2)
    {
      slots *= 2;
    }
    this->clear(slots);
    this->ends.push_back(0);
  }

  /// @p cell is in the box. What rounding made equal is one; a cell of two corners is an edge that
  /// its neighbours share.
  void add(std::int64_t id, CellPolygon& cell)
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
      this->cells.push_back(this->number(corner));
    }
    this->ids.push_back(id);
    this->ends.push_back(static_cast<std::int64_t>(this->cells.size()));
  }

  /// Takes what add() was given.
  PowerDiagram finish(const double* box, Monitor& monitor)
  {
    RoundedCells rounded{ std::move(this->positions), std::move(this->cells), std::move(this->ends),
      std::move(this->ids) };
    repairCells(rounded, box, monitor);
    PowerDiagram result;
    copy(rounded.positions, result.corners);
    copy(rounded.corners, result.connectivity);
    copy(rounded.ends, result.offsets);
    copy(rounded.ids, result.siteIds);
    return result;
  }

private:
  template <class From, class To>
  static void copy(const std::vector<From>& from, Buffer<To>& to)
  {
    to.allocate(from.size());
    std::copy(from.begin(), from.end(), to.begin());
  }

  Index number(const CellCorner& corner)
  {
    if (corner.facet == NoIndex)
    {
      return this->numberOf(corner.x[0], corner.x[1]);
    }
    Index& known = this->numbers[corner.facet];
    if (known == NoIndex)
    {
      known = this->numberOf(corner.x[0], corner.x[1]);
    }
    return known;
  }

  /// Different facets may have centers that round to one position.
  Index numberOf(double x, double y)
  {
    x += 0.0; // -0 is 0
    y += 0.0;
    Index& slot = this->find(x, y);
    if (slot != NoIndex)
    {
      return slot;
    }
    const std::size_t count = this->positions.size() / 2;
    if (count >= NoIndex)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(count));
    }
    slot = static_cast<Index>(count);
    this->positions.push_back(x);
    this->positions.push_back(y);
    if (3 * count > 2 * this->table.size())
    {
      this->clear(2 * this->table.size());
      for (Index i = 0; i <= static_cast<Index>(count); ++i)
      {
        this->find(this->positions[2 * std::size_t(i)], this->positions[2 * std::size_t(i) + 1]) =
          i;
      }
    }
    return static_cast<Index>(count);
  }

  /// Where the number of a position stands, or would stand.
  Index& find(double x, double y)
  {
    std::uint64_t a, b;
    std::memcpy(&a, &x, sizeof(a));
    std::memcpy(&b, &y, sizeof(b));
    a = (a ^ (b << 32 | b >> 32)) * 0x9e3779b97f4a7c15u;
    a = (a ^ (a >> 29) ^ b) * 0xbf58476d1ce4e5b9u;
    const std::size_t mask = this->table.size() - 1;
    for (std::size_t i = (a ^ (a >> 32)) & mask;; i = (i + 1) & mask)
    {
      Index& slot = this->table[i];
      if (slot == NoIndex ||
        (this->positions[2 * std::size_t(slot)] == x &&
          this->positions[2 * std::size_t(slot) + 1] == y))
      {
        return slot;
      }
    }
  }

  void clear(std::size_t slots) { this->table.assign(slots, NoIndex); }

  std::vector<Index> table; ///< open addressing; a power of two
  Buffer<Index> numbers;    ///< of the facets' centers
  std::vector<double> positions;
  std::vector<Index> cells;
  std::vector<std::int64_t> ends;
  std::vector<std::int64_t> ids;
};

// ---- The cells, by dimension -------------------------------------------------------------------

/// One site: all of the box.
void addBox(Diagram& diagram, std::int64_t id, const double* box)
{
  CellPolygon cell = { finiteCorner(box[0], box[2], boxSide(2)),
    finiteCorner(box[1], box[2], boxSide(1)), finiteCorner(box[1], box[3], boxSide(3)),
    finiteCorner(box[0], box[3], boxSide(0)) };
  diagram.add(id, cell);
}

/// Tell of progress now and then.
void advance(Monitor& monitor, std::size_t done)
{
  constexpr std::size_t Step = 1024;
  if (done % Step == 0)
  {
    monitor.advance(done ? Step : 0);
  }
}

/// Sites on a line: strips. A strip's two lines are given by a point each, which is no corner.
void addStrips(Diagram& diagram, const Triangulation& t, const Buffer<PowerSite>& sites,
  const double* box, Monitor& monitor)
{
  Buffer<std::array<Index, 2>> neighbours(sites.size());
  std::fill(neighbours.begin(), neighbours.end(), std::array<Index, 2>{ NoIndex, NoIndex });
  for (std::size_t h = 0; h < t.connectivity.size(); ++h)
  {
    auto& mine = neighbours[static_cast<std::size_t>(t.connectivity[h])];
    const Index other = static_cast<Index>(t.connectivity[h ^ 1]);
    if (mine[1] != NoIndex)
    {
      refuse();
    }
    mine[mine[0] == NoIndex ? 0 : 1] = other;
  }
  CellClipper clipper(sites, box);
  CellPolygon cell;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    advance(monitor, i);
    if (neighbours[i][0] == NoIndex)
    {
      refuse(t.pointIds[i]);
    }
    // Up one line and down the other; an end site's other line is at infinity.
    cell.clear();
    for (int k = 0; k < 2; ++k)
    {
      const Index other = neighbours[i][k];
      const PowerSite& a = sites[i];
      const PowerSite& b = sites[other == NoIndex ? neighbours[i][0] : other];
      const int x = (a.x[0] > b.x[0]) - (a.x[0] < b.x[0]);
      const int y = (a.x[1] > b.x[1]) - (a.x[1] < b.x[1]);
      if (other == NoIndex)
      {
        cell.back().line = LineAtInfinity;
        cell.push_back(infiniteCorner(x, y, LineAtInfinity));
        cell.push_back(infiniteCorner(-y, x, neighbours[i][0]));
        continue;
      }
      double middle[2];
      powerMiddle(a, b, middle);
      if (k == 1)
      {
        cell.back().line = other;
      }
      cell.push_back(finiteCorner(middle[0], middle[1], other));
      cell.push_back(infiniteCorner(y, -x, neighbours[i][0]));
    }
    clipper.clip(static_cast<Index>(i), cell);
    // A point within its line's edge comes and goes along one line.
    CellPolygon corners;
    for (std::size_t c = 0; c < cell.size(); ++c)
    {
      if (cell[c].line < 0 || cell[(c + cell.size() - 1) % cell.size()].line != cell[c].line)
      {
        corners.push_back(cell[c]);
      }
    }
    diagram.add(t.pointIds[i], corners);
  }
}

void addCells(Diagram& diagram, const Triangulation& t, const Buffer<PowerSite>& sites,
  const double* box, Monitor& monitor)
{
  Buffer<std::array<double, 2>> centers(static_cast<std::size_t>(t.cellCount()));
  for (std::size_t f = 0; f < centers.size(); ++f)
  {
    advance(monitor, f);
    facetCenter(t, sites, static_cast<std::int64_t>(f), centers[f].data());
  }
  FacetRings rings(t);
  CellClipper clipper(sites, box);
  std::vector<Index> ring;
  CellPolygon cell;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    advance(monitor, i);
    const bool closed = rings.walk(static_cast<Index>(i), ring);
    bool inside = closed;
    cell.clear();
    for (const Index h : ring)
    {
      const Index f = rings.facet(h);
      cell.push_back(finiteCorner(centers[f][0], centers[f][1], rings.source(h), f));
      inside = inside && clipper.inside(centers[f].data());
    }
    if (!closed)
    {
      // Outwards along the last border edge's normal, and back along the first's.
      const PowerSite& a = sites[i];
      const PowerSite& last = sites[rings.source(ring.back())];
      const PowerSite& first = sites[rings.destination(ring.front())];
      const auto compare = [](double p, double q) { return (p > q) - (p < q); };
      cell.push_back(
        infiniteCorner(compare(a.x[1], last.x[1]), compare(last.x[0], a.x[0]), LineAtInfinity));
      cell.push_back(infiniteCorner(
        compare(first.x[1], a.x[1]), compare(a.x[0], first.x[0]), rings.destination(ring.front())));
    }
    if (!inside)
    {
      clipper.clip(static_cast<Index>(i), cell);
    }
    diagram.add(t.pointIds[i], cell);
  }
}

PowerDiagram diagramInBox(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const double* box, const Options& options)
{
  Monitor monitor(options);
  monitor.stage(
    0.0, 1.0, triangulation.cellCount() + static_cast<std::int64_t>(triangulation.pointIds.size()));
  if (!box || !(box[0] < box[1] && box[2] < box[3]))
  {
    refuse();
  }
  for (int k = 0; k < 4; ++k)
  {
    if (!std::isfinite(box[k]))
    {
      refuse();
    }
  }
  const Buffer<PowerSite> sites = loadSites(points, weights, triangulation);
  const int dimension = triangulation.dimension;
  if (dimension < -1 || dimension > 2 || (dimension == -1 && !sites.empty()) ||
    (dimension == 0 && sites.size() != 1) || (dimension == 1 && sites.size() < 2))
  {
    refuse();
  }
  checkCells(triangulation, dimension + 1, dimension < 2 ? dimension + 1 : NoIndex);
  Diagram diagram(dimension == 2 ? static_cast<std::size_t>(triangulation.cellCount()) : 0);
  if (dimension == 0)
  {
    addBox(diagram, triangulation.pointIds[0], box);
  }
  else if (dimension == 1)
  {
    addStrips(diagram, triangulation, sites, box, monitor);
  }
  else if (dimension == 2)
  {
    addCells(diagram, triangulation, sites, box, monitor);
  }
  PowerDiagram result = diagram.finish(box, monitor);
  monitor.stage(1.0, 1.0, 1);
  return result;
}

}

PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const double* box, const Options& options)
{
  return withTypedErrors(
    [&] { return diagramInBox(points, weights, triangulation, box, options); });
}

}
