// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is dismissed without a sign is inside: points as far out as the locator still dismisses
/// them, and points about the border below all planes, are held to the polyhedron exactly.
#include "Geometry/HullCones.h"
#include "Geometry/HullLocator.h"
#include "Geometry/HullPlanes.h"
#include "Surface/StarShape.h"
#include "Testing/Engine/Geometry/Solid.h"
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/References/Reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// The hull of a cloud.
struct Body
{
  explicit Body(const Cloud& cloud)
  {
    const ReferenceHull hull = cloud.size() <= 40 ? bruteForceHull(cloud) : cgalHull(cloud);
    for (const std::int64_t id : hull.ids)
    {
      this->surface.points.push_back(cloud[static_cast<std::size_t>(id)]);
    }
    const auto rank = [&](std::int64_t id)
    { return std::lower_bound(hull.ids.begin(), hull.ids.end(), id) - hull.ids.begin(); };
    for (const Cell& t : triangulate(hull.cells))
    {
      this->surface.triangles.push_back({ rank(t[0]), rank(t[1]), rank(t[2]) });
    }
    this->solid = solidOf(this->surface);
  }

  Point middle() const { return this->mix(std::vector<double>(this->surface.points.size(), 1)); }
  /// The mean of the vertices by these shares.
  Point mix(const std::vector<double>& shares) const
  {
    Point sum = { 0, 0, 0 };
    double total = 0;
    for (std::size_t v = 0; v < shares.size(); ++v)
    {
      total += shares[v];
      for (std::size_t k = 0; k < 3; ++k)
      {
        sum[k] += shares[v] * this->surface.points[v][k];
      }
    }
    return times(sum, 1 / total);
  }

  /// How far each is above a side: 1 outside, 0 on the border, -1 inside.
  std::vector<int> sidesOf(const Cloud& places) const
  {
    const Cloud all = joined(this->surface.points, places);
    const FilteredSpace space(all);
    std::vector<int> sides(places.size(), -1);
    for (std::size_t n = 0; n < places.size(); ++n)
    {
      for (const Corners& t : this->surface.triangles)
      {
        sides[n] = std::max(sides[n],
          space.orient(static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2]),
            static_cast<int>(this->surface.points.size() + n)));
      }
    }
    return sides;
  }

  Surface surface;
  Solid solid;
};

struct Named
{
  const char* name;
  Cloud cloud;
};

std::vector<Named> bodies()
{
  const Cloud ball = fromFamily("shell0", 24, 94).make();
  return { { "tetrahedron", fromFamily("shell0", 4, 95).make() }, { "ball", ball },
    { "many", fromFamily("shell0", 120, 96).make() }, { "thin", scaled(ball, 1, 1e-7, 1) },
    { "thinner", scaled(ball, 1, 1e-14, 1e-5) }, { "far", moved(ball, 1e6, -3e5, 1e7) } };
}

/// Along the diagonal, or all but at right angles to it.
Cloud alongDiagonal(const Cloud& cloud, double along, double across)
{
  Cloud result;
  for (const Point& p : cloud)
  {
    const double mean = (p[0] + p[1] + p[2]) / 3;
    Point q;
    for (std::size_t k = 0; k < 3; ++k)
    {
      q[k] = along * mean + across * (p[k] - mean);
    }
    result.push_back(q);
  }
  return result;
}

/// How near the limits came to the border.
struct Seen
{
  int kernels = 0;
  int dismissed = 0; ///< directions in which something is
  int tight = 0;     ///< of these, where what is little farther is outside
};

/// All around, on the corners of the locator's cells and a little to their sides.
Cloud directionsAround(const Body& body, Random& random)
{
  Cloud directions;
  for (int face = 0; face < 6; ++face)
  {
    for (int i = 0; i <= 8; ++i)
    {
      for (int j = 0; j <= 8; ++j)
      {
        const auto axis = static_cast<std::size_t>(face / 2);
        Point d;
        d[axis] = face % 2 ? -1.0 : 1.0;
        const double aside = (i + j) % 2 ? 0.0 : random.uniform(-4e-7, 4e-7);
        d[(axis + 1) % 3] = 0.25 * i - 1 + aside;
        d[(axis + 2) % 3] = 0.25 * j - 1 - aside;
        for (std::size_t k = 0; k < 3; ++k)
        {
          // Half the cube's side, whose grid has its corners at multiples of an eighth.
          d[k] *= std::ldexp(1.0, std::ilogb(body.solid.range.high[k] - body.solid.range.low[k]));
        }
        directions.push_back(d);
      }
    }
  }
  return directions;
}

