// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces that Flip-Flop must refuse, and how it says so.
#include "Testing/Engine/Surface/FlipFlopChecks.h"

#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

const double origin[3] = { 0, 0, 0 };

struct Found
{
  bool thrown = false;
  ErrorCode code = ErrorCode::Aborted;
  std::int64_t index = -2;
  std::int64_t count = -2;
};

Found run(const PointView& points, const TriangleView& triangles, const double* kernel,
  const Options& options = Options())
{
  Found found;
  try
  {
    convexify(points, triangles, kernel, options);
  }
  catch (const Error& error)
  {
    found = { true, error.code(), error.index(), error.count() };
  }
  return found;
}

/// The same refusal on 1 and 2 threads, from outside and turned inward; -2: any.
void expectRefusal(const Surface& surface, const double* kernel, ErrorCode code,
  std::int64_t index = -2, std::int64_t count = -2)
{
  for (const Surface& s : { surface, reversed(surface) })
  {
    for (int threads : { 1, 2 })
    {
      Options options;
      options.threads = threads;
      const Found found = run(viewOf(s.points), s.view(), kernel, options);
      ASSERT_TRUE(found.thrown) << "taken for good; wanted: " << Error(code).what();
      EXPECT_EQ(found.code, code) << Error(found.code).what() << "; wanted: " << Error(code).what();
      if (index != -2)
      {
        EXPECT_EQ(found.index, index);
      }
      if (count != -2)
      {
        EXPECT_EQ(found.count, count);
      }
    }
  }
}

Surface tetrahedron(double shift = 0)
{
  Surface surface;
  surface.points = { { -1, -1, -1 }, { 3, -1, -1 }, { -1, 3, -1 }, { -1, -1, 3 } };
  surface.points = moved(surface.points, shift, 0, 0);
  surface.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  return surface;
}

TEST(FlipFlopErrors, TheGoodTetrahedronIsTaken)
{
  EXPECT_FALSE(codeOf(tetrahedron(), origin).has_value());
  EXPECT_FALSE(codeOf(tetrahedron(), nullptr).has_value());
}

TEST(FlipFlopErrors, BadTriangle)
{
  for (std::int64_t bad :
    { std::int64_t(-1), std::int64_t(42), std::int64_t(1) << 32, std::int64_t(1) << 33 | 3,
      std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max() })
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      Surface surface = icosphere(1);
      ASSERT_EQ(surface.points.size(), 42u);
      surface.triangles[7][corner] = bad;
      expectRefusal(surface, origin, ErrorCode::BadTriangle, 7, 1);
      surface.triangles[70][corner] = surface.triangles[70][(corner + 1) % 3];
      expectRefusal(surface, origin, ErrorCode::BadTriangle, 7, 2);
    }
  }
}

TEST(FlipFlopErrors, NotClosed)
{
  for (std::size_t missing : { std::size_t(0), std::size_t(13), std::size_t(79) })
  {
    Surface surface = icosphere(1);
    const Corners gone = surface.triangles[missing];
    surface.triangles.erase(surface.triangles.begin() + static_cast<std::ptrdiff_t>(missing));
    // The first triangle with two corners of the missing one.
    std::int64_t first = -1;
    for (std::size_t t = 0; t < surface.triangles.size() && first < 0; ++t)
    {
      int shared = 0;
      for (std::int64_t v : surface.triangles[t])
      {
        shared += v == gone[0] || v == gone[1] || v == gone[2];
      }
      first = shared == 2 ? static_cast<std::int64_t>(t) : -1;
    }
    expectRefusal(surface, origin, ErrorCode::NotClosed, first, 3);
    expectRefusal(surface, nullptr, ErrorCode::NotClosed, first, 3);
  }
  Surface lone;
  lone.points = tetrahedron().points;
  lone.triangles = { { 0, 1, 2 } };
  expectRefusal(lone, origin, ErrorCode::NotClosed, 0, 3);
}

TEST(FlipFlopErrors, NotManifoldAtAnEdge)
{
  // Two tetrahedra on one edge: four triangles share it.
  Surface surface;
  surface.points = { { 0, 0, -1 }, { 0, 0, 1 }, { 2, 1, 0 }, { 2, -1, 0 }, { -2, 1, 0 },
    { -2, -1, 0 } };
  surface.triangles = { { 0, 1, 3 }, { 1, 0, 2 }, { 0, 3, 2 }, { 1, 2, 3 }, { 0, 1, 4 },
    { 1, 0, 5 }, { 0, 4, 5 }, { 1, 5, 4 } };
  const double kernel[3] = { 1, 0, 0 };
  expectRefusal(surface, kernel, ErrorCode::NotManifold, 0);
  expectRefusal(surface, nullptr, ErrorCode::NotManifold, 0);
}

TEST(FlipFlopErrors, NotManifoldWhereATriangleIsTwice)
{
  Surface surface = tetrahedron();
  surface.triangles.push_back(surface.triangles[3]);
  surface.triangles.push_back(surface.triangles[3]);
  expectRefusal(surface, origin, ErrorCode::NotManifold, 0);
}

