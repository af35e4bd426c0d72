// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small random inputs in bulk, nearly all of them degenerate, against the brute force; larger
/// ones against CGAL.
///
/// FLIPFLOP_TEST_SEED starts the cases elsewhere, FLIPFLOP_TEST_CASES makes more of them.
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

using IntegerPoint = std::array<std::int64_t, 3>;

/// The brute force's result of integers.
ReferenceHull bruteForceOfIntegers(const Kind& kind, const Cloud& cloud)
{
  std::vector<IntegerPoint> points;
  for (const Point& p : cloud)
  {
    points.push_back({ static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1]),
      static_cast<std::int64_t>(p[2]) });
  }
  return kind.dimension == 3 ? bruteForceHull(points) : bruteForceTriangulation(points);
}

/// Points with integer coordinates: x and y from low to high; z, or the weight, from lowest to
/// highest.
struct Integers
{
  const char* name;
  const Kind* kind;
  int cases;
  int most; ///< points
  int low, high;
  int lowest, highest;
  /// So far from the origin that every double is a lattice point, a rounded centroid too: points
  /// lie on borders between cones, duplicates on either side.
  bool isFar;

  friend void PrintTo(const Integers& of, std::ostream* out) { *out << of.name; }
};

class RandomIntegers : public ::testing::TestWithParam<Integers>
{
};

TEST_P(RandomIntegers, AreTheBruteForces)
{
  const Integers& of = this->GetParam();
  runRandomCases(*of.kind, of.cases,
    [&](Random& r, Cloud& cloud)
    {
      const int count = r.integer(1, of.most);
      cloud = smallIntegerSites(count, of.low, of.high, of.lowest, of.highest, r);
      const ReferenceHull wanted = bruteForceOfIntegers(*of.kind, cloud);
      if (of.isFar && of.kind->dimension == 3)
      {
        cloud = moved(scaled(std::move(cloud), 0.5, 0.5, 0.5), 0x1p51, 0x1p51, -0x1p51);
      }
      else if (of.isFar)
      {
        cloud = moved(scaled(std::move(cloud), 0.5, 0.5, 0.25), 0x1p51, -0x1p51, 0);
      }
      return wanted;
    });
}

INSTANTIATE_TEST_SUITE_P(Random, RandomIntegers,
  ::testing::Values(Integers{ "HullsTo2", &convexHulls, 80000, 12, 0, 2, 0, 2, false },
    Integers{ "HullsTo3", &convexHulls, 60000, 12, 0, 3, 0, 3, false },
    Integers{ "HullsAroundZero", &convexHulls, 60000, 10, -1, 1, -1, 1, false },
    Integers{ "HullsInASlab", &convexHulls, 30000, 16, -4, 4, 0, 1, false },
    Integers{ "HullsOfMany", &convexHulls, 3000, 40, 0, 4, 0, 4, false },
    Integers{ "HullsFar", &convexHulls, 20000, 24, -2, 2, -2, 2, true },
    Integers{ "To2", &regularTriangulations, 60000, 10, 0, 2, -1, 1, false },
    Integers{ "To4", &regularTriangulations, 60000, 12, 0, 4, -3, 3, false },
    Integers{ "WithoutWeights", &regularTriangulations, 40000, 14, 0, 3, 0, 0, false },
    Integers{ "WithGreatWeights", &regularTriangulations, 20000, 14, 0, 5, -40, 40, false },
    Integers{ "Many", &regularTriangulations, 3000, 40, 0, 7, -4, 4, false },
    Integers{ "Far", &regularTriangulations, 20000, 16, 0, 4, -3, 3, true }),
  [](const auto& given) { return given.param.name; });

TEST(Random, Ulps)
{
  runCasesOfUlps(convexHulls, 40000, 0x1p-23, 4);
  runCasesOfUlps(regularTriangulations, 10000, 0x1p-23, 4);
  for (const int odds : { 4, 12 })
  {
    runCasesOfUlps(convexHulls, 6000, 0x1p-52, odds);
    runCasesOfUlps(regularTriangulations, 4000, 0x1p-52, odds);
  }
}

/// Every number is 0 or a power of two, from the least to the greatest.
void runMixedScales(const Kind& kind, int cases)
{
  runRandomCases(kind, cases,
    [&](Random& r, Cloud& cloud)
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
      return kind.bruteForce(cloud);
    });
}

