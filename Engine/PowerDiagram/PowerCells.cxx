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

#include "Geometry/ConvexPolygon.h"
#include "PowerDiagram/CellLines.h"
#include "PowerDiagram/CellRing.h"
#include "PowerDiagram/CornerNumbers.h"
#include "PowerDiagram/DomainCorners.h"
#include "PowerDiagram/SiteNeighbours.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Predicates/PlaneOrientation.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

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

CellLine lineTo(const PowerSite& other)
{
  return { &other, nullptr, nullptr };
}

/// The polygon that cells are cut by.
class Domain
{
public:
  /// Where the center of a facet is: a bit for each side of the bounding box that it is not within,
  /// and one more if it is in the polygon. None: that is not known.
  static constexpr std::uint8_t Inside = 16;

  explicit Domain(const std::vector<double>& polygon)
    : corners(polygon)
    , bounds(boundingBox(polygon))
    , isBox(polygon == boxCorners(bounds.data()))
  {
  }

  /// Rounding keeps the order along each axis, but may take a position to a side.
  bool isInBox(const Position& x) const
  {
    const std::array<double, 4>& b = this->bounds;
    return this->isBox && x[0] > b[0] && x[0] < b[1] && x[1] > b[2] && x[1] < b[3];
  }

  /// @param x        the center, each coordinate rounded to nearest
  /// @param triangle of the facet
  std::uint8_t whereIs(const Position& x, const std::array<const PowerSite*, 3>& triangle) const
  {
    if (this->isInBox(x))
    {
      return Inside;
    }
    const std::array<double, 4>& b = this->bounds;
    int sides =
      (x[0] < b[0] ? 1 : 0) | (x[0] > b[1] ? 2 : 0) | (x[1] < b[2] ? 4 : 0) | (x[1] > b[3] ? 8 : 0);
    if (sides != 0 || !this->isBox)
    {
      return static_cast<std::uint8_t>(sides == 0 && this->surelyHolds(x) ? Inside : sides);
    }
    constexpr std::size_t numbers[] = { 3, 1, 0, 2 };
    bool isInside = true;
    for (std::size_t k = 0; k < 4; ++k)
    {
      if (x[k / 2] == b[k])
      {
        const int sign = sideOfMeeting(
          *triangle[0], lineTo(*triangle[1]), lineTo(*triangle[2]), this->side(numbers[k]));
        sides |= (sign <= 0 ? 1 : 0) << k;
        isInside = isInside && sign >= 0;
      }
    }
    return static_cast<std::uint8_t>(sides | (isInside ? Inside : 0));
  }

  /// From one corner of the polygon to the next.
  CellLine side(std::size_t number) const
  {
    return { nullptr, this->corner(number), this->corner(number + 1) };
  }

  /// Where a cell in a box starts: at a position, if that is a corner; else where the sides end
  /// that cut it off, those of x first, then those of y.
  /// @param entry the first corner after it on an edge to a neighbour, if there is one
  CellRing::Index startInBox(
    const CellRing& ring, CellRing::Index entry, const Position& wanted) const
  {
    CellRing::Index found = NoIndex;
    ring.eachFrom(entry,
      [&](CellRing::Index i)
      {
        const bool isThere = ring[i].x[0] == wanted[0] && ring[i].x[1] == wanted[1];
        found = found == NoIndex && isThere ? i : found;
      });
    if (found != NoIndex)
    {
      return found;
    }
    // The ends of the sides that lead to the entry: bottom, right, top, left.
    std::array<CellRing::Index, 4> ends = { NoIndex, NoIndex, NoIndex, NoIndex };
    const auto endOf = [&](CellRing::Index i) -> CellRing::Index&
    { return ends[static_cast<std::size_t>(-1 - ring[i].line)]; };
    for (CellRing::Index i = ring[entry].before; ring[i].line < 0 && endOf(i) == NoIndex;
         i = ring[i].before)
    {
      endOf(i) = ring[i].after;
    }
    const int x = (wanted[0] > this->bounds[1]) - (wanted[0] < this->bounds[0]);
    const int y = (wanted[1] > this->bounds[3]) - (wanted[1] < this->bounds[2]);
    const CellRing::Index across = x < 0 ? ends[3] : x > 0 ? ends[1] : NoIndex;
    if (across == entry && ring[entry].line >= 0)
    {
      return entry;
    }
    // A side of x that is there ends beyond the one of y that comes next around.
    const bool isBelow = across != NoIndex ? x < 0 : y < 0 || (y == 0 && x < 0);
    const CellRing::Index end = ends[isBelow ? 0 : 2];
    return end == NoIndex ? entry : end;
  }

  /// Does an edge to a neighbour meet a side of the box here, after rounding took its other end to
  /// that side? The other end stands for both: their order along the side may be wrong.
  bool isSpike(const CellRing& ring, CellRing::Index i) const
  {
    const RingCorner& corner = ring[i];
    const std::int64_t before = ring[corner.before].line;
    if (!this->isBox || (before < 0) == (corner.line < 0))
    {
      return false;
    }
    constexpr std::size_t bound[] = { 2, 1, 3, 0 }; // of bottom, right, top, left
    const std::size_t k = bound[-1 - std::min(before, corner.line)];
    const std::size_t along = 1 - k / 2;
    const double x = corner.x[along];
    return x != this->bounds[2 * along] && x != this->bounds[2 * along + 1] &&
      ring[before < 0 ? corner.after : corner.before].x[k / 2] == this->bounds[k];
  }

  const std::vector<double>& corners;
  const std::array<double, 4> bounds;
  const bool isBox;

private:
  const double* corner(std::size_t i) const
  {
    return this->corners.data() + 2 * i % this->corners.size();
  }

