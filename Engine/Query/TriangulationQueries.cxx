// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/TriangulationQueries.h>

#include "Points/InsertionOrder.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Query/FanMesh.h"
#include "Query/NaturalShares.h"
#include "Query/PlaneShares.h"
#include "Query/SiteChain.h"
#include "Query/SiteLocator.h"
#include "Query/Sites.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"
#include "Support/Monitor.h"
#include "Support/Threads.h"

#include <algorithm>
#include <limits>

namespace flipflop
{

namespace
{

/// Evaluate each query. Many are evaluated along a curve, so that one finds in the cache what the
/// one before has used. A result depends on its query alone, so the
/// order and the threads do not matter to it.
/// @param results    space for one a query
/// @param makeQuery  query (): for a task; query(i, position) is called for each query, where
///                   position is null for one that is not finite
/// @throw Error BadArgument, NonFinite, TooManyPoints, OutOfMemory, Aborted
template <class MakeQuery>
void eachPosition(
  const PointView& queries, const void* results, const Options& options, const MakeQuery& makeQuery)
{
  constexpr std::uint32_t Many = 1 << 12;
  Buffer<std::uint32_t> order; // empty: as they come
  eachQuery(
    queries, 2, results, options,
    [&](QueryRun& run)
    {
      if (run.source.count() >= Many && !run.checkFinite)
      {
        PointSubset all;
        all.count = run.source.count();
        run.monitor.stage(0.1, 0.3, 1, "sorting");
        order = curveOrder(run.source, all, OctahedralMap(), run.monitor);
      }
    },
    [&](QueryRun& run, std::uint32_t begin, std::uint32_t end)
    {
      auto query = makeQuery();
      for (std::uint32_t k = begin; k < end; ++k)
      {
        const std::uint32_t i = order.empty() ? k : order[k];
        double position[3];
        run.source.load(i, position);
        query(i, isFinite(position) ? position : nullptr);
      }
    });
}

}

class TriangulationQueries::Implementation
{
public:
  /// @param fixedEdges null: of a regular triangulation
  /// @param inside     a mask of the cells; null: all are inside
  Implementation(const PointView& points, const WeightView& weights,
    const Triangulation& triangulation, const Buffer<std::int64_t>* fixedEdges,
    const std::uint8_t* inside, const Options& options)
    : isConstrained(fixedEdges)
  {
    Monitor monitor(options);
    monitor.stage(0.0, 1.0, 1, "preparing");
    ArenaLoan arena(
      threadCount(options.threads, static_cast<std::int64_t>(triangulation.pointIds.size())));
    arena.execute(
      [&]
      {
        const Buffer<PowerSite> given = loadSites(points, weights, triangulation);
        checkCells(triangulation);
        this->dimension = triangulation.dimension;
        if (this->dimension >= 0)
        {
          this->sites = Sites(given, triangulation);
        }
        if (this->dimension == 1)
        {
          this->chain = SiteChain(this->sites, triangulation, monitor);
        }
        if (this->dimension == 2)
        {
          this->mesh = FanMesh(
            this->sites.data(), this->sites.scaledGeometry(), triangulation, fixedEdges, monitor);
          this->locator = SiteLocator(this->sites, this->mesh, monitor);
          this->numberCells(triangulation.cellCount(), inside);
        }
        monitor.stage(1.0, 1.0, 1);
      });
  }

  /// The locator refers to the sites.
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  /// -1 outside.
  std::int64_t cellAt(const SiteSigns& signs, const double* position) const
  {
    if (this->dimension < 0 || !this->sites.inBox(position))
    {
      return -1;
    }
    if (this->dimension == 0)
    {
      return 0; // the box is the site
    }
    return signs.withSpace(position,
      [&](const auto& space) -> std::int64_t
      {
        if (this->dimension == 1)
        {
          const ChainLocation found = this->chain.locate(space);
          return found.from == NoIndex ? -1 : static_cast<std::int64_t>(found.cell);
        }
        const std::uint32_t found = this->lowestCell(this->locator.locate(space, position));
        return found == NoIndex ? -1 : static_cast<std::int64_t>(found);
      });
  }

