// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Flip-Flop takes any star-shaped polyhedron to its hull.
#include "Testing/Engine/Surface/FlipFlopChecks.h"
#include <flipflop/FlipFlop.h>

#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

const double origin[3] = { 0, 0, 0 };

TEST(FlipFlop, ConvexPolyhedraStayAsTheyAre)
{
  for (int levels = 0; levels <= 4; ++levels)
  {
    SCOPED_TRACE("icosphere " + std::to_string(levels));
    expectFlipFlop(icosphere(levels), origin);
  }
  for (int side : { 1, 2, 5, 9 })
  {
    // Flat edges everywhere, and vertices that are not extreme: eight remain.
    const Surface cube = griddedCube(side);
    const double middle[3] = { 0.5 * side, 0.5 * side, 0.5 * side };
    SCOPED_TRACE("cube " + std::to_string(side));
    expectFlipFlop(cube, middle);
    EXPECT_EQ(convexify(viewOf(cube.points), cube.view(), middle).pointIds.size(), 8u);
  }
}

TEST(FlipFlop, HasItsFormerName)
{
  const Surface cube = griddedCube(2);
  const double middle[3] = { 1, 1, 1 };
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  const Hull hull = flipFlop(viewOf(cube.points), cube.view(), middle);
#pragma GCC diagnostic pop
  EXPECT_EQ(bitDifference(hull, convexify(viewOf(cube.points), cube.view(), middle)), "");
}

TEST(FlipFlop, SunkenFacets)
{
  // A tetrahedron with one facet's middle sunk: one 3-1 flip.
  Surface surface;
  surface.points = { { 0, 0, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { 0, 0, 9 }, { 2.5, 2.5, 2.5 } };
  surface.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 4, 1, 2 }, { 4, 2, 3 },
    { 4, 3, 1 } };
  const double kernel[3] = { 1, 1, 1 };
  expectFlipFlop(surface, kernel);
  const Hull hull = convexify(viewOf(surface.points), surface.view(), kernel);
  EXPECT_EQ(hull.pointIds.size(), 4u);
  EXPECT_GE(hull.statistics.flips31, 1);
  EXPECT_EQ(hull.volume, 9.0 * 9 * 9 / 6);
}

TEST(FlipFlop, RaisedMiddlesStayAndDiagonalsTurn)
{
  // A square pyramid on a square pyramid, cut along the wrong diagonal: one 2-2 flip.
  Surface surface;
  surface.points = { { 2, 0, 0 }, { 0, 2, 0 }, { -2, 0, 0 }, { 0, -2, 0 }, { 0, 0, -2 } };
  surface.points[0][2] = surface.points[2][2] = 1;
  surface.triangles = { { 1, 2, 3 }, { 1, 3, 0 }, { 1, 0, 4 }, { 2, 1, 4 }, { 3, 2, 4 },
    { 0, 3, 4 } };
  const double kernel[3] = { 0, 0, -0.5 };
  expectFlipFlop(surface, kernel);
  const Hull hull = convexify(viewOf(surface.points), surface.view(), kernel);
  EXPECT_EQ(hull.pointIds.size(), 5u);
  EXPECT_GE(hull.statistics.flips22, 1);
  EXPECT_EQ(hull.statistics.flips31, 0);
}

TEST(FlipFlop, PerturbedSpheres)
{
  const std::uint64_t seeds = isSanitized() ? 1 : 3;
  for (double depth : { 1e-9, 1e-3, 0.05, 0.5, 0.9 })
  {
    for (int levels : { 0, 1, 2, 4 })
    {
      for (std::uint64_t seed = 1; seed <= seeds; ++seed)
      {
        SCOPED_TRACE("depth " + std::to_string(depth) + ", levels " + std::to_string(levels) +
          ", seed " + std::to_string(seed));
        expectFlipFlop(perturbedIcosphere(levels, depth, seed), origin);
      }
    }
  }
}