TEST(Random, MixedScales)
{
  runMixedScales(convexHulls, 4000);
  runMixedScales(regularTriangulations, 800);
}

TEST(Random, CollinearTriples)
{
  // Midpoints and extrapolations of points already there: exact lines in every direction.
  runRandomCases(convexHulls, 30000,
    [](Random& r, Cloud& cloud)
    {
      std::vector<IntegerPoint> points;
      const int n = r.integer(1, 12);
      for (int i = 0; i < n; ++i)
      {
        IntegerPoint p;
        for (auto& x : p)
        {
          x = r.integer(-20, 20);
        }
        if (i >= 2 && r.integer(0, 2) != 0)
        {
          const IntegerPoint& a = points[r.integer(0, i - 1)];
          const IntegerPoint& b = points[r.integer(0, i - 1)];
          const int t = r.integer(-1, 2);
          for (int c = 0; c < 3; ++c)
          {
            p[c] = a[c] + t * (b[c] - a[c]);
          }
        }
        points.push_back(p);
        cloud.push_back({ double(p[0]), double(p[1]), double(p[2]) });
      }
      return bruteForceHull(points);
    });
}

TEST(Random, FarHullsOfMany)
{
  // The same with enough points for duplicates to be grown apart.
  runRandomCases(convexHulls, 400,
    [](Random& r, Cloud& cloud)
    {
      for (int n = r.integer(100, 600); n > 0; --n)
      {
        const Point u = r.direction();
        const double length = r.uniform(0, 2);
        cloud.push_back({ std::nearbyint(2 * length * u[0]) / 2,
          std::nearbyint(2 * length * u[1]) / 2, std::nearbyint(2 * length * u[2]) / 2 });
      }
      cloud = moved(std::move(cloud), 0x1p51, 0x1p51, -0x1p51);
      return cgalHull(cloud, CgalKernel::Inexact);
    });
}

TEST(Random, LinesInSpace)
{
  // One point, or points of one line: dimension 0 and 1 above all.
  runRandomCases(convexHulls, 10000,
    [](Random& r, Cloud& cloud)
    {
      Point u;
      for (double& x : u)
      {
        x = r.integer(-3, 3);
      }
      const int range = r.integer(0, 3);
      for (int n = r.integer(1, 9); n > 0; --n)
      {
        const int t = r.integer(-range, range);
        cloud.push_back({ t * u[0] + 1, t * u[1] - 1, t * u[2] });
      }
      if (r.integer(0, 2) == 0)
      {
        cloud.push_back({ double(r.integer(-1, 1)), double(r.integer(-1, 1)), 1 });
        cloud.push_back({ double(r.integer(-1, 1)), double(r.integer(-1, 1)), -1 });
      }
      return bruteForceHull(cloud);
    });
}

TEST(Random, FewLifts)
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

TEST(Random, ScaledIntegers)
{
  // Ties among numbers whose squares, or whose weights, leave the range of doubles.
  runRandomCases(regularTriangulations, 4000,
    [](Random& r, Cloud& cloud)
    {
      cloud = smallIntegerSites(r.integer(1, 12), 0, 4, -3, 3, r);
      const ReferenceHull wanted = bruteForceOfIntegers(regularTriangulations, cloud);
      static const int powers[] = { -536, -300, -40, 40, 300, 508 };
      const int power = powers[r.integer(0, 5)];
      cloud = scaled(std::move(cloud), std::ldexp(1.0, power), std::ldexp(1.0, power),
        std::ldexp(1.0, 2 * power));
      return wanted;
    });
}

TEST(Random, LinesOfThePlane)
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

TEST(Random, LinesOfManyPoints)
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

TEST(Random, ManyIntegers)
{
  runCasesByCgal(regularTriangulations, 150,
    [](Random& r, Cloud& cloud)
    {
      const int side = r.integer(3, 60);
      const int weight = r.integer(0, 1) ? r.integer(0, 3) : r.integer(0, side * side);
      cloud = smallIntegerSites(r.integer(100, 3000), -side, side, -weight, weight, r);
    });
}

TEST(Random, ManyDuplicates)
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

TEST(Random, ManyOnALineButFew)
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

TEST(Random, ManyOfMixedScales)
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

TEST(Random, ManyOfAnyWeight)
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

TEST(Random, ManyOfFewLifts)
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

TEST(Random, ManyInRings)
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
