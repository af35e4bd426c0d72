// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rounds that run out of memory at any place, or whose observer throws: one typed error, nothing
/// left behind, and the same engine works again. Inputs without work for an engine do not reach it.
/// The device test stops runs (Device/MemoryChecks.cxx).
#include "Geometry/HullGeometry.h"
#include "Rounds/RoundsBuilder.h"
#include "Testing/Cuda/Rounds/RoundsKinds.h"

#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();

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
    EXPECT_EQ(executor.allocations(), before + failures + 1) << "allocated after the failure";
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
  const Cloud sites = repeated(fromWeightedFamily("uniform", 600, 94).make(), 2, random);
  const Hull hull = convexHull(viewOf(cloud));
  const Triangulation triangulation = regularTriangulation(viewOf(sites), weightsOf(sites));
  Options options;
  options.threads = 1;
  WatchedExecutor executor;
  RoundsBuilder<WatchedExecutor, HullGeometry> hulls(executor);
  expectShortages(
    executor, [&] { EXPECT_EQ(bitDifference(hullBy(hulls, viewOf(cloud), options), hull), ""); });
  RoundsBuilder<WatchedExecutor, LiftedGeometry<true>> triangulations(executor);
  expectShortages(executor,
    [&]
    {
      const Triangulation found =
        triangulationBy(triangulations, viewOf(sites), weightsOf(sites), options);
      EXPECT_EQ(bitDifference(found, triangulation), "");
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

TEST(RoundsErrors, NonFinitePointsDoNotReachTheEngine)
{
  const Cloud cloud = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { nan, 0, 1 }, { 0, 0, 1 } };
  for (const RoundsKind& kind : roundsKinds)
  {
    WatchedExecutor executor;
    EXPECT_EQ(codeOf([&] { kind.rounds(executor, cloud, Options(), nullptr); }),
      static_cast<int>(ErrorCode::NonFinite));
    EXPECT_TRUE(executor.calls().empty());
  }
}

TEST(RoundsErrors, InputsThatSpanTooLittleDoNotReachTheEngine)
{
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  // Of these the last reaches the engine: it spans just enough.
  const std::vector<Cloud> hulls = { {}, { { 1, 2, 3 } }, { { 1, 2, 3 }, { 1, 2, 3 } },
    { { nan, 0, 0 }, { 0, 0, nan } }, { { 0, 0, 0 }, { 1, 1, 1 }, { 3, 3, 3 }, { 2, 2, 2 } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0.5, 0.5, 0 } },
    latticeTetrahedron(2) };
  const std::vector<Cloud> sites = { {}, { { 1, 2, 3 } }, { { 1, 2, 3 }, { 1, 2, 5 } },
    { { nan, 0, 0 }, { nan, 0, nan } }, { { 0, 0, 1 }, { 1, 1, 0 }, { 3, 3, 0 }, { 2, 2, 7 } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } };
  for (const RoundsKind& kind : roundsKinds)
  {
    const std::vector<Cloud>& clouds = kind.kind->dimension == 3 ? hulls : sites;
    for (const Cloud& cloud : clouds)
    {
      SCOPED_TRACE(kind.name + toString(cloud));
      const bool spans = &cloud == &clouds.back();
      WatchedExecutor executor;
      const Result found = kind.rounds(executor, cloud, options, nullptr);
      EXPECT_EQ(bitDifference(found, kind.cpu(cloud, options)), "");
      EXPECT_EQ(complexOf(found).dimension == kind.kind->dimension, spans);
      EXPECT_EQ(executor.allocations() > 0, spans);
      EXPECT_EQ(executor.calls().empty(), !spans);
    }
  }
}

}
}
}
