// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/TriangulationQueries.h>

#include "PowerDiagram/TriangulationInput.h"
#include "Query/AnswerQueries.h"
#include "Query/FanMesh.h"
#include "Query/PlaneShares.h"
#include "Query/SiteChain.h"
#include "Query/SiteLocator.h"
#include "Query/Sites.h"
#include "Support/Monitor.h"
#include "Support/Threads.h"
#include "Support/TypedErrors.h"

#include <algorithm>
#include <limits>

namespace flipflop
{

class TriangulationQueries::Implementation
{
public:
  Implementation(const PointView& points, const WeightView& weights,
    const Triangulation& triangulation, const Options& options)
  {
    Monitor monitor(options);
    monitor.stage(0.0, 1.0, 1);
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
          this->mesh =
            FanMesh(this->sites.data(), this->sites.scaledGeometry(), triangulation, monitor);
          this->locator = SiteLocator(this->sites, this->mesh, monitor);
        }
        monitor.stage(1.0, 1.0, 1);
      });
  }

  /// The locator knows where its sites are.
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  /// -1 outside.
  std::int64_t cellAt(const SiteSigns& signs, const double* place) const
  {
    if (this->dimension < 0 || !this->sites.inBox(place))
    {
      return -1;
    }
    if (this->dimension == 0)
    {
      return 0; // the box is the site
    }
    return signs.withSpace(place,
      [&](const auto& space) -> std::int64_t
      {
        if (this->dimension == 1)
        {
          const PlaceInChain found = this->chain.locate(space);
          return found.from == NoIndex ? -1 : static_cast<std::int64_t>(found.cell);
        }
        const PlaceInMesh found = this->locator.locate(space, place);
        return found.kind == PlaceInMesh::Outside
          ? -1
          : static_cast<std::int64_t>(this->mesh.cellOf(found.triangle));
      });
  }

  /// -1: there is no site.
  std::int64_t nearestTo(const SiteSigns& signs, const double* place) const
  {
    if (this->dimension < 1)
    {
      return this->dimension < 0 ? -1 : static_cast<std::int64_t>(this->sites[0].id);
    }
    return signs.withSpace(place,
      [&](const auto& space) -> std::int64_t
      {
        const std::uint32_t found =
          this->dimension == 1 ? this->chain.nearest(space) : this->locator.nearest(space, place);
        return this->sites[found].id;
      });
  }

  void sharesAt(const SiteSigns& signs, const double* place, PlaneShares& shares) const
  {
    shares.clear();
    if (this->dimension < 0 || !this->sites.inBox(place))
    {
      return;
    }
    if (this->dimension == 0)
    {
      shares.push_back({ 0, 1.0 });
      return;
    }
    signs.withSpace(place,
      [&](const auto& space)
      {
        if (this->dimension == 1)
        {
          linearShares(space, this->chain.locate(space), shares);
          return;
        }
        linearShares(space, this->mesh, this->locator.locate(space, place), shares);
      });
  }

  /// What each query's place has in @p results, a number a query.
  /// @param find std::int64_t (signs, place)
  template <class Find>
  void answer(
    const PointView& queries, std::int64_t* results, const Options& options, const Find& find) const
  {
    if (queries.count > 0 && !results)
    {
      refuse();
    }
    answerQueries(queries, options,
      [&]
      {
        return [&find, results, signs = SiteSigns(this->sites)](std::uint32_t i,
                 const double* place) { results[i] = place ? find(signs, place) : -1; };
      });
  }

  /// The values between the sites.
  /// @param findShares void (signs, place, shares)
  template <class FindShares>
  void interpolate(const double* values, std::int64_t components, const PointView& queries,
    double* result, const Options& options, const FindShares& findShares) const
  {
    if (components < 1 || (queries.count > 0 && (!result || (!values && this->dimension >= 0))))
    {
      refuse();
    }
    answerQueries(queries, options,
      [&]
      {
        return [&, signs = SiteSigns(this->sites), shares = PlaneShares()](
                 std::uint32_t i, const double* place) mutable
        {
          shares.clear();
          if (place)
          {
            findShares(signs, place, shares);
          }
          double* const to = result + static_cast<std::int64_t>(i) * components;
          std::fill(
            to, to + components, shares.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0);
          for (const PlaneShare& share : shares)
          {
            const double* from =
              values + static_cast<std::int64_t>(this->sites[share.site].id) * components;
            for (std::int64_t c = 0; c < components; ++c)
            {
              to[c] += share.share * from[c];
            }
          }
        };
      });
  }

private:
  int dimension = -1;
  Sites sites;
  FanMesh mesh;        ///< of dimension 2
  SiteLocator locator; ///< of dimension 2
  SiteChain chain;     ///< of dimension 1
};

TriangulationQueries::TriangulationQueries(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const Options& options)
  : implementation(withTypedErrors(
      [&] { return std::make_unique<Implementation>(points, weights, triangulation, options); }))
{
}

TriangulationQueries::TriangulationQueries(TriangulationQueries&& other) noexcept = default;
TriangulationQueries& TriangulationQueries::operator=(
  TriangulationQueries&& other) noexcept = default;
TriangulationQueries::~TriangulationQueries() = default;

void TriangulationQueries::locate(
  const PointView& queries, std::int64_t* cells, const Options& options) const
{
  const Implementation& self = *this->implementation;
  self.answer(queries, cells, options,
    [&self](const SiteSigns& signs, const double* place) { return self.cellAt(signs, place); });
}

void TriangulationQueries::nearest(
  const PointView& queries, std::int64_t* ids, const Options& options) const
{
  const Implementation& self = *this->implementation;
  self.answer(queries, ids, options,
    [&self](const SiteSigns& signs, const double* place) { return self.nearestTo(signs, place); });
}

void TriangulationQueries::interpolateLinear(const double* values, std::int64_t components,
  const PointView& queries, double* result, const Options& options) const
{
  const Implementation& self = *this->implementation;
  self.interpolate(values, components, queries, result, options,
    [&self](const SiteSigns& signs, const double* place, PlaneShares& shares)
    { self.sharesAt(signs, place, shares); });
}

}