  /// -1: there is no site.
  std::int64_t nearestTo(const SiteSigns& signs, const double* position) const
  {
    if (this->dimension < 1)
    {
      return this->dimension < 0 ? -1 : static_cast<std::int64_t>(this->sites[0].id);
    }
    return signs.withSpace(position,
      [&](const auto& space) -> std::int64_t
      {
        const std::uint32_t found = this->dimension == 1 ? this->chain.nearest(space)
                                                         : this->locator.nearest(space, position);
        return this->sites[found].id;
      });
  }

  /// @param natural null: linear over each triangle
  void sharesAt(const SiteSigns& signs, const double* position, NaturalNeighbours* natural,
    PlaneShares& shares) const
  {
    shares.clear();
    if (this->dimension < 0 || !this->sites.inBox(position))
    {
      return;
    }
    if (this->dimension == 0)
    {
      shares.push_back({ 0, 1.0 });
      return;
    }
    const auto evaluate = [&](const auto& space)
    {
      if (this->dimension == 1)
      {
        linearShares(space, this->chain.locate(space), shares);
        return true;
      }
      const MeshLocation found = this->locator.locate(space, position);
      if (this->lowestCell(found) == NoIndex)
      {
        return true;
      }
      linearShares(space, this->mesh, found, shares);
      return !natural || this->makeNatural(space, found, *natural, shares);
    };
    if (!signs.withSpace(position, evaluate))
    {
      signs.withWideSpace(position, evaluate);
    }
  }

  /// What each query's position has in @p results, a number a query.
  /// @param find std::int64_t (signs, position)
  template <class Find>
  void findEach(
    const PointView& queries, std::int64_t* results, const Options& options, const Find& find) const
  {
    eachPosition(queries, results, options,
      [&]
      {
        return [&find, results, signs = SiteSigns(this->sites)](std::uint32_t i,
                 const double* position) { results[i] = position ? find(signs, position) : -1; };
      });
  }

  /// The values between the sites.
  /// @param isNatural or linear over each triangle
  void interpolate(bool isNatural, const double* values, std::int64_t components,
    const PointView& queries, double* result, const Options& options) const
  {
    if (components < 1 || (queries.count > 0 && !values && this->dimension >= 0))
    {
      refuse();
    }
    eachPosition(queries, result, options,
      [&]
      {
        return [&, signs = SiteSigns(this->sites), natural = NaturalNeighbours(this->mesh),
                 shares = PlaneShares()](std::uint32_t i, const double* position) mutable
        {
          shares.clear();
          if (position)
          {
            this->sharesAt(signs, position, isNatural ? &natural : nullptr, shares);
          }
          double* const to = result + static_cast<std::int64_t>(i) * components;
          for (std::int64_t c = 0; c < components; ++c)
          {
            to[c] = this->blended(shares, values, components, c);
          }
        };
      });
  }

  /// @throw Error BadArgument
  void requireRegular(const char* sentence) const
  {
    if (this->isConstrained)
    {
      throw badArgument(sentence);
    }
  }

private:
  /// Those inside, in order.
  void numberCells(std::int64_t count, const std::uint8_t* inside)
  {
    if (!inside)
    {
      return;
    }
    this->numberOf.allocate(static_cast<std::size_t>(count));
    std::uint32_t number = 0;
    for (std::size_t c = 0; c < this->numberOf.size(); ++c)
    {
      this->numberOf[c] = inside[c] ? number++ : NoIndex;
    }
  }

  /// The lowest cell that holds a position, by its number among those inside; NoIndex: there is
  /// none.
  std::uint32_t lowestCell(const MeshLocation& location) const
  {
    if (location.kind == MeshLocation::Outside)
    {
      return NoIndex;
    }
    if (this->numberOf.empty())
    {
      return this->mesh.cellOf(location.triangle);
    }
    const auto number = [this](std::uint32_t h)
    { return h == NoIndex ? NoIndex : this->numberOf[this->mesh.cellOf(triangleOf(h))]; };
    const std::uint32_t h = halfEdge(location.triangle, location.corner);
    std::uint32_t lowest = number(h);
    if (location.kind == MeshLocation::OnEdge)
    {
      lowest = std::min(lowest, number(this->mesh.twin(h)));
    }
    if (location.kind == MeshLocation::AtCorner)
    {
      this->mesh.eachLeaving(this->mesh.origin(h),
        [&](std::uint32_t out)
        {
          lowest = std::min(lowest, number(out));
          return true;
        });
    }
    return lowest;
  }

