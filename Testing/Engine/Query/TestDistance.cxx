// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances from the surface have the right sign, and the value that all triangles, one after
/// another, give in numbers of many bits.
#include "Testing/Engine/Query/QueryCases.h"
#include "Testing/Engine/Query/ReferenceDistance.h"
#include <flipflop/HullQueries.h>

namespace flipflop
{
namespace test
{

namespace
{

void expectDistance(
  double found, const Real& square, const Real& farthestSquare, const std::string& what)
{
  EXPECT_TRUE(isDistance(found, square, farthestSquare))
    << what << ": " << found << ", not " << Real(sqrt(square)).get_d();
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
  const std::vector<std::vector<Vector>> cells = cornersOf(polygons, cloud);
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    const std::vector<double> found =
      distancesOf(HullQueries(viewOf(cloud), hullOf(cloud, facets)), queries, 1);
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      const Vector x = exactly(queries[i]);
      Real least, farthest;
      squaresFromCells(cells, x, least, farthest);
      EXPECT_EQ(found[i] < 0 ? 1 : found[i] > 0 ? -1 : 0, sides[i]) << name;
      expectDistance(found[i], sides[i] == 0 ? Real(0, Bits) : least, farthest,
        name + ", query " + std::to_string(i));
    }
  }
}

TEST(Distance, AgreesWithAllTrianglesEverywhere)
{
  for (const auto& [name, cloud] : queryClouds())
  {
    expectDistances(name, cloud, queriesAbout(cloud, 31, effort(60)));
  }
}

TEST(Distance, AtAnyMagnitude)
{
  for (const auto& [name, cloud] : extremeClouds())
  {
    expectDistances(name, cloud, extremeQueries(cloud, 34, effort(40)));
  }
}

/// z of the points and of the queries is not read.
TEST(Distance, OfPolygonsInThePlane)
{
  for (const auto& [name, solid] : joined(queryClouds(), extremeClouds()))
  {
    Cloud cloud = solid;
    for (Point& p : cloud)
    {
      p[2] = 0;
    }
    Cloud queries = extremeQueries(cloud, 35, effort(40));
    for (Point& q : queries)
    {
      q[2] = 0;
    }
    const Hull hull = hullOf(cloud, FacetMode::Polygons);
    const std::vector<std::int8_t> inHull = sidesByBruteForce(cloud, hull, queries);
    const std::vector<Vector> ring = cornersOf(hull, cloud)[0];
    std::vector<std::vector<Vector>> edges;
    for (std::size_t k = 0; k < ring.size(); ++k)
    {
      edges.push_back({ ring[k], ring[(k + 1) % ring.size()] });
    }
    for (Cloud* points : { &cloud, &queries })
    {
      for (Point& p : *points)
      {
        p[2] = std::numeric_limits<double>::quiet_NaN();
      }
    }
    const HullQueries plane(viewOf(cloud), hull, Options(), PointSpace::Plane);
    const std::vector<double> found = distancesOf(plane, queries, 1);
    std::vector<std::int8_t> sides(queries.size());
    plane.contains(viewOf(queries), sides.data());
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      const Vector x = exactly({ queries[i][0], queries[i][1], 0 });
      Real least, farthest;
      squaresFromCells(edges, x, least, farthest);
      const int side = inHull[i] < 0 ? -1 : isOnBorder(edges, x) ? 0 : 1;
      EXPECT_EQ(sides[i], side) << name;
      EXPECT_EQ(found[i] < 0 ? 1 : found[i] > 0 ? -1 : 0, side) << name;
      expectDistance(found[i], least, farthest, name + ", query " + std::to_string(i));
    }
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

}
}
}
