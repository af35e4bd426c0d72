// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every question about a hull, beside its definition: of points in space and in the plane, at any
/// magnitude, of many corners, and by the thousand.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Query/HullCases.h"
#include "Testing/Engine/Query/HullReference.h"
#include <flipflop/Neighbors.h>
#include <flipflop/RegularTriangulation.h>

#include <array>

namespace flipflop
{
namespace test
{

namespace
{

struct Questions
{
  Cloud queries;
  Cloud directions;
  std::size_t distances; ///< of the queries, the first so many
};

/// How many queries were on each side.
using Met = std::array<int, 3>;

void expectResults(const Cloud& cloud, const Questions& questions, PointSpace space, Met& met)
{
  const HullReference wanted(cloud, space);
  const std::vector<std::int8_t> wantedSides = wanted.sides(questions.queries);
  const std::vector<std::int64_t> wantedIds = wanted.farthest(questions.directions);
  Cloud points = cloud;
  Cloud queries = questions.queries;
  for (Cloud* const some : { &points, &queries })
  {
    for (Point& p : *some)
    {
      p[2] = space == PointSpace::Plane ? std::numeric_limits<double>::quiet_NaN() : p[2];
    }
  }
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    SCOPED_TRACE(facets == FacetMode::Polygons ? "polygons" : "triangles");
    const Hull hull = hullOf(wanted.cloud, facets);
    const HullQueries asked(viewOf(points), hull, Options(), space);
    std::vector<std::int8_t> sides(queries.size(), 99);
    std::vector<double> distances(queries.size(), 99);
    std::vector<std::int64_t> ids(questions.directions.size(), -2);
    asked.contains(viewOf(queries), sides.data());
    asked.distance(viewOf(queries), distances.data());
    asked.support(viewOf(questions.directions), ids.data());
    EXPECT_EQ(sides, wantedSides);
    EXPECT_EQ(ids, wantedIds);
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      EXPECT_EQ(distances[i] < 0 ? 1 : distances[i] > 0 ? -1 : 0, sides[i]) << "query " << i;
      EXPECT_EQ(
        i < questions.distances ? wanted.distanceFault(queries[i], sides[i], distances[i]) : "", "")
        << "query " << i;
      ++met[static_cast<std::size_t>(sides[i] + 1)];
    }
    EXPECT_EQ(wanted.diameterFault(asked.diameter()), "");
    EXPECT_EQ(wanted.boxFault(asked.minimalBox()), "");
    if (space == PointSpace::Space)
    {
      EXPECT_EQ(wanted.planesFault(hull, facetPlanes(viewOf(points), hull)), "");
      const Buffer<std::int64_t> neighbors = cellNeighbors(hull);
      EXPECT_EQ(
        std::vector<std::int64_t>(neighbors.begin(), neighbors.end()), neighborsByMap(hull));
    }
  }
}

Met expectResults(const NamedCloud& named, const Questions& questions)
{
  Met met{};
  for (const PointSpace space : { PointSpace::Space, PointSpace::Plane })
  {
    SCOPED_TRACE(named.first + ", " + std::to_string(named.second.size()) +
      (space == PointSpace::Plane ? ", in the plane" : ""));
    expectResults(named.second, questions, space, met);
  }
  return met;
}

TEST(HullResults, OfFamilies)
{
  Met met{};
  for (const NamedCloud& named : queryClouds())
  {
    const Cloud& cloud = named.second;
    const Met some = expectResults(named,
      { joined(queriesAbout(cloud, 11, effort(300)), cloud), directionsFor(cloud, 21, effort(400)),
        static_cast<std::size_t>(effort(60)) });
    std::transform(some.begin(), some.end(), met.begin(), met.begin(), std::plus<int>());
  }
  for (const int count : met)
  {
    EXPECT_GT(count, effort(500));
  }
}

TEST(HullResults, AtAnyMagnitude)
{
  for (const NamedCloud& named : extremeClouds())
  {
    const Cloud queries = extremeQueries(named.second, 34, effort(40));
    expectResults(named, { queries, directionsFor(named.second, 22, 60), queries.size() });
  }
}

/// The slanted facet of a unit tetrahedron passes through none of these, but closely.
TEST(HullResults, OfPointsWhoseBitsReachLowerThanTheHulls)
{
  Cloud queries;
  for (const double tiny : { 5e-324, 1e-300, 1e-200, 1e-100, 1e-80, 1e-30 })
  {
    for (const double sign : { 1.0, -1.0 })
    {
      queries.insert(queries.end(),
        { { 0.5, 0.5, sign * tiny }, { sign * tiny, tiny, tiny }, { 0.25, 0.25 + sign * tiny, 0.5 },
          { sign * tiny, 1, 0 } });
    }
  }
  expectResults({ "unit tetrahedron", latticeTetrahedron(1) }, { queries, queries, 60 });
}

TEST(HullResults, OfManyCorners)
{
  Random random(7);
  const Cloud ball = fromFamily("shell0", 60, 9).make();
  std::vector<NamedCloud> clouds = { { "cospherical", cosphericalIntegers(101) },
    { "rotated cospherical", rotated(cosphericalIntegers(101)) },
    { "prism", prism(effort(300), 0, random) },
    { "a ball far away", joined(scaled(ball, 1e-12, 1e-12, 1e-12), { { 1, 2, 3 } }) },
    { "two balls",
      joined(
        scaled(ball, 1e-18, 1e-18, 1e-18), moved(scaled(ball, 1e-14, 1e-14, 1e-14), 1, 0, 0)) } };
  for (const char* name : { "shell0", "helix", "shell1e2", "planeXyz0" })
  {
    clouds.emplace_back(name, fromFamily(name, effort(900), 8).make());
  }
  for (const NamedCloud& named : clouds)
  {
    Cloud queries;
    for (int i = 0; i < 10; ++i)
    {
      const double far = std::pow(10.0, 5 * i);
      queries.push_back({ far, -0.3 * far, 0.2 });
    }
    queries = joined(queries, queriesAbout(named.second, 12, effort(60)));
    expectResults(named, { queries, directionsFor(named.second, 23, effort(100)), 12 });
  }
}

TEST(HullResults, InBulk)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", randomCases(400));
  for (std::int64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Cloud cloud = anyCloud(random);
    Cloud directions = directionsFor(cloud, static_cast<std::uint64_t>(seed), 57);
    for (Point& p : directions)
    {
      double& x = p[random.pick(3)];
      x = std::isfinite(x * anyScale(random)) ? x * anyScale(random) : x;
      x = std::isfinite(x) ? x : 1;
    }
    SCOPED_TRACE("seed " + std::to_string(seed));
    Met met{};
    expectResults(cloud,
      { queriesAbout(cloud, static_cast<std::uint64_t>(seed), 60), directions, 2 },
      PointSpace::Space, met);
  }
}

