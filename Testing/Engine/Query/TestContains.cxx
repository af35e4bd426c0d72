// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every point is on the side of the hull that exact integers tell.
#include "Testing/Engine/Query/QueryCases.h"
#include <flipflop/HullQueries.h>

#include <array>

namespace flipflop
{
namespace test
{

namespace
{

std::vector<std::int8_t> sidesOf(const HullQueries& hull, const Cloud& queries, int threads)
{
  std::vector<std::int8_t> sides(queries.size(), 99);
  hull.contains(viewOf(queries), sides.data(), onThreads(threads));
  return sides;
}

TEST(Contains, AgreesWithIntegersEverywhere)
{
  std::array<int, 3> met = {};
  for (const auto& [name, cloud] : queryClouds())
  {
    const Cloud queries = queriesAbout(cloud, 11, effort(600));
    const Hull polygons = hullOf(cloud, FacetMode::Polygons);
    const std::vector<std::int8_t> wanted = sidesByBruteForce(cloud, polygons, queries);
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      const HullQueries hull(viewOf(cloud), hullOf(cloud, facets));
      EXPECT_EQ(sidesOf(hull, queries, 1), wanted) << name << ", " << cloud.size();
    }
    for (const std::int8_t side : wanted)
    {
      ++met[static_cast<std::size_t>(side + 1)];
    }
  }
  for (const int count : met)
  {
    EXPECT_GT(count, effort(500));
  }
}

TEST(Contains, OnItsOwnPoints)
{
  for (const auto& [name, cloud] : queryClouds())
  {
    const Hull hull = hullOf(cloud, FacetMode::Triangles);
    const std::vector<std::int8_t> sides = sidesOf(HullQueries(viewOf(cloud), hull), cloud, 1);
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      EXPECT_GE(sides[i], 0) << name << ", point " << i;
    }
    for (const std::int64_t id : hull.pointIds)
    {
      EXPECT_EQ(sides[static_cast<std::size_t>(id)], 0) << name << ", vertex " << id;
    }
  }
}

TEST(Contains, PointsWhoseBitsReachLowerThanTheHulls)
{
  // A unit tetrahedron: its slanted facet passes through none of these, but closely.
  const Cloud cloud = latticeTetrahedron(1);
  Cloud queries;
  for (const double tiny : { 5e-324, 1e-300, 1e-200, 1e-100, 1e-80, 1e-30 })
  {
    for (const double sign : { 1.0, -1.0 })
    {
      queries.push_back({ 0.5, 0.5, sign * tiny });
      queries.push_back({ sign * tiny, tiny, tiny });
      queries.push_back({ 0.25, 0.25 + sign * tiny, 0.5 });
      queries.push_back({ sign * tiny, 1, 0 });
    }
  }
  const Hull hull = hullOf(cloud, FacetMode::Polygons);
  EXPECT_EQ(
    sidesOf(HullQueries(viewOf(cloud), hull), queries, 1), sidesByBruteForce(cloud, hull, queries));
}

TEST(Contains, ManyPointsOnAnyThreads)
{
  const Cloud cloud = fromFamily("ball", 3000, 5).make();
  const Cloud queries = joined(queriesAbout(cloud, 12, effort(20000)), cloud);
  const Hull polygons = hullOf(cloud, FacetMode::Polygons);
  const HullQueries hull(viewOf(cloud), polygons);
  const std::vector<std::int8_t> one = sidesOf(hull, queries, 1);
  EXPECT_EQ(sidesOf(hull, queries, 2), one);
  EXPECT_EQ(sidesOf(hull, queries, 4), one);
  const Cloud some(queries.begin(), queries.begin() + effort(2000));
  EXPECT_EQ(sidesOf(hull, some, 1), sidesByBruteForce(cloud, polygons, some));
}

TEST(Contains, FloatsAndStrides)
{
  const Cloud cloud = roundedToFloat(fromFamily("ball", 200, 6).make());
  const Cloud queries = roundedToFloat(queriesAbout(cloud, 13, 500));
  Cloud finite;
  std::copy_if(queries.begin(), queries.end(), std::back_inserter(finite),
    [](const Point& p)
    { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); });
  const std::vector<float> floats = floatsOf(cloud);
  const std::vector<float> asked = floatsOf(finite);
  std::vector<double> wide(5 * finite.size());
  for (std::size_t i = 0; i < finite.size(); ++i)
  {
    std::copy(finite[i].begin(), finite[i].end(), wide.begin() + 5 * static_cast<int>(i));
  }
  const auto count = static_cast<std::int64_t>(finite.size());
  const Hull polygons = hullOf(cloud, FacetMode::Polygons);
  const HullQueries hull(
    PointView(floats.data(), static_cast<std::int64_t>(cloud.size())), polygons);
  const std::vector<std::int8_t> wanted = sidesByBruteForce(cloud, polygons, finite);
  std::vector<std::int8_t> sides(finite.size(), 99);
  hull.contains(PointView(asked.data(), count), sides.data());
  EXPECT_EQ(sides, wanted);
  std::fill(sides.begin(), sides.end(), std::int8_t(99));
  hull.contains(PointView(wide.data(), count, 5), sides.data());
  EXPECT_EQ(sides, wanted);
}

}
}
}
