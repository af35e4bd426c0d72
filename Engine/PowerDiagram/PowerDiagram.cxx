// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The diagram is read off the triangulation: a facet is a corner, the ring of facets around a site
/// is its cell, and a border edge is a ray along its outward normal, which ends in a corner at
/// infinity. Of that corner only the signs of its direction matter.
#include <flipflop/PowerDiagram.h>

#include "Points/PointSource.h"
#include "PowerDiagram/CellClipper.h"
#include "PowerDiagram/CellRepair.h"
#include "PowerDiagram/CornerNumbers.h"
#include "PowerDiagram/DomainCorners.h"
#include "PowerDiagram/PolygonCells.h"
#include "PowerDiagram/PowerCorners.h"
#include "PowerDiagram/SiteNeighbours.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Support/BufferCopy.h"
#include "Support/EngineCall.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace flipflop
{
namespace
{

using Index = std::uint32_t;

/// The power center of a facet: from the widest triangle of its fan, though any would give the
/// same.
Position facetCenter(const CellComplex& t, const Buffer<PowerSite>& sites, std::int64_t facet)
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
  Position center;
  powerCenter(a, corner(best), corner(best + 1), center.data());
  return { center[0] + 0.0, center[1] + 0.0 }; // -0 is 0
}

// ---- The cells, by dimension -------------------------------------------------------------------

/// One site: all of the box.
void addBox(CellChunk& chunk, std::int64_t id, const double* box)
{
  CellPolygon cell = { finiteCorner(box[0], box[2], boxSide(2)),
    finiteCorner(box[1], box[2], boxSide(1)), finiteCorner(box[1], box[3], boxSide(3)),
    finiteCorner(box[0], box[3], boxSide(0)) };
  chunk.add(id, cell);
}

/// Sites on a line: strips. A strip's two lines are given by a point each, which is no corner.
void addStrips(CellChunk& chunk, const CellComplex& t, const std::uint8_t* wanted,
  const Buffer<PowerSite>& sites, const double* box, Monitor& monitor)
{
  const LineNeighbours neighbours = lineNeighbours(t);
  CellClipper clipper(sites, box);
  CellPolygon cell;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if ((i + 1) % StepPoll::Every == 0)
    {
      monitor.advance(StepPoll::Every);
    }
    if (wanted && !wanted[i])
    {
      continue;
    }
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
    chunk.add(t.pointIds[i], corners);
  }
}

/// The corners of a site's cell before the box cuts it.
/// @return is all of it in the box?
bool cellOf(Index site, const VertexStars<CellSides>& stars, const Star& star,
  const Buffer<Position>& centers, const Buffer<PowerSite>& sites, const CellClipper& clipper,
  CellPolygon& cell)
{
  bool inside = star.isClosed;
  cell.clear();
  for (const Index h : star.ring)
  {
    const Index f = stars.of().cell(h);
    cell.push_back(finiteCorner(centers[f][0], centers[f][1], stars.source(h), f));
    inside = inside && clipper.inside(centers[f].data());
  }
  if (!star.isClosed)
  {
    // Outwards along the last border edge's normal, and back along the first's.
    const Index next = stars.destination(star.ring.front());
    const PowerSite& a = sites[site];
    const PowerSite& last = sites[stars.source(star.ring.back())];
    const PowerSite& first = sites[next];
    const auto compare = [](double p, double q) { return (p > q) - (p < q); };
    cell.push_back(
      infiniteCorner(compare(a.x[1], last.x[1]), compare(last.x[0], a.x[0]), LineAtInfinity));
    cell.push_back(infiniteCorner(compare(first.x[1], a.x[1]), compare(a.x[0], first.x[0]), next));
  }
  return inside;
}

/// The cells of a run of sites.
void addCells(CellChunk& chunk, Index begin, Index end, const CellComplex& t,
  const std::uint8_t* wanted, const VertexStars<CellSides>& stars, const Buffer<Position>& centers,
  const Buffer<PowerSite>& sites, const double* box)
{
  CellClipper clipper(sites, box);
  Star star;
  CellPolygon cell;
  for (Index i = begin; i < end; ++i)
  {
    if (wanted && !wanted[i])
    {
      continue;
    }
    linkFacets(stars, t, i, star);
    if (!cellOf(i, stars, star, centers, sites, clipper, cell))
    {
      clipper.clip(i, cell);
    }
    chunk.add(t.pointIds[i], cell);
  }
}

Buffer<Position> facetCenters(
  const CellComplex& t, const Buffer<PowerSite>& sites, Monitor& monitor)
{
  Buffer<Position> centers(static_cast<std::size_t>(t.cellCount()));
  eachCheckedChunk(centers.size(), FacetsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        centers[f] = facetCenter(t, sites, static_cast<std::int64_t>(f));
      }
      monitor.advance(static_cast<std::int64_t>(end - begin));
    });
  return centers;
}

