// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The same bits on any number of threads, run after run, at sizes that keep all of them busy.
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <cmath>
#include <random>
#include <thread>

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

class Determinism : public ::testing::TestWithParam<Sized>
{
};

TEST_P(Determinism, AnyNumberOfThreadsGivesTheSameBits)
{
  const Sized sized = this->GetParam();
  const Input input = fromWeightedFamily(sized.family, effort(sized.count), 2024);
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = input.make();
  for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Options options;
    options.facets = facets;
    options.threads = 1;
    const Triangulation first = run(cloud, options);
    const Validation valid = validate(viewOf(cloud), weightsOf(cloud), first);
    ASSERT_TRUE(valid) << describe(valid.fault) << ", index " << valid.index;
    for (int threads : { 0, 2, 3, 4, 8, 2 })
    {
      options.threads = threads;
      const Triangulation found = run(cloud, options);
      EXPECT_EQ(bitDifference(found, first), "") << threads << " threads";
      if (threads > 0)
      {
        EXPECT_EQ(
          found.statistics.threads, threadCount(threads, static_cast<std::int64_t>(cloud.size())));
      }
    }
    options.vBiased = false;
    options.threads = 4;
    EXPECT_EQ(bitDifference(run(cloud, options), first), "") << "labels early";
  }
}

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, Determinism,
  ::testing::Values(Sized{ "uniform", 60000 }, Sized{ "uniformHeavy", 150000 },
    Sized{ "uniformHiding", 200000 }, Sized{ "gridOfTwoWeights", 40000 },
    Sized{ "smallIntegers", 60000 }, Sized{ "doubled", 50000 }, Sized{ "clusters", 50000 },
    Sized{ "wheel", 20000 }, Sized{ "far15", 40000 }, Sized{ "coplanarLiftsAlmost", 60000 }),
  [](const auto& given) { return std::string(given.param.family); });

TEST(RegularTriangulationDeterminism, DegenerateInputsGiveTheSameBits)
{
  for (const Input& input : largeWeightedInputs())
  {
    SCOPED_TRACE(input.name);
    const Cloud cloud = input.make();
    Options options;
    options.threads = 1;
    const Triangulation first = run(cloud, options);
    for (int threads : { 3, 8 })
    {
      options.threads = threads;
      EXPECT_EQ(bitDifference(run(cloud, options), first), "") << threads;
    }
  }
}

TEST(RegularTriangulationDeterminism, PatchesThatHideTheirBordersVerticesGiveTheSameBits)
{
  // A vertex that patches share may be hidden by a point of one of them: its label waits.
  for (int seed = 1; seed <= effort(20); ++seed)
  {
    for (const double mostWeight : { 3.0, 30.0, 1000.0 })
    {
      SCOPED_TRACE(
        "weights below " + std::to_string(mostWeight) + "/n, seed " + std::to_string(seed));
      const int count = 10000;
      Random random(seed);
      const Cloud cloud = withWeights(
        fromWeightedFamily("uniform", count, seed).make(), 0, mostWeight / count, random);
      Options options;
      options.threads = 1;
      const Triangulation first = run(cloud, options);
      for (int threads : { 2, 4, 16 })
      {
        options.threads = threads;
        ASSERT_EQ(bitDifference(run(cloud, options), first), "") << threads << " threads";
      }
    }
  }
}

TEST(RegularTriangulationDeterminism, CallersMayRunAtOnce)
{
  // The engine keeps no state of its own: callers on several threads do not meet.
  const Cloud a = fromWeightedFamily("uniformHeavy", effort(10000), 1).make();
  const Cloud b = squareGrid(50);
  Options options;
  options.threads = 2;
  const Triangulation ofA = run(a, options);
  const Triangulation ofB = run(b, options);
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
          faults[i] += bitDifference(run(even ? a : b, options), even ? ofA : ofB);
        }
      });
  }
  for (std::thread& caller : callers)
  {
    caller.join();
  }
  EXPECT_EQ(faults, std::vector<std::string>(4));
}

/// Integer points of a square, each about twice.
Cloud crowdedSquare(std::uint64_t seed)
{
  std::mt19937_64 engine(seed);
  engine.discard(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Cloud cloud;
  for (int i = 0; i < 3414; ++i)
  {
    const double x = std::floor(20 * uniform(engine));
    const double y = std::floor(20 * uniform(engine));
    cloud.push_back({ x, y, std::floor(20 * uniform(engine)) });
  }
  return cloud;
}

TEST(RegularTriangulationDeterminism, ManyPatchesOfDuplicates)
{
  // With the first, and without weights, two duplicates were corners of one quadrilateral.
  for (const std::uint64_t seed : { 102880, 1, 2, 3 })
  {
    const Cloud cloud = crowdedSquare(seed);
    for (const bool weighted : { false, true })
    {
      const WeightView weights = weighted ? weightsOf(cloud) : WeightView();
      Options options;
      options.threads = 1;
      const Triangulation alone = regularTriangulation(viewOf(cloud), weights, options);
      for (const int threads : { 3, 4 })
      {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(threads) + " threads");
        options.threads = threads;
        const Triangulation found = regularTriangulation(viewOf(cloud), weights, options);
        EXPECT_EQ(found.statistics.threads, threads);
        EXPECT_EQ(bitDifference(found, alone), "");
      }
    }
  }
}

}
}
}
