// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Queries refuse what they cannot answer, stop when asked to, and give the answers that the header
/// names for what is ignored, and for no hull at all.
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Query/QueryCases.h"
#include <flipflop/HullQueries.h>
#include <flipflop/Neighbors.h>

#include <atomic>
#include <functional>
#include <thread>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

TEST(QueryErrors, HullsThatAreNotOfThePoints)
{
  const Cloud cloud = integerGrid(3);
  const auto expectBad = [&](const std::function<void(Hull&)>& spoil)
  {
    Hull hull = hullOf(cloud, FacetMode::Triangles);
    spoil(hull);
    expectError([&] { HullQueries(viewOf(cloud), hull); }, ErrorCode::BadArgument);
    expectError([&] { facetPlanes(viewOf(cloud), hull); }, ErrorCode::BadArgument);
  };
  expectBad([](Hull& hull) { hull.pointIds[7] = 27; });
  expectBad([](Hull& hull) { hull.pointIds[0] = -1; });
  expectBad([](Hull& hull) { std::swap(hull.pointIds[0], hull.pointIds[1]); });
  expectBad([](Hull& hull) { hull.connectivity[1] = 8; });
  expectBad([](Hull& hull) { hull.connectivity[1] = -1; });
  expectBad([](Hull& hull) { hull.connectivity.truncate(hull.connectivity.size() - 1); });
  expectBad([](Hull& hull) { hull.dimension = 4; });
  expectBad([](Hull& hull) { hull.dimension = 0; });
  // A surface with a hole has planes, but no inside.
  Hull open = hullOf(cloud, FacetMode::Triangles);
  open.connectivity.truncate(open.connectivity.size() - 3);
  expectError([&] { HullQueries(viewOf(cloud), open); }, ErrorCode::BadArgument);
  Cloud spoilt = cloud;
  spoilt[0][1] = nan;
  const Hull hull = hullOf(cloud, FacetMode::Triangles);
  expectError([&] { HullQueries(viewOf(spoilt), hull); }, ErrorCode::BadArgument);
}

TEST(QueryErrors, ArraysThatAreNotThere)
{
  const Cloud cloud = integerGrid(2);
  const HullQueries hull(viewOf(cloud), hullOf(cloud, FacetMode::Triangles));
  expectError([&] { hull.distance(viewOf(cloud), nullptr); }, ErrorCode::BadArgument);
  expectError([&] { hull.contains(viewOf(cloud), nullptr); }, ErrorCode::BadArgument);
  expectError([&] { hull.support(viewOf(cloud), nullptr); }, ErrorCode::BadArgument);
  // No query is no error.
  hull.contains(PointView(), nullptr);
  hull.support(PointView(), nullptr);
  hull.distance(PointView(), nullptr);
}

TEST(QueryErrors, QueriesThatAreNotFiniteAreIgnored)
{
  for (const int dimension : { -1, 0, 2, 3 })
  {
    Cloud cloud = integerGrid(2);
    cloud.resize(dimension < 0 ? 0 : dimension == 0 ? 1 : dimension == 2 ? 4 : 8);
    const HullQueries hull(viewOf(cloud), hullOf(cloud, FacetMode::Triangles));
    const Cloud queries = { { 0, 0, 0 }, { 0, nan, 0 }, { -infinity, 0, 0 }, { 0, 0, 0.5 } };
    std::vector<std::int8_t> sides(4, 99);
    std::vector<std::int64_t> ids(4, -2);
    std::vector<double> distances(4, 99);
    Options options;
    options.nonFinite = NonFinitePolicy::Ignore;
    hull.contains(viewOf(queries), sides.data(), options);
    hull.support(viewOf(queries), ids.data(), options);
    hull.distance(viewOf(queries), distances.data(), options);
    EXPECT_EQ(distances[0], dimension < 0 ? infinity : 0);
    EXPECT_EQ(sides[0], dimension < 0 ? -1 : 0);
    EXPECT_EQ(ids[0], dimension < 0 ? -1 : 0);
    for (const std::size_t i : { 1, 2 })
    {
      EXPECT_EQ(sides[i], -1);
      EXPECT_EQ(ids[i], -1);
      EXPECT_TRUE(std::isnan(distances[i]));
    }
  }
}

TEST(QueryErrors, ManyThreadsAskAtOnce)
{
  const Cloud cloud = fromFamily("ball", 3000, 9).make();
  const Hull hull = hullOf(cloud, FacetMode::Triangles);
  const HullQueries shared(viewOf(cloud), hull);
  const HullQueries apart(viewOf(cloud), hull);
  std::vector<std::int8_t> sides(cloud.size());
  std::vector<std::int64_t> ids(cloud.size());
  apart.contains(viewOf(cloud), sides.data());
  apart.support(viewOf(cloud), ids.data());
  std::atomic<int> same{ 0 };
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        std::vector<std::int8_t> mySides(cloud.size());
        std::vector<std::int64_t> myIds(cloud.size());
        if (i % 2)
        {
          shared.support(viewOf(cloud), myIds.data(), onThreads(1 + i));
        }
        shared.contains(viewOf(cloud), mySides.data(), onThreads(1 + i));
        shared.support(viewOf(cloud), myIds.data(), onThreads(1 + i));
        same += mySides == sides && myIds == ids ? 1 : 0;
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(same.load(), 4);
}

TEST(QueryErrors, MovedQueriesAnswer)
{
  const Cloud cloud = integerGrid(2);
  HullQueries first(viewOf(cloud), hullOf(cloud, FacetMode::Triangles));
  const Cloud one = { { 0.5, 0.5, 0.5 } };
  std::int8_t side = 99;
  first.contains(viewOf(one), &side);
  HullQueries second(std::move(first));
  second.contains(viewOf(one), &side);
  EXPECT_EQ(side, 1);
  first = std::move(second);
  side = 99;
  first.contains(viewOf(one), &side);
  EXPECT_EQ(side, 1);
}

}
}
}
