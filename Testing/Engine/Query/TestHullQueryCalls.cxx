// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Queries of hulls refuse what they cannot answer, and give the answers that the header names for
/// what is ignored, and for no hull at all.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Query/HullReference.h"
#include <flipflop/Certificate.h>
#include <flipflop/Neighbors.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <thread>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();
const Cloud cube = integerGrid(2);

TEST(HullQueryCalls, HullsThatAreNotOfThePoints)
{
  const Cloud cloud = integerGrid(3);
  const std::function<void(Hull&)> changes[] = { [](Hull& hull) { hull.pointIds[7] = 27; },
    [](Hull& hull) { hull.pointIds[0] = -1; },
    [](Hull& hull) { std::swap(hull.pointIds[0], hull.pointIds[1]); },
    [](Hull& hull) { hull.connectivity[1] = 8; }, [](Hull& hull) { hull.connectivity[1] = -1; },
    [](Hull& hull) { hull.connectivity.truncate(hull.connectivity.size() - 1); },
    [](Hull& hull) { hull.dimension = 4; }, [](Hull& hull) { hull.dimension = 0; } };
  for (const auto& change : changes)
  {
    Hull hull = hullOf(cloud, FacetMode::Triangles);
    change(hull);
    expectError([&] { HullQueries(viewOf(cloud), hull); }, ErrorCode::BadArgument);
    expectError([&] { facetPlanes(viewOf(cloud), hull); }, ErrorCode::BadArgument);
  }
  // A surface with a hole has planes, but no inside.
  Hull open = hullOf(cloud, FacetMode::Triangles);
  open.connectivity.truncate(open.connectivity.size() - 3);
  expectError([&] { HullQueries(viewOf(cloud), open); }, ErrorCode::BadArgument);
  // No polygon is a hull of dimension 2.
  Hull none;
  none.dimension = 2;
  expectError([&] { HullQueries(viewOf(cloud), none); }, ErrorCode::BadArgument, -1);
  expectError([&] { certificate(viewOf(cloud), none); }, ErrorCode::BadArgument, -1);
  // An edge of three cells has no neighbours.
  Hull crowded;
  crowded.dimension = 3;
  crowded.cellSize = 3;
  crowded.pointIds.allocate(5);
  std::fill(crowded.pointIds.begin(), crowded.pointIds.end(), 0);
  const std::int64_t corners[] = { 0, 1, 2, 1, 2, 3, 1, 2, 4 };
  crowded.connectivity.allocate(9);
  std::copy(corners, corners + 9, crowded.connectivity.begin());
  for (std::size_t i = 0; i < 5; ++i)
  {
    crowded.pointIds[i] = static_cast<std::int64_t>(i);
  }
  expectError([&] { cellNeighbors(crowded); }, ErrorCode::BadArgument, 0);
  crowded.connectivity[8] = 7;
  expectError([&] { cellNeighbors(crowded); }, ErrorCode::BadArgument, -1);
}

TEST(HullQueryCalls, CertificatesNameNoCellForPointsThatAreNotFinite)
{
  for (const Cloud& finite :
    { integerGrid(3), integerGrid(1), Cloud{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } } })
  {
    Cloud cloud = finite;
    cloud.insert(cloud.begin(), { nan, 0, 0 });
    cloud.push_back({ 0, infinity, 0 });
    Options options;
    options.nonFinite = NonFinitePolicy::Ignore;
    const Hull hull = convexHull(viewOf(cloud), options);
    const Certificate found = certificate(viewOf(cloud), hull, options);
    ASSERT_EQ(found.cells.size(), cloud.size());
    EXPECT_EQ(found.cells[0], -1);
    EXPECT_EQ(found.cells[cloud.size() - 1], -1);
    for (std::size_t i = 1; i + 1 < cloud.size(); ++i)
    {
      EXPECT_TRUE(found.cells[i] >= 0 && found.cells[i] < hull.cellCount()) << i;
    }
  }
}

TEST(HullQueryCalls, ArraysThatAreNotThere)
{
  const HullQueries hull(viewOf(cube), hullOf(cube, FacetMode::Triangles));
  expectError([&] { hull.distance(viewOf(cube), nullptr); }, ErrorCode::BadArgument);
  expectError([&] { hull.contains(viewOf(cube), nullptr); }, ErrorCode::BadArgument);
  expectError([&] { hull.support(viewOf(cube), nullptr); }, ErrorCode::BadArgument);
  // No query is no error.
  hull.contains(PointView(), nullptr);
  hull.support(PointView(), nullptr);
  hull.distance(PointView(), nullptr);
}

TEST(HullQueryCalls, QueriesThatAreNotFiniteAreIgnored)
{
  for (const std::size_t points : { 0, 1, 4, 8 })
  {
    const Cloud cloud(cube.begin(), cube.begin() + static_cast<std::ptrdiff_t>(points));
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
    EXPECT_EQ(distances[0], points == 0 ? infinity : 0);
    EXPECT_EQ(sides[0], points == 0 ? -1 : 0);
    EXPECT_EQ(ids[0], points == 0 ? -1 : 0);
    for (const std::size_t i : { 1, 2 })
    {
      EXPECT_EQ(sides[i], -1);
      EXPECT_EQ(ids[i], -1);
      EXPECT_TRUE(std::isnan(distances[i]));
    }
  }
}

/// What a query needs is prepared when the first one comes, from whichever thread.
TEST(HullQueryCalls, ManyThreadsAskAtOnce)
{
  const Cloud cloud = fromFamily("ball", 3000, 9).make();
  const Hull hull = hullOf(cloud, FacetMode::Triangles);
  const auto ask = [&](const HullQueries& asked, int threads)
  {
    Options options;
    options.threads = threads;
    std::vector<std::int8_t> sides(cloud.size());
    std::vector<std::int64_t> ids(cloud.size());
    asked.support(viewOf(cloud), ids.data(), options);
    asked.contains(viewOf(cloud), sides.data(), options);
    return std::make_pair(sides, ids);
  };
  const auto wanted = ask(HullQueries(viewOf(cloud), hull), 1);
  const HullQueries shared(viewOf(cloud), hull);
  std::atomic<int> same{ 0 };
  std::vector<std::thread> threads;
  for (int i = 1; i <= 4; ++i)
  {
    threads.emplace_back([&, i] { same += ask(shared, i) == wanted ? 1 : 0; });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(same.load(), 4);
}

TEST(HullQueryCalls, MovedQueriesAnswer)
{
  HullQueries first(viewOf(cube), hullOf(cube, FacetMode::Triangles));
  const Cloud one = { { 0.5, 0.5, 0.5 } };
  const auto expectInside = [&](const HullQueries& queries)
  {
    std::int8_t side = 99;
    queries.contains(viewOf(one), &side);
    EXPECT_EQ(side, 1);
  };
  expectInside(first);
  HullQueries second(std::move(first));
  expectInside(second);
  first = std::move(second);
  expectInside(first);
}

}
}
}
