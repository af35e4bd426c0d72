// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Clouds of every kind that queries of hulls meet, and what to ask about them.
#ifndef flipflop_test_HullCases_h
#define flipflop_test_HullCases_h

#include "Testing/Engine/Inputs/Inputs.h"

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

using NamedCloud = std::pair<std::string, Cloud>;

/// Families of points, of each dimension and range.
inline std::vector<NamedCloud> queryClouds()
{
  std::vector<NamedCloud> clouds;
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
inline std::vector<NamedCloud> extremeClouds()
{
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const double ulp = std::numeric_limits<double>::epsilon();
  std::vector<NamedCloud> clouds;
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

/// Normals of facets, where doubles hold them, and what is near them; vectors along axes and
/// diagonals; of any length, in any range.
inline Cloud directionsFor(const Cloud& cloud, std::uint64_t seed, int count)
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

inline double anyScale(Random& random)
{
  return std::ldexp(1.0, random.integer(-1050, 1000));
}

/// A small cloud of any kind, and of numbers of any size.
inline Cloud anyCloud(Random& random)
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

}
}

#endif
