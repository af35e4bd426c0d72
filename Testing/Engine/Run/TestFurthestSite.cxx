// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Furthest-site triangulations, by all points and all circles, in rationals.
#include "Testing/Engine/Calls/Bits.h"
#include "Testing/Engine/Conformance/RandomCases.h"

#include <flipflop/FurthestSite.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

namespace
{

using Exact = std::array<mpq_class, 2>;

mpq_class turn(const Exact& a, const Exact& b, const Exact& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Positive: d is inside the circle of the counter-clockwise triangle abc.
mpq_class inCircle(const Exact& a, const Exact& b, const Exact& c, const Exact& d)
{
  mpq_class rows[3][3];
  const Exact* const corner[3] = { &a, &b, &c };
  for (int i = 0; i < 3; ++i)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      rows[i][k] = (*corner[i])[k] - d[k];
    }
    rows[i][2] = rows[i][0] * rows[i][0] + rows[i][1] * rows[i][1];
  }
  const auto minor = [&rows](int i, int j) -> mpq_class
  { return rows[i][0] * rows[j][1] - rows[i][1] * rows[j][0]; };
  return rows[0][2] * minor(1, 2) - rows[1][2] * minor(0, 2) + rows[2][2] * minor(0, 1);
}

std::vector<Exact> exactOf(const Cloud& cloud)
{
  std::vector<Exact> points;
  for (const auto& point : cloud)
  {
    points.push_back({ mpq_class(point[0]), mpq_class(point[1]) });
  }
  return points;
}

/// The corners of the convex hull, by gift wrapping; of one position the lowest id.
std::vector<std::int64_t> cornersOf(const std::vector<Exact>& points)
{
  std::map<Exact, std::int64_t> positions;
  for (std::size_t id = 0; id < points.size(); ++id)
  {
    positions.insert({ points[id], static_cast<std::int64_t>(id) });
  }
  std::vector<std::int64_t> ring;
  const auto first = positions.begin();
  auto at = first;
  do
  {
    ring.push_back(at->second);
    auto next = positions.end();
    for (auto it = positions.begin(); it != positions.end(); ++it)
    {
      if (it == at)
      {
        continue;
      }
      const int side = next == positions.end() ? -1 : sgn(turn(at->first, next->first, it->first));
      const auto isFurther = [&]
      {
        const Exact& a = at->first;
        const mpq_class x = it->first[0] - a[0], y = it->first[1] - a[1];
        const mpq_class u = next->first[0] - a[0], v = next->first[1] - a[1];
        return x * x + y * y > u * u + v * v;
      };
      if (side < 0 || (side == 0 && isFurther()))
      {
        next = it;
      }
    }
    at = next == positions.end() ? first : next;
  } while (at != first);
  return ring;
}

std::string faultOf(const Cloud& cloud)
{
  const std::vector<Exact> points = exactOf(cloud);
  const std::vector<std::int64_t> ring = cornersOf(points);
  Options options;
  const Triangulation found = furthestSiteTriangulation(viewOf(cloud), options);
  const std::set<std::int64_t> visible(found.pointIds.begin(), found.pointIds.end());
  if (visible != std::set<std::int64_t>(ring.begin(), ring.end()) ||
    visible.size() + found.hiddenIds.size() != cloud.size())
  {
    return "the vertices are not the corners of the hull";
  }
  if (ring.size() < 3)
  {
    const bool isRight =
      found.dimension == static_cast<int>(ring.size()) - 1 && found.cellCount() == 1;
    return isRight ? "" : "points of less than a plane";
  }
  mpq_class area, whole;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
  {
    const auto corner = [&](std::size_t k) { return points[static_cast<std::size_t>(ring[k])]; };
    whole += turn(corner(0), corner(i), corner(i + 1));
  }
  const auto corner = [&](const Triangulation& of, std::int64_t cell, std::int64_t i)
  {
    const std::int64_t at = of.connectivity[static_cast<std::size_t>(of.cellBegin(cell) + i)];
    return points[static_cast<std::size_t>(of.pointIds[static_cast<std::size_t>(at)])];
  };
  for (std::int64_t cell = 0; cell < found.cellCount(); ++cell)
  {
    const Exact a = corner(found, cell, 0), b = corner(found, cell, 1), c = corner(found, cell, 2);
    const mpq_class twice = turn(a, b, c);
    area += twice;
    if (twice <= 0)
    {
      return "a triangle turns right";
    }
    for (const Exact& point : points)
    {
      if (inCircle(a, b, c, point) < 0)
      {
        return "a point is outside of a circle";
      }
    }
  }
  if (area != whole)
  {
    return "the triangles do not cover the hull once";
  }
  // Polygons: the same as triangles, and each has all corners of its circle.
  options.facets = FacetMode::Polygons;
  Triangulation polygons = furthestSiteTriangulation(viewOf(cloud), options);
  for (std::int64_t cell = 0; cell < polygons.cellCount(); ++cell)
  {
    const std::int64_t size = polygons.cellBegin(cell + 1) - polygons.cellBegin(cell);
    std::int64_t onCircle = 0;
    for (const std::int64_t id : ring)
    {
      onCircle += inCircle(corner(polygons, cell, 0), corner(polygons, cell, 1),
                    corner(polygons, cell, 2), points[static_cast<std::size_t>(id)]) == 0;
    }
    if (onCircle != size)
    {
      return "a polygon lacks corners of its circle";
    }
  }
  fanPolygons(polygons);
  return bitsOf(static_cast<const CellComplex&>(polygons)) ==
      bitsOf(static_cast<const CellComplex&>(found))
    ? ""
    : "polygons and triangles differ";
}

/// Small integers, points of a circle, or any.
Cloud drawCloud(Random& random)
{
  Cloud cloud(static_cast<std::size_t>(random.integer(1, 24)));
  const int kind = random.integer(0, 3);
  const int reach = random.integer(1, 5);
  static constexpr double pythagorean[][2] = { { 3, 4 }, { 4, 3 }, { 5, 0 }, { 0, 5 } };
  for (auto& point : cloud)
  {
    point[2] = std::nan("");
    if (kind == 0)
    {
      point[0] = random.uniform(-1, 1);
      point[1] = random.uniform(-1, 1);
    }
    else if (kind == 1)
    {
      const double* const x = pythagorean[random.integer(0, 3)];
      point[0] = random.integer(0, 1) ? x[0] : -x[0];
      point[1] = random.integer(0, 1) ? x[1] : -x[1];
    }
    else
    {
      point[0] = random.integer(-reach, reach);
      point[1] = kind == 2 ? random.integer(-reach, reach) : point[0] * random.integer(1, 2);
    }
  }
  return cloud;
}

TEST(FurthestSite, AreThoseOfAllPointsAndCircles)
{
  runSeeds(500, drawCloud, faultOf, [](const Cloud& cloud) { return toString(cloud); });
}

TEST(FurthestSite, OfManyPoints)
{
  Random random(3);
  for (const bool isRing : { false, true })
  {
    Cloud cloud(isRing ? 150 : 2000);
    for (auto& point : cloud)
    {
      const double angle = random.uniform(0, 6.28);
      const double radius = isRing ? 1 : random.uniform();
      point = { radius * std::cos(angle), radius * std::sin(angle), 0 };
    }
    EXPECT_EQ(faultOf(cloud), "");
  }
}

}
}
}
