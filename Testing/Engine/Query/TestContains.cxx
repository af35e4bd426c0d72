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

TEST(Contains, ManyPoints)
{
  const Cloud cloud = fromFamily("ball", 3000, 5).make();
  const Cloud queries = joined(queriesAbout(cloud, 12, effort(2000)), cloud);
  const Hull polygons = hullOf(cloud, FacetMode::Polygons);
  const HullQueries hull(viewOf(cloud), polygons);
  EXPECT_EQ(sidesOf(hull, queries, 1), sidesByBruteForce(cloud, polygons, queries));
}

}
}
}
