// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Long runs say how far they are, and stop when asked to.
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"

#include <functional>

namespace flipflop
{
namespace test
{

namespace
{

/// Run. @return whether it said that it was aborted.
bool isAborted(const std::function<void()>& run)
{
  try
  {
    run();
    return false;
  }
  catch (const Error& error)
  {
    return error.code() == ErrorCode::Aborted;
  }
}

class ProgressOf : public ::testing::TestWithParam<FamilyOf>
{
protected:
  Cloud make(std::uint64_t seed) const
  {
    const FamilyOf& of = this->GetParam();
    return of.kind->family(of.name, effort(of.count), seed).make();
  }
};

TEST_P(ProgressOf, NamesItsStepsAndStopsWhenAsked)
{
  const Kind& kind = *this->GetParam().kind;
  const Cloud cloud = this->make(62);
  for (int threads : { 1, 2, 4 })
  {
    Watch all;
    kind.run(cloud, all.options(threads));
    all.expectOrder();
    EXPECT_GE(all.fractions.size(), 2u) << threads << " threads";
    ASSERT_FALSE(all.steps.empty());
    EXPECT_EQ(all.steps.front(), "scanning");
    if (all.steps.size() > 1) // what is on a line is done at once
    {
      EXPECT_EQ(all.steps.back(), "finishing");
    }
    const int calls = static_cast<int>(all.fractions.size());
    for (int stopAt : { 1, 2, 5, calls / 2, calls })
    {
      if (stopAt < 1 || stopAt > calls)
      {
        continue;
      }
      Watch watch;
      watch.stopAt = stopAt;
      const bool aborted = isAborted([&] { kind.run(cloud, watch.options(threads)); });
      const std::chrono::duration<double> delay = std::chrono::steady_clock::now() - watch.stopped;
      // With several threads the number of calls may vary a little from run to run.
      const bool asked = static_cast<int>(watch.fractions.size()) >= stopAt;
      EXPECT_EQ(aborted, asked) << threads << " threads, stop at call " << stopAt;
      if (asked)
      {
        EXPECT_EQ(static_cast<int>(watch.fractions.size()), stopAt)
          << "called again after the stop";
        EXPECT_LT(delay.count(), 2.0) << "took long to stop";
      }
      watch.expectOrder();
    }
    // And nothing is left behind: the next run is whole.
    Options options;
    options.threads = threads;
    EXPECT_TRUE(validate(cloud, kind.run(cloud, options)));
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, ProgressOf,
  ::testing::ValuesIn(
    familiesOf(convexHulls, { "cube", "shell0", "shell1e2", "boxFaces" }, { 400000 })),
  Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, ProgressOf,
  ::testing::ValuesIn(familiesOf(regularTriangulations,
    { "uniform", "uniformHeavy", "uniformHiding", "smallIntegers", "lineAlongX" }, { 80000 })),
  Named());

void expectManyReports(const Kind& kind, const Cloud& cloud)
{
  for (int threads : { 1, 2 })
  {
    Watch watch;
    kind.run(cloud, watch.options(threads));
    EXPECT_GE(watch.fractions.size(), 5u) << threads << " threads";
  }
}

TEST(Progress, LongRunsReportManyTimes)
{
  expectManyReports(convexHulls, fromFamily("shell0", effort(600000), 63).make());
  expectManyReports(
    regularTriangulations, fromWeightedFamily("uniformLight", effort(200000), 63).make());
}

void expectAbortAtTheFirstCallIfAny(const Kind& kind, const Cloud& cloud)
{
  Watch all;
  kind.run(cloud, all.options(2));
  all.expectOrder();
  Watch watch;
  watch.stopAt = 1;
  EXPECT_EQ(isAborted([&] { kind.run(cloud, watch.options(2)); }), !all.fractions.empty());
}

TEST(Progress, SmallRunsAbortAtTheirFirstCallIfThereIsOne)
{
  const Cloud few[] = { {}, { { 1, 2, 3 } }, { { 0, 0, 0 }, { 1, 0, 0 } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } };
  for (const Kind* kind : { &convexHulls, &regularTriangulations })
  {
    for (const Cloud& cloud : few)
    {
      expectAbortAtTheFirstCallIfAny(*kind, cloud);
    }
  }
  expectAbortAtTheFirstCallIfAny(convexHulls, integerGrid(2));
  expectAbortAtTheFirstCallIfAny(convexHulls, integerGrid(10));
  expectAbortAtTheFirstCallIfAny(regularTriangulations, squareGrid(2));
  expectAbortAtTheFirstCallIfAny(regularTriangulations, squareGrid(30));
}

}
}
}