TEST(FlipFlopErrors, NotManifoldAtAVertex)
{
  // Two tetrahedra that touch in one vertex, each closed by itself.
  Surface surface = together(tetrahedron(), tetrahedron(8));
  for (Corners& t : surface.triangles)
  {
    for (std::int64_t& v : t)
    {
      v = v == 4 ? 1 : v;
    }
  }
  expectRefusal(surface, origin, ErrorCode::NotManifold, 0, 1);
  expectRefusal(surface, nullptr, ErrorCode::NotManifold, 0, 1);
}

TEST(FlipFlopErrors, NotOriented)
{
  for (std::size_t turned = 0; turned < 4; ++turned)
  {
    Surface surface = tetrahedron();
    std::swap(surface.triangles[turned][0], surface.triangles[turned][1]);
    // All four are neighbours of the turned one.
    expectRefusal(surface, origin, ErrorCode::NotOriented, 0);
    expectRefusal(surface, nullptr, ErrorCode::NotOriented, 0);
  }
  Surface sphere = icosphere(2);
  std::swap(sphere.triangles[100][1], sphere.triangles[100][2]);
  std::int64_t first = 100;
  for (std::size_t t = 0; t < 100; ++t)
  {
    int shared = 0;
    for (std::int64_t v : sphere.triangles[t])
    {
      for (std::int64_t w : sphere.triangles[100])
      {
        shared += v == w;
      }
    }
    if (shared == 2)
    {
      first = static_cast<std::int64_t>(t);
      break;
    }
  }
  expectRefusal(sphere, origin, ErrorCode::NotOriented, first);
}

TEST(FlipFlopErrors, NotSeenFromAWrongKernel)
{
  const Surface sphere = icosphere(2);
  const double outside[][3] = { { 5, 0, 0 }, { 0, 1.01, 0 }, { 0.6, 0.6, 0.6 }, { 0, 0, -1e300 } };
  for (const auto& kernel : outside)
  {
    const std::vector<std::int64_t> bad = unseen(sphere, kernel);
    ASSERT_FALSE(bad.empty());
    if (2 * bad.size() < sphere.triangles.size())
    {
      expectRefusal(
        sphere, kernel, ErrorCode::NotStarShaped, bad[0], static_cast<std::int64_t>(bad.size()));
    }
    else
    {
      expectRefusal(sphere, kernel, ErrorCode::NotStarShaped);
    }
  }
}

TEST(FlipFlopErrors, NotStrictlySeen)
{
  // On a facet's plane, on an edge, at a vertex.
  const double onFacet[3] = { 0, 0, -1 };
  const std::vector<std::int64_t> bad = unseen(tetrahedron(), onFacet);
  ASSERT_EQ(bad, (std::vector<std::int64_t>{ 0 }));
  expectRefusal(tetrahedron(), onFacet, ErrorCode::NotStarShaped, 0, 1);
  const double onEdge[3] = { 0, -1, -1 };
  expectRefusal(tetrahedron(), onEdge, ErrorCode::NotStarShaped, 0, 2);
  const double atVertex[3] = { -1, -1, 3 };
  expectRefusal(tetrahedron(), atVertex, ErrorCode::NotStarShaped, 1, 3);
  // Inside by the least that a double can say, outside by the same.
  const double above[3] = { 0, 0, -1 + 0x1p-53 };
  EXPECT_FALSE(codeOf(tetrahedron(), above).has_value());
  const double below[3] = { 0, 0, -1 - 0x1p-52 };
  expectRefusal(tetrahedron(), below, ErrorCode::NotStarShaped, 0, 1);
}

TEST(FlipFlopErrors, NotStarShapedAtAll)
{
  const Surface ring = torus(12, 8);
  expectRefusal(ring, origin, ErrorCode::NotStarShaped);
  expectRefusal(ring, nullptr, ErrorCode::NoKernel);
  // A sphere with one vertex pushed through the other side.
  Surface sphere = icosphere(1);
  for (double& x : sphere.points[0])
  {
    x *= -3;
  }
  expectRefusal(sphere, origin, ErrorCode::NotStarShaped);
  expectRefusal(sphere, nullptr, ErrorCode::NoKernel);
}

TEST(FlipFlopErrors, WoundTwice)
{
  // Every triangle is seen from inside, every edge is sound; the cones overlap all the same.
  for (int windings : { 2, 3, 5 })
  {
    for (int sides : { 3, 5, 8, 40 })
    {
      SCOPED_TRACE(std::to_string(sides) + " sides, wound " + std::to_string(windings));
      const Surface surface = wound(sides, windings);
      ASSERT_TRUE(seesAll(surface, origin));
      expectRefusal(surface, origin, ErrorCode::NotStarShaped);
      const std::optional<ErrorCode> code = codeOf(surface, nullptr);
      ASSERT_TRUE(code.has_value());
      EXPECT_TRUE(code == ErrorCode::NotStarShaped || code == ErrorCode::NoKernel);
    }
  }
  EXPECT_FALSE(codeOf(wound(5, 1), origin).has_value());
}

