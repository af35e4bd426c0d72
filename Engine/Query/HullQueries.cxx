// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/HullQueries.h>

#include "Geometry/Extents.h"
#include "Query/FarthestPair.h"
#include "Query/MinimalBox.h"
#include "Query/PreparedHull.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

HullQueries::HullQueries(
  const PointView& points, const Hull& hull, const Options& options, PointSpace space)
  : model(engineCall(
      [&] { return std::make_unique<const PreparedHull>(points, hull, options, space); }))
{
}

HullQueries::HullQueries(HullQueries&& other) noexcept = default;
HullQueries& HullQueries::operator=(HullQueries&& other) noexcept = default;
HullQueries::~HullQueries() = default;

namespace
{

/// @param exponent the corners are scaled by 2^ this
double distanceBetween(const Vertex& a, const Vertex& b, int exponent)
{
  // In halves, and in units of the longest coordinate: nothing overflows on the way.
  double gap[3];
  for (int i = 0; i < 3; ++i)
  {
    gap[i] = 0.5 * a.x[i] - 0.5 * b.x[i];
  }
  const double longest = largestOf(gap[0], gap[1], gap[2]);
  const int unit = longest > 0 ? std::ilogb(longest) : 0;
  double sum = 0;
  for (double& x : gap)
  {
    x = std::ldexp(x, -unit);
    sum += x * x;
  }
  return std::ldexp(std::sqrt(sum), unit + 1 - exponent);
}

/// use (std::uint32_t query, const double* x, const Placed&) for some queries; the triangle of
/// those outside the box is NoIndex. The others are examined a block at a time: the locator
/// dismisses those deep inside, what remains walks.
template <class Use>
void eachLocated(const PreparedHull& model, const QueryRun& run, const HullLocator* locator,
  std::uint32_t begin, std::uint32_t end, const Use& use)
{
  constexpr int Size = HullLocator::BlockSize;
  const HullGeometry local = model.geometry();
  HullLocator::Block block;
  double x[3][Size];
  std::uint32_t from[Size]; // of the block's points: their index in x
  const int exponent = model.scaleExponent();
  for (std::uint32_t first = begin; first < end; first += Size)
  {
    const int n = static_cast<int>(std::min<std::uint32_t>(Size, end - first));
    run.source.load(first, n, x[0], x[1], x[2]);
    int inBox = 0;
    for (int i = 0; i < n; ++i)
    {
      const double p[3] = { x[0][i], x[1][i], x[2][i] };
      if (!model.isInBox(p)) // as what is not finite
      {
        use(first + static_cast<std::uint32_t>(i), p, Location{ Side::Outside, NoIndex });
        continue;
      }
      from[inBox] = static_cast<std::uint32_t>(i);
      for (int k = 0; k < 3; ++k)
      {
        block.x[k][inBox] = exponent ? std::ldexp(p[k], exponent) : p[k];
      }
      ++inBox;
    }
    if (locator)
    {
      locator->classify(block, inBox);
    }
    for (int i = 0; i < inBox; ++i)
    {
      const std::uint32_t at = from[i];
      const double p[3] = { x[0][at], x[1][at], x[2][at] };
      const std::uint32_t start = locator ? locator->near(Vertex(), block.cell[i]) : 0;
      use(first + at, p,
        locator && block.inside[i] ? Location{ Side::Inside, start }
                                   : model.locate(local, p, start, locator));
    }
  }
}

/// The locator, where the hull has one.
const HullLocator* locatorOf(const PreparedHull& hull, Monitor& monitor)
{
  if (hull.dimension() < 3)
  {
    return nullptr;
  }
  monitor.stage(0.1, 0.2, 1, "preparing");
  return &hull.locator(monitor);
}

}

