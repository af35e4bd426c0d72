// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Transport/CellMoments.h"

#include "Points/Vertex.h"
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

/// A convex polygon that half-planes cut; positions are relative to the site.
class ClippedCell
{
public:
  struct Corner
  {
    double x[2];
    Index line; ///< of the edge from here: the neighbour that cut it, or NoIndex
  };

  void begin(const std::vector<double>& polygon, const double* site)
  {
    this->corners.clear();
    for (std::size_t i = 0; i < polygon.size(); i += 2)
    {
      this->corners.push_back({ { polygon[i] - site[0], polygon[i + 1] - site[1] }, NoIndex });
    }
  }

  /// Leaves what has a product with @p normal of at most @p most.
  void cut(const double* normal, double most, Index line)
  {
    const std::size_t count = this->corners.size();
    this->beyond.resize(count);
    bool isCut = false;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double* const x = this->corners[i].x;
      this->beyond[i] = x[0] * normal[0] + x[1] * normal[1] - most;
      isCut = isCut || this->beyond[i] > 0;
    }
    if (!isCut)
    {
      return;
    }
    this->next.clear();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t j = i + 1 < count ? i + 1 : 0;
      const Corner& a = this->corners[i];
      const double atA = this->beyond[i];
      const double atB = this->beyond[j];
      if (atA <= 0)
      {
        this->next.push_back(a);
      }
      if ((atA <= 0) != (atB <= 0))
      {
        const double share = atA / (atA - atB);
        const double* const b = this->corners[j].x;
        this->next.push_back(
          { { a.x[0] + share * (b[0] - a.x[0]), a.x[1] + share * (b[1] - a.x[1]) },
            atA <= 0 ? line : a.line });
      }
    }
    this->corners.swap(this->next);
  }

  /// @param centroid is relative to the site
  /// @return the area
  double measure(double* centroid) const
  {
    double whole = 0;
    for (std::size_t i = 1; i + 1 < this->corners.size(); ++i)
    {
      whole += this->areaOf(i);
    }
    if (!(whole > 0))
    {
      return 0;
    }
    // Of shares: a product of three lengths may be out of range where areas are not; and of
    // quarters, for the sum of three lengths may be, too.
    double mean[2] = { 0, 0 };
    for (std::size_t i = 1; i + 1 < this->corners.size(); ++i)
    {
      const double share = this->areaOf(i) / whole;
      for (int k = 0; k < 2; ++k)
      {
        mean[k] += share * (0.25 * this->fromFirst(i, k) + 0.25 * this->fromFirst(i + 1, k));
      }
    }
    for (int k = 0; k < 2; ++k)
    {
      centroid[k] = this->corners[0].x[k] + mean[k] / 0.75;
    }
    return whole;
  }

  /// use(line, length) for each edge.
  template <class Use>
  void eachEdge(const Use& use) const
  {
    for (std::size_t i = 0; i < this->corners.size(); ++i)
    {
      const Corner& a = this->corners[i];
      const Corner& b = this->corners[i + 1 < this->corners.size() ? i + 1 : 0];
      use(a.line, distanceBetween(a.x, b.x));
    }
  }

private:
  double fromFirst(std::size_t i, int k) const
  {
    return this->corners[i].x[k] - this->corners[0].x[k];
  }

  /// Of the fan's triangle at corner @p i.
  double areaOf(std::size_t i) const
  {
    return 0.5 * this->fromFirst(i, 0) * this->fromFirst(i + 1, 1) -
      0.5 * this->fromFirst(i, 1) * this->fromFirst(i + 1, 0);
  }

  std::vector<Corner> corners;
  std::vector<Corner> next;
  std::vector<double> beyond;
};

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
          ClippedCell cell;
          for (std::size_t i = begin; i < end; ++i)
          {
            const auto id = static_cast<std::size_t>(ids[i]);
            const double* const site = sites.data() + 2 * id;
            lists.find(static_cast<Index>(i), star, neighbours);
            cell.begin(polygon, site);
            for (const Index j : neighbours)
            {
              const auto other = static_cast<std::size_t>(ids[j]);
              const ScaledWay way(site, &sites[2 * other]);
              const double lead = weights ? weights[id] - weights[other] : 0.0;
              const double most =
                std::ldexp(way.x[0] * way.x[0] + way.x[1] * way.x[1], way.exponent) +
                std::ldexp(lead, -way.exponent);
              cell.cut(way.x, 0.5 * most, j);
            }
            double centroid[2] = { 0, 0 };
            moments.areas[id] = cell.measure(centroid);
            moments.centroids[2 * id] = site[0] + centroid[0];
            moments.centroids[2 * id + 1] = site[1] + centroid[1];
            cell.eachEdge(
              [&](Index line, double length)
              {
                // Both cells have the edge; that of the lower site adds it.
                if (line != NoIndex && line > i && length > 0)
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
  ClippedCell whole;
  whole.begin(this->polygon, first);
  this->area = whole.measure(this->centroid.data());
  const std::array<double, 4> box = boundingBox(this->polygon);
  if (!std::isfinite(box[1] - box[0]) || !std::isfinite(box[3] - box[2]))
  {
    throw badArgument("the domain's width and height must be 1.7e308 or less");
  }
  if (!std::isnormal(this->area))
  {
    throw badArgument("the domain's area must be a normal double, from 2.3e-308 to 1.7e308");
  }
  this->centroid[0] += first[0];
  this->centroid[1] += first[1];
}

}
