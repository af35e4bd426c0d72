// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The order of insertion: every point once, in levels that grow, each along a curve that stays
/// near, wherever the points crowd.
#include "Geometry/HilbertCurve.h"
#include "Geometry/InsertionOrder.h"
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flipflop
{
namespace test
{

namespace
{

Buffer<std::uint32_t> orderOf(const Cloud& cloud, const std::vector<std::uint32_t>& without = {},
  bool skipNonFinite = false, int threads = 1)
{
  const Options options;
  Monitor monitor(options);
  Buffer<std::uint32_t> result;
  ArenaLoan arena(threads);
  arena.execute(
    [&]
    {
      PointSubset subset;
      subset.count = static_cast<std::uint32_t>(cloud.size());
      subset.exclude(without);
      subset.checkFinite = skipNonFinite;
      result = insertionOrder(PointSource(viewOf(cloud)), subset, OctahedralMap(), monitor);
    });
  return result;
}

Cloud inSquare(int count, double side, double x, double y, std::uint64_t seed)
{
  return moved(scaled(randomSites(count, 0, seed), side, side, 0), x, y, 0);
}

/// Where the last level begins.
std::size_t lastLevelOf(const Buffer<std::uint32_t>& ids)
{
  return static_cast<std::size_t>(
    std::find_if(ids.begin(), ids.end(),
      [](std::uint32_t id) { return insertionLevelOf(id) == InsertionLevels - 1; }) -
    ids.begin());
}

/// How far it is, in all, from point to point of the last level, steps to an outlier left out.
double wayThroughLastLevel(const Cloud& cloud, const Buffer<std::uint32_t>& ids)
{
  double way = 0;
  for (std::size_t i = lastLevelOf(ids) + 1; i < ids.size(); ++i)
  {
    const auto& p = cloud[ids[i - 1]];
    const auto& q = cloud[ids[i]];
    const double step = std::hypot(q[0] - p[0], q[1] - p[1]);
    way += step < 1 ? step : 0;
  }
  return way;
}

void expectEachOnce(const Buffer<std::uint32_t>& order, std::vector<std::uint32_t> wanted)
{
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end(),
    [](std::uint32_t a, std::uint32_t b) { return insertionLevelOf(a) < insertionLevelOf(b); }));
  std::vector<std::uint32_t> ids(order.begin(), order.end());
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, wanted);
}

}

TEST(InsertionOrder, HoldsEachPointOnce)
{
  // Also of one place; and where each point is twice as near to the origin as the one before: over
  // a thousand of a double's powers of two, of which a curve sees sixteen.
  Cloud scales;
  for (int i = 0; i < 2000; ++i)
  {
    scales.push_back({ std::ldexp(1.0, -(i % 1000)), std::ldexp(1.0, -(i / 2)), 0 });
  }
  std::vector<Cloud> clouds = { scales, Cloud(20000, { 3, 4, 0 }) };
  for (const int count : { 0, 1, 2, 3, 100, 4096, 4097, 50000 })
  {
    clouds.push_back(inSquare(count, 1, 0, 0, 1));
  }
  for (const Cloud& cloud : clouds)
  {
    SCOPED_TRACE(cloud.size());
    std::vector<std::uint32_t> all(cloud.size());
    std::iota(all.begin(), all.end(), 0u);
    expectEachOnce(orderOf(cloud), all);
  }
  Cloud cloud = inSquare(6, 1, 0, 0, 1);
  cloud[4][1] = std::nan("");
  expectEachOnce(orderOf(cloud, { 0, 2 }, true), { 1, 3, 5 });
}

TEST(InsertionOrder, EachLevelHasSevenTimesAllBefore)
{
  std::vector<double> upTo(InsertionLevels);
  for (const std::uint32_t id : orderOf(inSquare(100000, 1, 0, 0, 2)))
  {
    for (std::uint32_t level = insertionLevelOf(id); level < InsertionLevels; ++level)
    {
      ++upTo[level];
    }
  }
  for (std::size_t level = InsertionLevels - 1; level > InsertionLevels - 4; --level)
  {
    const double share = upTo[level] / 8;
    EXPECT_NEAR(upTo[level - 1], share, 5 * std::sqrt(share)) << "level " << level;
  }
}

TEST(InsertionOrder, IsTheSameOnManyThreads)
{
  const Cloud cloud = joined(inSquare(60000, 1, 0, 0, 3), inSquare(60000, 1e-9, 0.5, 0.5, 4));
  const Buffer<std::uint32_t> one = orderOf(cloud);
  const Buffer<std::uint32_t> four = orderOf(cloud, {}, false, 4);
  EXPECT_TRUE(std::equal(one.begin(), one.end(), four.begin(), four.end()));
}

TEST(InsertionOrder, TheWayIsShort)
{
  // Through n points at random in a square, a Hilbert curve's way is about 0.92 sqrt(n) sides. Also
  // where all are in one step of the curve through the whole, for one point far away.
  const int count = 100000;
  const double side = 1e-7;
  Cloud cloud = inSquare(count, side, 0, 0, 6);
  EXPECT_LT(wayThroughLastLevel(cloud, orderOf(cloud)), 1.2 * side * std::sqrt(count));
  cloud.push_back({ 1, 1, 0 });
  EXPECT_LT(wayThroughLastLevel(cloud, orderOf(cloud)), 1.5 * side * std::sqrt(count));
}

}
}
