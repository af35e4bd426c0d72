// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Long triangulations say how far they are, and stop when asked to.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

namespace flipflop
{
namespace test
{

namespace
{

Triangulation run(const Cloud& weighted, const Options& options)
{
  return regularTriangulation(viewOf(weighted), weightsOf(weighted), options);
}

/// Run, stopping at a call. @return whether it said that it was aborted.
bool isAborted(const Cloud& weighted, Watch& watch, int threads)
{
  try
  {
    run(weighted, watch.options(threads));
    return false;
  }
  catch (const Error& error)
  {
    return error.code() == ErrorCode::Aborted;
  }
}

class TriangulationProgress : public ::testing::TestWithParam<const char*>
{
};

TEST_P(TriangulationProgress, GrowsFrom0To1OnTheCallersThread)
{
  const Cloud cloud = fromWeightedFamily(this->GetParam(), effort(80000), 61).make();
  for (int threads : { 1, 2, 4 })
  {
    Watch watch;
    const Triangulation found = run(cloud, watch.options(threads));
    watch.expectOrder();
    EXPECT_GE(watch.fractions.size(), 2u) << threads << " threads";
    Options quiet;
    quiet.threads = threads;
    EXPECT_EQ(bitDifference(found, run(cloud, quiet)), "") << "watching changed it";
  }
}

TEST_P(TriangulationProgress, StopsWhenAsked)
{
  const Cloud cloud = fromWeightedFamily(this->GetParam(), effort(80000), 62).make();
  for (int threads : { 1, 2, 4 })
  {
    Watch all;
    run(cloud, all.options(threads));
    const int calls = static_cast<int>(all.fractions.size());
    for (int stopAt : { 1, 2, calls / 2, calls })
    {
      if (stopAt < 1 || stopAt > calls)
      {
        continue;
      }
      Watch watch;
      watch.stopAt = stopAt;
      const bool aborted = isAborted(cloud, watch, threads);
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
    EXPECT_TRUE(validate(viewOf(cloud), weightsOf(cloud), run(cloud, options)));
  }
}

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, TriangulationProgress,
  ::testing::Values("uniform", "uniformHeavy", "uniformHiding", "smallIntegers", "lineAlongX"),
  [](const auto& given) { return std::string(given.param); });

TEST(TriangulationProgress, LongRunsReportManyTimes)
{
  const Cloud cloud = fromWeightedFamily("uniformLight", effort(200000), 63).make();
  for (int threads : { 1, 2 })
  {
    Watch watch;
    run(cloud, watch.options(threads));
    EXPECT_GE(watch.fractions.size(), 5u) << threads << " threads";
  }
}

TEST(TriangulationProgress, SmallRunsAbortAtTheirFirstCallIfThereIsOne)
{
  for (const Cloud& cloud : { Cloud{}, Cloud{ { 1, 2, 3 } }, squareGrid(2), squareGrid(30),
         Cloud{ { 0, 0, 0 }, { 1, 0, 0 } }, Cloud{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } })
  {
    Watch all;
    run(cloud, all.options(2));
    all.expectOrder();
    Watch watch;
    watch.stopAt = 1;
    EXPECT_EQ(isAborted(cloud, watch, 2), !all.fractions.empty());
  }
}

}
}
}
