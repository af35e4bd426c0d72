// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The diagram is read off the triangulation: a facet's power center is a corner, and the ring of
/// facets around a site is its cell. That is all of a cell whose corners are surely in the polygon,
/// as most are. Any other is the polygon, cut by the lines to the site's neighbours (CellRing.h).
///
/// All signs are exact (CellLines.h). So a cell is the true one, but for its corners' coordinates,
/// each rounded to nearest; neighbours find the same bits, and corners of the polygon stay as they
/// are.
#include "PowerDiagram/PowerCells.h"

#include "PowerDiagram/CellDomain.h"
#include "PowerDiagram/CellLines.h"
#include "PowerDiagram/CellRing.h"
#include "PowerDiagram/CornerNumbers.h"
#include "PowerDiagram/SiteNeighbours.h"
#include "PowerDiagram/StartInBox.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace flipflop
{
namespace
{

using Index = std::uint32_t;

/// Three sites of a facet: of its fan the widest triangle, though any would give the same center.
std::array<const PowerSite*, 3> triangleOf(
  const CellComplex& t, const Buffer<PowerSite>& sites, std::int64_t facet)
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
  return { &a, &corner(best), &corner(best + 1) };
}

/// What the cell of a site is cut by, by number (CellRing.h).
struct LinesOfCell
{
  const CellDomain& domain;
  const Buffer<PowerSite>& sites;
  const PowerSite& site;
  const std::vector<Index>& neighbours; ///< the first facet is between the last and the first
  const CellPolygon& whole;             ///< the facets' centers

  CellLine operator[](std::int64_t line) const
  {
    return line < 0 ? this->domain.side(static_cast<std::size_t>(-1 - line))
                    : lineTo(this->sites[this->neighbours[static_cast<std::size_t>(line)]]);
  }

  /// Of two that turn left.
  void meet(std::int64_t a, std::int64_t b, double* x) const
  {
    const auto next = static_cast<std::size_t>(a + 1) % this->neighbours.size();
    const auto facet = static_cast<std::size_t>(b);
    if (a >= 0 && b >= 0 && facet == next && facet < this->whole.size())
    {
      x[0] = this->whole[facet].x[0];
      x[1] = this->whole[facet].x[1];
      return;
    }
    meetingOf(this->site, (*this)[a], (*this)[b], x);
  }
};

/// One of them, for CellRing::cut().
class ExactCutter
{
public:
  static constexpr bool IsExact = true;

  ExactCutter(const LinesOfCell& linesOfCell, std::int64_t line)
    : lines(linesOfCell)
    , own(line)
    , cutter(linesOfCell.site, *linesOfCell[line].other)
  {
  }

  int side(const RingCorner& before, const RingCorner& corner) const
  {
    const int quick = this->cutter.signOfRounded(corner.x);
    return quick != 0 ? quick
                      : this->cutter.sign(this->lines[before.line], this->lines[corner.line]);
  }

  int rise(const RingCorner& from, const RingCorner& /*to*/) const
  {
    return this->cutter.rise(this->lines[from.line]);
  }

  void meet(const RingCorner& from, const RingCorner& /*to*/, bool leaves, double* x) const
  {
    this->lines.meet(leaves ? from.line : this->own, leaves ? this->own : from.line, x);
  }

private:
  const LinesOfCell& lines;
  const std::int64_t own;
  const CellCutter cutter;
};

class CellMaker
{
public:
  CellMaker(const CellComplex& triangulation, const Buffer<PowerSite>& given,
    const std::vector<double>& polygon, bool isBox, Monitor& monitor)
    : t(triangulation)
    , sites(given)
    , domain(polygon, isBox)
    , neighbours(triangulation)
    , centers(neighbours.facets() ? static_cast<std::size_t>(t.cellCount()) : 0)
    , where(centers.size())
  {
    eachCheckedChunk(this->centers.size(), FacetsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t f = begin; f < end; ++f)
        {
          const auto triangle = triangleOf(t, this->sites, static_cast<std::int64_t>(f));
          Position& center = this->centers[f];
          centerOf(*triangle[0], *triangle[1], *triangle[2], center.data());
          this->where[f] = this->domain.whereIs(center, triangle);
        }
        monitor.advance(static_cast<std::int64_t>(end - begin));
      });
  }

  const Buffer<Position>& facetCenters() const { return this->centers; }

  /// The cells of some sites that follow each other.
  void add(CellChunk& chunk, Index begin, Index end, const std::uint8_t* wanted) const
  {
    CellRing cut;
    Star star;
    std::vector<Index> around;
    CellPolygon whole;
    CellPolygon cell;
    for (Index i = begin; i < end; ++i)
    {
      if (wanted && !wanted[i])
      {
        continue;
      }
      this->neighbours.link(i, star);
      if (this->isDecided(star, whole))
      {
        chunk.add(this->t.pointIds[i], whole);
        continue;
      }
      this->neighbours.list(i, star, around);
      this->checkAround(i, star, around);
      this->cutCell(i, whole, around, cut, cell);
      chunk.add(this->t.pointIds[i], cell);
    }
  }

