// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The same bits on any number of threads, run after run, at sizes that keep all of them busy.
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <thread>

namespace flipflop
{
namespace test
{

namespace
{

class Determinism : public ::testing::TestWithParam<Sized>
{
};

TEST_P(Determinism, AnyNumberOfThreadsGivesTheSameBits)
{
  const Input input = fromFamily(this->GetParam().family, effort(this->GetParam().count), 2024);
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = input.make();
  for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Options options;
    options.facets = facets;
    options.threads = 1;
    const Hull first = convexHull(viewOf(cloud), options);
    const Validation valid = validate(viewOf(cloud), first);
    ASSERT_TRUE(valid) << describe(valid.fault) << ", index " << valid.index;
    for (int threads : { 0, 1, 2, 3, 4, 8, 2, 4 })
    {
      options.threads = threads;
      const Hull hull = convexHull(viewOf(cloud), options);
      EXPECT_EQ(bitDifference(hull, first), "") << threads << " threads";
      if (threads > 0)
      {
        EXPECT_EQ(
          hull.statistics.threads, threadCount(threads, static_cast<std::int64_t>(cloud.size())));
      }
    }
    options.vBiased = false;
    options.threads = 4;
    EXPECT_EQ(bitDifference(convexHull(viewOf(cloud), options), first), "") << "labels early";
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, Determinism,
  ::testing::Values(Sized{ "shell0", 300000 }, Sized{ "shell1e4", 200000 }, Sized{ "cube", 500000 },
    Sized{ "ball", 300000 }, Sized{ "shell1e2", 200000 }, Sized{ "clustered", 200000 },
    Sized{ "paraboloid", 100000 }, Sized{ "far15", 200000 }, Sized{ "boxFaces", 200000 },
    Sized{ "doubled", 200000 }, Sized{ "coreAndShell", 200000 }, Sized{ "skewPlane", 50000 },
    Sized{ "thin12", 100000 }, Sized{ "skewNeedle", 50000 }),
  [](const auto& given) { return std::string(given.param.family); });

TEST(ConvexHullDeterminism, DegenerateInputsGiveTheSameBits)
{
  for (const Input& input : largeSpecialInputs())
  {
    SCOPED_TRACE(input.name);
    const Cloud cloud = input.make();
    Options options;
    options.threads = 1;
    const Hull first = convexHull(viewOf(cloud), options);
    for (int threads : { 3, 8 })
    {
      options.threads = threads;
      EXPECT_EQ(bitDifference(convexHull(viewOf(cloud), options), first), "") << threads;
    }
  }
}

TEST(ConvexHullDeterminism, PatchesThatHideTheirBordersVerticesGiveTheSameBits)
{
  // A vertex that patches share may be hidden by a point of one of them: its label waits.
  for (int seed = 1; seed <= effort(20); ++seed)
  {
    for (const char* family : { "shell1e4", "shell1e2" })
    {
      const Input input = fromFamily(family, 20000, seed);
      SCOPED_TRACE(input.name + ", seed " + std::to_string(seed));
      const Cloud cloud = input.make();
      Options options;
      options.threads = 1;
      const Hull first = convexHull(viewOf(cloud), options);
      for (int threads : { 2, 4, 16 })
      {
        options.threads = threads;
        ASSERT_EQ(bitDifference(convexHull(viewOf(cloud), options), first), "")
          << threads << " threads";
      }
    }
  }
}

TEST(ConvexHullDeterminism, CallersMayRunAtOnce)
{
  // The engine keeps no state of its own: callers on several threads do not meet.
  const Cloud a = fromFamily("shell0", effort(20000), 1).make();
  const Cloud b = cosphericalIntegers(5201);
  Options options;
  options.threads = 2;
  const Hull hullA = convexHull(viewOf(a), options);
  const Hull hullB = convexHull(viewOf(b), options);
  std::vector<std::thread> callers;
  std::vector<std::string> faults(4);
  for (int i = 0; i < 4; ++i)
  {
    callers.emplace_back(
      [&, i]()
      {
        for (int k = 0; k < 5; ++k)
        {
          const bool even = (i + k) % 2 == 0;
          faults[i] +=
            bitDifference(convexHull(viewOf(even ? a : b), options), even ? hullA : hullB);
        }
      });
  }
  for (std::thread& caller : callers)
  {
    caller.join();
  }
  EXPECT_EQ(faults, std::vector<std::string>(4));
}

}
}
}
