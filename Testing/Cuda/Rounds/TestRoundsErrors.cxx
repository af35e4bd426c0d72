// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rounds that are stopped, or run out of memory, at any place: one typed error, nothing left
/// behind, and the same engine works again. Inputs without work for an engine do not reach it.
#include "Geometry/HullGeometry.h"
#include "Rounds/RoundsBuilder.h"
#include "Testing/Cuda/Rounds/RoundsOnHost.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();

/// The code of the error that work throws; -1: none.
template <class Work>
int codeOf(const Work& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    return static_cast<int>(error.code());
  }
  return -1;
}

/// A progress function that stops at a call. It is slow, so that the monitor, which calls some 50
/// times a second, has time for it after every round.
struct SlowWatch : Watch
{
  static bool seeSlowly(double fraction, void* context)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(21));
    return see(fraction, static_cast<Watch*>(static_cast<SlowWatch*>(context)));
  }
  Options slowOptions()
  {
    Options options = this->options(1);
    options.progress = seeSlowly;
    options.progressContext = this;
    return options;
  }
};

/// Stop at every call until one run is whole.
/// @param run (WatchedExecutor&, const Options&): throws Aborted, or compares its result
template <class Run>
void expectAborts(const Run& run)
{
  WatchedExecutor executor;
  int stopAt = 1;
  for (; stopAt < 200; ++stopAt)
  {
    SlowWatch watch;
    watch.stopAt = stopAt;
    const int code = codeOf([&] { run(executor, watch.slowOptions()); });
    watch.expectOrder();
    EXPECT_EQ(executor.bytesOut(), 0) << "stopped at call " << stopAt;
    EXPECT_EQ(executor.blocksOut(), 0);
    if (code == -1)
    {
      EXPECT_LT(static_cast<int>(watch.fractions.size()), stopAt);
      EXPECT_EQ(watch.fractions.back(), 1.0);
      break;
    }
    EXPECT_EQ(code, static_cast<int>(ErrorCode::Aborted));
    EXPECT_EQ(static_cast<int>(watch.fractions.size()), stopAt) << "called again after the stop";
  }
  // Stages alone report five times: rounds did too.
  EXPECT_GT(stopAt, 12);
  EXPECT_LT(stopAt, 200);
}

TEST(RoundsErrors, AbortAtEveryCall)
{
  const Cloud cloud = fromFamily("ball", 30, 91).make();
  const Hull wanted = convexHull(viewOf(cloud));
  expectAborts([&](WatchedExecutor& executor, const Options& options)
    { EXPECT_EQ(bitDifference(hullByRounds(executor, viewOf(cloud), options), wanted), ""); });
}

TEST(RoundsErrors, AbortAtEveryCallOfATriangulation)
{
  const Cloud cloud = fromWeightedFamily("uniform", 15, 92).make();
  const Triangulation wanted = regularTriangulation(viewOf(cloud), weightsOf(cloud));
  expectAborts(
    [&](WatchedExecutor& executor, const Options& options)
    {
      const Triangulation found =
        triangulationByRounds(executor, viewOf(cloud), weightsOf(cloud), options);
      EXPECT_EQ(bitDifference(found, wanted), "");
    });
}

/// Fail at every allocation until one run is whole.
/// @param run (): throws OutOfMemory, or compares its result
template <class Run>
void expectShortages(WatchedExecutor& executor, const Run& run)
{
  int failures = 0;
  for (;; ++failures)
  {
    const int before = executor.allocations();
    executor.failAt = before + failures + 1;
    const int code = codeOf(run);
    EXPECT_EQ(executor.bytesOut(), 0) << "allocation " << failures + 1;
    EXPECT_EQ(executor.blocksOut(), 0) << "allocation " << failures + 1;
    if (code == -1)
    {
      EXPECT_EQ(executor.allocations(), before + failures);
      break;
    }
    ASSERT_EQ(code, static_cast<int>(ErrorCode::OutOfMemory));
    EXPECT_EQ(executor.allocations(), before + failures + 1) << "asked again after the failure";
    executor.failAt = 0;
    ASSERT_EQ(codeOf(run), -1) << "does not work again after the failure";
  }
  EXPECT_GT(failures, 20);
}

TEST(RoundsErrors, OutOfMemoryAtEveryAllocation)
{
  // More triangles than there is room for at the start, and duplicates.
  Random random(93);
  const Cloud cloud = repeated(fromFamily("shell0", 900, 93).make(), 2, random);
  const Hull wanted = convexHull(viewOf(cloud));
  Options options;
  options.threads = 1;
  WatchedExecutor executor;
  RoundsBuilder<WatchedExecutor, HullGeometry> engine(executor);
  expectShortages(executor,
    [&] { EXPECT_EQ(bitDifference(hullBy(engine, viewOf(cloud), options), wanted), ""); });
}

TEST(RoundsErrors, OutOfMemoryAtEveryAllocationOfATriangulation)
{
  Random random(94);
  const Cloud cloud = repeated(fromWeightedFamily("uniform", 600, 94).make(), 2, random);
  const Triangulation wanted = regularTriangulation(viewOf(cloud), weightsOf(cloud));
  Options options;
  options.threads = 1;
  WatchedExecutor executor;
  RoundsBuilder<WatchedExecutor, LiftedGeometry<true>> engine(executor);
  expectShortages(executor,
    [&]
    {
      const Triangulation found = triangulationBy(engine, viewOf(cloud), weightsOf(cloud), options);
      EXPECT_EQ(bitDifference(found, wanted), "");
    });
}

