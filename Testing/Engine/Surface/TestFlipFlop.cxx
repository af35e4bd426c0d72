// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Flip-Flop takes any star-shaped polyhedron to its hull, also from where flipping by the
/// V-criterion alone gets stuck (paper, Fig. 1).
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/Surface/FlipFlopChecks.h"
#include <flipflop/FlipFlop.h>

#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

const Point origin = { 0, 0, 0 };

struct Star
{
  std::string name;
  std::function<Surface()> make;
  Point kernel = origin;

  friend void PrintTo(const Star& star, std::ostream* out) { *out << star.name; }
};

std::string text(double x)
{
  std::ostringstream out;
  out << x;
  return out.str();
}

Surface changed(Surface surface, const std::function<Cloud(const Cloud&)>& change)
{
  surface.points = change(surface.points);
  return surface;
}

/// A long spike: the mean of the vertices is far from what sees them all.
Surface spike(double length)
{
  Surface surface = perturbedIcosphere(1, 0.2, 10);
  surface.points[0] = times(surface.points[0], length);
  return surface;
}

std::vector<Star> stars()
{
  std::vector<Star> all;
  const auto add = [&](const std::string& name, const std::function<Surface()>& make,
                     const Point& kernel = origin) {
    all.push_back({ name, make, kernel });
  };
  for (int levels = 0; levels <= 4; ++levels)
  {
    add("icosphere " + text(levels), [=] { return icosphere(levels); });
  }
  // Flat edges everywhere, and vertices that are not extreme: eight remain.
  for (const int side : { 1, 2, 4, 9 })
  {
    add("cube " + text(side), [=] { return griddedCube(side); });
    add("scrambled cube " + text(side), [=] { return scrambledCube(side, 7); });
  }
  for (const double depth : { 1e-9, 1e-3, 0.05, 0.5, 0.9 })
  {
    for (const int levels : { 0, 1, 2, 4 })
    {
      add("depth " + text(depth) + ", levels " + text(levels),
        [=] { return perturbedIcosphere(levels, depth, 1); });
    }
  }
  add("large", [] { return perturbedIcosphere(isSanitized() ? 4 : 6, 0.02, 9); });
  for (const int count : { 4, 5, 6, 8, 10, 15, 30, 100, 600 })
  {
    for (const double low : { 0.05, 0.5, 0.99 })
    {
      for (const std::uint64_t seed : { 1, 2 })
      {
        add(text(count) + " points, low " + text(low) + ", seed " + text(double(seed)),
          [=] { return randomStar(count, low, 1000 * seed + count); });
      }
    }
  }
  for (const int count : { 8, 30, 300, 2000 })
  {
    add("scrambled " + text(count), [=] { return scrambledSphere(count, 50); });
  }
  // Unused points far outside are no part of the polyhedron.
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    add("shuffled, seed " + text(double(seed)),
      [=] { return shuffled(perturbedIcosphere(2, 0.3, 5), 40, seed); });
  }
  const Surface plain = perturbedIcosphere(2, 0.2, 6);
  const Point far = { 1e8, 2e8, -1e8 };
  add(
    "far",
    [=]
    { return changed(plain, [=](const Cloud& c) { return moved(c, far[0], far[1], far[2]); }); },
    far);
  for (const double s : { 0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000 })
  {
    add("times " + text(s),
      [=] { return changed(plain, [=](const Cloud& c) { return scaled(c, s, s, s); }); });
  }
  for (const double s : { 1e-6, 1e-14, 1e-100, 1e-300 })
  {
    add("thin " + text(s),
      [=] { return changed(plain, [=](const Cloud& c) { return scaled(c, 1, s, 1); }); });
  }
  for (const double length : { 2.0, 10.0, 100.0 })
  {
    add("spike " + text(length), [=] { return spike(length); });
  }
  return all;
}

class Stars : public ::testing::TestWithParam<Star>
{
};

