// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small random inputs in bulk, nearly all of them degenerate, against the brute force; larger
/// ones against CGAL.
///
/// FLIPFLOP_TEST_SEED starts the cases elsewhere, FLIPFLOP_TEST_CASES makes more of them.
#include "Testing/Engine/Conformance/RandomCases.h"

#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

/// n points with integer coordinates 0 to @p side and weights up to @p weight either way.
ReferenceTriangulation integers(int side, int weight, int most, Random& random, Cloud& cloud)
{
  const int count = random.integer(1, most);
  cloud = smallIntegerSites(count, 0, side, -weight, weight, random);
  std::vector<std::array<std::int64_t, 3>> sites;
  for (const Point& p : cloud)
  {
    sites.push_back({ static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1]),
      static_cast<std::int64_t>(p[2]) });
  }
  return bruteForceTriangulation(sites);
}

TEST(RegularTriangulationRandom, IntegersTo2)
{
  runRandomCases(regularTriangulations, 60000,
    [](Random& r, Cloud& cloud) { return integers(2, 1, 10, r, cloud); });
}

TEST(RegularTriangulationRandom, IntegersTo4)
{
  runRandomCases(regularTriangulations, 60000,
    [](Random& r, Cloud& cloud) { return integers(4, 3, 12, r, cloud); });
}

TEST(RegularTriangulationRandom, IntegersWithoutWeights)
{
  runRandomCases(regularTriangulations, 40000,
    [](Random& r, Cloud& cloud) { return integers(3, 0, 14, r, cloud); });
}

TEST(RegularTriangulationRandom, IntegersWithGreatWeights)
{
  runRandomCases(regularTriangulations, 20000,
    [](Random& r, Cloud& cloud) { return integers(5, 40, 14, r, cloud); });
}

TEST(RegularTriangulationRandom, IntegersMany)
{
  runRandomCases(regularTriangulations, 3000,
    [](Random& r, Cloud& cloud) { return integers(7, 4, 40, r, cloud); });
}

TEST(RegularTriangulationRandom, FewLifts)
{
  // The heights are chosen, not the weights: coplanar and collinear lifts of every kind.
  runRandomCases(regularTriangulations, 25000,
    [](Random& r, Cloud& cloud)
    {
      const int range = r.integer(1, 6);
      const int heights = r.integer(0, 3);
      const int a = r.integer(-2, 2);
      const int b = r.integer(-2, 2);
      for (int n = r.integer(1, 14); n > 0; --n)
      {
        const double x = r.integer(0, range);
        const double y = r.integer(0, range);
        cloud.push_back({ x, y, x * x + y * y - a * x - b * y - r.integer(0, heights) });
      }
      return bruteForceTriangulation(cloud);
    });
}

TEST(RegularTriangulationRandom, FloatUlps)
{
  runCasesOfUlps(regularTriangulations, 10000, 0x1p-23, 4);
}

TEST(RegularTriangulationRandom, DoubleUlps)
{
  runCasesOfUlps(regularTriangulations, 4000, 0x1p-52, 4);
}

TEST(RegularTriangulationRandom, DoubleUlpsFew)
{
  runCasesOfUlps(regularTriangulations, 4000, 0x1p-52, 12);
}

TEST(RegularTriangulationRandom, MixedScales)
{
  // Every number is 0 or a power of two, from the least to the greatest.
  runRandomCases(regularTriangulations, 800,
    [](Random& r, Cloud& cloud)
    {
      static const double sizes[] = { 0, 0x1p-1074, 0x1p-1000, 0x1p-537, 0x1p-300, 0x1p-60, 1,
        0x1p60, 0x1p300, 0x1p511, 0x1p1000, 0x1p1023 };
      for (int n = r.integer(1, 9); n > 0; --n)
      {
        Point p;
        for (double& x : p)
        {
          x = sizes[r.integer(0, 11)] * (r.integer(0, 1) ? 1 : -1);
        }
        cloud.push_back(p);
      }
      return bruteForceTriangulation(cloud);
    });
}

TEST(RegularTriangulationRandom, ScaledIntegers)
{
  // Ties among numbers whose squares, or whose weights, leave the range of doubles.
  runRandomCases(regularTriangulations, 4000,
    [](Random& r, Cloud& cloud)
    {
      const ReferenceTriangulation wanted = integers(4, 3, 12, r, cloud);
      static const int powers[] = { -536, -300, -40, 40, 300, 508 };
      const int power = powers[r.integer(0, 5)];
      cloud = scaled(std::move(cloud), std::ldexp(1.0, power), std::ldexp(1.0, power),
        std::ldexp(1.0, 2 * power));
      return wanted;
    });
}

TEST(RegularTriangulationRandom, FarLattice)
{
  // So far from the origin that every double is a lattice point.
  runRandomCases(regularTriangulations, 20000,
    [](Random& r, Cloud& cloud)
    {
      const ReferenceTriangulation wanted = integers(4, 3, 16, r, cloud);
      cloud = moved(scaled(std::move(cloud), 0.5, 0.5, 0.25), 0x1p51, -0x1p51, 0);
      return wanted;
    });
}

TEST(RegularTriangulationRandom, Lines)
{
  // One point, or points of one line: dimension 0 and 1 above all.
  runRandomCases(regularTriangulations, 20000,
    [](Random& r, Cloud& cloud)
    {
      const int u = r.integer(-3, 3);
      const int v = r.integer(-3, 3);
      const int range = r.integer(0, 4);
      const int weight = r.integer(0, 4);
      for (int n = r.integer(1, 9); n > 0; --n)
      {
        const int t = r.integer(-range, range);
        cloud.push_back({ double(t * u + 1), double(t * v - 1), double(r.integer(0, weight)) });
      }
      if (r.integer(0, 2) == 0)
      {
        cloud.push_back({ double(r.integer(-1, 1)), double(r.integer(-1, 1)), 1 });
      }
      return bruteForceTriangulation(cloud);
    });
}

