// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The same bits on any number of threads, run after run: at sizes that keep all of them busy, and
/// of patches as small as can be, of inputs at random.
///
/// What goes wrong between patches may do so on one input of thousands: FLIPFLOP_TEST_CASES makes
/// more cases, FLIPFLOP_TEST_SEED starts them elsewhere.
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/RandomCases.h"

#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

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
    for (int threads : { 0, 2, 3, 8, 2 })
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
    std::vector<FamilyOf>{ { &convexHulls, "shell0", 150000 }, { &convexHulls, "shell1e4", 150000 },
      { &convexHulls, "cube", 500000 }, { &convexHulls, "ball", 300000 },
      { &convexHulls, "shell1e2", 200000 }, { &convexHulls, "clustered", 200000 },
      { &convexHulls, "paraboloid", 100000 }, { &convexHulls, "far15", 200000 },
      { &convexHulls, "boxFaces", 200000 }, { &convexHulls, "doubled", 200000 },
      { &convexHulls, "coreAndShell", 200000 }, { &convexHulls, "skewPlane", 30000 },
      { &convexHulls, "thin12", 100000 }, { &convexHulls, "skewNeedle", 30000 } }),
  Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, Determinism,
  ::testing::ValuesIn(std::vector<FamilyOf>{ { &regularTriangulations, "uniform", 60000 },
    { &regularTriangulations, "uniformHeavy", 100000 },
    { &regularTriangulations, "uniformHiding", 100000 },
    { &regularTriangulations, "gridOfTwoWeights", 40000 },
    { &regularTriangulations, "smallIntegers", 60000 },
    { &regularTriangulations, "doubled", 50000 }, { &regularTriangulations, "clusters", 50000 },
    { &regularTriangulations, "wheel", 20000 }, { &regularTriangulations, "far15", 40000 },
    { &regularTriangulations, "coplanarLiftsAlmost", 60000 } }),
  Named());

/// Some of the points again, with other weights or at other heights.
void addDuplicates(Cloud& cloud, Random& random)
{
  const auto count = static_cast<int>(cloud.size());
  for (int i = random.integer(0, count); i > 0; --i)
  {
    Point p = cloud[random.integer(0, count - 1)];
    p[2] += random.integer(-1, 1) * random.uniform();
    cloud.push_back(p);
  }
}