void HullQueries::contains(
  const PointView& queries, std::int8_t* sides, const Options& options) const
{
  engineCall(
    [&]
    {
      const PreparedHull& hull = *this->model;
      const HullLocator* locator = nullptr;
      eachQuery(
        queries, hull.axisCount(), sides, options,
        [&](QueryRun& run) { locator = locatorOf(hull, run.monitor); },
        [&](QueryRun& run, std::uint32_t begin, std::uint32_t end)
        {
          eachLocated(hull, run, locator, begin, end,
            [sides](std::uint32_t query, const double*, const Location& location)
            { sides[query] = static_cast<std::int8_t>(location.side); });
        });
    });
}

void HullQueries::distance(
  const PointView& queries, double* distances, const Options& options) const
{
  engineCall(
    [&]
    {
      const PreparedHull& hull = *this->model;
      const HullLocator* locator = nullptr;
      const SurfaceTree* surface = nullptr;
      const auto distanceOf = [&](const double* x, const Location& location)
      {
        if (!isFinite(x))
        {
          return std::numeric_limits<double>::quiet_NaN();
        }
        if (location.side == Side::On || !surface)
        {
          return surface ? 0.0 : std::numeric_limits<double>::infinity();
        }
        const std::uint32_t start = location.triangle == NoIndex && locator
          ? hull.triangleTowards(x, *locator)
          : location.triangle;
        // The side is exact, so zero would be wrong.
        const double distance = std::max(surface->distance(x, location.side == Side::Inside, start),
          std::numeric_limits<double>::denorm_min());
        return location.side == Side::Inside ? -distance : distance;
      };
      eachQuery(
        queries, hull.axisCount(), distances, options,
        [&](QueryRun& run)
        {
          locator = locatorOf(hull, run.monitor);
          run.monitor.stage(0.2, 0.3, 1);
          surface = hull.dimension() < 0 ? nullptr : &hull.surface(run.monitor);
        },
        [&](QueryRun& run, std::uint32_t begin, std::uint32_t end)
        {
          eachLocated(hull, run, locator, begin, end,
            [&](std::uint32_t query, const double* x, const Location& location)
            { distances[query] = distanceOf(x, location); });
        });
    });
}

void HullQueries::support(
  const PointView& directions, std::int64_t* ids, const Options& options) const
{
  engineCall(
    [&]
    {
      const PreparedHull& hull = *this->model;
      const DirectionMap* map = nullptr;
      eachQuery(
        directions, hull.axisCount(), ids, options,
        [&](QueryRun& run)
        {
          run.monitor.stage(0.1, 0.3, 1);
          map = hull.dimension() < 0 ? nullptr : &hull.directions(run.monitor);
        },
        [&](QueryRun& run, std::uint32_t begin, std::uint32_t end)
        {
          for (std::uint32_t i = begin; i < end; ++i)
          {
            double vector[3];
            run.source.load(i, vector);
            ids[i] = map && (!run.checkFinite || isFinite(vector))
              ? hull.inputId(map->farthest(vector))
              : -1;
          }
        });
    });
}

Diameter HullQueries::diameter(const Options& options) const
{
  return engineCall(
    [&]
    {
      const PreparedHull& hull = *this->model;
      Diameter result;
      runOver(hull.size(), options,
        [&](Monitor& monitor)
        {
          if (hull.dimension() < 0)
          {
            return;
          }
          const CornerPair pair =
            farthestPair(&hull.corner(0), hull.size(), hull.isWide(), monitor);
          result.first = hull.inputId(pair.first);
          result.second = hull.inputId(pair.second);
          result.length = distanceBetween(
            hull.corner(pair.first), hull.corner(pair.second), hull.scaleExponent());
        });
      return result;
    });
}

OrientedBox HullQueries::minimalBox(const Options& options) const
{
  return engineCall(
    [&]
    {
      const PreparedHull& hull = *this->model;
      OrientedBox box;
      runOver(hull.size(), options,
        [&](Monitor& monitor)
        {
          if (hull.dimension() >= 0)
          {
            box = minimalBoxOf(hull, monitor);
          }
        });
      return box;
    });
}

}
