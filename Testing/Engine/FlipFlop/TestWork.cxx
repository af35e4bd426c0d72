// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The work for a point does not grow with the number of points: insertions, moves, flips, checks
/// and exact signs, counted at two sizes, for all families and for the shapes that people have.
///
/// Counts, not seconds: they are the same on every machine.
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsInUse.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <cmath>
#include <cstdio>
#include <map>

namespace flipflop
{
namespace test
{

namespace
{

constexpr int Small = 5000;
constexpr int Large = 8 * Small;

struct Work
{
  const char* what;
  double small;
  double large;
};

/// Of a point.
std::vector<Work> workOf(const Statistics& small, const Statistics& large)
{
  std::vector<Work> all;
  const auto add = [&](const char* what, auto count)
  {
    all.push_back({ what, static_cast<double>(count(small)) / static_cast<double>(small.points),
      static_cast<double>(count(large)) / static_cast<double>(large.points) });
  };
  add("insertions", [](const Statistics& s) { return s.insertions; });
  add("moves", [](const Statistics& s) { return s.moves; });
  add("flips", [](const Statistics& s) { return s.flips22 + s.flips31; });
  add("edge checks", [](const Statistics& s) { return s.edgeChecks; });
  add("exact signs", [](const Statistics& s) { return s.exactCalls; });
  return all;
}

/// How much more a point may cost at eight times the size, shuffled or not. Walks through slivers
/// are longer the more there are; that the flips of a knot grow shows only in the samples of more
/// points than these. Hulls of the smaller size are quickhull's, which takes few exact signs for a
/// flat cloud, and few flips for a curve. What that comes to today is the bound.
double mostGrowth(const std::string& name)
{
  static const std::map<std::string, double> most = { { "helix", 2.5 }, { "knot", 3.5 },
    { "momentCurve", 8 }, { "moment-curve", 2 }, { "cone", 2.1 }, { "thin200", 2 },
    { "skewNeedle", 2 }, { "wall", 2 }, { "near-line", 2 }, { "twoLines", 2 } };
  const auto known = most.find(name.substr(0, name.find("-shuffled")));
  return known == most.end() ? 1.5 : known->second;
}

template <class Run>
void expectSteadyWork(
  const std::string& name, const Cloud& small, const Cloud& large, const Run& run)
{
  const double growth = mostGrowth(name);
  for (const Work& work : workOf(run(small), run(large)))
  {
    if (std::getenv("FLIPFLOP_TEST_PRINT"))
    {
      std::printf("%-12s %9.2f %9.2f\n", work.what, work.small, work.large);
    }
    // Two of each for a point are little, whatever it was at the smaller size.
    EXPECT_LE(work.large, growth * work.small + 2) << work.what << " for a point";
  }
}

Statistics hullWork(const Cloud& cloud)
{
  Options options;
  options.threads = 1;
  return convexHull(viewOf(cloud), options).statistics;
}

Statistics triangulationWork(const Cloud& weighted)
{
  Options options;
  options.threads = 1;
  return regularTriangulation(viewOf(weighted), weightsOf(weighted), options).statistics;
}

class HullFamily : public ::testing::TestWithParam<const char*>
{
};

TEST_P(HullFamily, WorkIsSteady)
{
  const auto make = [this](int count) { return fromFamily(this->GetParam(), count, 5).make(); };
  expectSteadyWork(this->GetParam(), make(Small), make(Large), hullWork);
}

std::vector<const char*> namesOf(const std::vector<Family>& list)
{
  std::vector<const char*> names;
  for (const Family& family : list)
  {
    names.push_back(family.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Work, HullFamily, ::testing::ValuesIn(namesOf(families())),
  [](const auto& given) { return std::string(given.param); });

class TriangulationFamily : public ::testing::TestWithParam<const char*>
{
};

TEST_P(TriangulationFamily, WorkIsSteady)
{
  const auto make = [this](int count)
  { return fromWeightedFamily(this->GetParam(), count, 5).make(); };
  expectSteadyWork(this->GetParam(), make(Small), make(Large), triangulationWork);
}

INSTANTIATE_TEST_SUITE_P(Work, TriangulationFamily,
  ::testing::ValuesIn(namesOf(weightedFamilies())),
  [](const auto& given) { return std::string(given.param); });

TEST(Work, HullsOfShapesInUse)
{
  for (const std::string& name : withShuffled(namesInUse(false)))
  {
    SCOPED_TRACE(name);
    expectSteadyWork(
      name, makeCloud(name, false, Small, 1), makeCloud(name, false, Large, 1), hullWork);
  }
}

TEST(Work, TriangulationsOfShapesInUse)
{
  for (const std::string& name : withShuffled(namesInUse(true)))
  {
    SCOPED_TRACE(name);
    expectSteadyWork(
      name, makeCloud(name, true, Small, 1), makeCloud(name, true, Large, 1), triangulationWork);
  }
}

TEST(Work, HullsAlongCurvesAreRight)
{
  for (const char* name : { "strands", "strands-shuffled" })
  {
    SCOPED_TRACE(name);
    const Cloud cloud = makeCloud(name, false, Large, 1);
    Options options;
    options.threads = 1;
    const Hull alone = convexHull(viewOf(cloud), options);
    // Grown, 20 and more.
    EXPECT_LT(alone.statistics.flips22, 10 * alone.statistics.insertions);
    const Validation valid = validate(viewOf(cloud), alone);
    EXPECT_TRUE(valid) << describe(valid.fault) << ", index " << valid.index;
    for (const int threads : { 2, 4 })
    {
      options.threads = threads;
      EXPECT_EQ(bitDifference(convexHull(viewOf(cloud), options), alone), "") << threads;
    }
  }
}

/// Seen from inside, all points of a slab are near one plane, and no map of directions tells them
/// apart.
TEST(Work, PointsOfAFlatBodyAreDismissed)
{
  Random random(12);
  Cloud cloud;
  for (int i = 0; i < 60000; ++i)
  {
    const double x = random.uniform(0, 5);
    const double y = random.uniform(0, 3);
    const double z = random.uniform(-0.002, 0.002);
    cloud.push_back({ 0.6 * x - 0.8 * z, y, 0.8 * x + 0.6 * z });
  }
  Options options;
  options.threads = 1;
  const Hull alone = convexHull(viewOf(cloud), options);
  EXPECT_GT(alone.statistics.culled, 30000);
  EXPECT_TRUE(validate(viewOf(cloud), alone));
  options.threads = 4;
  const Hull shared = convexHull(viewOf(cloud), options);
  EXPECT_EQ(bitDifference(shared, alone), "");
  EXPECT_EQ(shared.statistics.culled, alone.statistics.culled);
}

/// All points are vertices; most triangles are slivers. At this size the sample's hull has more
/// vertices than the smaller levels have points.
TEST(Work, CurvesOfManyPointsAreInserted)
{
  constexpr int Count = 560000;
  Cloud cloud;
  for (int i = 0; i < Count; ++i)
  {
    const double t = 6.283185307179586 * (i + 0.5) / Count;
    cloud.push_back({ std::cos(t), std::sin(t) + 0.3 * std::sin(2 * t), std::cos(2 * t) });
  }
  const Statistics s = hullWork(cloud);
  // 31 where they are grown.
  EXPECT_LT(s.flips22, 5 * s.points);
  EXPECT_LT(s.moves, 12 * s.points);
}

/// Parts are as large as users have them, not as small as the other tests make them.
class PartsAsUsersHaveThem : public ::testing::Test
{
public:
  PartsAsUsersHaveThem() { pointsPerThread() = UsualPointsPerThread; }
  ~PartsAsUsersHaveThem() override { pointsPerThread() = 1; }
};

TEST_F(PartsAsUsersHaveThem, ThreadsAddNoWork)
{
  for (const std::string& name : withShuffled(namesInUse(true)))
  {
    SCOPED_TRACE(name);
    const Cloud cloud = makeCloud(name, true, 60000, 1);
    for (const WeightView& weights : { WeightView(), weightsOf(cloud) })
    {
      const auto worked = [&](int threads)
      {
        Options options;
        options.threads = threads;
        return regularTriangulation(viewOf(cloud), weights, options).statistics;
      };
      const Statistics alone = worked(1);
      const Statistics shared = worked(4);
      EXPECT_EQ(shared.flips22, alone.flips22);
      EXPECT_EQ(shared.flips31, alone.flips31);
      EXPECT_EQ(shared.edgeChecks, alone.edgeChecks);
      EXPECT_EQ(shared.moves, alone.moves);
      EXPECT_EQ(shared.exactCalls, alone.exactCalls);
    }
  }
}

}
}
}