private:
  /// Do the facets alone show what is left of the cell, all or nothing?
  /// @param whole becomes the facets' centers; if nothing is left, nothing
  bool isDecided(const Star& star, CellPolygon& whole) const
  {
    whole.clear();
    bool isInBox = star.isClosed;
    for (const Index h : star.ring)
    {
      const Index f = this->neighbours.facets()->of().cell(h);
      whole.push_back({ this->centers[f], f });
      isInBox = isInBox && this->domain.isInBox(this->centers[f]);
    }
    if (isInBox || !star.isClosed)
    {
      return isInBox;
    }
    std::uint8_t common = 0xFF;
    for (const CellCorner& corner : whole)
    {
      common &= this->where[corner.facet];
    }
    if (common != 0 && common < CellDomain::Inside)
    {
      whole.clear();
    }
    return common != 0;
  }

  void cutCell(Index site, const CellPolygon& whole, std::vector<Index>& around, CellRing& ring,
    CellPolygon& cell) const
  {
    cell.clear();
    if (!around.empty())
    {
      // The edge to the first neighbour starts in the first facet's center.
      std::rotate(around.begin(), around.begin() + 1, around.end());
    }
    const LinesOfCell lines = { this->domain, this->sites, this->sites[site], around, whole };
    ring.begin(this->domain.corners);
    for (std::size_t i = 0; i < around.size() && !ring.isEmpty(); ++i)
    {
      const auto line = static_cast<std::int64_t>(i);
      ring.cut(ExactCutter(lines, line), line);
    }
    if (ring.isEmpty())
    {
      return;
    }
    this->removeSpikes(ring);
    ring.eachFrom(this->startOf(ring, site, whole, around),
      [&](CellRing::Index i) {
        cell.push_back({ { ring[i].x[0], ring[i].x[1] }, NoIndex });
      });
  }

  void removeSpikes(CellRing& ring) const
  {
    std::vector<CellRing::Index> spikes;
    ring.eachFrom(ring.first(),
      [&](CellRing::Index i)
      {
        if (this->domain.isSpike(ring, i))
        {
          spikes.push_back(i);
        }
      });
    for (const CellRing::Index i : spikes)
    {
      ring.remove(i);
    }
  }

  /// In a box, see StartInBox.h. Else from the first neighbour's edge, or from the polygon's first
  /// corner.
  CellRing::Index startOf(const CellRing& ring, Index site, const CellPolygon& whole,
    const std::vector<Index>& around) const
  {
    const auto rank = [&ring](CellRing::Index corner)
    {
      const std::int64_t line = ring[corner].line;
      return line >= 0 ? line : static_cast<std::int64_t>(NoIndex) - line;
    };
    CellRing::Index start = ring.first();
    CellRing::Index endOfLast = NoIndex;
    ring.eachFrom(ring.first(),
      [&](CellRing::Index i)
      {
        start = rank(i) < rank(start) ? i : start;
        endOfLast =
          rank(i) + 1 == static_cast<std::int64_t>(around.size()) ? ring[i].after : endOfLast;
      });
    if (!this->domain.isBox || around.empty())
    {
      return start;
    }
    const CellRing::Index found =
      startInBox(ring, this->domain.bounds, this->startOfBorder(site, whole, around),
        [&](std::size_t side, const double* x)
        {
          return std::any_of(around.begin(), around.end(),
            [&](Index other)
            { return isEntry(this->sites[site], this->sites[other], this->domain.side(side), x); });
        });
    return found != NoIndex ? found : whole.empty() && endOfLast != NoIndex ? endOfLast : start;
  }

  /// Where the cell starts before it is cut: in the first facet's center. A strip has no corners,
  /// but starts on its last line, where that meets the line of the sites.
  Position startOfBorder(
    Index site, const CellPolygon& whole, const std::vector<Index>& around) const
  {
    if (!whole.empty())
    {
      return whole[0].x;
    }
    const PowerSite& own = this->sites[site];
    const PowerSite& last = this->sites[around.back()];
    Position position;
    meetingOf(own, lineTo(last), { nullptr, last.x, own.x }, position.data());
    return position;
  }

  /// Does the line to a neighbour come into the domain over a side, and do so at a position?
  static bool isEntry(
    const PowerSite& site, const PowerSite& neighbour, const CellLine& side, const double* x)
  {
    if (CellCutter(site, neighbour).rise(side) <= 0)
    {
      return false;
    }
    Position meeting;
    meetingOf(site, side, lineTo(neighbour), meeting.data());
    return meeting[0] == x[0] && meeting[1] == x[1];
  }

  /// Are there neighbours, elsewhere, and is the triangulation regular at the edges to them? The
  /// center of a facet must not be in the power of what is opposite across its next edge.
  /// @throw Error BadArgument
  void checkAround(Index site, const Star& star, const std::vector<Index>& around) const
  {
    const double* const x = this->sites[site].x;
    if ((around.empty() && this->sites.size() > 1) ||
      std::any_of(around.begin(), around.end(),
        [&](Index other) { return std::equal(x, x + 2, this->sites[other].x); }))
    {
      refuse(this->t.pointIds[site]);
    }
    const VertexStars<CellSides>* const facets = this->neighbours.facets();
    const std::size_t count = star.ring.size();
    for (std::size_t i = 0; i < (star.isClosed ? count : std::max<std::size_t>(count, 1) - 1); ++i)
    {
      const Index h = star.ring[i];
      const CellCutter cutter(
        this->sites[site], this->sites[facets->source(star.ring[(i + 1) % count])]);
      const int quick = cutter.signOfRounded(this->centers[facets->of().cell(h)].data());
      if (quick < 0 ||
        (quick == 0 &&
          cutter.sign(lineTo(this->sites[facets->destination(h)]),
            lineTo(this->sites[facets->source(h)])) < 0))
      {
        refuse(this->t.pointIds[site]);
      }
    }
  }

  const CellComplex& t;
  const Buffer<PowerSite>& sites;
  const CellDomain domain;
  const SiteNeighbours neighbours;
  Buffer<Position> centers;   ///< of the facets
  Buffer<std::uint8_t> where; ///< they are
};

}

void writeCenters(
  const CellComplex& t, const Buffer<PowerSite>& sites, double* centers, Monitor& monitor)
{
  eachCheckedChunk(static_cast<std::size_t>(t.cellCount()), FacetsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const auto triangle = triangleOf(t, sites, static_cast<std::int64_t>(f));
        centerOf(*triangle[0], *triangle[1], *triangle[2], centers + 2 * f);
      }
      monitor.advance(static_cast<std::int64_t>(end - begin));
    });
}

RoundedCells roundedCells(const CellComplex& t, const std::uint8_t* wanted,
  const Buffer<PowerSite>& sites, const std::vector<double>& polygon, bool isBox, Monitor& monitor)
{
  const CellMaker maker(t, sites, polygon, isBox, monitor);
  monitor.poll();
  std::vector<CellChunk> chunks(
    chunkCount(sites.size(), SitesPerTask), CellChunk(maker.facetCenters().size()));
  eachCheckedChunk(sites.size(), SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      maker.add(chunks[number], static_cast<Index>(begin), static_cast<Index>(end), wanted);
      monitor.advance(static_cast<std::int64_t>(end - begin));
    });
  monitor.stage(0.8, 0.9, 1);
  return numberCorners(chunks, maker.facetCenters(), monitor);
}

}
