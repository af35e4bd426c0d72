// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/TriangulationQueries.h>

#include "Geometry/InsertionOrder.h"
#include "Query/PlaneImage.h"
#include "Query/PlaneInterpolator.h"
#include "Query/PreparedTriangulation.h"
#include "Query/SiteGradients.h"
#include "Query/TaskValues.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

namespace
{

constexpr double outside = std::numeric_limits<double>::quiet_NaN();

/// Is nearly each query near the one before, as the pixels of an image are?
bool areInOrder(const PreparedTriangulation& prepared, const PointSource& source)
{
  constexpr std::uint32_t Samples = 256;
  std::uint32_t near = 0;
  for (std::uint32_t k = 0; k < Samples; ++k)
  {
    const std::uint32_t i = partBegin(source.count() - 1, Samples, k);
    double a[3], b[3];
    source.load(i, a);
    source.load(i + 1, b);
    const Vertex from = prepared.sites.scaled(a);
    const Vertex to = prepared.sites.scaled(b);
    const double distance = std::fabs(to.x[0] - from.x[0]) + std::fabs(to.x[1] - from.x[1]);
    near += distance < 4 * prepared.locator.reach() ? 1 : 0;
  }
  return near > Samples - Samples / 8;
}

/// Evaluate each query. Many that are in no order are evaluated along a curve, so that one finds in
/// the cache what the one before has used. A result depends on its query alone, so the order and
/// the threads do not matter to it.
/// @param results    space for one a query
/// @param makeReady  void (Monitor&): before the first query
/// @param makeQuery  query (): for a task; query(i, position) is called for each query, where
///                   position is null for one that is not finite, and query.finish() in the end
/// @throw Error BadArgument, NonFinite, TooManyPoints, OutOfMemory, Aborted
template <class MakeReady, class MakeQuery>
void eachPosition(const PreparedTriangulation& prepared, const PointView& queries,
  const void* results, const Options& options, const MakeReady& makeReady,
  const MakeQuery& makeQuery)
{
  constexpr std::uint32_t Many = 1 << 12;
  Buffer<std::uint32_t> order; // empty: as they come
  eachQuery(
    queries, 2, results, options,
    [&](QueryRun& run)
    {
      makeReady(run.monitor);
      if (run.source.count() >= Many && !run.checkFinite && !areInOrder(prepared, run.source))
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
      query.finish();
    });
}

/// A number a query, for one task.
/// @tparam Find std::int64_t (signs, position, start)
template <class Find>
struct NumberQuery
{
  void operator()(std::uint32_t i, const double* position)
  {
    this->results[i] = position ? this->find(this->signs, position, this->start) : -1;
  }
  void finish() const {}

  const Find& find;
  std::int64_t* results;
  SiteSigns signs;
  WalkStart start{};
};

template <class Find>
void findEach(const PreparedTriangulation& prepared, const PointView& queries,
  std::int64_t* results, const Options& options, const Find& find)
{
  eachPosition(
    prepared, queries, results, options, [](Monitor&) {},
    [&] {
      return NumberQuery<Find>{ find, results, SiteSigns(prepared.sites) };
    });
}

/// @throw Error BadArgument
void requireValues(
  const PreparedTriangulation& prepared, const InterpolationTask& task, bool isQueried)
{
  if (task.isNatural())
  {
    prepared.requireRegular(
      "natural neighbours are those of a regular triangulation, not of a constrained one");
  }
  if (task.components < 1)
  {
    throw badArgument("a value must have 1 or more components");
  }
  if (isQueried && !task.values && prepared.dimension >= 0)
  {
    throw badArgument("values must be in memory: a null pointer was given");
  }
}

void interpolateEach(const PreparedTriangulation& prepared, InterpolationTask task,
  const PointView& queries, double* result, const Options& options)
{
  requireValues(prepared, task, queries.count > 0);
  TaskValues values;
  eachPosition(
    prepared, queries, result, options,
    [&](Monitor& monitor) { values.prepare(prepared, queries.count, task, monitor); },
    [&] { return PlaneInterpolator<double>(prepared, task, result); });
}

/// @param count of the sites
/// @throw Error Aborted
void gradientsInto(const PreparedTriangulation& prepared, const InterpolationTask& task,
  std::size_t count, double* gradients, Monitor& monitor)
{
  constexpr std::size_t SitesPerTask = 1 << 10;
  const SiteGradients estimated(prepared, task, false, monitor);
  const int exponent = std::ilogb(estimated.unit()) + prepared.sites.scaleExponent();
  const auto size = 2 * task.components;
  eachChunk(count, SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t site = begin; site < end; ++site)
      {
        double* const own = gradients + size * prepared.sites[site].id;
        if (prepared.dimension < 2)
        {
          std::fill_n(own, size, outside);
          continue;
        }
        estimated.at(static_cast<std::uint32_t>(site), own);
        std::transform(
          own, own + size, own, [exponent](double x) { return std::ldexp(x, exponent); });
      }
      monitor.advance(static_cast<std::int64_t>(end - begin));
    });
}

