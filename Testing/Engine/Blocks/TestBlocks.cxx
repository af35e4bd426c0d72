// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What blocks have together is what one run on all points has, however points are dealt to them,
/// and whether or not they wait as bytes: all families of the engine's tests, and small degenerate
/// inputs in bulk.
#include "Blocks/ConflictBound.h"
#include "Testing/Engine/Blocks/BlocksInProcess.h"
#include "Testing/Engine/Conformance/RandomCases.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// Empty when blocks have what one run has.
std::string fault(BlockShape shape, Cloud cloud, const Dealing& dealing, int blocks,
  FacetMode facets = FacetMode::Triangles)
{
  for (Point& p : cloud)
  {
    p[2] = shape == BlockShape::Delaunay ? 0 : p[2];
  }
  Options options;
  options.facets = facets;
  options.threads = blocks % 2 + 1;
  return differenceFromOneRun(
    shape, cloud, runBlocks(shape, cloud, dealing, blocks, options), options);
}

/// Blocks that wait as bytes between any two calls send the same messages, and have the same.
void expectSameAsBytes(
  BlockShape shape, const Cloud& cloud, const Dealing& dealing, int blocks, int threads)
{
  SCOPED_TRACE(threads);
  Options options;
  options.facets = FacetMode::Polygons;
  options.threads = threads;
  std::vector<BlockMessage> messages[2];
  BlocksReport reports[2];
  for (const Waiting waiting : { Waiting::InMemory, Waiting::AsBytes })
  {
    const auto i = static_cast<std::size_t>(waiting);
    reports[i] = runBlocks(
      shape, cloud, dealing, blocks, options,
      [&](BlockMessage message)
      {
        messages[i].push_back(message);
        return message;
      },
      waiting);
  }
  const auto& [kept, saved] = reports;
  EXPECT_EQ(messages[0], messages[1]);
  EXPECT_EQ(kept.cells, saved.cells);
  EXPECT_EQ(kept.ids, saved.ids);
  EXPECT_EQ(kept.hidden, saved.hidden);
  EXPECT_EQ(kept.dimension, saved.dimension);
  EXPECT_EQ(kept.volume, saved.volume);
  EXPECT_EQ(kept.area, saved.area);
  EXPECT_EQ(kept.received, saved.received);
  EXPECT_EQ(kept.fault, saved.fault);
  Statistics::eachField(
    [&](const char* name, auto field)
    {
      if (std::string(name).find("seconds") != 0)
      {
        EXPECT_EQ(kept.statistics.*field, saved.statistics.*field) << name;
      }
    });
}

class Blocks : public ::testing::TestWithParam<InputOf>
{
};