/// To integers of few bits, so that many positions are one and many signs are ties.
void roundToFew(Cloud& cloud, Random& random)
{
  double extent = 0;
  for (const Point& p : cloud)
  {
    extent = std::max({ extent, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  const double factor = random.integer(4, 40) / std::max(extent, 1e-300);
  for (Point& p : cloud)
  {
    for (double& x : p)
    {
      x = std::floor(x * factor);
    }
  }
}

/// Weights of any reach, from none that hides a point to all but a few.
void weigh(Cloud& cloud, Random& random)
{
  const double reach = std::ldexp(1.0, random.integer(-20, 2));
  const double slope[2] = { random.uniform(-1, 1), random.uniform(-1, 1) };
  const int kind = random.integer(0, 3);
  for (Point& p : cloud)
  {
    const double lift = p[0] * p[0] + p[1] * p[1];
    p[2] = kind == 0 ? reach * random.uniform()
      : kind == 1    ? lift - reach * random.uniform() // nearly one plane, lifted
      : kind == 2    ? slope[0] * p[0] + slope[1] * p[1]
                     : reach * std::sin(3 * p[0]) + 0.1 * random.uniform();
  }
}

struct Patched
{
  const char* name;
  const Kind* kind;
  bool weighted;
  int cases;

  friend void PrintTo(const Patched& of, std::ostream* out) { *out << of.name; }
};

class Patches : public ::testing::TestWithParam<Patched>
{
protected:
  static Cloud draw(Random& random)
  {
    const Patched& of = GetParam();
    const bool isHull = of.kind->dimension == 3;
    const std::vector<Family>& list =
      random.integer(0, isHull ? 3 : 1) == 0 ? weightedFamilies() : families();
    const Family& family = list[random.pick(list.size())];
    Cloud cloud = family.make(random.integer(50, isSanitized() ? 1500 : 4000), random);
    const int change = random.integer(0, 5);
    if (change == 0)
    {
      roundToFew(cloud, random);
    }
    if (change == 1)
    {
      addDuplicates(cloud, random);
    }
    if (of.weighted && random.integer(0, 1))
    {
      weigh(cloud, random);
    }
    return cloud;
  }

  static Views viewsOf(const Cloud& cloud)
  {
    return { viewOf(cloud), GetParam().weighted ? weightsOf(cloud) : WeightView() };
  }
};

TEST_P(Patches, AreAsOneThreadMakesThem)
{
  const Kind& kind = *GetParam().kind;
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", randomCases(GetParam().cases));
  for (std::int64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 5);
    const Cloud cloud = draw(random);
    Options options;
    options.facets = random.integer(0, 1) ? FacetMode::Polygons : FacetMode::Triangles;
    options.threads = 1;
    const Result alone = kind.runOn(viewsOf(cloud), options);
    const Validation valid = validate(viewsOf(cloud), alone);
    EXPECT_TRUE(valid) << "seed " << seed << ": " << describe(valid.fault);
    options.threads = random.integer(2, 4);
    options.vBiased = random.integer(0, 3) > 0;
    EXPECT_EQ(bitDifference(kind.runOn(viewsOf(cloud), options), alone), "")
      << "seed " << seed << ", " << cloud.size() << " points, " << options.threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(Random, Patches,
  ::testing::Values(Patched{ "OfHulls", &convexHulls, false, 200 },
    Patched{ "OfTriangulations", &regularTriangulations, true, 300 },
    Patched{ "OfTriangulationsWithoutWeights", &regularTriangulations, false, 200 }),
  [](const auto& given) { return given.param.name; });

struct Found
{
  const char* name;
  const Kind* kind;
  Cloud (*make)(std::uint64_t seed);
  std::vector<std::uint64_t> seeds;
};

/// What has once differed: two duplicates were corners of one quadrilateral; a vertex that patches
/// share was hidden by a point of one of them, and its label must wait.
TEST(Patches, OfWhatHasOnceDiffered)
{
  const auto heavy = [](std::uint64_t seed)
  {
    Random random(seed);
    return withWeights(fromWeightedFamily("uniform", 10000, seed).make(), 0, 0.003, random);
  };
  const auto crowdedSquare = [](std::uint64_t seed)
  {
    std::mt19937_64 engine(seed);
    engine.discard(5);
    const auto draw = [&]
    { return std::floor(20 * std::uniform_real_distribution<double>(-1, 1)(engine)); };
    Cloud cloud;
    for (int i = 0; i < 3414; ++i)
    {
      cloud.push_back({ draw(), draw(), draw() });
    }
    return cloud;
  };
  const auto shell = [](std::uint64_t seed) { return fromFamily("shell1e4", 20000, seed).make(); };
  const Found all[] = { { "crowded square", &regularTriangulations, crowdedSquare, { 102880, 1 } },
    { "heavy", &regularTriangulations, heavy, { 1, 2, 3, 4, 5 } },
    { "shell", &convexHulls, shell, { 1, 2, 3, 4, 5 } } };
  for (const Found& found : all)
  {
    for (const std::uint64_t seed : found.seeds)
    {
      const Cloud cloud = found.make(seed);
      for (const WeightView& weights : { weightsOf(cloud), WeightView() })
      {
        SCOPED_TRACE(found.name + (", seed " + std::to_string(seed)));
        Options options;
        options.threads = 1;
        const Result alone = found.kind->runOn({ viewOf(cloud), weights }, options);
        for (const int threads : { 2, 3, 4, 16 })
        {
          options.threads = threads;
          EXPECT_EQ(
            bitDifference(found.kind->runOn({ viewOf(cloud), weights }, options), alone), "")
            << threads << " threads";
        }
      }
    }
  }
}

}
}
}
