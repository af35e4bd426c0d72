// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The same bits on any number of threads, run after run, at sizes that keep all of them busy.
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Kind.h"

#include <cmath>
#include <random>

namespace flipflop
{
namespace test
{

namespace
{

void expectSameBits(const Kind& kind, const Cloud& cloud, const std::vector<int>& threadsTried)
{
  Options options;
  options.threads = 1;
  const Result first = kind.run(cloud, options);
  for (int threads : threadsTried)
  {
    options.threads = threads;
    EXPECT_EQ(bitDifference(kind.run(cloud, options), first), "") << threads << " threads";
  }
}

class Determinism : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(Determinism, AnyNumberOfThreadsGivesTheSameBits)
{
  const Kind& kind = *this->GetParam().kind;
  const Input input = kind.family(this->GetParam().name, effort(this->GetParam().count), 2024);
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = input.make();
  for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Options options;
    options.facets = facets;
    options.threads = 1;
    const Result first = kind.run(cloud, options);
    const Validation valid = validate(cloud, first);
    ASSERT_TRUE(valid) << describe(valid.fault) << ", index " << valid.index;
    for (int threads : { 0, 1, 2, 3, 4, 8, 2, 4 })
    {
      options.threads = threads;
      const Result found = kind.run(cloud, options);
      EXPECT_EQ(bitDifference(found, first), "") << threads << " threads";
      if (threads > 0)
      {
        EXPECT_EQ(complexOf(found).statistics.threads,
          threadCount(threads, static_cast<std::int64_t>(cloud.size())));
      }
    }
    options.vBiased = false;
    options.threads = 4;
    EXPECT_EQ(bitDifference(kind.run(cloud, options), first), "") << "labels early";
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, Determinism,
  ::testing::ValuesIn(
    std::vector<FamilyOf>{ { &convexHulls, "shell0", 300000 }, { &convexHulls, "shell1e4", 200000 },
      { &convexHulls, "cube", 500000 }, { &convexHulls, "ball", 300000 },
      { &convexHulls, "shell1e2", 200000 }, { &convexHulls, "clustered", 200000 },
      { &convexHulls, "paraboloid", 100000 }, { &convexHulls, "far15", 200000 },
      { &convexHulls, "boxFaces", 200000 }, { &convexHulls, "doubled", 200000 },
      { &convexHulls, "coreAndShell", 200000 }, { &convexHulls, "skewPlane", 50000 },
      { &convexHulls, "thin12", 100000 }, { &convexHulls, "skewNeedle", 50000 } }),
  Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, Determinism,
  ::testing::ValuesIn(std::vector<FamilyOf>{ { &regularTriangulations, "uniform", 60000 },
    { &regularTriangulations, "uniformHeavy", 150000 },
    { &regularTriangulations, "uniformHiding", 200000 },
    { &regularTriangulations, "gridOfTwoWeights", 40000 },
    { &regularTriangulations, "smallIntegers", 60000 },
    { &regularTriangulations, "doubled", 50000 }, { &regularTriangulations, "clusters", 50000 },
    { &regularTriangulations, "wheel", 20000 }, { &regularTriangulations, "far15", 40000 },
    { &regularTriangulations, "coplanarLiftsAlmost", 60000 } }),
  Named());

void expectSameBitsOfLargeInputs(const Kind& kind)
{
  for (const Input& input : kind.largeInputs())
  {
    SCOPED_TRACE(input.name);
    expectSameBits(kind, input.make(), { 3, 8 });
  }
}

TEST(ConvexHullDeterminism, DegenerateInputsGiveTheSameBits)
{
  expectSameBitsOfLargeInputs(convexHulls);
}

TEST(RegularTriangulationDeterminism, DegenerateInputsGiveTheSameBits)
{
  expectSameBitsOfLargeInputs(regularTriangulations);
}

// A vertex that patches share may be hidden by a point of one of them: its label waits.

TEST(ConvexHullDeterminism, PatchesThatHideTheirBordersVerticesGiveTheSameBits)
{
  for (int seed = 1; seed <= effort(20) && !HasFailure(); ++seed)
  {
    for (const char* family : { "shell1e4", "shell1e2" })
    {
      const Input input = fromFamily(family, 20000, seed);
      SCOPED_TRACE(input.name + ", seed " + std::to_string(seed));
      expectSameBits(convexHulls, input.make(), { 2, 4, 16 });
    }
  }
}

TEST(RegularTriangulationDeterminism, PatchesThatHideTheirBordersVerticesGiveTheSameBits)
{
  for (int seed = 1; seed <= effort(20) && !HasFailure(); ++seed)
  {
    for (const double mostWeight : { 3.0, 30.0, 1000.0 })
    {
      SCOPED_TRACE(
        "weights below " + std::to_string(mostWeight) + "/n, seed " + std::to_string(seed));
      const int count = 10000;
      Random random(seed);
      const Cloud cloud = fromWeightedFamily("uniform", count, seed).make();
      expectSameBits(
        regularTriangulations, withWeights(cloud, 0, mostWeight / count, random), { 2, 4, 16 });
    }
  }
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