TEST(RegularTriangulationRandom, LinesOfManyPoints)
{
  runRandomCases(regularTriangulations, 100,
    [](Random& r, Cloud& cloud)
    {
      const int count = r.integer(50, 5000);
      const int u = r.integer(-3, 3);
      const int weight = r.integer(0, 100);
      for (int i = 0; i < count; ++i)
      {
        const int t = r.integer(-count, count);
        cloud.push_back({ double(t * u), double(t), double(r.integer(0, weight)) });
      }
      return cgalTriangulation(cloud);
    });
}

// Many points: what small cases cannot reach.

TEST(RegularTriangulationRandom, ManyIntegers)
{
  runCasesByCgal(regularTriangulations, 150,
    [](Random& r, Cloud& cloud)
    {
      const int side = r.integer(3, 60);
      const int weight = r.integer(0, 1) ? r.integer(0, 3) : r.integer(0, side * side);
      cloud = smallIntegerSites(r.integer(100, 3000), -side, side, -weight, weight, r);
    });
}

TEST(RegularTriangulationRandom, ManyDuplicates)
{
  // So many that a sample has a place's later ids, and not its lowest.
  runCasesByCgal(regularTriangulations, 150,
    [](Random& r, Cloud& cloud)
    {
      const int side = r.integer(1, 5);
      const int weight = r.integer(0, 3) * r.integer(0, side * side);
      cloud = smallIntegerSites(r.integer(2000, 4000), -side, side, -weight, weight, r);
    });
}

TEST(RegularTriangulationRandom, ManyOnALineButFew)
{
  // A sample is likely on the line, or in one place.
  runCasesByCgal(regularTriangulations, 30,
    [](Random& r, Cloud& cloud)
    {
      const int count = r.integer(1500, 4000);
      const int range = r.integer(0, 2) * r.integer(1, count);
      const int weight = r.integer(0, 3) * r.integer(0, 50);
      const int u = r.integer(-2, 2);
      const int v = r.integer(1, 2);
      for (int i = 0; i < count; ++i)
      {
        const int t = r.integer(-range, range);
        cloud.push_back({ double(t * u), double(t * v), double(r.integer(0, weight)) });
      }
      for (int few = r.integer(0, 4); few > 0; --few)
      {
        Point& p = cloud[r.integer(0, count - 1)];
        p[0] += r.integer(-1, 1);
        p[1] += r.integer(-1, 1) * r.integer(1, 1 + range);
      }
    });
}

TEST(RegularTriangulationRandom, ManyOfMixedScales)
{
  // Few values of any size, so that there are ties and duplicates at all scales.
  runCasesByCgal(regularTriangulations, 4,
    [](Random& r, Cloud& cloud)
    {
      const int least = r.integer(0, 1) ? -1074 : -60;
      const int greatest = r.integer(0, 1) ? 1022 : 60;
      double values[40] = { 0 };
      for (double& x : values)
      {
        x = std::ldexp(r.integer(-4, 4), r.integer(least, greatest - 2));
      }
      const int count = r.integer(1000, 2600);
      for (int i = 0; i < count; ++i)
      {
        const double x = values[r.integer(0, 39)];
        const double y = values[r.integer(0, 39)];
        cloud.push_back({ x, y, values[r.integer(0, 39)] });
      }
    });
}

TEST(RegularTriangulationRandom, ManyOfAnyWeight)
{
  runCasesByCgal(regularTriangulations, 80,
    [](Random& r, Cloud& cloud)
    {
      const int count = r.integer(50, 4000);
      const double heaviest = std::ldexp(1.0, r.integer(-24, 2));
      for (int i = 0; i < count; ++i)
      {
        const double x = r.uniform();
        const double y = r.uniform();
        cloud.push_back({ x, y, r.uniform(-heaviest, heaviest) });
      }
    });
}

TEST(RegularTriangulationRandom, ManyOfFewLifts)
{
  // A tilted plane with a few points below it and many above.
  runCasesByCgal(regularTriangulations, 150,
    [](Random& r, Cloud& cloud)
    {
      const int count = r.integer(100, 4000);
      const int side = r.integer(10, 200);
      const int rare = r.integer(5, 500);
      for (int i = 0; i < count; ++i)
      {
        const double x = r.integer(-side, side);
        const double y = r.integer(-side, side);
        const int dice = r.integer(0, rare);
        const int off = dice == 0 ? r.integer(1, 3) : dice % 2 ? 0 : -r.integer(0, 2);
        cloud.push_back({ x, y, x * x + y * y - 3 * x + y + off });
      }
    });
}

TEST(RegularTriangulationRandom, ManyInRings)
{
  // Few circles, rounded or not, around few centres, with few weights.
  runCasesByCgal(regularTriangulations, 100,
    [](Random& r, Cloud& cloud)
    {
      const int count = r.integer(100, 3000);
      const double grid = r.integer(0, 1) ? 64 : 0x1p40;
      for (int i = 0; i < count; ++i)
      {
        const double angle = 6.283185307179586 * r.integer(0, 63) / 64;
        const double radius = r.integer(0, 3);
        const double x = 10 * r.integer(0, 2) + radius * std::cos(angle);
        const double y = 10 * r.integer(0, 2) + radius * std::sin(angle);
        cloud.push_back({ std::nearbyint(x * grid) / grid, std::nearbyint(y * grid) / grid,
          0.125 * r.integer(0, 1) });
      }
    });
}

}
}
}
