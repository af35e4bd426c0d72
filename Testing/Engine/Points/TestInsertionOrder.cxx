// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The order of insertion: every point once, in levels that grow, each along a curve that stays
/// near, wherever the points crowd.
#include "Points/InsertionOrder.h"
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

InsertionOrder orderOf(const Cloud& cloud, const std::vector<std::uint32_t>& without = {},
  bool skipNonFinite = false, int threads = 1)
{
  const Options options;
  Monitor monitor(options);
  InsertionOrder result;
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

/// How far it is, in all, from point to point of the last level, steps to an outlier left out.
double wayThroughLastLevel(const Cloud& cloud, const InsertionOrder& order)
{
  const std::size_t levels = order.levelEnds.size();
  double way = 0;
  for (std::size_t i = order.levelEnds[levels - 2] + 1; i < order.ids.size(); ++i)
  {
    const auto& p = cloud[order.ids[i - 1]];
    const auto& q = cloud[order.ids[i]];
    const double step = std::hypot(q[0] - p[0], q[1] - p[1]);
    way += step < 1 ? step : 0;
  }
  return way;
}

void expectEachOnce(const InsertionOrder& order, std::vector<std::uint32_t> wanted)
{
  std::vector<std::uint32_t> ids(order.ids.begin(), order.ids.end());
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, wanted);
  ASSERT_FALSE(order.levelEnds.empty());
  EXPECT_TRUE(std::is_sorted(order.levelEnds.begin(), order.levelEnds.end()));
  EXPECT_EQ(order.levelEnds.back(), order.ids.size());
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
  const InsertionOrder order = orderOf(inSquare(100000, 1, 0, 0, 2));
  const std::size_t levels = order.levelEnds.size();
  for (std::size_t level = levels - 1; level > levels - 4; --level)
  {
    const double all = order.levelEnds[level];
    EXPECT_NEAR(order.levelEnds[level - 1], all / 8, 5 * std::sqrt(all / 8)) << "level " << level;
  }
}

TEST(InsertionOrder, IsTheSameOnManyThreads)
{
  const Cloud cloud = joined(inSquare(60000, 1, 0, 0, 3), inSquare(60000, 1e-9, 0.5, 0.5, 4));
  const InsertionOrder one = orderOf(cloud);
  const InsertionOrder four = orderOf(cloud, {}, false, 4);
  EXPECT_TRUE(std::equal(one.ids.begin(), one.ids.end(), four.ids.begin(), four.ids.end()));
  EXPECT_EQ(one.levelEnds, four.levelEnds);
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

/// The direction that an unfolded place stands for.
Point foldedBack(const double* uv)
{
  const double z = 1 - std::fabs(uv[0]) - std::fabs(uv[1]);
  return z >= 0 ? Point{ uv[0], uv[1], z }
                : Point{ std::copysign(1 - std::fabs(uv[1]), uv[0]),
                    std::copysign(1 - std::fabs(uv[0]), uv[1]), z };
}

TEST(OctahedralMap, GivesEachDirectionAPlaceInTheSquare)
{
  Random random(6);
  const double kernel[3] = { 1, -2, 0.5 };
  const double basis[3][3] = { { 2, 0, 0 }, { -1, 1, 0 }, { 0.5, 0.25, 4 } };
  const OctahedralMap octahedral(kernel, basis);
  for (int i = 0; i < 10000; ++i)
  {
    const double d[3] = { random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5 };
    const double near[3] = { kernel[0] + d[0], kernel[1] + d[1], kernel[2] + d[2] };
    const double far[3] = { kernel[0] + 9 * d[0], kernel[1] + 9 * d[1], kernel[2] + 9 * d[2] };
    double uv[2], same[2];
    octahedral.map(near, uv);
    octahedral.map(far, same);
    double size = 0;
    double seen[3];
    for (int k = 0; k < 3; ++k)
    {
      seen[k] = basis[k][0] * d[0] + basis[k][1] * d[1] + basis[k][2] * d[2];
      size += std::fabs(seen[k]);
    }
    const Point back = foldedBack(uv);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_NEAR(back[static_cast<std::size_t>(k)], seen[k] / size, 1e-10);
    }
    for (int k = 0; k < 2; ++k)
    {
      ASSERT_LE(std::fabs(uv[k]), 1);
      ASSERT_NEAR(uv[k], same[k], 1e-10) << "only the direction counts";
    }
  }
  double uv[2];
  octahedral.map(kernel, uv);
  EXPECT_EQ(uv[0], 0);
  EXPECT_EQ(uv[1], 0);
}

}
}