TEST(RoundsErrors, AnObserverMayThrow)
{
  const Cloud cloud = fromFamily("ball", 200, 95).make();
  for (std::size_t stopAt : { 1, 2, 9 })
  {
    std::size_t calls = 0;
    const RoundObserver observer = [&](const RoundReport&)
    {
      if (++calls == stopAt)
      {
        throw Error(ErrorCode::Aborted);
      }
    };
    WatchedExecutor executor;
    RoundsBuilder<WatchedExecutor, HullGeometry> engine(executor, &observer);
    EXPECT_EQ(codeOf([&] { hullBy(engine, viewOf(cloud), Options()); }),
      static_cast<int>(ErrorCode::Aborted));
    EXPECT_EQ(calls, stopAt);
    EXPECT_EQ(executor.blocksOut(), 0);
  }
}

TEST(RoundsErrors, NonFinitePointsAreAnErrorOrLeftOut)
{
  Random random(96);
  std::vector<std::int64_t> places;
  const Cloud cloud = withNonFinite(fromFamily("shell1e2", 500, 96).make(), random, places);
  const Cloud weighted =
    withNonFinite(fromWeightedFamily("uniformHeavy", 500, 96).make(), random, places);
  Options options;
  WatchedExecutor executor;
  EXPECT_EQ(codeOf([&] { hullByRounds(executor, viewOf(cloud), options); }),
    static_cast<int>(ErrorCode::NonFinite));
  EXPECT_EQ(codeOf([&]
              { triangulationByRounds(executor, viewOf(weighted), weightsOf(weighted), options); }),
    static_cast<int>(ErrorCode::NonFinite));
  EXPECT_TRUE(executor.calls().empty());
  options.nonFinite = NonFinitePolicy::Ignore;
  const Hull hull = hullByRounds(executor, viewOf(cloud), options);
  EXPECT_EQ(bitDifference(hull, convexHull(viewOf(cloud), options)), "");
  EXPECT_GT(hull.statistics.nonFinite, 0);
  const Triangulation found =
    triangulationByRounds(executor, viewOf(weighted), weightsOf(weighted), options);
  const Triangulation wanted = regularTriangulation(viewOf(weighted), weightsOf(weighted), options);
  EXPECT_EQ(bitDifference(found, wanted), "");
  EXPECT_EQ(found.statistics.nonFinite, wanted.statistics.nonFinite);
}

TEST(RoundsErrors, InputsThatSpanTooLittleDoNotReachTheEngine)
{
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  const Cloud clouds[] = { {}, { { 1, 2, 3 } }, { { 1, 2, 3 }, { 1, 2, 3 } },
    { { nan, 0, 0 }, { 0, 0, nan } }, { { 0, 0, 0 }, { 1, 1, 1 }, { 3, 3, 3 }, { 2, 2, 2 } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0.5, 0.5, 0 } } };
  for (const Cloud& cloud : clouds)
  {
    SCOPED_TRACE(toString(cloud));
    WatchedExecutor executor;
    const Hull hull = hullByRounds(executor, viewOf(cloud), options);
    EXPECT_EQ(bitDifference(hull, convexHull(viewOf(cloud), options)), "");
    EXPECT_LT(hull.dimension, 3);
    EXPECT_EQ(executor.allocations(), 0);
    EXPECT_TRUE(executor.calls().empty());
  }
  const Cloud weighted[] = { {}, { { 1, 2, 3 } }, { { 1, 2, 3 }, { 1, 2, 5 } },
    { { nan, 0, 0 }, { 0, 0, nan } }, { { 0, 0, 1 }, { 1, 1, 0 }, { 3, 3, 0 }, { 2, 2, 7 } } };
  for (const Cloud& cloud : weighted)
  {
    SCOPED_TRACE(toString(cloud));
    WatchedExecutor executor;
    const Triangulation found =
      triangulationByRounds(executor, viewOf(cloud), weightsOf(cloud), options);
    const Triangulation wanted = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
    EXPECT_EQ(bitDifference(found, wanted), "");
    EXPECT_LT(found.dimension, 2);
    EXPECT_EQ(executor.allocations(), 0);
    EXPECT_TRUE(executor.calls().empty());
  }
}

TEST(RoundsErrors, TheSmallestInputsThatDo)
{
  for (const Cloud& cloud : { latticeTetrahedron(2), latticeTetrahedron(3), integerGrid(2) })
  {
    WatchedExecutor executor;
    const Hull hull = hullByRounds(executor, viewOf(cloud), Options());
    EXPECT_EQ(bitDifference(hull, convexHull(viewOf(cloud))), "");
    EXPECT_GT(executor.calls().size(), 0u);
  }
  const Cloud weighted = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  WatchedExecutor executor;
  const Triangulation found =
    triangulationByRounds(executor, viewOf(weighted), weightsOf(weighted), Options());
  EXPECT_EQ(found.cellCount(), 1);
  EXPECT_GT(executor.calls().size(), 0u);
}

}
}
}
