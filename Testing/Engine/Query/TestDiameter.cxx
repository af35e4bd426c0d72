// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The farthest pair is the one that exact integers find among all pairs.
#include "Testing/Engine/Query/QueryCases.h"
#include <flipflop/HullQueries.h>

namespace flipflop
{
namespace test
{

namespace
{

void expectDiameter(const std::string& name, const Cloud& cloud)
{
  const Hull hull = hullOf(cloud, FacetMode::Polygons);
  const FarthestIds wanted = farthestPairByBruteForce(cloud, hull);
  const HullQueries queries(viewOf(cloud), hull);
  for (const int threads : { 1, 2, 4 })
  {
    const Diameter found = queries.diameter(onThreads(threads));
    EXPECT_EQ(found.first, wanted.first) << name;
    EXPECT_EQ(found.second, wanted.second) << name;
    mpf_class length(wanted.square, 4000);
    length = sqrt(length);
    const int exponent = commonScale(cloud).exponent;
    exponent < 0 ? mpf_div_2exp(length.get_mpf_t(), length.get_mpf_t(), -exponent)
                 : mpf_mul_2exp(length.get_mpf_t(), length.get_mpf_t(), exponent);
    if (length > mpf_class(std::numeric_limits<double>::max(), 64))
    {
      EXPECT_EQ(found.length, std::numeric_limits<double>::infinity()) << name;
    }
    else
    {
      const double exact = length.get_d();
      EXPECT_NEAR(found.length, exact, std::max(1e-15 * exact, 5e-324)) << name;
    }
  }
}

TEST(Diameter, AgreesWithAllPairsEverywhere)
{
  for (const auto& [name, cloud] : queryClouds())
  {
    expectDiameter(name, cloud);
  }
}

TEST(Diameter, OfManyPairsThatAreAsLong)
{
  Random random(7);
  expectDiameter("cospherical", cosphericalIntegers(101));
  expectDiameter("rotated", rotated(cosphericalIntegers(101)));
  expectDiameter("prism", prism(effort(300), 0, random));
  for (const char* name : { "shell0", "helix", "ball" })
  {
    expectDiameter(name, fromFamily(name, effort(900), 8).make());
  }
  // Two balls of nearly equal distances, far from each other.
  const Cloud ball = fromFamily("shell0", 60, 9).make();
  expectDiameter("pair", joined(scaled(ball, 1e-12, 1e-12, 1e-12), { { 1, 2, 3 } }));
  expectDiameter("pairs",
    joined(scaled(ball, 1e-18, 1e-18, 1e-18), moved(scaled(ball, 1e-14, 1e-14, 1e-14), 1, 0, 0)));
}

TEST(Diameter, OfNothingAndOfOnePoint)
{
  const Diameter none = HullQueries(PointView(), Hull()).diameter();
  EXPECT_EQ(none.first, -1);
  EXPECT_EQ(none.second, -1);
  EXPECT_EQ(none.length, 0);
  const Cloud one = { { 1, 2, 3 } };
  const Diameter point = HullQueries(viewOf(one), hullOf(one, FacetMode::Polygons)).diameter();
  EXPECT_EQ(point.first, 0);
  EXPECT_EQ(point.second, 0);
  EXPECT_EQ(point.length, 0);
}

TEST(Diameter, OfALargeSphere)
{
  const Cloud cloud = fromFamily("shell0", effort(100000), 10).make();
  const Hull hull = hullOf(cloud, FacetMode::Triangles);
  const HullQueries queries(viewOf(cloud), hull);
  const Diameter one = queries.diameter(onThreads(1));
  const Diameter four = queries.diameter(onThreads(4));
  EXPECT_EQ(one.first, four.first);
  EXPECT_EQ(one.second, four.second);
  EXPECT_EQ(one.length, four.length);
}

}
}
}
