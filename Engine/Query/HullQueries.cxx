// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/HullQueries.h>

#include "Query/HullModel.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

HullQueries::HullQueries(const PointView& points, const Hull& hull, const Options& options)
  : model(withTypedErrors([&] { return std::make_unique<const HullModel>(points, hull, options); }))
{
}

HullQueries::HullQueries(HullQueries&& other) noexcept = default;
HullQueries& HullQueries::operator=(HullQueries&& other) noexcept = default;
HullQueries::~HullQueries() = default;

namespace
{

/// Points in the box, a block at a time: the locator dismisses those deep inside, the others walk.
void containsRun(const HullModel& model, const QueryRun& run, const HullLocator* locator,
  std::uint32_t begin, std::uint32_t end, std::int8_t* sides)
{
  constexpr int Size = HullLocator::BlockSize;
  const HullGeometry local = model.geometry();
  HullLocator::Block block;
  double x[3][Size];
  std::uint32_t from[Size]; // of the block's points: their place in x
  const int exponent = model.scaleExponent();
  for (std::uint32_t first = begin; first < end; first += Size)
  {
    const int n = static_cast<int>(std::min<std::uint32_t>(Size, end - first));
    run.source.load(first, n, x[0], x[1], x[2]);
    int inBox = 0;
    for (int i = 0; i < n; ++i)
    {
      const double p[3] = { x[0][i], x[1][i], x[2][i] };
      sides[first + i] = static_cast<std::int8_t>(Side::Outside);
      from[inBox] = static_cast<std::uint32_t>(i);
      for (int k = 0; k < 3; ++k)
      {
        block.x[k][inBox] = p[k];
      }
      inBox += model.isInBox(p) ? 1 : 0; // what is not finite is not
    }
    for (int k = 0; k < 3 && exponent; ++k)
    {
      for (int i = 0; i < inBox; ++i)
      {
        block.x[k][i] = std::ldexp(block.x[k][i], exponent);
      }
    }
    if (locator)
    {
      locator->classify(block, inBox);
    }
    for (int i = 0; i < inBox; ++i)
    {
      const std::uint32_t at = from[i];
      if (locator && block.inside[i])
      {
        sides[first + at] = static_cast<std::int8_t>(Side::Inside);
        continue;
      }
      const double p[3] = { x[0][at], x[1][at], x[2][at] };
      const std::uint32_t start = locator ? locator->near(Vertex(), block.cell[i]) : 0;
      sides[first + at] = static_cast<std::int8_t>(model.place(local, p, start, locator).side);
    }
  }
}

}

void HullQueries::contains(
  const PointView& queries, std::int8_t* sides, const Options& options) const
{
  const HullModel& hull = *this->model;
  const HullLocator* locator = nullptr;
  eachQuery(
    queries, sides, options,
    [&](QueryRun& run)
    {
      if (hull.dimension() == 3)
      {
        run.monitor.stage(0.1, 0.3, 1);
        locator = &hull.locator(run.monitor);
      }
    },
    [&](QueryRun& run, std::uint32_t begin, std::uint32_t end)
    {
      if (hull.dimension() < 0)
      {
        std::fill(sides + begin, sides + end, static_cast<std::int8_t>(Side::Outside));
        return;
      }
      containsRun(hull, run, locator, begin, end, sides);
    });
}

void HullQueries::support(
  const PointView& directions, std::int64_t* ids, const Options& options) const
{
  const HullModel& hull = *this->model;
  const DirectionMap* map = nullptr;
  eachQuery(
    directions, ids, options,
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
        ids[i] =
          map && (!run.checkFinite || isFinite(vector)) ? hull.inputId(map->farthest(vector)) : -1;
      }
    });
}

}
