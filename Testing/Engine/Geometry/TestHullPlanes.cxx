// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is below all planes is inside, and what is certainly above one is: points about the border
/// are held to the planes exactly.
#include "Geometry/HullPlanes.h"
#include "Testing/Engine/Geometry/Solid.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/References/Exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// The farthest that a point is above a side: 1 outside, 0 on the border, -1 inside.
/// @param space the vertices, then the points
int sideOf(const FilteredSpace& space, const Polyhedron& polyhedron, std::size_t point)
{
  int most = -1;
  for (const Triangle& t : polyhedron.triangles)
  {
    most = std::max(most,
      space.orient(static_cast<int>(t.v[0]), static_cast<int>(t.v[1]), static_cast<int>(t.v[2]),
        static_cast<int>(polyhedron.vertexCount() + point)));
  }
  return most;
}

/// Points on sides, edges and at vertices, rounded, and beside them by a sixteenth of the box down
/// to a unit in the last place.
std::vector<Point> aboutTheBorder(const Solid& solid, Random& random)
{
  const Polyhedron& polyhedron = solid.polyhedron;
  std::vector<Point> points;
  for (const Triangle& t : polyhedron.triangles)
  {
    for (int i = 0; i < 24; ++i)
    {
      double share[3] = { random.uniform(0, 1), i % 3 ? random.uniform(0, 1) : 0,
        i % 4 ? random.uniform(0, 1) : 0 };
      const double sum = share[0] + share[1] + share[2];
      Point p = { 0, 0, 0 };
      for (int k = 0; k < 3; ++k)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          p[axis] += share[k] / sum * polyhedron.vertices[t.v[k]].x[axis];
        }
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double beside =
          i % 5 ? std::ldexp(random.uniform(-1, 1), -4 * random.integer(1, 13)) : 0;
        const double x = p[axis] + beside * (solid.range.high[axis] - solid.range.low[axis]);
        p[axis] = std::min(std::max(x, solid.range.low[axis]), solid.range.high[axis]);
      }
      points.push_back(p);
    }
  }
  return points;
}

struct Counts
{
  int inside = 0;
  int above = 0;
};

Counts check(const Cloud& cloud)
{
  Random random(97);
  const Solid solid = solidOf(cloud);
  const Polyhedron& polyhedron = solid.polyhedron;
  HullGeometry geometry(solid.range, Arithmetic());
  Point middle = { 0, 0, 0 };
  for (const Vertex& v : polyhedron.vertices)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      middle[i] += v.x[i] / polyhedron.vertexCount();
    }
  }
  geometry.setKernel(middle.data());
  const HullPlanes planes(geometry, polyhedron, solid.range);
  EXPECT_TRUE(planes.isReliable());
  std::vector<Point> points = aboutTheBorder(solid, random);
  for (const Vertex& v : polyhedron.vertices)
  {
    points.push_back({ v.x[0], v.x[1], v.x[2] });
  }
  Cloud all;
  for (const Vertex& v : polyhedron.vertices)
  {
    all.push_back({ v.x[0], v.x[1], v.x[2] });
  }
  all.insert(all.end(), points.begin(), points.end());
  const FilteredSpace space(all);
  Counts counts;
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const Point& p = points[n];
    double x[3][HullPlanes::Lanes] = {};
    for (std::size_t i = 0; i < 3; ++i)
    {
      x[i][0] = p[i];
    }
    double height[HullPlanes::Lanes];
    double plane[HullPlanes::Lanes];
    planes.highest(x[0], x[1], x[2], 1, height, plane);
    const int side = sideOf(space, polyhedron, n);
    if (planes.count() > 0 && planes.isAbove(height[0], static_cast<std::size_t>(plane[0])))
    {
      EXPECT_EQ(side, 1);
      ++counts.above;
    }
    if (height[0] < 0 && !planes.mayBeVertex(height[0], p.data()))
    {
      EXPECT_LE(side, 0);
      for (const Vertex& v : polyhedron.vertices)
      {
        EXPECT_FALSE(v.x[0] == p[0] && v.x[1] == p[1] && v.x[2] == p[2]);
      }
      ++counts.inside;
    }
    else if (height[0] <= 0)
    {
      EXPECT_LE(side, 0);
    }
  }
  return counts;
}

TEST(HullPlanes, WhatIsCertainIsTrue)
{
  const Cloud ball = fromFamily("shell0", 24, 94).make();
  struct Case
  {
    const char* name;
    Cloud cloud;
  };
  const Case cases[] = { { "tetrahedron", fromFamily("shell0", 4, 95).make() }, { "ball", ball },
    { "many", fromFamily("shell0", 120, 96).make() }, { "thin", scaled(ball, 1, 1e-7, 1) },
    { "thinner", scaled(ball, 1, 1e-14, 1e-5) }, { "far", moved(ball, 1e6, -3e5, 1e7) } };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.name);
    const Counts counts = check(c.cloud);
    EXPECT_GT(counts.inside, 0);
    EXPECT_GT(counts.above, 0);
  }
}

TEST(HullPlanes, SidesOfTheBoundingBoxAreLeftOut)
{
  // All of a box; of a prism two.
  const Cloud box = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 }, { 2, 3, 0 }, { 0, 0, 1 }, { 2, 0, 1 },
    { 0, 3, 1 }, { 2, 3, 1 } };
  const Counts ofBox = check(box);
  EXPECT_GT(ofBox.inside, 0);
  EXPECT_EQ(ofBox.above, 0);
  const Cloud octagon = { { 1, 0, 0 }, { 2, 0, 0 }, { 3, 1, 0 }, { 3, 2, 0 }, { 2, 3, 0 },
    { 1, 3, 0 }, { 0, 2, 0 }, { 0, 1, 0 }, { 1, 0, 4 }, { 2, 0, 4 }, { 3, 1, 4 }, { 3, 2, 4 },
    { 2, 3, 4 }, { 1, 3, 4 }, { 0, 2, 4 }, { 0, 1, 4 } };
  EXPECT_GT(check(octagon).inside, 0);
}

}

}
}
