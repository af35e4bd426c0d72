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

const Point origin = { 0, 0, 0 };

void convexifyAny(const Surface& surface, const double* kernel, int threads = 1)
{
  Options options;
  options.threads = threads;
  convexify(viewOf(surface.points), surface.view(), kernel, options);
}

/// The same refusal on 1 and 2 threads, from outside and turned inward; -2: any. Without a kernel
/// point that is NoKernel for what is not star-shaped, and the same for what is broken.
void expectRefusal(const Surface& surface, const Point& kernel, ErrorCode code,
  std::int64_t index = -2, std::int64_t count = -2)
{
  const bool isBroken = code != ErrorCode::NotStarShaped;
  for (const Surface& s : { surface, reversed(surface) })
  {
    for (const int threads : { 1, 2 })
    {
      expectError([&] { convexifyAny(s, kernel.data(), threads); }, code, index, count);
      if (isBroken)
      {
        expectError([&] { convexifyAny(s, nullptr, threads); }, code, index, count);
      }
    }
  }
}

/// From no point.
void expectNoKernel(const Surface& surface)
{
  expectRefusal(surface, origin, ErrorCode::NotStarShaped);
  expectError([&] { convexifyAny(surface, nullptr); }, ErrorCode::NoKernel);
}

void expectTaken(const Surface& surface, const Point& kernel = origin)
{
  EXPECT_NO_THROW(convexifyAny(surface, kernel.data()));
  EXPECT_NO_THROW(convexifyAny(surface, nullptr));
}

Surface tetrahedron(double shift = 0)
{
  Surface surface;
  surface.points = { { -1, -1, -1 }, { 3, -1, -1 }, { -1, 3, -1 }, { -1, -1, 3 } };
  surface.points = moved(surface.points, shift, 0, 0);
  surface.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  return surface;
}

/// The first triangle with two corners of that one, itself included.
std::int64_t firstNeighbour(const Surface& surface, const Corners& of)
{
  const auto shares = [&](const Corners& t)
  {
    return std::count_if(t.begin(), t.end(),
             [&](std::int64_t v) { return std::count(of.begin(), of.end(), v) > 0; }) >= 2;
  };
  return std::find_if(surface.triangles.begin(), surface.triangles.end(), shares) -
    surface.triangles.begin();
}

TEST(FlipFlopErrors, BadTriangle)
{
  using Limits = std::numeric_limits<std::int64_t>;
  for (const std::int64_t bad : { std::int64_t(-1), std::int64_t(42), std::int64_t(1) << 32,
         std::int64_t(1) << 33 | 3, Limits::min(), Limits::max() })
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
  for (const std::ptrdiff_t missing : { 0, 13, 79 })
  {
    Surface surface = icosphere(1);
    const Corners gone = surface.triangles[static_cast<std::size_t>(missing)];
    surface.triangles.erase(surface.triangles.begin() + missing);
    expectRefusal(surface, origin, ErrorCode::NotClosed, firstNeighbour(surface, gone), 3);
  }
  Surface lone = tetrahedron();
  lone.triangles = { { 0, 1, 2 } };
  expectRefusal(lone, origin, ErrorCode::NotClosed, 0, 3);
}

TEST(FlipFlopErrors, NotManifold)
{
  // Two tetrahedra on one edge: four triangles share it.
  Surface edge;
  edge.points = { { 0, 0, -1 }, { 0, 0, 1 }, { 2, 1, 0 }, { 2, -1, 0 }, { -2, 1, 0 },
    { -2, -1, 0 } };
  edge.triangles = { { 0, 1, 3 }, { 1, 0, 2 }, { 0, 3, 2 }, { 1, 2, 3 }, { 0, 1, 4 }, { 1, 0, 5 },
    { 0, 4, 5 }, { 1, 5, 4 } };
  expectRefusal(edge, { 1, 0, 0 }, ErrorCode::NotManifold, 0);
  // A triangle three times.
  Surface triple = tetrahedron();
  triple.triangles.insert(triple.triangles.end(), 2, triple.triangles[3]);
  expectRefusal(triple, origin, ErrorCode::NotManifold, 0);
  // One more on an edge: its two others are open.
  Surface fin = tetrahedron();
  fin.points.push_back({ 0, 0, 9 });
  fin.triangles.push_back({ 0, 1, 4 });
  expectRefusal(fin, origin, ErrorCode::NotManifold, -2, 1);
  // Two tetrahedra that touch in one vertex, each closed by itself.
  Surface vertex = together(tetrahedron(), tetrahedron(8));
  for (Corners& t : vertex.triangles)
  {
    std::replace(t.begin(), t.end(), std::int64_t(4), std::int64_t(1));
  }
  expectRefusal(vertex, origin, ErrorCode::NotManifold, 0, 1);
}

TEST(FlipFlopErrors, NotOriented)
{
  for (const Surface& whole : { tetrahedron(), icosphere(2) })
  {
    for (const std::size_t turned : { std::size_t(0), whole.triangles.size() - 1 })
    {
      Surface surface = whole;
      std::swap(surface.triangles[turned][0], surface.triangles[turned][1]);
      expectRefusal(surface, origin, ErrorCode::NotOriented,
        firstNeighbour(surface, surface.triangles[turned]));
    }
  }
}

