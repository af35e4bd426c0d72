// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Long runs say how far they are and in which step, many times, and stop when asked to; short ones
/// may be stopped at their first report.
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"

namespace flipflop
{
namespace test
{

namespace
{

class ProgressOf : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(ProgressOf, NamesItsStepsAndStopsWhenAsked)
{
  const FamilyOf& of = this->GetParam();
  const Cloud cloud = of.kind->family(of.name, effort(of.count), 62).make();
  const bool isLong = of.name == "shell0" || of.name == "uniformLight";
  for (const int threads : { 1, 4 })
  {
    expectProgress(
      [&](const Options& options) { of.kind->run(cloud, options); }, threads, isLong ? 5 : 2);
    Watch all;
    // Nothing of the runs before is left behind.
    EXPECT_TRUE(validate(cloud, of.kind->run(cloud, all.options(threads))));
    ASSERT_FALSE(all.steps.empty());
    EXPECT_EQ(all.steps.front(), "scanning");
    if (all.steps.size() > 1) // what is on a line is done at once
    {
      EXPECT_EQ(all.steps.back(), "finishing");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, ProgressOf,
  ::testing::ValuesIn(
    familiesOf(convexHulls, { "cube", "shell0", "shell1e2", "boxFaces" }, { 200000 })),
  Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, ProgressOf,
  ::testing::ValuesIn(familiesOf(regularTriangulations,
    { "uniformLight", "uniformHeavy", "uniformHiding", "smallIntegers", "lineAlongX" },
    { 100000 })),
  Named());

TEST(Progress, SmallRunsStopAtTheirFirstReportIfThereIsOne)
{
  const Cloud corner = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  for (const Kind* kind : { &convexHulls, &regularTriangulations })
  {
    for (const Cloud& cloud :
      { Cloud(), Cloud{ { 1, 2, 3 } }, Cloud(corner.begin(), corner.end() - 1), corner,
        integerGrid(2), integerGrid(10), squareGrid(30) })
    {
      expectProgress([&](const Options& options) { kind->run(cloud, options); }, 2, 0);
    }
  }
}

}
}
}