/// The lowest id of a facet need not be next to the others, once ids are shuffled.
TEST(HullResults, TheLowestVertexOfAFlatFace)
{
  Random random(4);
  for (int attempt = 0; attempt < effort(20); ++attempt)
  {
    Cloud cloud = joined(prism(12, 0, random), cubeSurfaceGrid(2));
    random.shuffle(cloud);
    expectResults({ "prism", cloud },
      { {}, { { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { 0, -5, 0 }, { 0, 0, 0 } }, 0 });
  }
}

/// Half of all directions end at an apex of so many edges that to pass them each time would be
/// long.
TEST(HullResults, DirectionsToACornerOfManyEdges)
{
  const Cloud cloud = bipyramid(effort(20000));
  const HullReference wanted(cloud);
  const HullQueries queries(viewOf(cloud), wanted.hull);
  Random random(5);
  Cloud directions(100000);
  std::generate(directions.begin(), directions.end(), [&] { return random.direction(); });
  std::vector<std::int64_t> ids(directions.size());
  queries.support(viewOf(directions), ids.data());
  directions.resize(20);
  ids.resize(20);
  EXPECT_EQ(ids, wanted.farthest(directions));
}

TEST(HullResults, KnownValues)
{
  const Cloud cube = integerGrid(2);
  const Hull hull = hullOf(cube, FacetMode::Polygons);
  const HullQueries asked(viewOf(cube), hull);
  const Cloud queries = { { 0.5, 0.5, 0.5 }, { 0.5, 0.5, 0.125 }, { 0.5, 0.5, 3 }, { 4, 5, 0.5 },
    { 3, 3, -1 }, { 0.5, 1, 0.25 }, { 1e308, 0, 0 } };
  std::vector<double> distances(queries.size());
  asked.distance(viewOf(queries), distances.data());
  EXPECT_EQ(distances, (std::vector<double>{ -0.5, -0.125, 2, 5, 3, 0, 1e308 }));
  const Buffer<double> planes = facetPlanes(viewOf(cube), hull);
  std::vector<std::array<double, 4>> found;
  for (std::size_t i = 0; i < planes.size(); i += 4)
  {
    found.push_back({ planes[i], planes[i + 1], planes[i + 2], planes[i + 3] });
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found,
    (std::vector<std::array<double, 4>>{ { -1, 0, 0, 0 }, { 0, -1, 0, 0 }, { 0, 0, -1, 0 },
      { 0, 0, 1, -1 }, { 0, 1, 0, -1 }, { 1, 0, 0, -1 } }));
}

TEST(HullResults, OfNothing)
{
  const HullQueries nothing{ PointView(), Hull() };
  EXPECT_EQ(HullReference({}).diameterFault(nothing.diameter()), "");
  EXPECT_EQ(HullReference({}).boxFault(nothing.minimalBox()), "");
  EXPECT_TRUE(cellNeighbors(Hull()).empty());
}

/// Cells 0-3, 1-2, 2-3.
TEST(HullResults, NeighborsInAChain)
{
  const Cloud cloud = { { 3, 3, 0 }, { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } };
  const Buffer<std::int64_t> found = cellNeighbors(regularTriangulation(viewOf(cloud)));
  EXPECT_EQ(std::vector<std::int64_t>(found.begin(), found.end()),
    (std::vector<std::int64_t>{ -1, 2, -1, 2, 1, 0 }));
}

}
}
}
