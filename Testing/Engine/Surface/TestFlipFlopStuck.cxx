// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where flipping by the V-criterion alone gets stuck, and Flip-Flop does not (paper, Fig. 1).
#include "Testing/Engine/Surface/FlipFlopChecks.h"

namespace flipflop
{
namespace test
{

namespace
{

/// V alone ends with reflex edges, in every order tried, and, if told so, cannot begin at all;
/// Flip-Flop ends with the hull, by labels and the D-criterion.
void expectStuckThenFree(const Surface& surface, bool fromTheStart)
{
  ASSERT_TRUE(seesAll(surface, stuckKernel));
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    const VFlips alone = flipByVAlone(surface, stuckKernel, seed);
    EXPECT_GT(alone.reflex, 0) << "not stuck, order " << seed;
    if (fromTheStart)
    {
      EXPECT_EQ(alone.flips, 0) << "order " << seed;
    }
  }
  expectFlipFlop(surface, stuckKernel);
  for (bool vBiased : { false, true })
  {
    for (int threads : { 1, 2, 4 })
    {
      Options options;
      options.vBiased = vBiased;
      options.threads = threads;
      const Hull hull = convexify(viewOf(surface.points), surface.view(), stuckKernel, options);
      EXPECT_GT(hull.statistics.labelled, 0);
      EXPECT_GT(hull.statistics.flipsD, 0);
      EXPECT_GT(hull.statistics.flips31, 0);
      EXPECT_GT(hull.statistics.edgeChecks, 0);
      // Each flip that removes a vertex is a 3-1 flip: all the sunken ones are gone.
      EXPECT_EQ(hull.statistics.flips31,
        static_cast<std::int64_t>(surface.points.size() - hull.pointIds.size()));
    }
  }
}

TEST(FlipFlopStuck, Tetrahedron)
{
  const Surface surface = stuckTetrahedron();
  EXPECT_EQ(flipByVAlone(surface, stuckKernel, 1).reflex, 6);
  expectStuckThenFree(surface, true);
  EXPECT_EQ(hullOfUsed(surface).ids, (Cell{ 0, 1, 2, 3 }));
}

TEST(FlipFlopStuck, Icosahedron)
{
  const Surface surface = stuckIcosahedron();
  EXPECT_EQ(flipByVAlone(surface, stuckKernel, 1).reflex, 6 * 20);
  expectStuckThenFree(surface, true);
  EXPECT_EQ(hullOfUsed(surface).ids.size(), 12u);
}

TEST(FlipFlopStuck, IcosahedronInAnyOrder)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectStuckThenFree(shuffled(stuckIcosahedron(), 0, seed), true);
  }
}

TEST(FlipFlopStuck, ManyPatternsNested)
{
  // The little triangle of each pattern gets a pattern of its own, sunk deeper: V cannot begin.
  Surface surface = stuckTetrahedron();
  // Points are multiples of 5, so thousandths of thousandths are not integers: rounding is part.
  const Corners inner = surface.triangles[0];
  Corners deeper;
  const double weights[3] = { 0.494, 0.290, 0.216 };
  for (int k = 0; k < 3; ++k)
  {
    Point p = { 0, 0, 0 };
    for (int i = 0; i < 3; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        p[c] += 0.95 * weights[i] * surface.points[inner[(k + i) % 3]][c];
      }
    }
    deeper[k] = static_cast<std::int64_t>(surface.points.size());
    surface.points.push_back(p);
  }
  surface.triangles[0] = deeper;
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    surface.triangles.push_back({ inner[k], inner[next], deeper[next] });
    surface.triangles.push_back({ inner[k], deeper[next], deeper[k] });
  }
  expectStuckThenFree(surface, false);
}

TEST(FlipFlopStuck, StuckIsNotTheRuleOfThisFlipper)
{
  // The V-only flipper of this test is no straw man: where every vertex is extreme it gets home.
  const double origin[3] = { 0, 0, 0 };
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    const Surface surface = scrambled(randomStar(100, 1, seed), origin, 1000, seed);
    const VFlips alone = flipByVAlone(surface, origin, seed);
    EXPECT_GT(alone.flips, 0) << "seed " << seed;
    EXPECT_EQ(alone.reflex, 0) << "seed " << seed;
  }
}

TEST(FlipFlopStuck, RoughSpheresThatGetStuck)
{
  // Stuck configurations arise of themselves; Flip-Flop is right on them as on the others.
  const double origin[3] = { 0, 0, 0 };
  int stuck = 0;
  std::int64_t labelled = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const Surface rough = perturbedIcosphere(3, 0.5, 300 + seed);
    ASSERT_TRUE(seesAll(rough, origin)) << "seed " << 300 + seed;
    stuck += flipByVAlone(rough, origin, seed).reflex > 0;
    Options options;
    options.facets = FacetMode::Polygons;
    options.threads = 1;
    const Hull hull = convexify(viewOf(rough.points), rough.view(), origin, options);
    EXPECT_EQ(difference(hull, hullOfUsed(rough), FacetMode::Polygons), "")
      << "seed " << 300 + seed;
    labelled += hull.statistics.labelled;
  }
  EXPECT_GT(stuck, 5);
  EXPECT_GT(labelled, 20);
}

}
}
}
