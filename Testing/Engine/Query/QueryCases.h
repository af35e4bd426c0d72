// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Clouds of every kind that queries meet, points to ask about, and the answers by brute force in
/// integers of any size.
#ifndef flipflop_test_QueryCases_h
#define flipflop_test_QueryCases_h

#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/References/Exact.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

/// Families of points, of each dimension and range.
inline std::vector<std::pair<std::string, Cloud>> queryClouds()
{
  std::vector<std::pair<std::string, Cloud>> clouds;
  for (const char* name :
    { "ball", "shell0", "gaussian", "helix", "smallIntegers", "thin12", "thin200", "needle",
      "far15", "skewPlane", "parallelPlanes", "collinearAlmost", "planeXyz0" })
  {
    for (const int count : { 12, 80 })
    {
      clouds.emplace_back(name, fromFamily(name, count, 7).make());
    }
  }
  Random random(3);
  clouds.emplace_back("grid", integerGrid(3));
  clouds.emplace_back("rotated grid", rotated(integerGrid(3)));
  clouds.emplace_back("cospherical", cosphericalIntegers(29));
  clouds.emplace_back("prism", prism(9, 2, random));
  clouds.emplace_back("bipyramid", bipyramid(20));
  clouds.emplace_back("huge", scaled(fromFamily("ball", 60, 8).make(), 1e300, 1e300, 1e300));
  clouds.emplace_back("tiny", scaled(fromFamily("ball", 60, 9).make(), 1e-300, 1e-300, 1e-300));
  clouds.emplace_back("mixed", scaled(fromFamily("ball", 60, 10).make(), 1e300, 1, 1e-300));
  clouds.emplace_back("largest", scaled(integerGrid(2), 1.7e308, 1.7e308, 1.7e308));
  clouds.emplace_back("denormal", scaled(integerGrid(3), 5e-324, 5e-324, 5e-324));
  clouds.emplace_back("one point", Cloud{ { 1, 2, 3 }, { 1, 2, 3 } });
  clouds.emplace_back("segment", Cloud{ { 0, 0, 0 }, { 3, 6, 9 }, { 1, 2, 3 } });
  clouds.emplace_back("skew segment", Cloud{ { 0.1, 0.2, 0.3 }, { 1e9, 1.7, -4e-9 } });
  clouds.emplace_back("triangle", Cloud{ { 0, 0, 1 }, { 3, 0, 1 }, { 0, 3, 1 }, { 1, 1, 1 } });
  clouds.emplace_back("tetrahedron", latticeTetrahedron(3));
  return clouds;
}

/// Hulls of the largest numbers and the smallest, of one unit of the last place, and thin ones of
/// all three.
inline std::vector<std::pair<std::string, Cloud>> extremeClouds()
{
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const double ulp = std::numeric_limits<double>::epsilon();
  std::vector<std::pair<std::string, Cloud>> clouds;
  clouds.emplace_back("the origin", Cloud{ { 0, 0, 0 } });
  clouds.emplace_back("a far point", Cloud{ { 1e200, 0, 0 } });
  clouds.emplace_back(
    "largest cube", scaled(moved(integerGrid(2), -0.5, -0.5, -0.5), most, most, most));
  clouds.emplace_back("largest box", scaled(integerGrid(2), 2, 2, 2));
  for (Point& p : clouds.back().second)
  {
    p = { p[0] > 0 ? most : -most, p[1] > 0 ? most : -most, p[2] > 0 ? most : -most };
  }
  clouds.emplace_back(
    "triangle at the largest", Cloud{ { 0, 0, 0 }, { -1e308, 0, 0 }, { 0, -1e308, 0 } });
  clouds.emplace_back("tetrahedron at the largest",
    Cloud{ { 0, 0, 0 }, { 1e308, 0, 0 }, { 0, -1e308, 0 }, { 0, 0, 1e308 } });
  clouds.emplace_back("nearly flat at the largest",
    Cloud{ { most, 0, 0 }, { most / 2, -most, -most }, { 0, least, least }, { -most, 0, 0 } });
  clouds.emplace_back("a needle at the largest",
    Cloud{ { most, 0, 0 }, { -most, least, 0 }, { 0, 1, 0 }, { 1, 0, 1e-300 } });
  clouds.emplace_back("one unit and a denormal",
    Cloud{ { 1, 0, 0 }, { 1 + ulp, 0, 0 }, { 1, 0, least }, { 1, ulp, 0 } });
  clouds.emplace_back("one unit beside the largest",
    Cloud{ { most, most, 0 }, { std::nextafter(most, 0), most, 0 },
      { most, std::nextafter(most, 0), 0 }, { most, most, least } });
  clouds.emplace_back("one unit far away", moved(scaled(integerGrid(2), ulp, ulp, ulp), 1, 1, 1));
  clouds.emplace_back(
    "a denormal segment beside the largest", Cloud{ { most, 0, 0 }, { most, 0, least } });
  clouds.emplace_back("denormal cube", scaled(integerGrid(2), least, least, least));
  clouds.emplace_back("a thin triangle", Cloud{ { 0, 0, 0 }, { 1, 1e-200, 0 }, { 2, 0, 1e-250 } });
  clouds.emplace_back("a thin tetrahedron",
    Cloud{ { 0, 0, 0 }, { 1, 1e-200, 0 }, { 2, 0, 1e-250 }, { 1, -1e-290, 1e-100 } });
  return clouds;
}