/// One query after another, by ascending ids.
SiteShares withIds(const PreparedTriangulation& prepared, std::vector<PlaneShares>& found)
{
  SiteShares result;
  result.offsets.allocate(found.size() + 1);
  std::size_t total = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    result.offsets[i] = static_cast<std::int64_t>(total);
    total += found[i].size();
  }
  result.offsets[found.size()] = static_cast<std::int64_t>(total);
  result.ids.allocate(total);
  result.shares.allocate(total);
  eachChunk(found.size(), 1 << 12,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto idOf = [&prepared](const PlaneShare& share)
        { return prepared.sites[share.site].id; };
        std::sort(found[i].begin(), found[i].end(),
          [&idOf](const PlaneShare& a, const PlaneShare& b) { return idOf(a) < idOf(b); });
        auto at = static_cast<std::size_t>(result.offsets[i]);
        for (const PlaneShare& share : found[i])
        {
          result.ids[at] = idOf(share);
          result.shares[at++] = share.share;
        }
      }
    });
  return result;
}

}

TriangulationQueries::TriangulationQueries(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const std::uint8_t* inside, const Options& options)
  : prepared(engineCall(
      [&]
      {
        return std::make_unique<PreparedTriangulation>(
          points, weights, triangulation, nullptr, inside, options);
      }))
{
}

TriangulationQueries::TriangulationQueries(const PointView& points,
  const ConstrainedTriangulation& triangulation, const std::uint8_t* inside, const Options& options)
  : prepared(engineCall(
      [&]
      {
        return std::make_unique<PreparedTriangulation>(
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
      findEach(*this->prepared, queries, cells, options,
        [this](const SiteSigns& signs, const double* position, WalkStart& start)
        { return this->prepared->cellAt(signs, position, start); });
    });
}

void TriangulationQueries::nearest(
  const PointView& queries, std::int64_t* ids, const Options& options) const
{
  engineCall(
    [&]
    {
      this->prepared->requireRegular("the nearest point is a question to a regular triangulation, "
                                     "not to a constrained one");
      findEach(*this->prepared, queries, ids, options,
        [this](const SiteSigns& signs, const double* position, WalkStart&)
        { return this->prepared->nearestTo(signs, position); });
    });
}

void TriangulationQueries::interpolateLinear(const double* values, std::int64_t components,
  const PointView& queries, double* result, const Options& options) const
{
  engineCall(
    [&]
    {
      interpolateEach(*this->prepared, { Interpolation::Linear, values, components, outside },
        queries, result, options);
    });
}

void TriangulationQueries::interpolateNatural(const double* values, std::int64_t components,
  const PointView& queries, double* result, const Options& options) const
{
  engineCall(
    [&]
    {
      interpolateEach(*this->prepared, { Interpolation::Natural, values, components, outside },
        queries, result, options);
    });
}

void TriangulationQueries::interpolateCloughTocher(const double* values, std::int64_t components,
  const PointView& queries, double* result, const Options& options) const
{
  engineCall(
    [&]
    {
      interpolateEach(*this->prepared, { Interpolation::CloughTocher, values, components, outside },
        queries, result, options);
    });
}

void TriangulationQueries::interpolateLaplace(const double* values, std::int64_t components,
  const PointView& queries, double* result, const Options& options) const
{
  engineCall(
    [&]
    {
      interpolateEach(*this->prepared, { Interpolation::Laplace, values, components, outside },
        queries, result, options);
    });
}

SiteShares TriangulationQueries::shares(
  Interpolation method, const PointView& queries, const Options& options) const
{
  return engineCall(
    [&]
    {
      if (method == Interpolation::CloughTocher)
      {
        throw badArgument("a smooth surface has no shares: it depends on gradients, too");
      }
      requireArray(queries, 2);
      std::vector<PlaneShares> found(static_cast<std::size_t>(queries.count));
      InterpolationTask task{ method, nullptr, 1, outside };
      task.shares = found.data();
      requireValues(*this->prepared, task, false);
      eachPosition(
        *this->prepared, queries, found.data(), options, [](Monitor&) {},
        [&] { return PlaneInterpolator<double>(*this->prepared, task, nullptr); });
      return withIds(*this->prepared, found);
    });
}

void TriangulationQueries::siteGradients(
  const double* values, std::int64_t components, double* gradients, const Options& options) const
{
  engineCall(
    [&]
    {
      const std::size_t count = this->prepared->sites.count();
      const InterpolationTask task{ Interpolation::CloughTocher, values, components, outside };
      requireValues(*this->prepared, task, count > 0);
      if (count > 0 && !gradients)
      {
        throw badArgument("there must be room for the gradients: a null pointer was given");
      }
      runOver(count, options,
        [&](Monitor& monitor) { gradientsInto(*this->prepared, task, count, gradients, monitor); });
    });
}

void TriangulationQueries::interpolateImage(Interpolation method, const double* values,
  std::int64_t components, const ImageGrid& grid, const ImageView& result, double fill,
  const Options& options) const
{
  engineCall(
    [&]
    {
      const InterpolationTask task{ method, values, components, fill };
      requireValues(*this->prepared, task, true);
      interpolatePixels(*this->prepared, task, grid, result, options);
    });
}

}