/// Corners and cells as rounded.
/// @param wanted by site: is its cell wanted? null: all are
RoundedCells roundedCells(const CellComplex& t, const std::uint8_t* wanted,
  const Buffer<PowerSite>& sites, const double* box, Monitor& monitor)
{
  if (t.dimension < 2)
  {
    std::vector<CellChunk> chunks(1, CellChunk(0));
    if (t.dimension == 0 && (!wanted || wanted[0]))
    {
      addBox(chunks[0], t.pointIds[0], box);
    }
    else if (t.dimension == 1)
    {
      addStrips(chunks[0], t, wanted, sites, box, monitor);
    }
    monitor.stage(0.8, 0.9, 1);
    return numberCorners(chunks, Buffer<Position>(), monitor);
  }
  const Buffer<Position> centers = facetCenters(t, sites, monitor);
  const VertexStars<CellSides> stars{ CellSides(t) };
  monitor.poll();
  std::vector<CellChunk> chunks(chunkCount(sites.size(), SitesPerTask), CellChunk(centers.size()));
  eachCheckedChunk(sites.size(), SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      addCells(chunks[number], static_cast<Index>(begin), static_cast<Index>(end), t, wanted, stars,
        centers, sites, box);
      monitor.advance(static_cast<std::int64_t>(end - begin));
    });
  monitor.stage(0.8, 0.9, 1);
  return numberCorners(chunks, centers, monitor);
}

void copyCells(const RoundedCells& cells, PowerDiagram& result)
{
  copyTo(cells.positions, result.corners);
  copyTo(cells.corners, result.connectivity);
  copyTo(cells.ends, result.offsets);
  copyTo(cells.ids, result.siteIds);
}

/// work(monitor, sites) on the run's threads, then copy what it returns.
/// @param work bool (Monitor&, const Buffer<PowerSite>&, RoundedCells&): false: there is no result
template <class Work>
bool makeCells(const PointView& points, const WeightView& weights, const CellComplex& complex,
  const Options& options, PowerDiagram& result, const Work& work)
{
  Monitor monitor(options);
  monitor.stage(0.0, 0.8, complex.cellCount() + static_cast<std::int64_t>(complex.pointIds.size()),
    "making cells");
  bool isMade = true;
  ArenaLoan arena(threadCount(options.threads, static_cast<std::int64_t>(complex.pointIds.size())));
  arena.execute(
    [&]
    {
      const Buffer<PowerSite> sites = loadSites(points, weights, complex);
      requireCells(complex);
      RoundedCells cells;
      isMade = work(monitor, sites, cells);
      if (isMade)
      {
        copyCells(cells, result);
        monitor.stage(1.0, 1.0, 1);
      }
    });
  return isMade;
}

/// @param wanted by site: is its cell wanted? null: all are
/// @return false: some are wanted, and one of these is not convex
bool diagramInBox(const PointView& points, const WeightView& weights, const CellComplex& complex,
  const std::uint8_t* wanted, const double* box, const Options& options, PowerDiagram& result)
{
  requireBox(box);
  return makeCells(points, weights, complex, options, result,
    [&](Monitor& monitor, const Buffer<PowerSite>& sites, RoundedCells& cells)
    {
      cells = roundedCells(complex, wanted, sites, box, monitor);
      monitor.stage(0.9, 1.0, 1, "finishing");
      if (wanted)
      {
        return areConvex(cells, box, monitor);
      }
      repairCells(cells, box, monitor);
      return true;
    });
}

void diagramInPolygon(const PointView& points, const WeightView& weights,
  const CellComplex& complex, const std::vector<double>& polygon, const Options& options,
  PowerDiagram& result)
{
  makeCells(points, weights, complex, options, result,
    [&](Monitor& monitor, const Buffer<PowerSite>& sites, RoundedCells& cells)
    {
      cells = cellsInPolygon(complex, sites,
        complex.dimension == 2 ? facetCenters(complex, sites, monitor) : Buffer<Position>(),
        polygon, monitor);
      monitor.stage(0.9, 1.0, 1, "finishing");
      repairCells(cells, boundingBox(polygon).data(), monitor, &polygon);
      return true;
    });
}

}

PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const double* box, const Options& options)
{
  return engineCall(
    [&] { return powerDiagram(points, weights, triangulation, ConvexDomain(box), options); });
}

PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const ConvexDomain& domain, const Options& options)
{
  return engineCall(
    [&]
    {
      PowerDiagram result;
      if (domain.corners == 0)
      {
        diagramInBox(points, weights, triangulation, nullptr, domain.data, options, result);
      }
      else
      {
        diagramInPolygon(points, weights, triangulation, domainCorners(domain), options, result);
      }
      return result;
    });
}

bool powerCells(const PointView& points, const WeightView& weights, const CellComplex& facets,
  const std::uint8_t* wanted, const double* box, PowerDiagram& diagram, const Options& options)
{
  return engineCall(
    [&]
    {
      diagram = PowerDiagram();
      if (facets.pointIds.empty())
      {
        return true;
      }
      if (!wanted)
      {
        throw badArgument("wanted must have one flag for each of the facets' points");
      }
      return diagramInBox(points, weights, facets, wanted, box, options, diagram);
    });
}

}