TEST(FlipFlop, LargeSphere)
{
  expectFlipFlop(perturbedIcosphere(isSanitized() ? 4 : 6, 0.02, 9), origin);
}

TEST(FlipFlop, RandomStars)
{
  for (int count : { 4, 5, 6, 8, 10, 15, 30, 100, 600 })
  {
    for (double low : { 0.05, 0.5, 0.99 })
    {
      for (std::uint64_t seed = 1; seed <= 4; ++seed)
      {
        const Surface star = randomStar(count, low, 1000 * seed + count);
        // A few directions may lie in one half-space: then the origin sees nothing.
        if (!seesAll(star, origin))
        {
          ASSERT_LE(count, 15);
          continue;
        }
        SCOPED_TRACE(std::to_string(count) + " points, low " + std::to_string(low) + ", seed " +
          std::to_string(1000 * seed + count));
        expectFlipFlop(star, origin);
      }
    }
  }
}

TEST(FlipFlop, ManySmallStars)
{
  // Integer points: exact coincidences, flat edges and cone borders that are hit.
  int tried = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(effort(4000)); ++seed)
  {
    Surface star = randomStar(5 + static_cast<int>(seed % 14), 0.2, seed);
    for (Point& p : star.points)
    {
      for (double& x : p)
      {
        x = std::round((seed % 2 ? 4 : 12) * x);
      }
    }
    if (!seesAll(star, origin))
    {
      continue;
    }
    ++tried;
    Options options;
    options.threads = seed % 8 ? 1 : 2;
    options.vBiased = seed % 3 == 0;
    options.facets = FacetMode::Polygons;
    const ReferenceHull wanted = hullOfUsed(star);
    std::string fault;
    try
    {
      const Hull hull =
        convexify(viewOf(star.points), star.view(), seed % 5 ? origin : nullptr, options);
      fault = difference(hull, wanted, FacetMode::Polygons);
    }
    catch (const Error& error)
    {
      fault = error.what();
    }
    ASSERT_EQ(fault, "") << "seed " << seed << "\n" << toString(star.points);
  }
  EXPECT_GT(tried, effort(1000));
}

TEST(FlipFlop, ScrambledConvexPolyhedra)
{
  // All vertices extreme, edges turned at random: the way back is by 2-2 flips alone.
  for (int count : { 8, 30, 300, 2000 })
  {
    const Surface surface = scrambled(randomStar(count, 1, 50 + count), origin, 5 * count, count);
    ASSERT_TRUE(seesAll(surface, origin));
    SCOPED_TRACE(std::to_string(count) + " points");
    const Hull hull = expectFlipFlop(surface, origin);
    EXPECT_GT(hull.statistics.flips22, 0);
  }
}

TEST(FlipFlop, ScrambledGrids)
{
  for (int side : { 2, 4, 8 })
  {
    const double middle[3] = { 0.5 * side, 0.5 * side, 0.5 * side };
    const Surface surface = scrambled(griddedCube(side), middle, 20 * side * side, 7);
    ASSERT_TRUE(seesAll(surface, middle));
    SCOPED_TRACE("side " + std::to_string(side));
    expectFlipFlop(surface, middle);
  }
}

TEST(FlipFlop, IdsAndOrderDoNotMatter)
{
  const Surface plain = perturbedIcosphere(2, 0.3, 5);
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    // Unused points far outside are no part of the polyhedron.
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectFlipFlop(shuffled(plain, 40, seed), origin);
  }
}