TEST(FlipFlopErrors, NotSeenFromAWrongKernel)
{
  const Surface sphere = icosphere(2);
  for (const Point& kernel :
    { Point{ 5, 0, 0 }, Point{ 0, 1.01, 0 }, Point{ 0.6, 0.6, 0.6 }, Point{ 0, 0, -1e300 } })
  {
    const std::vector<std::int64_t> bad = unseen(sphere, kernel);
    ASSERT_FALSE(bad.empty());
    const bool isMinority = 2 * bad.size() < sphere.triangles.size(); // else the others are named
    expectRefusal(sphere, kernel, ErrorCode::NotStarShaped, isMinority ? bad[0] : -2,
      isMinority ? static_cast<std::int64_t>(bad.size()) : -2);
  }
  // On a facet's plane, on an edge, at a vertex; outside by the least that a double can say.
  const Surface solid = tetrahedron();
  expectRefusal(solid, { 0, 0, -1 }, ErrorCode::NotStarShaped, 0, 1);
  expectRefusal(solid, { 0, -1, -1 }, ErrorCode::NotStarShaped, 0, 2);
  expectRefusal(solid, { -1, -1, 3 }, ErrorCode::NotStarShaped, 1, 3);
  expectRefusal(solid, { 0, 0, -1 - 0x1p-52 }, ErrorCode::NotStarShaped, 0, 1);
  expectTaken(solid, { 0, 0, -1 + 0x1p-53 });
}

TEST(FlipFlopErrors, NotStarShapedAtAll)
{
  expectNoKernel(torus(12, 8));
  // A sphere with one vertex pushed through the other side.
  Surface sphere = icosphere(1);
  sphere.points[0] = { -3 * sphere.points[0][0], -3 * sphere.points[0][1],
    -3 * sphere.points[0][2] };
  expectNoKernel(sphere);
  expectNoKernel(together(tetrahedron(), tetrahedron(20)));
  // Closed, oriented, a manifold, and no inside at all.
  Surface flat = tetrahedron();
  flat.points[3] = { 0.25, 0.25, -1 };
  expectNoKernel(flat);
  flat.triangles = { { 0, 1, 2 }, { 0, 2, 1 } };
  expectNoKernel(flat);
  // A triangle without area is seen from nowhere.
  Surface pinched = icosphere(0);
  pinched.points[pinched.triangles[4][0]] = pinched.points[pinched.triangles[4][1]];
  expectNoKernel(pinched);
}

TEST(FlipFlopErrors, WoundTwice)
{
  // Every triangle is seen from inside, every edge is sound; the cones overlap all the same. Also
  // where the coordinates dwarf the surface.
  const Point far = { 0x1p27, -0x1p27, 0x1p27 };
  for (const Point& middle : { origin, far })
  {
    const auto at = [&](Surface surface)
    {
      surface.points = moved(surface.points, middle[0], middle[1], middle[2]);
      return surface;
    };
    const auto expectOverlap = [&](const Surface& surface)
    {
      ASSERT_TRUE(seesAll(surface, middle));
      expectRefusal(surface, middle, ErrorCode::NotStarShaped);
      try
      {
        convexifyAny(surface, nullptr);
        ADD_FAILURE() << "taken for good";
      }
      catch (const Error& error)
      {
        EXPECT_TRUE(
          error.code() == ErrorCode::NotStarShaped || error.code() == ErrorCode::NoKernel);
      }
    };
    for (const int windings : { 2, 3, 5 })
    {
      for (const int sides : { 3, 8, 40 })
      {
        SCOPED_TRACE(std::to_string(sides) + " sides, wound " + std::to_string(windings));
        expectOverlap(at(wound(sides, windings)));
      }
    }
    // Two surfaces, each star-shaped from the same point.
    Surface inner = icosphere(1);
    inner.points = scaled(inner.points, 0.5, 0.5, 0.5);
    expectOverlap(at(together(icosphere(1), inner)));
    expectTaken(at(wound(5, 1)), middle);
    expectTaken(at(icosphere(2)), middle);
  }
}

TEST(FlipFlopErrors, NonFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Surface surface = icosphere(2);
  surface.points[60][1] = nan;
  surface.points[33] = { nan, -std::numeric_limits<double>::infinity(), 0 };
  expectRefusal(surface, origin, ErrorCode::NonFinite, 33, 2);
  // A vertex cannot be left out of a surface.
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  expectError([&] { convexify(viewOf(surface.points), surface.view(), &origin[0], options); },
    ErrorCode::NonFinite, 33, 2);
  // Unused points do not count.
  Surface sphere = icosphere(1);
  sphere.points.push_back({ nan, 0, 0 });
  expectTaken(sphere);
  for (const double bad : { nan, std::numeric_limits<double>::infinity() })
  {
    const double kernel[3] = { 0, bad, 0 };
    EXPECT_THROW(convexifyAny(icosphere(1), kernel), Error);
  }
}

TEST(FlipFlopErrors, BadArguments)
{
  const Surface surface = icosphere(1);
  const auto run = [&](const TriangleView& triangles)
  { return convexify(viewOf(surface.points), triangles, &origin[0]); };
  TriangleView triangles = surface.view();
  triangles.corners = nullptr;
  expectError([&] { run(triangles); }, ErrorCode::BadArgument);
  triangles = surface.view();
  triangles.count = -1;
  expectError([&] { run(triangles); }, ErrorCode::BadArgument);
  // No triangle is no polyhedron: the hull of no point.
  const Hull none = run(TriangleView());
  EXPECT_EQ(none.dimension, -1);
  EXPECT_TRUE(none.pointIds.empty());
}

}
}
}