inline std::vector<std::pair<std::string, Cloud>> joined(
  std::vector<std::pair<std::string, Cloud>> a, const std::vector<std::pair<std::string, Cloud>>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Points on the hull and near it: corners, points between two, three and four of them, and what is
/// some units of the last place beside these; others about the box, and far away.
inline Cloud queriesAbout(const Cloud& cloud, std::uint64_t seed, int count)
{
  Random random(seed);
  const auto pick = [&]() -> const Point& {
    return cloud[static_cast<std::size_t>(random.integer(0, static_cast<int>(cloud.size()) - 1))];
  };
  Point low = cloud[0];
  Point high = cloud[0];
  for (const Point& p : cloud)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  Cloud queries = { { 0, 0, 0 }, low, high };
  while (static_cast<int>(queries.size()) < count)
  {
    const int kind = random.integer(0, 7);
    Point q = pick();
    if (kind < 4)
    {
      const Point a = pick(), b = pick(), c = pick();
      for (std::size_t i = 0; i < 3; ++i)
      {
        const double q4[4] = { q[i], 0.5 * q[i] + 0.5 * a[i],
          0.25 * q[i] + 0.25 * a[i] + 0.5 * b[i],
          0.25 * q[i] + 0.25 * a[i] + 0.25 * b[i] + 0.25 * c[i] };
        q[i] = q4[kind];
      }
    }
    else
    {
      const double wider = kind == 4 ? 0.5 : 0.0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const double share = random.uniform(-wider, 1 + wider);
        q[i] = (1 - share) * low[i] + share * high[i];
        q[i] = kind == 7 && random.integer(0, 3) == 0 ? random.uniform(-1e300, 1e300) : q[i];
      }
    }
    if (random.integer(0, 3) == 0)
    {
      double& x = q[static_cast<std::size_t>(random.integer(0, 2))];
      x = std::nextafter(x, random.integer(0, 1) ? 1e308 : -1e308);
    }
    if (random.integer(0, 9) == 0)
    {
      double& x = q[static_cast<std::size_t>(random.integer(0, 2))];
      x += random.integer(0, 1) ? 1e-200 : -5e-324;
    }
    if (std::isfinite(q[0]) && std::isfinite(q[1]) && std::isfinite(q[2]))
    {
      queries.push_back(q);
    }
  }
  return queries;
}

/// The same, and points of any magnitude, up to the largest, along each axis from corners.
inline Cloud extremeQueries(const Cloud& cloud, std::uint64_t seed, int count)
{
  const double most = std::numeric_limits<double>::max();
  Cloud queries = queriesAbout(cloud, seed, count);
  Random random(seed + 1);
  for (int i = 0; i < count; ++i)
  {
    Point q =
      cloud[static_cast<std::size_t>(random.integer(0, static_cast<int>(cloud.size()) - 1))];
    for (double& x : q)
    {
      const double size = std::ldexp(1 + random.uniform(0, 1), random.integer(-1074, 1022));
      const double given[] = { x, size, -size, x + size, x - size, most, -most, 0, 0.5 * x };
      const double chosen = given[random.integer(0, 8)];
      x = std::isfinite(chosen) ? chosen : x;
    }
    queries.push_back(q);
  }
  return queries;
}