/// Every shape that a kind's cloud has, each dealt in several ways.
TEST_P(Blocks, AreOneRun)
{
  const bool isHull = this->GetParam().kind->dimension == 3;
  const int axes = isHull ? 3 : 2;
  const Cloud cloud = this->GetParam().input.make();
  for (const BlockShape shape :
    { isHull ? BlockShape::Hull : BlockShape::RegularTriangulation, BlockShape::Delaunay })
  {
    for (const int blocks : { 1, 2, 5 })
    {
      const FacetMode facets = blocks == 2 ? FacetMode::Polygons : FacetMode::Triangles;
      EXPECT_EQ(fault(shape, cloud, dealInHalves(cloud, blocks, axes), blocks, facets), "")
        << blocks << " blocks in halves";
    }
    const SmallSamples small;
    EXPECT_EQ(fault(shape, cloud, dealInHalves(cloud, 8, axes), 8), "") << "8 blocks in halves";
    EXPECT_EQ(fault(shape, cloud, dealAtRandom(cloud, 3, axes, 1), 3), "") << "at random";
    EXPECT_EQ(fault(shape, cloud, Dealing(cloud.size(), 2), 4), "") << "all in one";
    if (isHull)
    {
      break;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Hulls, Blocks, ::testing::ValuesIn(blockInputs(convexHulls)));
INSTANTIATE_TEST_SUITE_P(
  Triangulations, Blocks, ::testing::ValuesIn(blockInputs(regularTriangulations)));

Cloud integersInSpace(int count, int side, Random& random)
{
  Cloud cloud(static_cast<std::size_t>(count));
  for (Point& p : cloud)
  {
    p = { double(random.integer(0, side)), double(random.integer(0, side)),
      double(random.integer(0, side)) };
  }
  return cloud;
}

struct RandomBlocks
{
  const char* name;
  BlockShape shape;
  int cases;
  Cloud (*make)(Random&);

  friend void PrintTo(const RandomBlocks& of, std::ostream* out) { *out << of.name; }
};

const RandomBlocks randomBlocks[] = {
  { "Weights", BlockShape::RegularTriangulation, 6000,
    [](Random& r) { return smallIntegerSites(r.integer(1, 24), 0, r.integer(1, 6), -3, 3, r); } },
  { "GreatWeights", BlockShape::RegularTriangulation, 3000,
    [](Random& r) { return smallIntegerSites(r.integer(1, 40), 0, 6, -40, 40, r); } },
  { "NoWeights", BlockShape::Delaunay, 6000,
    [](Random& r) { return smallIntegerSites(r.integer(1, 40), 0, r.integer(1, 7), 0, 0, r); } },
  { "Space", BlockShape::Hull, 6000,
    [](Random& r) { return integersInSpace(r.integer(1, 40), r.integer(1, 5), r); } },
  { "Ulps", BlockShape::RegularTriangulation, 3000,
    [](Random& r) { return withUlps(0x1p-52, 3, r); } },
  { "UlpsInSpace", BlockShape::Hull, 3000, [](Random& r) { return withUlps(0x1p-52, 3, r); } },
};

class BlocksInBulk : public ::testing::TestWithParam<RandomBlocks>
{
};

/// Stops at the third failure.
TEST_P(BlocksInBulk, AreOneRun)
{
  const RandomBlocks& of = this->GetParam();
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", randomCases(of.cases));
  int failures = 0;
  for (std::int64_t seed = first; seed < first + count && failures < 3; ++seed)
  {
    // In half of the cases most queries are triangulated.
    const SmallSamples small(seed / 2 % 2 ? ReplyLimits() : ReplyLimits{ 1, 0 });
    Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 1);
    const Cloud cloud = of.make(random);
    const int blocks = random.integer(1, 6);
    const int axes = of.shape == BlockShape::Hull ? 3 : 2;
    const Dealing dealing = seed % 3
      ? dealAtRandom(cloud, blocks, axes, static_cast<std::uint64_t>(seed))
      : dealInHalves(cloud, blocks, axes);
    const std::string found = fault(
      of.shape, cloud, dealing, blocks, seed % 2 ? FacetMode::Polygons : FacetMode::Triangles);
    if (seed % 5 == 0)
    {
      expectSameAsBytes(of.shape, cloud, dealing, blocks, 1);
    }
    failures += found.empty() ? 0 : 1;
    EXPECT_EQ(found, "") << "seed " << seed << "\n"
                         << toString(cloud) << ::testing::PrintToString(dealing);
  }
}

INSTANTIATE_TEST_SUITE_P(Integers, BlocksInBulk, ::testing::ValuesIn(randomBlocks));

/// The exact signs for a point do not grow with the points, also where each facet is near all of
/// them: on a circle, on two, on a line, nearly on a line, on a lattice.
TEST(BlocksWork, IsSteady)
{
  const auto onCircle = [](int i) { return Point{ std::cos(i), std::sin(i), 0 }; };
  const std::vector<std::pair<const char*, std::function<Point(int)>>> families = {
    { "circle", onCircle },
    { "circles",
      [&](int i) {
        return Point{ onCircle(i)[0] + 3 * (i % 2), onCircle(i)[1], 0 };
      } },
    { "line",
      [](int i) {
        return Point{ i * 0.37, i * 0.37, 0 };
      } },
    { "near-line",
      [](int i) {
        return Point{ i * 0.37, i * 0.37 * 0.3, 0 };
      } },
    { "line and one point",
      [](int i) {
        return Point{ i * 0.37, i == 500 ? 1000.0 : 0.0, 0 };
      } },
    { "lattice",
      [](int i) {
        return Point{ double(i / 64), double(i % 64), 0 };
      } },
  };
  for (const auto& [name, point] : families)
  {
    SCOPED_TRACE(name);
    const auto signsFor = [&, &make = point](int count)
    {
      Cloud cloud;
      for (int i = 0; i < count; ++i)
      {
        cloud.push_back(make(i));
      }
      Options options;
      options.threads = 1;
      const BlocksReport report =
        runBlocks(BlockShape::Delaunay, cloud, dealInHalves(cloud, 4, 2), 4, options);
      EXPECT_EQ(differenceFromOneRun(BlockShape::Delaunay, cloud, report, options), "");
      return static_cast<double>(report.statistics.exactCalls) / count;
    };
    const double few = signsFor(1000);
    const double many = signsFor(8000);
    if (std::getenv("FLIPFLOP_TEST_PRINT"))
    {
      std::printf("%-12s %9.2f %9.2f\n", name, few, many);
    }
    EXPECT_LE(many, 2 * few + 10);
  }
}

/// A thin patch has a point above a plane, also where squares of its lengths lost bits or vanished
/// before it was scaled.
TEST(ConflictBounds, HoldWhereSquaresVanish)
{
  constexpr std::uint64_t Seed = 7;
  SCOPED_TRACE(Seed);
  Random random(Seed);
  const auto uniform = [&random] { return random.integer(-1000, 1000) / 1024.0; };
  for (int i = 0; i < 3000; ++i)
  {
    const int exponent = random.integer(-540, -530);
    const auto scale = [](double* x, int by)
    { std::transform(x, x + 3, x, [by](double value) { return std::ldexp(value, by); }); };
    const double n[2] = { uniform(), uniform() };
    const double m[2] = { n[0] + 0.25 * uniform(), n[1] + 0.25 * uniform() };
    const auto heightOf = [&m](const double* x) { return m[0] * x[0] + m[1] * x[1] + x[2]; };
    std::vector<BlockSite> sites(8);
    double highest[3] = { 0, 0, -HUGE_VAL };
    for (BlockSite& site : sites)
    {
      site.x[0] = uniform();
      site.x[1] = uniform();
      site.x[2] = uniform() / 256 - n[0] * site.x[0] - n[1] * site.x[1];
      if (heightOf(site.x) > heightOf(highest))
      {
        std::copy(site.x, site.x + 3, highest);
      }
      scale(site.x, exponent);
    }
    BlockPatch patch(sites.data(), sites.data() + sites.size(), false);
    double sizes[3] = { patch.low, patch.high, patch.radius };
    for (double* const x : { patch.box.low, patch.box.high, patch.origin, sizes })
    {
      scale(x, -exponent);
    }
    patch.low = sizes[0];
    patch.high = sizes[1];
    patch.radius = sizes[2];
    const double a[3] = { highest[0], highest[1], highest[2] - 0.001 };
    const double b[3] = { a[0] + 1, a[1], a[2] - m[0] };
    const double c[3] = { a[0], a[1] + 1, a[2] - m[1] };
    ASSERT_FALSE(ConflictBound::ofPlane(a, b, c).most(patch) < 0) << exponent << ", " << i;
  }
}

}

}
}