TEST_P(Stars, BecomeTheirHulls)
{
  const Star& star = this->GetParam();
  const Surface surface = star.make();
  if (!seesAll(surface, star.kernel))
  {
    // A few directions may lie in one half-space: then the origin sees nothing.
    ASSERT_LE(surface.points.size(), 15u);
    return;
  }
  const Hull hull = expectFlipFlop(surface, star.kernel);
  EXPECT_TRUE(hull.statistics.flips22 > 0 || star.name.compare(0, 12, "scrambled 30") != 0);
}

INSTANTIATE_TEST_SUITE_P(FlipFlop, Stars, ::testing::ValuesIn(stars()));

/// Labels and the D-criterion bring home what flips by the V-criterion cannot begin.
TEST(FlipFlop, WhereTheVCriterionIsStuck)
{
  const Surface shuffledOne = shuffled(stuckIcosahedron(), 0, 1);
  for (const Surface& surface :
    { stuckTetrahedron(), stuckTwice(), stuckIcosahedron(), shuffledOne })
  {
    ASSERT_TRUE(seesAll(surface));
    expectFlipFlop(surface);
    for (const bool vBiased : { false, true })
    {
      for (const int threads : { 1, 2, 4 })
      {
        Options options;
        options.vBiased = vBiased;
        options.threads = threads;
        const Hull hull = convexify(viewOf(surface.points), surface.view(), &origin[0], options);
        EXPECT_GT(hull.statistics.labelled, 0);
        EXPECT_GT(hull.statistics.flipsD, 0);
        EXPECT_GT(hull.statistics.edgeChecks, 0);
        // Each flip that removes a vertex is a 3-1 flip: all the sunken ones are gone.
        EXPECT_EQ(hull.statistics.flips31,
          static_cast<std::int64_t>(surface.points.size() - hull.pointIds.size()));
      }
    }
  }
}

TEST(FlipFlop, HasItsFormerName)
{
  const Surface cube = griddedCube(2);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  const Hull hull = flipFlop(viewOf(cube.points), cube.view(), &origin[0]);
#pragma GCC diagnostic pop
  EXPECT_EQ(bitDifference(hull, convexify(viewOf(cube.points), cube.view(), &origin[0])), "");
}

TEST(FlipFlop, OneFlipOfEachKind)
{
  // A tetrahedron with one facet's middle sunk: one 3-1 flip.
  Surface surface;
  surface.points = { { 0, 0, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { 0, 0, 9 }, { 2.5, 2.5, 2.5 } };
  surface.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 4, 1, 2 }, { 4, 2, 3 },
    { 4, 3, 1 } };
  const Hull sunken = expectFlipFlop(surface, { 1, 1, 1 });
  EXPECT_EQ(sunken.pointIds.size(), 4u);
  EXPECT_GE(sunken.statistics.flips31, 1);
  EXPECT_EQ(sunken.volume, 9.0 * 9 * 9 / 6);
  // A square pyramid on a square pyramid, cut along the wrong diagonal: one 2-2 flip.
  surface.points = { { 2, 0, 1 }, { 0, 2, 0 }, { -2, 0, 1 }, { 0, -2, 0 }, { 0, 0, -2 } };
  surface.triangles = { { 1, 2, 3 }, { 1, 3, 0 }, { 1, 0, 4 }, { 2, 1, 4 }, { 3, 2, 4 },
    { 0, 3, 4 } };
  const Hull turned = expectFlipFlop(surface, { 0, 0, -0.5 });
  EXPECT_EQ(turned.pointIds.size(), 5u);
  EXPECT_GE(turned.statistics.flips22, 1);
  EXPECT_EQ(turned.statistics.flips31, 0);
}

TEST(FlipFlop, ManySmallStars)
{
  // Integer points: exact coincidences, flat edges and cone borders that are hit.
  int tried = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(effort(4000)); ++seed)
  {
    Surface star = randomStar(5 + static_cast<int>(seed % 14), 0.2, seed);
    const double s = seed % 2 ? 4 : 12;
    star.points = toSteps(scaled(star.points, s, s, s), 1);
    if (!seesAll(star))
    {
      continue;
    }
    ++tried;
    Options options;
    options.threads = seed % 8 ? 1 : 2;
    options.vBiased = seed % 3 == 0;
    options.facets = FacetMode::Polygons;
    Hull hull;
    ASSERT_NO_THROW(
      hull = convexify(viewOf(star.points), star.view(), seed % 5 ? &origin[0] : nullptr, options))
      << "seed " << seed << "\n"
      << toString(star.points);
    ASSERT_EQ(difference(hull, hullOfUsed(star), FacetMode::Polygons), "")
      << "seed " << seed << "\n"
      << toString(star.points);
  }
  EXPECT_GT(tried, effort(1000));
}