  /// Is every position that rounds to @p x within? False where that is not certain.
  bool surelyHolds(const Position& x) const
  {
    constexpr double Infinite = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 4; ++k)
    {
      const double around[2] = { std::nextafter(x[0], k % 2 ? Infinite : -Infinite),
        std::nextafter(x[1], k / 2 ? Infinite : -Infinite) };
      if (!std::isfinite(around[0]) || !std::isfinite(around[1]) ||
        fanTriangleOf(this->corners.size() / 2,
          [&](std::size_t i, std::size_t j)
          { return planeOrientation(this->corner(i), this->corner(j), around); }) == 0)
      {
        return false;
      }
    }
    return true;
  }
};

/// What the cell of a site is cut by, by number (CellRing.h).
struct LinesOfCell
{
  const Domain& domain;
  const Buffer<PowerSite>& sites;
  const PowerSite& site;
  const std::vector<Index>& neighbours;

  CellLine operator[](std::int64_t line) const
  {
    return line < 0 ? this->domain.side(static_cast<std::size_t>(-1 - line))
                    : lineTo(this->sites[this->neighbours[static_cast<std::size_t>(line)]]);
  }
};

/// One of them, for CellRing::cut().
class ExactCutter
{
public:
  static constexpr bool IsExact = true;

  ExactCutter(const LinesOfCell& linesOfCell, std::int64_t line)
    : lines(linesOfCell)
    , own(linesOfCell[line])
    , cutter(linesOfCell.site, *own.other)
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
    const CellLine edge = this->lines[from.line];
    meetingOf(this->lines.site, leaves ? edge : this->own, leaves ? this->own : edge, x);
  }

private:
  const LinesOfCell& lines;
  const CellLine own;
  const CellCutter cutter;
};

class CellMaker
{
public:
  CellMaker(const CellComplex& triangulation, const Buffer<PowerSite>& given,
    const std::vector<double>& polygon, Monitor& monitor)
    : t(triangulation)
    , sites(given)
    , domain(polygon)
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
    CellPolygon cell;
    for (Index i = begin; i < end; ++i)
    {
      if (wanted && !wanted[i])
      {
        continue;
      }
      this->neighbours.link(i, star);
      cell.clear();
      if (!this->isDecided(star, cell))
      {
        this->neighbours.list(i, star, around);
        this->checkAround(i, star, around);
        this->cutCell(i, star, around, cut, cell);
      }
      chunk.add(this->t.pointIds[i], cell);
    }
  }

private:
  /// Do the facets alone show what is left of the cell: all, and its corners become @p cell; or
  /// nothing?
  bool isDecided(const Star& star, CellPolygon& cell) const
  {
    if (!star.isClosed)
    {
      return false;
    }
    bool isInBox = true;
    for (const Index h : star.ring)
    {
      const Index f = this->neighbours.facets()->of().cell(h);
      cell.push_back({ this->centers[f], f });
      isInBox = isInBox && this->domain.isInBox(this->centers[f]);
    }
    if (isInBox)
    {
      return true;
    }
    std::uint8_t common = 0xFF;
    for (const CellCorner& corner : cell)
    {
      common &= this->where[corner.facet];
    }
    if (common < Domain::Inside)
    {
      cell.clear();
    }
    return common != 0;
  }

  void cutCell(Index site, const Star& star, std::vector<Index>& around, CellRing& ring,
    CellPolygon& cell) const
  {
    if (!around.empty())
    {
      // The edge to the first neighbour starts in the first facet's center.
      std::rotate(around.begin(), around.begin() + 1, around.end());
    }
    const LinesOfCell lines = { this->domain, this->sites, this->sites[site], around };
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
    const CellRing::Index start = this->startOf(ring, star, around.size());
    ring.eachFrom(start,
      [&](CellRing::Index i)
      {
        if (!this->domain.isSpike(ring, i))
        {
          cell.push_back({ { ring[i].x[0], ring[i].x[1] }, NoIndex });
        }
      });
  }

  /// From the first neighbour's edge, else from the polygon's first corner. In a box, from where
  /// the first facet's center is or was cut off, else from the end of the last neighbour's edge.
  CellRing::Index startOf(const CellRing& ring, const Star& star, std::size_t neighbourCount) const
  {
    const auto rank = [&ring](CellRing::Index corner)
    {
      const std::int64_t line = ring[corner].line;
      return line >= 0 ? line : static_cast<std::int64_t>(NoIndex) - line;
    };
    CellRing::Index start = ring.first();
    CellRing::Index end = NoIndex;
    ring.eachFrom(ring.first(),
      [&](CellRing::Index i)
      {
        start = rank(i) < rank(start) ? i : start;
        end = rank(i) + 1 == static_cast<std::int64_t>(neighbourCount) ? ring[i].after : end;
      });
    if (this->domain.isBox && !star.ring.empty())
    {
      const Index f = this->neighbours.facets()->of().cell(star.ring[0]);
      return this->domain.startInBox(ring, start, this->centers[f]);
    }
    return this->domain.isBox && end != NoIndex ? end : start;
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
  const Domain domain;
  const SiteNeighbours neighbours;
  Buffer<Position> centers;   ///< of the facets
  Buffer<std::uint8_t> where; ///< they are
};

}

RoundedCells roundedCells(const CellComplex& t, const std::uint8_t* wanted,
  const Buffer<PowerSite>& sites, const std::vector<double>& polygon, Monitor& monitor)
{
  const CellMaker maker(t, sites, polygon, monitor);
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
