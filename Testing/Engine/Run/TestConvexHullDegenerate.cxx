// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The ladder of degenerate inputs, rung by rung, with the cells written out by hand.
#include "Testing/Engine/Conformance/Kind.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

namespace flipflop
{
namespace test
{

namespace
{

void expectCells(const Cloud& cloud, int dimension, std::vector<Cell> cells)
{
  expectCells(convexHulls, cloud, dimension, std::move(cells));
}

TEST(ConvexHullDegenerate, NoPoint)
{
  expectCells({}, -1, {});
  const Hull hull = convexHull(PointView());
  EXPECT_EQ(hull.dimension, -1);
  EXPECT_EQ(hull.cellCount(), 0);
  EXPECT_TRUE(hull.pointIds.empty());
  EXPECT_TRUE(hull.connectivity.empty());
}

TEST(ConvexHullDegenerate, OnePosition)
{
  expectCells({ { 1, 2, 3 } }, 0, { { 0 } });
  expectCells(Cloud(2, Point{ -1, 0, 1e300 }), 0, { { 0 } });
  expectCells(Cloud(5000, Point{ 0.1, 0.2, 0.3 }), 0, { { 0 } });
  expectCells({ { 0, 0, -0.0 }, { -0.0, 0, 0 }, { 0, -0.0, 0 } }, 0, { { 0 } });
}

TEST(ConvexHullDegenerate, TwoPositions)
{
  expectCells({ { 0, 0, 0 }, { 0, 0, 1 } }, 1, { { 0, 1 } });
  expectCells({ { 1, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } }, 1, { { 0, 1 } });
  const double tiny = std::numeric_limits<double>::denorm_min();
  expectCells({ { 1, 1, 0 }, { 1, 1, tiny } }, 1, { { 0, 1 } });
  expectCells({ { 1, 1, -tiny }, { 1, 1, 1e308 } }, 1, { { 0, 1 } });
}

TEST(ConvexHullDegenerate, Collinear)
{
  expectCells({ { 1, 1, 1 }, { 3, 3, 3 }, { 0, 0, 0 }, { 2, 2, 2 }, { 3, 3, 3 }, { 0, 0, 0 } }, 1,
    { { 1, 2 } });
  expectCells({ { 0, 5, 0 }, { 0, -5, 0 }, { 0, 0, 0 } }, 1, { { 0, 1 } });
  // The greatest coordinate is not the one that varies.
  expectCells({ { 1e15, 3, -1e15 }, { 1e15, 1, -1e15 }, { 1e15, 2, -1e15 } }, 1, { { 0, 1 } });
  Cloud line;
  for (int i = 0; i < 3001; ++i)
  {
    const double t = (i * 1000) % 3001;
    line.push_back({ 3 * t, -5 * t, 7 * t });
  }
  // 1000 * i = 3000 modulo 3001 first at i = 3; t = 0 at i = 0.
  ASSERT_EQ(line[3][0], 9000);
  expectHull(line, cgalHull(line));
  const Hull hull = convexHull(viewOf(line));
  EXPECT_EQ(cellsOf(hull), (std::vector<Cell>{ { 0, 3 } }));
}

TEST(ConvexHullDegenerate, AlmostCollinear)
{
  // The middle point is off the line by one unit in the last place.
  expectCells({ { 1, 1, 1 }, { 2, 2, 2 + 0x1p-51 }, { 3, 3, 3 } }, 2, { { 0, 1, 2 } });
}

TEST(ConvexHullDegenerate, Triangle)
{
  // Whichever way the points are named, the normal's last non-zero component is positive.
  expectCells({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, 2, { { 0, 1, 2 } });
  expectCells({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 } }, 2, { { 0, 2, 1 } });
  expectCells({ { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, 2, { { 0, 1, 2 } }); // normal +x
  expectCells({ { 0, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 } }, 2, { { 0, 2, 1 } });
  expectCells({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } }, 2, { { 0, 2, 1 } }); // normal +y
  expectCells({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 } }, 2, { { 0, 1, 2 } });
  // The normal (-1, -1, 1) stays; (1, -1, 0) is turned: y is its last non-zero component.
  expectCells({ { 0, 0, 0 }, { 1, 0, 1 }, { 0, 1, 1 } }, 2, { { 0, 1, 2 } });
  expectCells({ { 0, 0, 0 }, { 1, 1, 0 }, { 0, 0, 1 } }, 2, { { 0, 2, 1 } });
}

TEST(ConvexHullDegenerate, CoplanarPolygon)
{
  // A square, its centre, an edge's middle, duplicates of all.
  const Cloud square = { { 0.5, 0.5, 7 }, { 0, 1, 7 }, { 1, 1, 7 }, { 0.5, 0, 7 }, { 1, 0, 7 },
    { 0, 0, 7 }, { 1, 1, 7 }, { 0.5, 0.5, 7 }, { 0, 0, 7 }, { 0, 0.5, 7 } };
  expectCells(square, 2, { { 1, 5, 4, 2 } });
  const Hull triangles = convexHull(viewOf(square));
  EXPECT_EQ(cellsOf(triangles), (std::vector<Cell>{ { 1, 4, 2 }, { 1, 5, 4 } }));
  EXPECT_EQ(triangles.area, 1);
  EXPECT_EQ(triangles.volume, 0);
}

TEST(ConvexHullDegenerate, CoplanarInManyDirections)
{
  // An integer grid in a lattice plane is exactly coplanar, whatever the plane.
  Random random(3);
  for (int i = 0; i < effort(60); ++i)
  {
    Point u;
    Point v;
    for (int c = 0; c < 3; ++c)
    {
      u[c] = random.integer(-9, 9);
      v[c] = random.integer(-9, 9);
    }
    Cloud cloud;
    for (int k = 0; k < 40; ++k)
    {
      const int a = random.integer(-6, 6);
      const int b = random.integer(-6, 6);
      cloud.push_back(
        { a * u[0] + b * v[0] + 3, a * u[1] + b * v[1] - 5, a * u[2] + b * v[2] + 1 });
    }
    SCOPED_TRACE("seed 3, case " + std::to_string(i));
    const ReferenceHull wanted = cgalHull(cloud);
    EXPECT_LE(wanted.dimension, 2);
    EXPECT_TRUE(wanted == bruteForceHull(cloud));
    expectHull(cloud, wanted);
    // One point a little off either side: a flat pyramid.
    cloud.push_back({ 3.0 + 0x1p-40, -5, 1 + 0x1p-41 });
    expectHull(cloud, cgalHull(cloud));
  }
}

TEST(ConvexHullDegenerate, LargePolygons)
{
  // Integer points on a circle, in four planes: all extreme, none collinear.
  Cloud circle;
  for (int x = -1105; x <= 1105; ++x)
  {
    for (int y = -1105; y <= 1105; ++y)
    {
      if (x * x + y * y == 1105 * 1105)
      {
        circle.push_back({ double(x), double(y), 0 });
      }
    }
  }
  ASSERT_GT(circle.size(), 50u);
  for (int plane = 0; plane < 4; ++plane)
  {
    Cloud cloud = circle;
    for (Point& p : cloud)
    {
      p = plane == 0 ? p
        : plane == 1 ? Point{ p[0], 0, p[1] }
        : plane == 2 ? Point{ 0, p[0], p[1] }
                     : Point{ p[0], p[1], -p[0] - p[1] };
    }
    SCOPED_TRACE("plane " + std::to_string(plane));
    const ReferenceHull wanted = cgalHull(cloud);
    EXPECT_EQ(wanted.dimension, 2);
    EXPECT_EQ(wanted.ids.size(), circle.size());
    expectHull(cloud, wanted);
  }
}

TEST(ConvexHullDegenerate, ManyCoplanarPoints)
{
  Random random(4);
  Cloud cloud;
  for (int i = 0; i < 60000; ++i)
  {
    const double x = random.integer(-2000, 2000);
    const double y = random.integer(-2000, 2000);
    cloud.push_back({ x, y, x - 2 * y + 11 });
  }
  const ReferenceHull wanted = cgalHull(cloud);
  EXPECT_EQ(wanted.dimension, 2);
  expectHull(cloud, wanted);
}

TEST(ConvexHullDegenerate, TetrahedronWithEverythingOnIt)
{
  // Points in edges, in facets, inside, and doubles of all; the corners are 3, 5, 8 and 9.
  const Cloud cloud = { { 1, 1, 1 }, { 2, 0, 0 }, { 1, 1, 0 }, { 4, 0, 0 }, { 2, 2, 0 },
    { 0, 4, 0 }, { 1, 1, 2 }, { 0.5, 0.5, 0.5 }, { 0, 0, 0 }, { 0, 0, 4 }, { 4, 0, 0 }, { 0, 0, 4 },
    { 1, 1, 1 }, { 0, 0, 0 } };
  expectCells(cloud, 3, { { 3, 5, 9 }, { 3, 8, 5 }, { 3, 9, 8 }, { 5, 8, 9 } });
}

TEST(ConvexHullDegenerate, CubeGrids)
{
  for (int side = 2; side <= 7; ++side)
  {
    const Cloud cloud = integerGrid(side);
    const std::int64_t x = side - 1;
    const std::int64_t y = side * x;
    const std::int64_t z = side * y;
    ReferenceHull wanted;
    wanted.dimension = 3;
    wanted.ids = { 0, x, y, x + y, z, x + z, y + z, x + y + z };
    wanted.cells = { { 0, x, x + z, z }, { 0, y, x + y, x }, { 0, z, y + z, y },
      { x, x + y, x + y + z, x + z }, { y, y + z, x + y + z, x + y },
      { z, x + z, x + y + z, y + z } };
    SCOPED_TRACE("side " + std::to_string(side));
    expectHull(cloud, wanted);
  }
}

TEST(ConvexHullDegenerate, LowestIdStandsForAll)
{
  // Copies of a cube's corners come before, between and after: the lowest id is the corner.
  Random random(6);
  for (int i = 0; i < 40; ++i)
  {
    const Cloud cloud = repeated(integerGrid(random.integer(2, 3)), random.integer(2, 6), random);
    const std::vector<std::int64_t> lowest = lowestIds(cloud);
    const Hull hull = convexHull(viewOf(cloud));
    ASSERT_EQ(hull.pointIds.size(), 8u) << "seed 6, case " << i;
    for (std::int64_t id : hull.pointIds)
    {
      EXPECT_EQ(lowest[id], id) << "seed 6, case " << i;
    }
    expectHull(cloud, bruteForceHull(cloud));
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

TEST(ConvexHullDegenerate, TheLowestIdStandsForManyDuplicates)
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

TEST(ConvexHullDegenerate, ManyPointsOnFewLinesAlongAnAxis)
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

TEST(ConvexHullDegenerate, RaisedByOneUlp)
{
  // A flat square with one inner point raised, or sunk, by one unit in the last place.
  for (double up : { 0x1p-52, -0x1p-53 })
  {
    const Cloud cloud = { { 0, 0, 1 }, { 4, 0, 1 }, { 4, 4, 1 }, { 0, 4, 1 }, { 1, 2, 1 + up } };
    const ReferenceHull wanted = bruteForceHull(cloud);
    EXPECT_EQ(wanted.dimension, 3);
    EXPECT_EQ(wanted.cells.size(), 5u);
    expectHull(cloud, wanted);
  }
}

TEST(ConvexHullDegenerate, NonFiniteIgnoredAtEveryRung)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const Cloud good = { { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const Cloud bad = { { nan, 0, 0 }, { 0, inf, 0 }, { 0, 0, -inf } };
  const std::vector<std::vector<Cell>> wanted = { {}, { { 1 } }, { { 1 } }, { { 1, 5 } },
    { { 1, 5, 6 } }, { { 1, 5, 7 }, { 1, 6, 5 }, { 1, 7, 6 }, { 5, 6, 7 } } };
  for (std::size_t n = 0; n <= good.size(); ++n)
  {
    // Ids count the ignored points too: one comes first, two after the second point.
    Cloud cloud = { bad[0] };
    for (std::size_t i = 0; i < n; ++i)
    {
      cloud.push_back(good[i]);
      if (i == 1)
      {
        cloud.push_back(bad[1]);
        cloud.push_back(bad[2]);
      }
    }
    Options options;
    options.facets = FacetMode::Polygons;
    options.nonFinite = NonFinitePolicy::Ignore;
    for (int threads : { 1, 2 })
    {
      options.threads = threads;
      const Hull hull = convexHull(viewOf(cloud), options);
      EXPECT_EQ(hull.dimension, n == 0 ? -1 : std::max(0, static_cast<int>(n) - 2));
      EXPECT_EQ(cellsOf(hull), wanted[n]);
      EXPECT_EQ(hull.statistics.nonFinite, n < 2 ? 1 : 3);
      EXPECT_EQ(hull.statistics.points, static_cast<std::int64_t>(cloud.size()));
      EXPECT_TRUE(validate(viewOf(cloud), hull));
    }
  }
}

}
}
}
