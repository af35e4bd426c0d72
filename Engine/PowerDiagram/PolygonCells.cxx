// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PowerDiagram/PolygonCells.h"

#include "PowerDiagram/DomainCorners.h"
#include "PowerDiagram/PolygonClipper.h"
#include "PowerDiagram/SiteNeighbours.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace flipflop
{
namespace
{

using Index = std::uint32_t;

/// Of polygons with more sides, a cell is first sought in their bounding box.
constexpr std::size_t FewSides = 8;

class PolygonCells
{
public:
  PolygonCells(const CellComplex& triangulation, const Buffer<PowerSite>& given,
    const Buffer<Position>& facetCenters, const std::vector<double>& corners)
    : t(triangulation)
    , sites(given)
    , centers(facetCenters)
    , polygon(corners)
    , neighbours(triangulation)
    , isSurelyInside(facetCenters.size())
  {
    const std::array<double, 4> b = boundingBox(corners);
    this->box = { b[0], b[2], b[1], b[2], b[1], b[3], b[0], b[3] };
    eachChunk(this->centers.size(), FacetsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t f = begin; f < end; ++f)
        {
          this->isSurelyInside[f] = surelyHolds(this->polygon, this->centers[f].data()) ? 1 : 0;
        }
      });
  }

  void add(CellChunk& chunk, Index begin, Index end) const
  {
    PolygonClipper clipper(this->sites, this->polygon);
    PolygonClipper boxClipper(this->sites, this->box);
    Star star;
    std::vector<Index> around;
    CellPolygon cell;
    for (Index i = begin; i < end; ++i)
    {
      this->neighbours.find(i, star, around);
      if (around.empty() && this->sites.size() > 1)
      {
        refuse(this->t.pointIds[i]);
      }
      if (!this->isInside(star, cell))
      {
        this->checkRing(i, star);
        if (!around.empty())
        {
          // The edge to the first neighbour ends in the first facet's center.
          std::rotate(around.begin(), around.begin() + 1, around.end());
        }
        if (this->polygon.size() / 2 > FewSides)
        {
          boxClipper.clip(i, around, cell);
          if (cell.empty())
          {
            continue;
          }
        }
        clipper.clip(i, around, cell);
      }
      chunk.add(this->t.pointIds[i], cell);
    }
  }

private:
  /// Is the triangulation regular at the edges from a site? The center of a facet must not be in
  /// the power of what is opposite across its next edge.
  /// @throw Error BadArgument
  void checkRing(Index site, const Star& star) const
  {
    const VertexStars<CellSides>* const facets = this->neighbours.facets();
    const std::size_t count = facets ? star.ring.size() : 0;
    for (std::size_t i = 0; i < (star.isClosed ? count : std::max<std::size_t>(count, 1) - 1); ++i)
    {
      const Index h = star.ring[i];
      const auto lineTo = [this](Index other) {
        return CellLine{ &this->sites[other], nullptr, nullptr };
      };
      const CellCutter cutter(
        this->sites[site], this->sites[facets->source(star.ring[(i + 1) % count])]);
      const int quick = cutter.signOfRounded(this->centers[facets->of().cell(h)].data());
      if (quick < 0 ||
        (quick == 0 && cutter.sign(lineTo(facets->destination(h)), lineTo(facets->source(h))) < 0))
      {
        throw badArgument(NotATriangulation, this->t.pointIds[site]);
      }
    }
  }

  /// Has the cell certainly no corner outside of the polygon? Then it becomes these.
  bool isInside(const Star& star, CellPolygon& cell) const
  {
    cell.clear();
    if (!this->neighbours.facets() || !star.isClosed)
    {
      return false;
    }
    for (const Index h : star.ring)
    {
      const Index f = this->neighbours.facets()->of().cell(h);
      if (!this->isSurelyInside[f])
      {
        return false;
      }
      cell.push_back(finiteCorner(
        this->centers[f][0], this->centers[f][1], this->neighbours.facets()->source(h), f));
    }
    return true;
  }

  const CellComplex& t;
  const Buffer<PowerSite>& sites;
  const Buffer<Position>& centers;
  const std::vector<double>& polygon;
  std::vector<double> box; ///< around the polygon, as a polygon
  const SiteNeighbours neighbours;
  std::vector<std::uint8_t> isSurelyInside; ///< of each facet's center
};

}

RoundedCells cellsInPolygon(const CellComplex& t, const Buffer<PowerSite>& sites,
  const Buffer<Position>& centers, const std::vector<double>& polygon, Monitor& monitor)
{
  const PolygonCells cells(t, sites, centers, polygon);
  monitor.poll();
  std::vector<CellChunk> chunks(chunkCount(sites.size(), SitesPerTask), CellChunk(centers.size()));
  eachCheckedChunk(sites.size(), SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      cells.add(chunks[number], static_cast<Index>(begin), static_cast<Index>(end));
      monitor.advance(static_cast<std::int64_t>(end - begin));
    });
  monitor.stage(0.8, 0.9, 1);
  return numberCorners(chunks, centers, monitor);
}

}
