// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Weighted points whose triangulations flipping by the V-criterion alone cannot make regular, and
/// Flip-Flop can (paper, section 1: Edelsbrunner and Shah's situation).
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/References/PlaneFlips.h"

namespace flipflop
{
namespace test
{

namespace
{

TEST(RegularTriangulationStuck, VAloneGetsStuck)
{
  const Cloud cloud = stuckSites();
  EXPECT_EQ(PlaneFlips(cloud).inserted(), static_cast<int>(cloud.size()));
  int stuck = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
  {
    PlaneFlips alone(cloud);
    EXPECT_GT(alone.irregularEdges(), 0);
    alone.flip(seed);
    EXPECT_NE(alone.irregularEdges(), 1);
    stuck += alone.irregularEdges() > 0;
  }
  EXPECT_GT(stuck, 70);
  expectTriangulation(cloud, bruteForceTriangulation(cloud));
}

TEST(RegularTriangulationStuck, StuckIsNotTheRuleOfThisFlipper)
{
  // It is no straw man: it nearly always gets home, and then to the right triangles.
  int stuck = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed)
  {
    Random random(seed);
    Cloud cloud = { { -2001, -1203, 0 }, { 2007, -1200, 0 }, { 5, 2400, 0 } };
    cloud = joined(std::move(cloud), smallIntegerSites(12, -700, 700, 0, 100000, random));
    PlaneFlips alone(cloud);
    alone.flip(seed);
    stuck += alone.irregularEdges() > 0;
    EXPECT_GT(alone.flips(), 0) << "seed " << seed;
  }
  EXPECT_LT(stuck, 3);
}

TEST(RegularTriangulationStuck, ManyPointsNeedTheDCriterion)
{
  // Among thousands of points such places arise of themselves, but not in parts of a few.
  pointsPerThread() = UsualPointsPerThread;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    const Cloud cloud = fromWeightedFamily("uniformHeavy", effort(20000), seed).make();
    Options options;
    options.threads = 1;
    options.vBiased = false; // else it waits, and hardly ever comes to that
    const Triangulation found = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
    EXPECT_GT(found.statistics.labelled, 0) << "seed " << seed;
    EXPECT_GT(found.statistics.flipsD, 0) << "seed " << seed;
    EXPECT_GT(found.statistics.flips31, 0) << "seed " << seed;
  }
  pointsPerThread() = 1;
}

}
}
}
