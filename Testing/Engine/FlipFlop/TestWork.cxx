// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The work for a point does not grow with the number of points: insertions, moves, flips, checks
/// and exact signs, counted at two sizes, for all families and for the shapes that people have.
///
/// Counts, not seconds: they are the same on every machine.
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Kind.h"
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

struct Counted
{
  const char* what;
  double small;
  double large;
};

/// Of a point.
std::vector<Counted> workOf(const Statistics& small, const Statistics& large)
{
  std::vector<Counted> all;
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
  static const std::map<std::string, double> most = { { "helix", 2.5 }, { "momentCurve", 8 },
    { "moment-curve", 6 }, { "thin200", 2 }, { "skewPlane", 2.2 }, { "wall", 2.1 },
    { "near-line", 2 }, { "lineAndPoint", 2 }, { "two-lines", 2 } };
  const auto known = most.find(name.substr(0, name.find("-shuffled")));
  return known == most.end() ? 1.5 : known->second;
}

Statistics statisticsOf(const Kind& kind, const Cloud& cloud, int threads = 1)
{
  Options options;
  options.threads = threads;
  return complexOf(kind.run(cloud, options)).statistics;
}

class Work : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(Work, IsSteady)
{
  const PointsPerThread here(UsualPointsPerThread);
  const FamilyOf& of = this->GetParam();
  const auto worked = [&](int count)
  {
    return statisticsOf(
      *of.kind, makeCloud(of.name, of.kind->dimension == 2, count, std::uint64_t(of.count)));
  };
  for (const Counted& counted : workOf(worked(Small), worked(Large)))
  {
    if (std::getenv("FLIPFLOP_TEST_PRINT"))
    {
      std::printf("%-12s %9.2f %9.2f\n", counted.what, counted.small, counted.large);
    }
    // Two of each for a point are little, whatever it was at the smaller size.
    EXPECT_LE(counted.large, mostGrowth(of.name) * counted.small + 2)
      << counted.what << " for a point";
  }
}

/// Families and shapes in use, these shuffled, too; each with its seed.
std::vector<FamilyOf> everything(const Kind& kind)
{
  std::vector<FamilyOf> all = familiesOf(kind, { 5 });
  for (const std::string& name : withShuffled(namesInUse(kind.dimension == 2)))
  {
    all.push_back({ &kind, name, 1 });
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, Work, ::testing::ValuesIn(everything(convexHulls)));
INSTANTIATE_TEST_SUITE_P(
  RegularTriangulation, Work, ::testing::ValuesIn(everything(regularTriangulations)));

TEST(WorkOn, CurvesIsLittle)
{
  for (const char* name : { "strands", "strands-shuffled" })
  {
    // Grown, 20 and more.
    const Statistics s = statisticsOf(convexHulls, makeCloud(name, false, Large, 1));
    EXPECT_LT(s.flips22, 10 * s.insertions) << name;
  }
}

/// Seen from inside, all points of a slab are near one plane, and no map of directions tells them
/// apart.
TEST(WorkOn, PointsOfAFlatBodyAreDismissed)
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
  const Statistics alone = statisticsOf(convexHulls, cloud);
  EXPECT_GT(alone.culled, 30000);
  EXPECT_EQ(statisticsOf(convexHulls, cloud, 4).culled, alone.culled);
}

/// Of a wall, the growth alone would not show that both sizes take more.
TEST(WorkOn, AWallTakesFewExactSigns)
{
  EXPECT_LT(statisticsOf(convexHulls, makeCloud("wall", false, Small, 1)).exactCalls, 10 * Small);
  EXPECT_LT(statisticsOf(convexHulls, makeCloud("wall", false, Large, 1)).exactCalls, 22 * Large);
}

/// All points are vertices; most triangles are slivers. At this size the sample's hull has more
/// vertices than the smaller levels have points.
TEST(WorkOn, CurvesOfManyPointsAreInserted)
{
  constexpr int Count = 560000;
  Cloud cloud;
  for (int i = 0; i < Count; ++i)
  {
    const double t = 6.283185307179586 * (i + 0.5) / Count;
    cloud.push_back({ std::cos(t), std::sin(t) + 0.3 * std::sin(2 * t), std::cos(2 * t) });
  }
  const Statistics s = statisticsOf(convexHulls, cloud);
  // 31 where they are grown.
  EXPECT_LT(s.flips22, 5 * s.points);
  EXPECT_LT(s.moves, 12 * s.points);
}

