// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Long runs say how far they are, and stop when asked to.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Inputs/Surfaces.h"
#include <flipflop/FlipFlop.h>

namespace flipflop
{
namespace test
{

namespace
{

class ProgressOf : public ::testing::TestWithParam<const char*>
{
};

TEST_P(ProgressOf, GrowsFrom0To1OnTheCallersThread)
{
  const Cloud cloud = fromFamily(this->GetParam(), effort(400000), 61).make();
  for (int threads : { 1, 2, 4 })
  {
    Watch watch;
    const Hull hull = convexHull(viewOf(cloud), watch.options(threads));
    watch.expectOrder();
    EXPECT_GE(watch.fractions.size(), 2u) << threads << " threads";
    Options quiet;
    quiet.threads = threads;
    EXPECT_EQ(bitDifference(hull, convexHull(viewOf(cloud), quiet)), "") << "watching changed it";
  }
}

TEST_P(ProgressOf, StopsWhenAsked)
{
  const Cloud cloud = fromFamily(this->GetParam(), effort(400000), 62).make();
  for (int threads : { 1, 2, 4 })
  {
    Watch all;
    convexHull(viewOf(cloud), all.options(threads));
    const int calls = static_cast<int>(all.fractions.size());
    for (int stopAt : { 1, 2, 5, calls / 2 })
    {
      if (stopAt < 1 || stopAt > calls)
      {
        continue;
      }
      Watch watch;
      watch.stopAt = stopAt;
      bool aborted = false;
      try
      {
        convexHull(viewOf(cloud), watch.options(threads));
      }
      catch (const Error& error)
      {
        aborted = error.code() == ErrorCode::Aborted;
      }
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
    const Hull hull = convexHull(viewOf(cloud), options);
    EXPECT_TRUE(validate(viewOf(cloud), hull));
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, ProgressOf,
  ::testing::Values("cube", "shell0", "shell1e2", "boxFaces"),
  [](const auto& given) { return std::string(given.param); });

TEST(Progress, LongRunsReportManyTimes)
{
  const Cloud cloud = fromFamily("shell0", effort(600000), 63).make();
  for (int threads : { 1, 2 })
  {
    Watch watch;
    convexHull(viewOf(cloud), watch.options(threads));
    EXPECT_GE(watch.fractions.size(), 5u) << threads << " threads";
  }
}

TEST(Progress, SmallRunsAbortAtTheirFirstCallIfThereIsOne)
{
  for (const Cloud& cloud : { Cloud{}, Cloud{ { 1, 2, 3 } }, integerGrid(2), integerGrid(10),
         Cloud{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } })
  {
    Watch all;
    const Hull whole = convexHull(viewOf(cloud), all.options(2));
    all.expectOrder();
    Watch watch;
    watch.stopAt = 1;
    bool aborted = false;
    try
    {
      convexHull(viewOf(cloud), watch.options(2));
    }
    catch (const Error& error)
    {
      aborted = error.code() == ErrorCode::Aborted;
    }
    EXPECT_EQ(aborted, !all.fractions.empty());
  }
}

TEST(Progress, FlipFlopReportsAndStops)
{
  const Surface surface = perturbedIcosphere(isSanitized() ? 4 : 7, 0.05, 64);
  const double kernel[3] = { 0, 0, 0 };
  for (int threads : { 1, 2 })
  {
    Watch all;
    flipFlop(viewOf(surface.points), surface.view(), kernel, all.options(threads));
    all.expectOrder();
    EXPECT_GE(all.fractions.size(), 1u);
    for (int stopAt : { 1, 2 })
    {
      Watch watch;
      watch.stopAt = stopAt;
      bool aborted = false;
      try
      {
        flipFlop(viewOf(surface.points), surface.view(), kernel, watch.options(threads));
      }
      catch (const Error& error)
      {
        aborted = error.code() == ErrorCode::Aborted;
      }
      EXPECT_EQ(aborted, static_cast<int>(watch.fractions.size()) >= stopAt);
    }
  }
}

}
}
}
