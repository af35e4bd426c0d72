// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances from the surface have the right sign, and the value that all triangles, one after
/// another, give in numbers of many bits.
#include "Testing/Engine/Query/QueryCases.h"
#include <flipflop/HullQueries.h>

#include <array>

namespace flipflop
{
namespace test
{

namespace
{

constexpr int Bits = 6000; // any two doubles' product, and some
using Real = mpf_class;
using Vector = std::array<Real, 3>;

Vector exactly(const Point& p)
{
  return { Real(p[0], Bits), Real(p[1], Bits), Real(p[2], Bits) };
}
Vector operator-(const Vector& a, const Vector& b)
{
  return { Real(a[0] - b[0]), Real(a[1] - b[1]), Real(a[2] - b[2]) };
}
Real dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b)
{
  return { Real(a[1] * b[2] - a[2] * b[1]), Real(a[2] * b[0] - a[0] * b[2]),
    Real(a[0] * b[1] - a[1] * b[0]) };
}

Real squareFromSegment(const Vector& a, const Vector& b, const Vector& x)
{
  const Vector edge = b - a;
  const Real length = dot(edge, edge);
  const Real along = dot(edge, x - a);
  if (along <= 0 || length == 0)
  {
    return dot(x - a, x - a);
  }
  if (along >= length)
  {
    return dot(x - b, x - b);
  }
  return dot(x - a, x - a) - along * along / length;
}

/// The square of the distance from a polygon, its border included.
Real squareFromCell(const std::vector<Vector>& cell, const Vector& x)
{
  bool over = cell.size() > 2;
  Vector normal;
  Real least(-1, Bits);
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    const Vector& a = cell[i];
    const Vector& b = cell[(i + 1) % cell.size()];
    if (over)
    {
      normal = i == 0 ? cross(cell[1] - cell[0], cell[2] - cell[0]) : normal;
      over = dot(normal, cross(b - a, x - a)) >= 0;
    }
    const Real square = squareFromSegment(a, b, x);
    least = least < 0 || square < least ? square : least;
  }
  if (over)
  {
    const Real height = dot(normal, x - cell[0]);
    least = height * height / dot(normal, normal);
  }
  return least;
}

std::vector<double> distancesOf(const HullQueries& hull, const Cloud& queries, int threads)
{
  std::vector<double> result(queries.size(), 99);
  hull.distance(viewOf(queries), result.data(), onThreads(threads));
  return result;
}

void expectDistances(const std::string& name, const Cloud& cloud, const Cloud& queries)
{
  const Hull polygons = hullOf(cloud, FacetMode::Polygons);
  const std::vector<std::int8_t> sides = sidesByBruteForce(cloud, polygons, queries);
  std::vector<std::vector<Vector>> cells;
  for (const Cell& cell : cellsOf(polygons))
  {
    cells.emplace_back();
    for (const std::int64_t id : cell)
    {
      cells.back().push_back(exactly(cloud[static_cast<std::size_t>(id)]));
    }
  }
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    const std::vector<double> found =
      distancesOf(HullQueries(viewOf(cloud), hullOf(cloud, facets)), queries, 1);
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      const Vector x = exactly(queries[i]);
      Real least(-1, Bits);
      Real farthest(0, Bits);
      for (const std::vector<Vector>& cell : cells)
      {
        const Real square = squareFromCell(cell, x);
        least = least < 0 || square < least ? square : least;
        for (const Vector& corner : cell)
        {
          const Real far = dot(x - corner, x - corner);
          farthest = far > farthest ? far : farthest;
        }
      }
      EXPECT_EQ(found[i] < 0 ? 1 : found[i] > 0 ? -1 : 0, sides[i]) << name;
      const Real wanted = sides[i] == 0 ? Real(0, Bits) : Real(sqrt(least));
      const Real off = abs(Real(std::fabs(found[i]), Bits) - wanted);
      EXPECT_LE(off, 1e-14 * Real(sqrt(farthest)) + Real(5e-324, Bits))
        << name << ", query " << i << ": " << found[i] << ", not " << wanted.get_d();
    }
  }
}

TEST(Distance, AgreesWithAllTrianglesEverywhere)
{
  for (const auto& [name, cloud] : queryClouds())
  {
    Cloud queries = queriesAbout(cloud, 31, effort(60));
    // No double holds some distances from the largest numbers.
    const double most = name == "largest" ? 1.2e308 : 1e301;
    queries.erase(std::remove_if(queries.begin(), queries.end(),
                    [most](const Point& p) {
                      return std::max({ std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]) }) > most;
                    }),
      queries.end());
    expectDistances(name, cloud, queries);
  }
}

TEST(Distance, FromALargerHull)
{
  const Cloud cloud = fromFamily("shell1e2", 700, 3).make();
  Cloud queries = queriesAbout(cloud, 32, effort(100));
  for (int i = 0; i < 10; ++i)
  {
    const double far = std::pow(10.0, 5 * i);
    queries.push_back({ far, -0.3 * far, 0.2 });
  }
  expectDistances("shell1e2", cloud, queries);
}

TEST(Distance, KnownValues)
{
  const Cloud cube = integerGrid(2);
  const HullQueries hull(viewOf(cube), hullOf(cube, FacetMode::Triangles));
  const Cloud queries = { { 0.5, 0.5, 0.5 }, { 0.5, 0.5, 0.125 }, { 0.5, 0.5, 3 }, { 4, 5, 0.5 },
    { 3, 3, -1 }, { 0.5, 1, 0.25 }, { 1e308, 0, 0 } };
  const std::vector<double> wanted = { -0.5, -0.125, 2, 5, 3, 0, 1e308 };
  EXPECT_EQ(distancesOf(hull, queries, 1), wanted);
}

TEST(Distance, FarBesideAThinHull)
{
  const Cloud plate = scaled(integerGrid(2), 1, 1e-60, 1);
  const HullQueries hull(viewOf(plate), hullOf(plate, FacetMode::Triangles));
  const Cloud queries = { { 0.5, 2, 0.5 }, { 0.5, -1e-30, 0.5 }, { 1e50, 0, 0 }, { 0.5, 3, 5 },
    { 0.5, 0.5e-60, 0.25 } };
  const std::vector<double> wanted = { 2, 1e-30, 1e50, 5, -0.5e-60 };
  const std::vector<double> found = distancesOf(hull, queries, 1);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    EXPECT_NEAR(found[i], wanted[i], 1e-15 * std::fabs(wanted[i])) << "query " << i;
  }
}

TEST(Distance, OnAnyThreads)
{
  const Cloud cloud = fromFamily("ball", 3000, 5).make();
  const Cloud queries = joined(queriesAbout(cloud, 33, effort(10000)), cloud);
  const HullQueries hull(viewOf(cloud), hullOf(cloud, FacetMode::Polygons));
  const std::vector<double> one = distancesOf(hull, queries, 1);
  EXPECT_EQ(distancesOf(hull, queries, 2), one);
  EXPECT_EQ(
    distancesOf(HullQueries(viewOf(cloud), hullOf(cloud, FacetMode::Polygons)), queries, 4), one);
}

}
}
}