/// In each direction, the farthest point that is dismissed is inside.
void expectInside(const Body& body, const Point& kernel, const Cloud& directions, Seen& seen)
{
  const Polyhedron& p = body.solid.polyhedron;
  HullGeometry geometry(body.solid.range, Arithmetic());
  geometry.setKernel(kernel.data());
  if (findStarFault(geometry, p).count)
  {
    return; // rounded onto the border
  }
  ++seen.kernels;
  const Options options;
  Monitor monitor(options);
  const HullLocator locator(
    geometry, p.triangles.data(), p.triangleCount(), p.vertices.data(), monitor);
  HullLocator::Block block;
  const auto at = [&](const Point& d, double t) {
    return Point{ kernel[0] + t * d[0], kernel[1] + t * d[1], kernel[2] + t * d[2] };
  };
  const auto isDismissed = [&](const Point& x)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      block.x[i][0] = x[i];
    }
    locator.classify(block, 1);
    return block.inside[0] != 0;
  };
  Cloud farthest;
  Cloud beyond;
  for (const Point& d : directions)
  {
    double in = 0;
    double out = 2;
    // Down to a limit that may be many powers of two away.
    for (double t = 1; t > 1e-40 && in == 0; t *= 0.5)
    {
      in = isDismissed(at(d, t)) ? t : 0;
      out = in == 0 ? t : out;
    }
    for (int step = 0; step < 30 && in > 0; ++step)
    {
      const double t = 0.5 * (in + out);
      (isDismissed(at(d, t)) ? in : out) = t;
    }
    if (in > 0)
    {
      farthest.push_back(at(d, in));
      beyond.push_back(at(d, 1.0001 * in));
    }
  }
  seen.dismissed += static_cast<int>(farthest.size());
  const std::vector<int> sides = body.sidesOf(farthest);
  EXPECT_EQ(std::count(sides.begin(), sides.end(), -1), static_cast<std::ptrdiff_t>(sides.size()))
    << "dismissed, but not inside";
  const std::vector<int> sidesBeyond = body.sidesOf(beyond);
  seen.tight += static_cast<int>(std::count(sidesBeyond.begin(), sidesBeyond.end(), 1));
}

TEST(HullLocator, DismissesOnlyWhatIsInside)
{
  constexpr std::uint64_t Seed = 93;
  Random random(Seed);
  const Cloud ball = fromFamily("shell0", 24, 94).make();
  std::vector<Named> all = bodies();
  all.push_back({ "plate", alongDiagonal(ball, 1e-6, 1) });
  // The depths are near what rounding leaves, and walks to a cone err.
  for (const double width : { 1e-3, 1e-5, 1e-6 })
  {
    all.push_back({ "needle", alongDiagonal(ball, 1, width) });
  }
  int tight = 0;
  for (const Named& of : all)
  {
    SCOPED_TRACE(of.name + (", seed " + std::to_string(Seed)));
    const Body body(of.cloud);
    const Point middle = body.middle();
    // In the middle, and nearer and nearer to a corner, an edge and a facet.
    Seen seen;
    const Corners& corner = body.surface.triangles[body.surface.triangles.size() / 2];
    Cloud kernels = { middle };
    for (const double near : { 1e-2, 1e-5, 1e-8, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15 })
    {
      std::vector<double> shares(body.surface.points.size(), 0);
      for (std::size_t corners = 0; corners < 3; ++corners)
      {
        shares[static_cast<std::size_t>(corner[corners])] = 1;
        const Point border = body.mix(shares);
        Point kernel;
        for (std::size_t k = 0; k < 3; ++k)
        {
          kernel[k] = border[k] + near * (middle[k] - border[k]);
        }
        kernels.push_back(kernel);
      }
    }
    for (const Point& kernel : kernels)
    {
      Cloud directions = directionsAround(body, random);
      for (const Point& p : body.surface.points)
      {
        directions.push_back({ p[0] - kernel[0], p[1] - kernel[1], p[2] - kernel[2] });
      }
      expectInside(body, kernel, directions, seen);
    }
    EXPECT_GT(seen.kernels, 5);
    EXPECT_GT(seen.dismissed, 0);
    tight += seen.tight;
  }
  EXPECT_GT(tight, 0);
}

