// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small random inputs in bulk, nearly all of them degenerate, against the brute force.
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

using IntegerPoint = std::array<std::int64_t, 3>;

/// n points with integer coordinates low to high.
ReferenceHull integers(int low, int high, int most, Random& random, Cloud& cloud)
{
  std::vector<IntegerPoint> points;
  for (int n = random.integer(1, most); n > 0; --n)
  {
    const int x = random.integer(low, high);
    const int y = random.integer(low, high);
    const int z = random.integer(low, high);
    points.push_back({ x, y, z });
    cloud.push_back({ double(x), double(y), double(z) });
  }
  return bruteForceHull(points);
}

TEST(ConvexHullRandom, IntegersTo2)
{
  runRandomCases(
    convexHulls, 80000, [](Random& r, Cloud& cloud) { return integers(0, 2, 12, r, cloud); });
}

TEST(ConvexHullRandom, IntegersTo3)
{
  runRandomCases(
    convexHulls, 60000, [](Random& r, Cloud& cloud) { return integers(0, 3, 12, r, cloud); });
}

TEST(ConvexHullRandom, IntegersAroundZero)
{
  runRandomCases(
    convexHulls, 60000, [](Random& r, Cloud& cloud) { return integers(-1, 1, 10, r, cloud); });
}

TEST(ConvexHullRandom, IntegersInASlab)
{
  // Many coplanar points, few heights.
  runRandomCases(convexHulls, 30000,
    [](Random& r, Cloud& cloud)
    {
      std::vector<IntegerPoint> points;
      for (int n = r.integer(1, 16); n > 0; --n)
      {
        const int x = r.integer(-4, 4);
        const int y = r.integer(-4, 4);
        const int z = r.integer(0, 5) / 5;
        points.push_back({ x, y, z });
        cloud.push_back({ double(x), double(y), double(z) });
      }
      return bruteForceHull(points);
    });
}

TEST(ConvexHullRandom, IntegersMany)
{
  runRandomCases(
    convexHulls, 3000, [](Random& r, Cloud& cloud) { return integers(0, 4, 40, r, cloud); });
}

TEST(ConvexHullRandom, FloatUlps)
{
  runCasesOfUlps(convexHulls, 40000, 0x1p-23, 4);
}

TEST(ConvexHullRandom, DoubleUlps)
{
  runCasesOfUlps(convexHulls, 6000, 0x1p-52, 4);
}

TEST(ConvexHullRandom, DoubleUlpsFew)
{
  runCasesOfUlps(convexHulls, 6000, 0x1p-52, 12);
}

TEST(ConvexHullRandom, CollinearTriples)
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

TEST(ConvexHullRandom, MixedScales)
{
  // Every coordinate is 0 or a power of two, from the least to the greatest.
  runRandomCases(convexHulls, 4000,
    [](Random& r, Cloud& cloud)
    {
      static const double sizes[] = { 0, 0x1p-1074, 0x1p-1000, 0x1p-300, 0x1p-60, 1, 0x1p60,
        0x1p300, 0x1p1000, 0x1p1023 };
      for (int n = r.integer(1, 9); n > 0; --n)
      {
        Point p;
        for (double& x : p)
        {
          x = sizes[r.integer(0, 9)] * (r.integer(0, 1) ? 1 : -1);
        }
        cloud.push_back(p);
      }
      return bruteForceHull(cloud);
    });
}

TEST(ConvexHullRandom, FarLattice)
{
  // So far from the origin that every double is a lattice point, a rounded centroid too: points
  // lie on borders between cones, duplicates on either side.
  runRandomCases(convexHulls, 20000,
    [](Random& r, Cloud& cloud)
    {
      std::vector<IntegerPoint> points;
      const int range = r.integer(1, 4);
      for (int n = r.integer(1, 24); n > 0; --n)
      {
        IntegerPoint p;
        for (auto& x : p)
        {
          x = r.integer(-range, range);
        }
        points.push_back(p);
        cloud.push_back({ double(p[0]), double(p[1]), double(p[2]) });
      }
      cloud = moved(scaled(std::move(cloud), 0.5, 0.5, 0.5), 0x1p51, 0x1p51, -0x1p51);
      return bruteForceHull(points);
    });
}

TEST(ConvexHullRandom, FarLatticeMany)
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

TEST(ConvexHullRandom, Lines)
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

}
}
}