TEST(FlipFlop, AnyKernelGivesTheSameHull)
{
  const Surface surface = perturbedIcosphere(3, 0.1, 7);
  const Hull first = convexify(viewOf(surface.points), surface.view(), &origin[0]);
  Random random(8);
  int tried = 0;
  for (int i = 0; i < 40; ++i)
  {
    const Point kernel = times(random.direction(), 0.4);
    if (seesAll(surface, kernel))
    {
      ++tried;
      EXPECT_EQ(
        bitDifference(convexify(viewOf(surface.points), surface.view(), &kernel[0]), first), "");
    }
  }
  EXPECT_GT(tried, 0) << "seed 8";
}

/// Does a point of the z axis strictly see all? @param kernel it, if so
bool findKernelOnAxis(const Surface& surface, Point& kernel)
{
  mpq_class low = -1000, high = 1000;
  for (const Corners& t : surface.triangles)
  {
    const auto at = [&](int corner, std::size_t axis)
    { return mpq_class(surface.points[static_cast<std::size_t>(t[corner])][axis]); };
    // The heights of the axis over the plane at z = 0, and at z = 1 less that.
    const auto minor = [&](std::size_t i, std::size_t j)
    {
      return mpq_class((at(1, i) - at(0, i)) * (at(2, j) - at(0, j)) -
        (at(1, j) - at(0, j)) * (at(2, i) - at(0, i)));
    };
    const mpq_class slope = minor(0, 1);
    const mpq_class height = -at(0, 0) * minor(1, 2) - at(0, 1) * minor(2, 0) - at(0, 2) * slope;
    if (slope == 0 && height >= 0)
    {
      return false;
    }
    if (slope != 0)
    {
      const mpq_class z = -height / slope;
      low = slope < 0 && z > low ? z : low;
      high = slope > 0 && z < high ? z : high;
    }
  }
  kernel = { 0, 0, mpq_class((low + high) / 2).get_d() };
  return low < high;
}

TEST(FlipFlop, FindsAKernelWheneverThereIsOne)
{
  // A triangular prism whose top is turned; its sides are cut along the convex or the reflex
  // diagonal: then its kernel shrinks to nothing as it turns. It is convex and, but for rounding,
  // symmetric about the z axis: it has a point of it, or there is none.
  int found = 0;
  int missing = 0;
  for (int degrees = 2; degrees <= 120; degrees += 4)
  {
    for (const bool isReflex : { false, true })
    {
      SCOPED_TRACE(std::to_string(degrees) + (isReflex ? " degrees, reflex" : " degrees"));
      Surface prism;
      for (int i = 0; i < 6; ++i)
      {
        prism.points.push_back(
          onCircle((120 * i + i / 3 * degrees) * Turn / 360, 1, i < 3 ? 0 : 2));
      }
      prism.triangles = { { 0, 2, 1 }, { 3, 4, 5 } };
      for (std::int64_t i = 0; i < 3; ++i)
      {
        const std::int64_t next = (i + 1) % 3;
        prism.triangles.push_back({ i, next, isReflex ? 3 + i : 3 + next });
        prism.triangles.push_back({ isReflex ? next : i, 3 + next, 3 + i });
      }
      Point kernel;
      if (findKernelOnAxis(prism, kernel))
      {
        ++found;
        ASSERT_TRUE(seesAll(prism, kernel));
        expectFlipFlop(prism, kernel);
      }
      else
      {
        ++missing;
        expectError(
          [&] { convexify(viewOf(prism.points), prism.view(), nullptr); }, ErrorCode::NoKernel);
      }
    }
  }
  EXPECT_GT(found, 20);
  EXPECT_GT(missing, 2);
}

}
}
}