TEST(HullLocator, DismissesOnlyWhatIsInsideWhereWalksErr)
{
  // Needles so thin that the cones around their tip are hardly told apart: what counts for the
  // negative coefficients decides.
  constexpr std::uint64_t Seed = 97;
  Random random(Seed);
  Seen seen;
  for (int needle = 0; needle < 400; ++needle)
  {
    const double width = std::pow(10, random.uniform(-6.8, -5));
    const Body body(generate(8,
      [&](int i)
      {
        const double along = i < 4 ? random.uniform(-1, 1) : (i % 2 ? 1 : -1);
        const Point p = inCube(random, -width, width);
        return Point{ along + p[0], along + p[1], along + p[2] };
      }));
    for (int i = 0; i < 10; ++i)
    {
      SCOPED_TRACE("needle " + std::to_string(needle) + ", kernel " + std::to_string(i));
      std::vector<double> shares(body.surface.points.size());
      std::generate(
        shares.begin(), shares.end(), [&] { return std::pow(random.uniform(0, 1), 3); });
      expectInside(body, body.mix(shares), { { 1, 1, 1 }, { -1, -1, -1 } }, seen);
    }
  }
  EXPECT_GT(seen.dismissed, 1000);
}

/// Points on sides, edges and at vertices, rounded, and beside them by a sixteenth of the box down
/// to a unit in the last place.
Cloud aboutTheBorder(const Body& body, Random& random)
{
  const CoordinateRange& range = body.solid.range;
  Cloud points = body.surface.points;
  for (const Corners& t : body.surface.triangles)
  {
    for (int i = 0; i < 24; ++i)
    {
      std::vector<double> shares(body.surface.points.size(), 0);
      shares[static_cast<std::size_t>(t[0])] = random.uniform(0, 1);
      shares[static_cast<std::size_t>(t[1])] = i % 3 ? random.uniform(0, 1) : 0;
      shares[static_cast<std::size_t>(t[2])] = i % 4 ? random.uniform(0, 1) : 0;
      Point p = body.mix(shares);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double beside =
          i % 5 ? std::ldexp(random.uniform(-1, 1), -4 * random.integer(1, 13)) : 0;
        const double x = p[axis] + beside * (range.high[axis] - range.low[axis]);
        p[axis] = std::min(std::max(x, range.low[axis]), range.high[axis]);
      }
      points.push_back(p);
    }
  }
  return points;
}

/// What is below all planes is inside, and what is certainly above one is outside.
/// @return whether there are points below all, and points above one
std::pair<bool, bool> checkPlanes(const Cloud& cloud)
{
  Random random(97);
  const Body body(cloud);
  HullGeometry geometry(body.solid.range, Arithmetic());
  geometry.setKernel(body.middle().data());
  const HullPlanes planes(geometry, body.solid.polyhedron, body.solid.range);
  EXPECT_TRUE(planes.isReliable());
  const Cloud points = aboutTheBorder(body, random);
  const std::vector<int> sides = body.sidesOf(points);
  std::pair<bool, bool> seen = { false, false };
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    double x[3][HullPlanes::Lanes] = {};
    for (std::size_t i = 0; i < 3; ++i)
    {
      x[i][0] = points[n][i];
    }
    double height[HullPlanes::Lanes];
    double plane[HullPlanes::Lanes];
    planes.highest(x[0], x[1], x[2], 1, height, plane);
    if (planes.count() > 0 && planes.isAbove(height[0], static_cast<std::size_t>(plane[0])))
    {
      EXPECT_EQ(sides[n], 1);
      seen.second = true;
    }
    if (height[0] < 0 && !planes.mayBeVertex(height[0], points[n].data()))
    {
      const Cloud& vertices = body.surface.points;
      EXPECT_EQ(std::count(vertices.begin(), vertices.end(), points[n]), 0);
      seen.first = true;
    }
    if (height[0] <= 0)
    {
      EXPECT_LE(sides[n], 0);
    }
  }
  return seen;
}

TEST(HullPlanes, WhatIsCertainIsTrue)
{
  for (const Named& of : bodies())
  {
    SCOPED_TRACE(of.name);
    EXPECT_EQ(checkPlanes(of.cloud), std::make_pair(true, true));
  }
  // Sides of the bounding box are left out: all of a box; of a prism two.
  EXPECT_EQ(checkPlanes(scaled(integerGrid(2), 2, 3, 1)), std::make_pair(true, false));
  Cloud octagon;
  for (const double z : { 0.0, 4.0 })
  {
    octagon = joined(octagon,
      { { 1, 0, z }, { 2, 0, z }, { 3, 1, z }, { 3, 2, z }, { 2, 3, z }, { 1, 3, z }, { 0, 2, z },
        { 0, 1, z } });
  }
  EXPECT_TRUE(checkPlanes(octagon).first);
}

}
}
}
