// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Transport/CellMoments.h"

#include "Points/Vertex.h"
#include "PowerDiagram/CellRing.h"
#include "PowerDiagram/DomainCorners.h"
#include "PowerDiagram/SiteNeighbours.h"
#include "Support/Parallel.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flipflop
{
namespace
{

using Index = std::uint32_t;

constexpr std::size_t CellsPerTask = 1 << 11;

/// A way and its exponent: over a power of two, so that products neither overflow nor vanish.
struct ScaledWay
{
  double x[2];
  int exponent = 0;

  ScaledWay(const double* a, const double* b)
    : x{ b[0] - a[0], b[1] - a[1] }
  {
    std::frexp(std::max(std::fabs(this->x[0]), std::fabs(this->x[1])), &this->exponent);
    this->x[0] = std::ldexp(this->x[0], -this->exponent);
    this->x[1] = std::ldexp(this->x[1], -this->exponent);
  }

  double length() const
  {
    return std::ldexp(std::sqrt(this->x[0] * this->x[0] + this->x[1] * this->x[1]), this->exponent);
  }
};

/// A half-plane in doubles, for CellRing::cut(): what has a product with a normal of at most so
/// much.
struct RoundedCutter
{
  static constexpr bool IsExact = false;

  const double* normal;
  double most;

  double beyond(const RingCorner& corner) const
  {
    return corner.x[0] * this->normal[0] + corner.x[1] * this->normal[1] - this->most;
  }

  int side(const RingCorner& /*before*/, const RingCorner& corner) const
  {
    return this->beyond(corner) > 0 ? -1 : 1;
  }

  void meet(const RingCorner& from, const RingCorner& to, bool /*leaves*/, double* x) const
  {
    const double atFrom = this->beyond(from);
    const double share = atFrom / (atFrom - this->beyond(to));
    for (int k = 0; k < 2; ++k)
    {
      x[k] = from.x[k] + share * (to.x[k] - from.x[k]);
    }
  }
};

/// Of a cell.
struct Moments
{
  double area = 0;
  double centroid[2] = { 0, 0 };
};

/// Measures a cell as a fan from its first corner.
Moments momentsOf(const CellRing& ring)
{
  Moments moments;
  if (ring.isEmpty())
  {
    return moments;
  }
  const CellRing::Index first = ring.first();
  const auto offset = [&](CellRing::Index i, int k) { return ring[i].x[k] - ring[first].x[k]; };
  const auto areaFrom = [&](CellRing::Index i)
  {
    return 0.5 * offset(i, 0) * offset(ring[i].after, 1) -
      0.5 * offset(i, 1) * offset(ring[i].after, 0);
  };
  ring.eachFrom(first, [&](CellRing::Index i) { moments.area += areaFrom(i); });
  if (!(moments.area > 0))
  {
    moments.area = 0;
    return moments;
  }
  // Of shares: a product of three lengths may be out of range where areas are not; and of
  // quarters, for the sum of three lengths may be, too.
  double mean[2] = { 0, 0 };
  ring.eachFrom(first,
    [&](CellRing::Index i)
    {
      const double share = areaFrom(i) / moments.area;
      for (int k = 0; k < 2; ++k)
      {
        mean[k] += share * (0.25 * offset(i, k) + 0.25 * offset(ring[i].after, k));
      }
    });
  for (int k = 0; k < 2; ++k)
  {
    moments.centroid[k] = ring[first].x[k] + mean[k] / 0.75;
  }
  return moments;
}

}

double distanceBetween(const double* a, const double* b)
{
  return ScaledWay(a, b).length();
}

void measureCells(const std::vector<double>& sites, const double* weights,
  const Triangulation& triangulation, const std::vector<double>& polygon, CellMoments& moments,
  const Options& options)
{
  const Buffer<std::int64_t>& ids = triangulation.pointIds;
  moments.areas.assign(sites.size() / 2, 0.0);
  moments.centroids = sites;
  moments.links.assign(chunkCount(ids.size(), CellsPerTask), {});
  Monitor monitor(options);
  ArenaLoan arena(threadCount(options.threads, static_cast<std::int64_t>(ids.size())));
  arena.execute(
    [&]
    {
      monitor.stage(0, 1, static_cast<std::int64_t>(ids.size()));
      const SiteNeighbours lists(triangulation);
      eachChunk(ids.size(), CellsPerTask,
        [&](std::size_t begin, std::size_t end, std::size_t run)
        {
          Star star;
          std::vector<Index> neighbours;
          CellRing cell;
          for (std::size_t i = begin; i < end; ++i)
          {
            const auto id = static_cast<std::size_t>(ids[i]);
            const double* const site = sites.data() + 2 * id;
            lists.link(static_cast<Index>(i), star);
            lists.list(static_cast<Index>(i), star, neighbours);
            cell.begin(polygon, site[0], site[1]);
            for (std::size_t n = 0; n < neighbours.size() && !cell.isEmpty(); ++n)
            {
              const auto other = static_cast<std::size_t>(ids[neighbours[n]]);
              const ScaledWay way(site, &sites[2 * other]);
              const double lead = weights ? weights[id] - weights[other] : 0.0;
              const double most =
                std::ldexp(way.x[0] * way.x[0] + way.x[1] * way.x[1], way.exponent) +
                std::ldexp(lead, -way.exponent);
              cell.cut(RoundedCutter{ way.x, 0.5 * most }, static_cast<std::int64_t>(n));
            }
            const Moments measured = momentsOf(cell);
            moments.areas[id] = measured.area;
            moments.centroids[2 * id] = site[0] + measured.centroid[0];
            moments.centroids[2 * id + 1] = site[1] + measured.centroid[1];
            cell.eachEdge(
              [&](const RingCorner& from, const RingCorner& to)
              {
                // Both cells have the edge; that of the lower site adds it.
                const Index line = from.line < 0 ? NoIndex : neighbours[from.line];
                const double length =
                  line == NoIndex || line < i ? 0 : distanceBetween(from.x, to.x);
                if (length > 0)
                {
                  const auto other = static_cast<std::size_t>(ids[line]);
                  moments.links[run].push_back({ static_cast<Index>(id), static_cast<Index>(other),
                    length, distanceBetween(site, &sites[2 * other]) });
                }
              });
          }
          monitor.advance(static_cast<std::int64_t>(end - begin));
        });
      monitor.stage(1, 1, 1);
    });
}

MeasuredDomain::MeasuredDomain(const ConvexDomain& given)
  : polygon(domainCorners(given))
  , centroid{}
{
  const double* const first = this->polygon.data();
  CellRing whole;
  whole.begin(this->polygon, first[0], first[1]);
  const Moments measured = momentsOf(whole);
  this->area = measured.area;
  const std::array<double, 4> box = boundingBox(this->polygon);
  if (!std::isfinite(box[1] - box[0]) || !std::isfinite(box[3] - box[2]))
  {
    throw badArgument("the domain's width and height must be 1.7e308 or less");
  }
  if (!std::isnormal(this->area))
  {
    throw badArgument("the domain's area must be a normal double, from 2.3e-308 to 1.7e308");
  }
  this->centroid = { first[0] + measured.centroid[0], first[1] + measured.centroid[1] };
}

}