TEST(FlipFlopErrors, FarFromTheOrigin)
{
  // What is not star-shaped is told apart as well where the coordinates dwarf the surface.
  const double far = 0x1p27;
  const double kernel[3] = { far, -far, far };
  const auto moved = [&kernel](Surface surface)
  {
    for (Point& p : surface.points)
    {
      for (int i = 0; i < 3; ++i)
      {
        p[i] += kernel[i];
      }
    }
    return surface;
  };
  for (int windings : { 2, 3 })
  {
    const Surface surface = moved(wound(8, windings));
    ASSERT_TRUE(seesAll(surface, kernel));
    expectRefusal(surface, kernel, ErrorCode::NotStarShaped);
  }
  EXPECT_FALSE(codeOf(moved(wound(8, 1)), kernel).has_value());
  EXPECT_FALSE(codeOf(moved(icosphere(2)), kernel).has_value());
  EXPECT_FALSE(codeOf(moved(icosphere(2)), nullptr).has_value());
}

TEST(FlipFlopErrors, OneInsideTheOther)
{
  // Two surfaces, each star-shaped from the same point: together they cover all twice.
  Surface inner = icosphere(1);
  inner.points = scaled(inner.points, 0.5, 0.5, 0.5);
  const Surface both = together(icosphere(1), inner);
  ASSERT_TRUE(seesAll(both, origin));
  expectRefusal(both, origin, ErrorCode::NotStarShaped);
  const std::optional<ErrorCode> code = codeOf(both, nullptr);
  ASSERT_TRUE(code.has_value());
  EXPECT_TRUE(code == ErrorCode::NotStarShaped || code == ErrorCode::NoKernel);
}

TEST(FlipFlopErrors, SideBySide)
{
  const Surface both = together(tetrahedron(), tetrahedron(20));
  expectRefusal(both, origin, ErrorCode::NotStarShaped);
  expectRefusal(both, nullptr, ErrorCode::NoKernel);
}

TEST(FlipFlopErrors, Flat)
{
  // Closed, oriented, a manifold, and no inside at all.
  Surface surface = tetrahedron();
  surface.points[3] = { 0.25, 0.25, -1 };
  expectRefusal(surface, origin, ErrorCode::NotStarShaped);
  expectRefusal(surface, nullptr, ErrorCode::NoKernel);
  Surface pillow;
  pillow.points = tetrahedron().points;
  pillow.triangles = { { 0, 1, 2 }, { 0, 2, 1 } };
  expectRefusal(pillow, origin, ErrorCode::NotStarShaped);
  expectRefusal(pillow, nullptr, ErrorCode::NoKernel);
}

TEST(FlipFlopErrors, TwoVerticesAtOnePosition)
{
  // A triangle without area is seen from nowhere.
  Surface surface = icosphere(0);
  surface.points[surface.triangles[4][0]] = surface.points[surface.triangles[4][1]];
  expectRefusal(surface, origin, ErrorCode::NotStarShaped);
  expectRefusal(surface, nullptr, ErrorCode::NoKernel);
}

TEST(FlipFlopErrors, NonFinite)
{
  Surface surface = icosphere(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  surface.points[60][1] = nan;
  surface.points[33] = { nan, -std::numeric_limits<double>::infinity(), 0 };
  expectRefusal(surface, origin, ErrorCode::NonFinite, 33, 2);
  expectRefusal(surface, nullptr, ErrorCode::NonFinite, 33, 2);
  // A vertex cannot be left out of a surface.
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  EXPECT_TRUE(run(viewOf(surface.points), surface.view(), origin, options).thrown);
}

TEST(FlipFlopErrors, UnusedNonFinitePointsDoNotCount)
{
  Surface surface = icosphere(1);
  const std::size_t before = surface.points.size();
  surface.points.push_back(Point{ std::numeric_limits<double>::quiet_NaN(), 0, 0 });
  const Hull hull = convexify(viewOf(surface.points), surface.view(), origin);
  EXPECT_EQ(hull.pointIds.size(), before);
}

TEST(FlipFlopErrors, BadKernel)
{
  for (double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    const double kernel[3] = { 0, bad, 0 };
    EXPECT_TRUE(codeOf(icosphere(1), kernel).has_value());
  }
}

TEST(FlipFlopErrors, BadArguments)
{
  const Surface surface = icosphere(1);
  TriangleView triangles = surface.view();
  triangles.corners = nullptr;
  EXPECT_EQ(run(viewOf(surface.points), triangles, origin).code, ErrorCode::BadArgument);
  triangles = surface.view();
  triangles.count = -1;
  EXPECT_EQ(run(viewOf(surface.points), triangles, origin).code, ErrorCode::BadArgument);
}

TEST(FlipFlopErrors, NothingAtAll)
{
  // No triangle is no polyhedron: the hull of no point, or a refusal, never a crash.
  const Cloud points = integerGrid(2);
  try
  {
    const Hull hull = convexify(viewOf(points), TriangleView(), origin);
    EXPECT_EQ(hull.dimension, -1);
    EXPECT_TRUE(hull.pointIds.empty());
  }
  catch (const Error& error)
  {
    EXPECT_NE(error.code(), ErrorCode::Aborted);
  }
}

}
}
}