/// Where the border passes both sides of an edge, a merge asks what hangs on it: on a curve, all of
/// the part's rest.
TEST(WorkOn, MergesOfACurveIsLittle)
{
  const PointsPerThread here(UsualPointsPerThread);
  Cloud cloud = makeCloud("parabola", true, Large, 1);
  Random random(1);
  for (Point& p : cloud)
  {
    p[2] = random.uniform(0, 1e-12);
  }
  // In edges from the near end each time, 46,000 for a point.
  EXPECT_LT(statisticsOf(regularTriangulations, cloud).moves, 12 * Large);
}

/// One weight for all changes no triangulation.
TEST(WorkOn, OneWeightIsThatOnNone)
{
  const Cloud cloud = makeCloud("grid", true, Large, 1);
  const Triangulation none = regularTriangulation(viewOf(cloud));
  const std::vector<float> floats(cloud.size(), 7);
  std::vector<double> doubles(cloud.size(), -1e200);
  const auto count = static_cast<std::int64_t>(cloud.size());
  const WeightView all(doubles.data(), count);
  for (const WeightView& one : { WeightView(floats.data(), count), all })
  {
    const Triangulation found = regularTriangulation(viewOf(cloud), one);
    EXPECT_EQ(cellsOf(found), cellsOf(none));
    EXPECT_EQ(found.statistics.flips22, none.statistics.flips22);
    EXPECT_EQ(found.statistics.edgeChecks, none.statistics.edgeChecks);
  }
  doubles[cloud.size() / 3] = -2e200; // inside the grid
  EXPECT_EQ(regularTriangulation(viewOf(cloud), all).hiddenIds.size(), 1u);
  doubles.assign(cloud.size(), HUGE_VAL);
  expectError([&] { regularTriangulation(viewOf(cloud), all); }, ErrorCode::NonFinite, 0, count);
}

/// Parts are as large as users have them, not as small as the other tests make them.
TEST(PartsAsUsersHaveThem, ThreadsAddNoWork)
{
  const PointsPerThread here(UsualPointsPerThread);
  const auto expectSame = [](const auto& worked)
  {
    const Statistics alone = worked(1);
    const Statistics shared = worked(4);
    EXPECT_EQ(shared.flips22, alone.flips22);
    EXPECT_EQ(shared.flips31, alone.flips31);
    EXPECT_EQ(shared.edgeChecks, alone.edgeChecks);
    EXPECT_EQ(shared.moves, alone.moves);
    EXPECT_EQ(shared.exactCalls, alone.exactCalls);
  };
  for (const std::string& name : withShuffled(namesInUse(true)))
  {
    SCOPED_TRACE(name);
    Cloud cloud = makeCloud(name, true, 40000, 1);
    Random random(2);
    for (Point& p : cloud)
    {
      p[2] = random.uniform(0, 1e-12);
    }
    for (const WeightView& weights : { WeightView(), weightsOf(cloud) })
    {
      expectSame(
        [&](int threads)
        {
          Options options;
          options.threads = threads;
          return regularTriangulation(viewOf(cloud), weights, options).statistics;
        });
    }
  }
  for (const char* name : { "shell0", "shell1e4", "pancake", "cylinder", "helix", "paraboloid",
         "skewNeedle", "collinearAlmost" })
  {
    SCOPED_TRACE(name);
    const Cloud cloud = makeCloud(name, false, 100000, 1);
    expectSame([&](int threads) { return statisticsOf(convexHulls, cloud, threads); });
  }
}

/// Among thousands of points are places that flips by the V-criterion alone leave.
TEST(PartsAsUsersHaveThem, NeedTheDCriterion)
{
  const PointsPerThread here(UsualPointsPerThread);
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    const Cloud cloud = fromWeightedFamily("uniformHeavy", 20000, seed).make();
    Options options;
    options.threads = 1;
    options.vBiased = false; // else it waits, and hardly ever comes to that
    const Triangulation found = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
    EXPECT_GT(found.statistics.labelled, 0) << "seed " << seed;
    EXPECT_GT(found.statistics.flipsD, 0) << "seed " << seed;
    EXPECT_GT(found.statistics.flips31, 0) << "seed " << seed;
  }
}

}
}
}
