// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HalfSpaces/SurelyRedundant.h"

#include <flipflop/ConvexHull.h>
#include <flipflop/HullQueries.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flipflop
{

namespace
{

constexpr std::int64_t Least = 4096; ///< half-spaces, of which it pays
constexpr std::int64_t Step = 16;    ///< one of so many makes the hull
constexpr double Stretch = 0x1p-24;  ///< s
constexpr double RoundingShare = 0x1p-50;

/// Less than this is far from overflow, more than its inverse from underflow.
constexpr double MostLength = 0x1p300;

}

std::vector<std::uint32_t> surelyRedundant(
  const std::vector<double>& duals, int threads, Monitor& monitor)
{
  std::vector<std::uint32_t> found;
  const auto count = static_cast<std::int64_t>(duals.size() / 3);
  if (count < Least)
  {
    return found;
  }
  double longest = 0;
  for (const double x : duals)
  {
    longest = std::max(longest, std::fabs(x));
  }
  if (!(longest < MostLength))
  {
    return found;
  }
  Options options;
  options.threads = threads;
  const PointView sample(duals.data(), count / Step, 3 * Step);
  const Hull hull = convexHull(sample, options);
  monitor.poll();
  if (hull.dimension < 3)
  {
    return found;
  }
  const HullQueries queries(sample, hull, options);
  const double origin[3] = { 0, 0, 0 };
  double height = 0;
  queries.distance(PointView(origin, 1), &height, options);
  // A length is at most twice the largest coordinate; heights are rounded, too.
  if (!(-height > 1 / MostLength && Stretch * -height > 4 * RoundingShare * longest))
  {
    return found;
  }
  std::vector<double> stretched(duals.size());
  std::transform(
    duals.begin(), duals.end(), stretched.begin(), [](double x) { return x + Stretch * x; });
  std::vector<std::int8_t> sides(static_cast<std::size_t>(count));
  queries.contains(PointView(stretched.data(), count), sides.data(), options);
  monitor.poll();
  for (std::size_t id = 0; id < sides.size(); ++id)
  {
    if (sides[id] == static_cast<std::int8_t>(Side::Inside))
    {
      found.push_back(static_cast<std::uint32_t>(id));
    }
  }
  return found;
}

}