/// Integer points: those of a cloud, then others.
inline std::vector<IntegerSpace<mpz_class>::Vector> integersOf(const Cloud& cloud)
{
  const int exponent = commonScale(cloud).exponent;
  std::vector<IntegerSpace<mpz_class>::Vector> result;
  for (const Point& p : cloud)
  {
    result.push_back(
      { toInteger(p[0], exponent), toInteger(p[1], exponent), toInteger(p[2], exponent) });
  }
  return result;
}

/// The side of each query, by every facet of a hull in polygons.
inline std::vector<std::int8_t> sidesByBruteForce(
  const Cloud& cloud, const Hull& hull, const Cloud& queries)
{
  const IntegerSpace<mpz_class> space(integersOf(joined(cloud, queries)));
  const std::vector<Cell> cells = cellsOf(hull);
  const auto at = [](std::int64_t id) { return static_cast<int>(id); };
  std::vector<std::int8_t> sides;
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    const int p = static_cast<int>(cloud.size() + i);
    int side = hull.dimension == 3 ? 1 : 0;
    for (const Cell& cell : cells)
    {
      const int a = at(cell[0]);
      const int b = at(cell[cell.size() / 2]);
      if (hull.dimension == 3)
      {
        side = std::min(side, -space.orient(a, at(cell[1]), at(cell[2]), p));
        continue;
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        // In the box of the corners, and on their line.
        const int low = space.compare(axis, a, p);
        const int high = space.compare(axis, b, p);
        const bool outside =
          hull.dimension < 2 && ((low != 0 && low == high) || space.normal(axis, a, b, p) != 0);
        side = outside ? -1 : side;
        // On the left of every side of the polygon.
        const int turn = hull.dimension == 2 ? space.normal(axis, a, at(cell[1]), at(cell[2])) : 0;
        for (std::size_t k = 0; k < cell.size() && turn != 0; ++k)
        {
          const int left =
            space.normal(axis, at(cell[k]), at(cell[(k + 1) % cell.size()]), p) * turn;
          side = left < 0 ? -1 : side;
        }
      }
      if (hull.dimension == 2 && space.orient(a, at(cell[1]), at(cell[2]), p) != 0)
      {
        side = -1;
      }
    }
    sides.push_back(static_cast<std::int8_t>(side));
  }
  return sides;
}

using Integers = IntegerSpace<mpz_class>::Vector;

inline mpz_class dot(const Integers& a, const Integers& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The farthest vertex in each direction, the lowest of several.
inline std::vector<std::int64_t> farthestByBruteForce(
  const Cloud& cloud, const Hull& hull, const Cloud& directions)
{
  const std::vector<Integers> points = integersOf(cloud);
  std::vector<std::int64_t> result;
  for (const Point& d : directions)
  {
    const Integers vector = integersOf({ d })[0];
    std::int64_t best = hull.pointIds[0];
    mpz_class most = dot(points[static_cast<std::size_t>(best)], vector);
    for (const std::int64_t id : hull.pointIds)
    {
      const mpz_class along = dot(points[static_cast<std::size_t>(id)], vector);
      if (along > most)
      {
        most = along;
        best = id;
      }
    }
    result.push_back(best);
  }
  return result;
}

/// Of all farthest pairs the first.
struct FarthestIds
{
  std::int64_t first = -1;
  std::int64_t second = -1;
  mpz_class square = -1;
};

inline FarthestIds farthestPairByBruteForce(const Cloud& cloud, const Hull& hull)
{
  const auto points = integersOf(cloud);
  FarthestIds wanted;
  for (std::size_t i = 0; i < hull.pointIds.size(); ++i)
  {
    for (std::size_t j = hull.pointIds.size() > 1 ? i + 1 : i; j < hull.pointIds.size(); ++j)
    {
      const auto& a = points[static_cast<std::size_t>(hull.pointIds[i])];
      const auto& b = points[static_cast<std::size_t>(hull.pointIds[j])];
      mpz_class square = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        square += (a[k] - b[k]) * (a[k] - b[k]);
      }
      if (square > wanted.square)
      {
        wanted = { hull.pointIds[i], hull.pointIds[j], square };
      }
    }
  }
  return wanted;
}

/// The hull in polygons or triangles.
inline Hull hullOf(const Cloud& cloud, FacetMode facets)
{
  Options options;
  options.facets = facets;
  return convexHull(viewOf(cloud), options);
}

inline Options onThreads(int threads)
{
  Options options;
  options.threads = threads;
  return options;
}

}
}

#endif