TEST(FlipFlop, ShapesAndRanges)
{
  const Surface plain = perturbedIcosphere(2, 0.2, 6);
  const double far[3] = { 1e8, 2e8, -1e8 };
  Surface moved8 = plain;
  moved8.points = moved(plain.points, far[0], far[1], far[2]);
  expectFlipFlop(moved8, far);
  for (double s : { 0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000 })
  {
    SCOPED_TRACE(std::to_string(std::ilogb(s)));
    Surface sized = plain;
    sized.points = scaled(plain.points, s, s, s);
    expectFlipFlop(sized, origin);
  }
  for (double s : { 1e-6, 1e-14, 1e-100, 1e-300 })
  {
    SCOPED_TRACE("thin " + std::to_string(std::ilogb(s)));
    Surface thin = plain;
    thin.points = scaled(plain.points, 1, s, 1);
    expectFlipFlop(thin, origin);
  }
}

TEST(FlipFlop, AnyKernelGivesTheSameHull)
{
  const Surface surface = perturbedIcosphere(3, 0.1, 7);
  const Hull first = convexify(viewOf(surface.points), surface.view(), origin);
  Random random(8);
  int tried = 0;
  for (int i = 0; i < 40; ++i)
  {
    const Point u = random.direction();
    const double kernel[3] = { 0.4 * u[0], 0.4 * u[1], 0.4 * u[2] };
    if (seesAll(surface, kernel))
    {
      ++tried;
      EXPECT_EQ(
        bitDifference(convexify(viewOf(surface.points), surface.view(), kernel), first), "");
    }
  }
  EXPECT_EQ(bitDifference(convexify(viewOf(surface.points), surface.view(), nullptr), first), "");
  EXPECT_GT(tried, 0) << "seed 8";
}

TEST(FlipFlop, FindsAKernelThatIsOffCentre)
{
  // A long spike: the mean of the vertices is far from what sees them all.
  for (double length : { 2.0, 10.0, 100.0 })
  {
    Surface surface = perturbedIcosphere(1, 0.2, 10);
    Point& tip = surface.points[0];
    tip = { length * tip[0], length * tip[1], length * tip[2] };
    ASSERT_TRUE(seesAll(surface, origin));
    SCOPED_TRACE("length " + std::to_string(length));
    expectFlipFlop(surface, origin);
  }
}

TEST(FlipFlop, FindsAKernelWheneverThereIsOne)
{
  // A triangular prism whose top is turned; its sides are cut along the reflex diagonal, so its
  // kernel shrinks to nothing as it turns. Which it is, rationals tell.
  int found = 0;
  int missing = 0;
  for (int degrees = 0; degrees <= 120; degrees += 4)
  {
    Surface surface;
    for (int top = 0; top < 2; ++top)
    {
      for (int i = 0; i < 3; ++i)
      {
        const double angle = (120 * i + top * degrees) * 0.017453292519943295;
        surface.points.push_back({ std::cos(angle), std::sin(angle), 2.0 * top });
      }
    }
    surface.triangles = { { 0, 2, 1 }, { 3, 4, 5 } };
    for (std::int64_t i = 0; i < 3; ++i)
    {
      const std::int64_t next = (i + 1) % 3;
      surface.triangles.push_back({ i, next, 3 + i });
      surface.triangles.push_back({ next, 3 + next, 3 + i });
    }
    // Either way to cut: one has convex diagonals, the other reflex ones.
    Surface other = surface;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int64_t a = static_cast<std::int64_t>(i);
      const std::int64_t next = (a + 1) % 3;
      other.triangles[2 + 2 * i] = { a, next, 3 + next };
      other.triangles[3 + 2 * i] = { a, 3 + next, 3 + a };
    }
    for (const Surface& prism : { surface, other })
    {
      SCOPED_TRACE(std::to_string(degrees) + " degrees");
      double kernel[3];
      if (findKernel(prism, kernel))
      {
        ++found;
        ASSERT_TRUE(seesAll(prism, kernel));
        expectFlipFlop(prism, kernel);
      }
      else
      {
        ++missing;
        EXPECT_EQ(codeOf(prism, nullptr), ErrorCode::NoKernel);
      }
    }
  }
  EXPECT_GT(found, 20);
  EXPECT_GT(missing, 2);
}

}
}
}
