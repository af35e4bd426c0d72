// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Very many small clouds, each a function of its seed, and every kind of query about their hulls.
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Query/QueryCases.h"
#include <flipflop/HullQueries.h>
#include <flipflop/Neighbors.h>

namespace flipflop
{
namespace test
{

namespace
{

double anyScale(Random& random)
{
  return std::ldexp(1.0, random.integer(-1050, 1000));
}

Cloud anyCloud(Random& random)
{
  Cloud cloud;
  switch (random.integer(0, 5))
  {
    case 0:
      return withUlps(0x1p-52, random.integer(1, 4), random);
    case 1:
      return rotated(integerGrid(random.integer(1, 4)));
    case 2:
      return scaled(
        integerGrid(random.integer(2, 3)), anyScale(random), anyScale(random), anyScale(random));
    case 3: // any numbers beside each other
      for (int i = random.integer(1, 30); i > 0; --i)
      {
        Point p = random.direction();
        for (double& x : p)
        {
          x *= random.integer(0, 1) ? anyScale(random) : 1.0;
        }
        cloud.push_back(p);
      }
      return cloud;
    case 4:
      for (int i = random.integer(1, 30), most = random.integer(1, 4); i > 0; --i)
      {
        Point p;
        for (double& x : p)
        {
          x = random.integer(-most, most);
        }
        cloud.push_back(p);
      }
      return cloud;
    default:
      for (int i = random.integer(4, 60); i > 0; --i)
      {
        cloud.push_back(random.direction());
      }
      return cloud;
  }
}

Cloud anyDirections(Random& random)
{
  Cloud directions;
  for (int i = 0; i < 30; ++i)
  {
    Point p = random.direction();
    const int kind = random.integer(0, 2);
    for (double& x : p)
    {
      x = kind == 0 ? x : kind == 1 ? random.integer(-1, 1) : x * anyScale(random);
    }
    directions.push_back(p);
  }
  return directions;
}

TEST(QueryRandom, EveryAnswer)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", effort(400));
  for (std::int64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Cloud cloud = anyCloud(random);
    const Cloud queries = queriesAbout(cloud, static_cast<std::uint64_t>(seed), 60);
    const Cloud directions = anyDirections(random);
    const Hull polygons = hullOf(cloud, FacetMode::Polygons);
    const Hull hull = hullOf(cloud, seed % 2 ? FacetMode::Polygons : FacetMode::Triangles);
    const Options options = onThreads(1);
    const HullQueries asked(viewOf(cloud), hull, options);

    const std::vector<std::int8_t> wanted = sidesByBruteForce(cloud, polygons, queries);
    std::vector<std::int8_t> sides(queries.size(), 99);
    asked.contains(viewOf(queries), sides.data(), options);
    EXPECT_EQ(sides, wanted) << "seed " << seed;

    std::vector<double> distances(queries.size(), 99);
    asked.distance(viewOf(queries), distances.data(), options);
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      EXPECT_TRUE(wanted[i] > 0 ? distances[i] < 0
          : wanted[i] < 0       ? distances[i] > 0
                                : distances[i] == 0)
        << "seed " << seed << ": " << distances[i];
    }

    std::vector<std::int64_t> ids(directions.size(), -2);
    asked.support(viewOf(directions), ids.data(), options);
    EXPECT_EQ(ids, farthestByBruteForce(cloud, hull, directions)) << "seed " << seed;

    const FarthestIds pair = farthestPairByBruteForce(cloud, hull);
    const Diameter diameter = asked.diameter(options);
    EXPECT_EQ(diameter.first, pair.first) << "seed " << seed;
    EXPECT_EQ(diameter.second, pair.second) << "seed " << seed;

    if (seed % 8 == 0)
    {
      const OrientedBox box = asked.minimalBox(options);
      EXPECT_LE(box.lowerBound, box.volume) << "seed " << seed;
    }
  }
}

}
}
}
