// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Degenerate inputs that no family draws, with the cells written out by hand: zeros of both signs,
/// one position thousands of times, ends of the range, weights that hide nearly all.
#include "Testing/Engine/Conformance/Kind.h"

#include <algorithm>
#include <limits>
#include <map>

namespace flipflop
{
namespace test
{

namespace
{

const double least = std::numeric_limits<double>::denorm_min();
const double greatest = std::numeric_limits<double>::max();

TEST(Degenerate, NoPoint)
{
  for (const Kind* kind : { &convexHulls, &regularTriangulations })
  {
    expectCells(*kind, {}, -1, {});
  }
  EXPECT_TRUE(regularTriangulation(PointView()).hiddenIds.empty());
}

TEST(Degenerate, OneLine)
{
  expectCells(convexHulls, { { 0, 0, -0.0 }, { -0.0, 0, 0 }, { 0, -0.0, 0 } }, 0, { { 0 } });
  expectCells(convexHulls, Cloud(5000, Point{ 0.1, 0.2, 0.3 }), 0, { { 0 } });
  expectCells(convexHulls, { { 1, 1, -least }, { 1, 1, 1e308 } }, 1, { { 0, 1 } });
  // The greatest coordinate is not the one that varies.
  expectCells(
    convexHulls, { { 1e15, 3, -1e15 }, { 1e15, 1, -1e15 }, { 1e15, 2, -1e15 } }, 1, { { 0, 1 } });
  const Kind& plane = regularTriangulations;
  expectCells(plane, { { 0, -0.0, -0.0 }, { -0.0, 0, 0 } }, 0, { { 0 } });
  Cloud many(5000, Point{ 0.1, 0.2, -0.3 });
  many[3999][2] = many[4001][2] = -0.2;
  expectCells(plane, many, 0, { { 3999 } });
  expectCells(plane, { { 0, 0, -greatest }, { least, 0, greatest } }, 1, { { 0, 1 } });
  expectCells(plane, { { -greatest, 0, 0 }, { greatest, 0, 0 } }, 1, { { 0, 1 } });
  // The middle of three is exactly tied when it is lighter by the product of its distances.
  expectCells(plane, { { 0, 0, 0 }, { 3, 0, 0 }, { 1, 0, -2 } }, 1, { { 0, 1 } });
  expectCells(
    plane, { { 0, 0, 0 }, { 3, 0, 0 }, { 1, 0, -2 + 0x1p-51 } }, 1, { { 0, 2 }, { 1, 2 } });
  expectCells(plane, { { 0, 0, 0 }, { 3, 0, 0 }, { 1, 0, -2 - 0x1p-51 } }, 1, { { 0, 1 } });
}

TEST(Degenerate, OneTriangle)
{
  const Kind& plane = regularTriangulations;
  expectCells(plane, { { 0, 0, 5 }, { 0, 1, -1e300 }, { 1, 0, 1e300 } }, 2, { { 0, 2, 1 } });
  expectCells(plane, { { 0, 0, 0 }, { least, 0, 0 }, { 0, least, 0 } }, 2, { { 0, 1, 2 } });
  expectCells(plane, { { 1e308, 0, 0 }, { -1e308, 0, 0 }, { 0, least, 0 } }, 2, { { 0, 2, 1 } });
}

TEST(Degenerate, LatticePlanes)
{
  // An integer grid in a lattice plane is exactly coplanar, whatever the plane.
  Random random(3);
  for (int i = 0; i < effort(60); ++i)
  {
    int step[6];
    std::generate(step, step + 6, [&] { return random.integer(-9, 9); });
    Cloud cloud;
    for (int k = 0; k < 40; ++k)
    {
      const int a = random.integer(-6, 6), b = random.integer(-6, 6);
      cloud.push_back({ double(a * step[0] + b * step[1] + 3),
        double(a * step[2] + b * step[3] - 5), double(a * step[4] + b * step[5] + 1) });
    }
    SCOPED_TRACE("seed 3, case " + std::to_string(i));
    const ReferenceHull wanted = bruteForceHull(cloud);
    EXPECT_LE(wanted.dimension, 2);
    expectHull(cloud, wanted);
    // One point a little off either side: a flat pyramid.
    cloud.push_back({ 3.0 + 0x1p-40, -5, 1 + 0x1p-41 });
    expectHull(cloud, cgalHull(cloud));
  }
}

/// The hull of many points is that of the few which are all that can be extreme.
void expectHullOfFew(const Cloud& cloud, const Cloud& few)
{
  std::map<Point, std::int64_t> lowest;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    lowest.emplace(cloud[i], static_cast<std::int64_t>(i));
  }
  std::vector<std::int64_t> ids;
  for (const std::int64_t id : bruteForceHull(few).ids)
  {
    ids.push_back(lowest.at(few[static_cast<std::size_t>(id)]));
  }
  std::sort(ids.begin(), ids.end());
  const Hull hull = convexHull(viewOf(cloud));
  EXPECT_EQ(std::vector<std::int64_t>(hull.pointIds.begin(), hull.pointIds.end()), ids);
}

TEST(Degenerate, TheLowestIdStandsForManyDuplicates)
{
  // A first polyhedron may be of a part of them, whose ids need not be the lowest.
  Random random(9);
  for (const char* family : { "shell0", "smallIntegers", "cube" })
  {
    for (const int count : { 300, 3000, 5000 })
    {
      SCOPED_TRACE(family + (" " + std::to_string(count)));
      const Cloud positions = fromFamily(family, 40, 8).make();
      Cloud cloud = positions;
      for (int i = 0; i < count; ++i)
      {
        cloud.push_back(positions[static_cast<std::size_t>(random.integer(0, 39))]);
      }
      random.shuffle(cloud);
      expectHullOfFew(cloud, positions);
    }
  }
}

TEST(Degenerate, ManyPointsOnFewLinesAlongAnAxis)
{
  Random random(10);
  const Cloud feet = fromFamily("shell0", 20, 11).make();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    Cloud cloud;
    Cloud ends;
    for (Point p : feet)
    {
      for (const double end : { -random.uniform(1, 2), random.uniform(1, 2) })
      {
        p[axis] = end;
        ends.push_back(p);
      }
      for (int i = 0; i < 300; ++i)
      {
        p[axis] = random.uniform(-1, 1);
        cloud.push_back(p);
      }
    }
    cloud.insert(cloud.end(), ends.begin(), ends.end());
    cloud.insert(cloud.end(), ends.begin(), ends.end());
    random.shuffle(cloud);
    expectHullOfFew(cloud, ends);
  }
}

TEST(Degenerate, AllButTheHeaviestHidden)
{
  // A triangle so heavy that it hides all others, and one that is not.
  Cloud cloud = moved(squareGrid(60), -30, -30, 0);
  cloud = joined(std::move(cloud), { { -200, -200, 1e6 }, { 200, -200, 1e6 }, { 0, 200, 1e6 } });
  expectCells(regularTriangulations, cloud, 2, { { 3600, 3601, 3602 } });
  cloud.push_back({ 0, 0, 1e6 });
  expectCells(regularTriangulations, cloud, 2,
    { { 3600, 3601, 3603 }, { 3600, 3603, 3602 }, { 3601, 3602, 3603 } });
}

TEST(Degenerate, DuplicatesOfAnyWeight)
{
  // Four corners, each three times; the heaviest appears, and of equals the lowest id.
  Cloud cloud;
  for (double weight : { 1.0, 2.0, 2.0 })
  {
    for (Point p : squareGrid(2))
    {
      p[2] = weight;
      cloud.push_back(p);
    }
  }
  expectCells(regularTriangulations, cloud, 2, { { 4, 5, 7, 6 } });
  cloud[0][2] = 2;
  expectCells(regularTriangulations, cloud, 2, { { 0, 5, 7, 6 } });
  // The differences of weights below the last place of the squares.
  for (Point& p : cloud)
  {
    p = { p[0] + 0x1p50, p[1] - 0x1p50, p[2] * 0x1p-1070 };
  }
  expectCells(regularTriangulations, cloud, 2, { { 0, 5, 7, 6 } });
}

TEST(Degenerate, GiantWeights)
{
  // One giant within hides all but the border: there the chain of each side is as it was.
  const double greatest = std::numeric_limits<double>::max();
  const int side = 40;
  Cloud cloud = squareGrid(side);
  const std::int64_t giant = side * 17 + 21;
  cloud[giant][2] = greatest;
  std::vector<Cell> fan;
  for (std::int64_t i = 0; i + 1 < side; ++i)
  {
    const std::int64_t last = side * (side - 1);
    fan.push_back({ i, i + 1, giant });
    fan.push_back({ last + i + 1, last + i, giant });
    fan.push_back({ (i + 1) * side, i * side, giant });
    fan.push_back({ i * side + side - 1, (i + 1) * side + side - 1, giant });
  }
  canonicalise(fan);
  expectCells(regularTriangulations, cloud, 2, fan);
  // As light as can be: it goes, if it is no corner.
  cloud = squareGrid(3);
  cloud[4][2] = -greatest;
  expectCells(regularTriangulations, cloud, 2,
    { { 0, 1, 3 }, { 1, 2, 5 }, { 1, 5, 7, 3 }, { 3, 7, 6 }, { 5, 8, 7 } });
  cloud = squareGrid(2);
  cloud[3][2] = -greatest;
  expectCells(regularTriangulations, cloud, 2, { { 0, 1, 2 }, { 1, 3, 2 } });
}

}
}
}