  /// Of shares that only nearly sum to 1; but never beyond the values, and of one value that value.
  /// @param c of the components
  double blended(
    const PlaneShares& shares, const double* values, std::int64_t components, std::int64_t c) const
  {
    double sum = shares.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const PlaneShare& share : shares)
    {
      const double value =
        values[static_cast<std::int64_t>(this->sites[share.site].id) * components + c];
      sum += share.share * value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    return sum < low ? low : sum > high ? high : sum; // NaN stays
  }

  /// From the linear shares to the natural ones, where these are others.
  /// @return false where the space does not carry the query's weight
  template <class Space>
  bool makeNatural(const Space& space, const MeshLocation& location, NaturalNeighbours& natural,
    PlaneShares& shares) const
  {
    const bool onEdge = location.kind == MeshLocation::OnEdge;
    if ((location.kind != MeshLocation::Inside && !onEdge) ||
      (onEdge && this->mesh.twin(halfEdge(location.triangle, location.corner)) == NoIndex))
    {
      return true;
    }
    double weight = 0.0;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const PlaneShare& share : shares)
    {
      const double ofSite = space.site(share.site).x[2];
      weight += share.share * ofSite;
      least = std::min(least, ofSite);
      most = std::max(most, ofSite);
    }
    weight = std::max(least, std::min(most, weight));
    if (!space.carries(weight))
    {
      return false;
    }
    Space lifted = space;
    lifted.query.x[2] = weight;
    natural.share(lifted, location.triangle, shares);
    return true;
  }

  int dimension = -1;
  bool isConstrained;
  Buffer<std::uint32_t> numberOf; ///< of each cell, in lowestCell(); empty: its own
  Sites sites;
  FanMesh mesh;        ///< of dimension 2
  SiteLocator locator; ///< of dimension 2
  SiteChain chain;     ///< of dimension 1
};

TriangulationQueries::TriangulationQueries(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const Options& options)
  : implementation(engineCall(
      [&]
      {
        return std::make_unique<Implementation>(
          points, weights, triangulation, nullptr, nullptr, options);
      }))
{
}

TriangulationQueries::TriangulationQueries(const PointView& points,
  const ConstrainedTriangulation& triangulation, const std::uint8_t* inside, const Options& options)
  : implementation(engineCall(
      [&]
      {
        return std::make_unique<Implementation>(
          points, WeightView(), triangulation, &triangulation.fixedEdges, inside, options);
      }))
{
}

TriangulationQueries::TriangulationQueries(TriangulationQueries&& other) noexcept = default;
TriangulationQueries& TriangulationQueries::operator=(
  TriangulationQueries&& other) noexcept = default;
TriangulationQueries::~TriangulationQueries() = default;

void TriangulationQueries::locate(
  const PointView& queries, std::int64_t* cells, const Options& options) const
{
  engineCall(
    [&]
    {
      const Implementation& self = *this->implementation;
      self.findEach(queries, cells, options,
        [&self](const SiteSigns& signs, const double* position)
        { return self.cellAt(signs, position); });
    });
}

void TriangulationQueries::nearest(
  const PointView& queries, std::int64_t* ids, const Options& options) const
{
  engineCall(
    [&]
    {
      const Implementation& self = *this->implementation;
      self.requireRegular("the nearest point is a question to a regular triangulation, not to a "
                          "constrained one");
      self.findEach(queries, ids, options,
        [&self](const SiteSigns& signs, const double* position)
        { return self.nearestTo(signs, position); });
    });
}

void TriangulationQueries::interpolateLinear(const double* values, std::int64_t components,
  const PointView& queries, double* result, const Options& options) const
{
  engineCall([&]
    { this->implementation->interpolate(false, values, components, queries, result, options); });
}

void TriangulationQueries::interpolateNatural(const double* values, std::int64_t components,
  const PointView& queries, double* result, const Options& options) const
{
  engineCall(
    [&]
    {
      this->implementation->requireRegular(
        "natural neighbours are those of a regular triangulation, not of a constrained one");
      this->implementation->interpolate(true, values, components, queries, result, options);
    });
}

}
