// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The farthest vertex in each direction is the one that exact integers tell.
#include "Testing/Engine/Query/QueryCases.h"
#include <flipflop/HullQueries.h>

namespace flipflop
{
namespace test
{

namespace
{

/// Normals of facets, where doubles hold them, and what is near them; vectors along axes and
/// diagonals; of any length, in any range.
Cloud directionsFor(const Cloud& cloud, std::uint64_t seed, int count)
{
  Random random(seed);
  Cloud directions;
  for (int x = -1; x <= 1; ++x)
  {
    for (int y = -1; y <= 1; ++y)
    {
      for (int z = -1; z <= 1; ++z)
      {
        directions.push_back({ double(x), double(y), double(z) });
      }
    }
  }
  const auto pick = [&]() -> const Point& {
    return cloud[static_cast<std::size_t>(random.integer(0, static_cast<int>(cloud.size()) - 1))];
  };
  while (static_cast<int>(directions.size()) < count)
  {
    Point d = random.direction();
    const int kind = random.integer(0, 5);
    if (kind < 2)
    {
      const Point a = pick(), b = pick(), c = pick();
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t p = (i + 1) % 3;
        const std::size_t q = (i + 2) % 3;
        d[i] = (b[p] - a[p]) * (c[q] - a[q]) - (b[q] - a[q]) * (c[p] - a[p]);
      }
    }
    if (kind == 2)
    {
      d = scaled({ d }, 1e300, 1e-300, 1e-10)[0];
    }
    if (kind == 3)
    {
      d = scaled({ d }, 1e-310, 1e-310, random.integer(0, 1) ? 0.0 : 1e-310)[0];
    }
    if (kind == 1 || kind == 4)
    {
      double& x = d[static_cast<std::size_t>(random.integer(0, 2))];
      x = kind == 4 ? 0.0 : std::nextafter(x, 1e308);
    }
    if (std::isfinite(d[0]) && std::isfinite(d[1]) && std::isfinite(d[2]))
    {
      directions.push_back(d);
    }
  }
  return directions;
}

std::vector<std::int64_t> farthestOf(const HullQueries& hull, const Cloud& directions, int threads)
{
  std::vector<std::int64_t> ids(directions.size(), -2);
  hull.support(viewOf(directions), ids.data(), onThreads(threads));
  return ids;
}

TEST(Support, AgreesWithIntegersEverywhere)
{
  for (const auto& [name, cloud] : queryClouds())
  {
    const Cloud directions = directionsFor(cloud, 21, effort(400));
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      const Hull hull = hullOf(cloud, facets);
      EXPECT_EQ(farthestOf(HullQueries(viewOf(cloud), hull), directions, 1),
        farthestByBruteForce(cloud, hull, directions))
        << name << ", " << cloud.size();
    }
  }
}

TEST(Support, TheLowestOfAFlatFace)
{
  Random random(4);
  // The lowest id of a facet need not be next to the others, once ids are shuffled.
  for (int attempt = 0; attempt < effort(20); ++attempt)
  {
    Cloud cloud = joined(prism(12, 0, random), cubeSurfaceGrid(2));
    random.shuffle(cloud);
    const Cloud up = { { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { 0, -5, 0 }, { 0, 0, 0 } };
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      const Hull hull = hullOf(cloud, facets);
      EXPECT_EQ(
        farthestOf(HullQueries(viewOf(cloud), hull), up, 1), farthestByBruteForce(cloud, hull, up));
    }
  }
}

TEST(Support, CornersOfManyEdges)
{
  // Half of all directions end at an apex of so many edges that each look at them would be long.
  const Cloud cloud = bipyramid(effort(20000));
  const Hull hull = hullOf(cloud, FacetMode::Triangles);
  Random random(5);
  Cloud directions;
  for (int i = 0; i < 100000; ++i)
  {
    directions.push_back(random.direction());
  }
  const HullQueries queries(viewOf(cloud), hull);
  const std::vector<std::int64_t> one = farthestOf(queries, directions, 1);
  EXPECT_EQ(farthestOf(queries, directions, 4), one);
  const Cloud some(directions.begin(), directions.begin() + 20);
  EXPECT_EQ(farthestOf(queries, some, 1), farthestByBruteForce(cloud, hull, some));
}

TEST(Support, LargeHulls)
{
  for (const char* name : { "shell0", "ball", "helix", "planeXyz0" })
  {
    const Cloud cloud = fromFamily(name, effort(4000), 6).make();
    const Hull hull = hullOf(cloud, FacetMode::Triangles);
    const Cloud directions = directionsFor(cloud, 22, effort(400));
    EXPECT_EQ(farthestOf(HullQueries(viewOf(cloud), hull), directions, 1),
      farthestByBruteForce(cloud, hull, directions))
      << name;
  }
}

}
}
}
