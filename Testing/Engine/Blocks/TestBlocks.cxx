// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What blocks have together is what one run on all points has, however points are dealt to them:
/// all families of the engine's tests, and small degenerate inputs in bulk.
#include "Blocks/BlockSummary.h"
#include "Blocks/ConflictBound.h"
#include "Testing/Engine/Blocks/BlocksInProcess.h"
#include "Testing/Engine/Conformance/RandomCases.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

Cloud withoutWeights(Cloud cloud)
{
  for (Point& p : cloud)
  {
    p[2] = 0;
  }
  return cloud;
}

/// Empty when blocks have what one run has.
std::string fault(BlockShape shape, const Cloud& cloud, const Dealing& dealing, int blocks,
  FacetMode facets = FacetMode::Triangles)
{
  Options options;
  options.facets = facets;
  options.threads = blocks % 2 + 1;
  return differenceFromOneRun(
    shape, cloud, runBlocks(shape, cloud, dealing, blocks, options), options);
}

/// While it lives, samples are small: blocks know little of each other, and have to ask.
class SmallSamples
{
public:
  SmallSamples()
    : usual(sampleSizes())
  {
    sampleSizes() = { 0, 0, 0, 0 };
  }
  SmallSamples(const SmallSamples&) = delete;
  SmallSamples& operator=(const SmallSamples&) = delete;
  ~SmallSamples() { sampleSizes() = this->usual; }

private:
  const SampleSizes usual;
};

/// Every shape that a kind's cloud has, each dealt in several ways.
void expectSame(const Kind& kind, const Cloud& cloud)
{
  const bool isHull = kind.dimension == 3;
  const int axes = isHull ? 3 : 2;
  std::vector<BlockShape> shapes = { BlockShape::RegularTriangulation, BlockShape::Delaunay };
  if (isHull)
  {
    shapes = { BlockShape::Hull };
  }
  for (const BlockShape shape : shapes)
  {
    const Cloud sites = shape == BlockShape::Delaunay ? withoutWeights(cloud) : cloud;
    for (const int blocks : { 1, 2, 5 })
    {
      const FacetMode facets = blocks == 2 ? FacetMode::Polygons : FacetMode::Triangles;
      EXPECT_EQ(fault(shape, sites, dealInHalves(sites, blocks, axes), blocks, facets), "")
        << blocks << " blocks in halves";
    }
    const SmallSamples small;
    EXPECT_EQ(fault(shape, sites, dealInHalves(sites, 8, axes), 8), "") << "8 blocks in halves";
    EXPECT_EQ(fault(shape, sites, dealAtRandom(sites, 3, axes, 1), 3), "") << "at random";
    EXPECT_EQ(fault(shape, sites, Dealing(sites.size(), 2), 4), "") << "all in one";
  }
}

class BlocksOfFamilies : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(BlocksOfFamilies, AreOneRun)
{
  const FamilyOf& of = this->GetParam();
  expectSame(*of.kind, of.kind->family(of.name, of.count, 1).make());
}

INSTANTIATE_TEST_SUITE_P(
  Hulls, BlocksOfFamilies, ::testing::ValuesIn(familiesOf(convexHulls, { 400 })), Named());
INSTANTIATE_TEST_SUITE_P(Triangulations, BlocksOfFamilies,
  ::testing::ValuesIn(familiesOf(regularTriangulations, { 400 })), Named());

class BlocksOfInputs : public ::testing::TestWithParam<InputOf>
{
};

TEST_P(BlocksOfInputs, AreOneRun)
{
  const InputOf& of = this->GetParam();
  expectSame(*of.kind, of.input.make());
}

INSTANTIATE_TEST_SUITE_P(
  Hulls, BlocksOfInputs, ::testing::ValuesIn(inputsOf(convexHulls, smallSpecialInputs())), Named());
INSTANTIATE_TEST_SUITE_P(Triangulations, BlocksOfInputs,
  ::testing::ValuesIn(inputsOf(regularTriangulations, smallWeightedInputs())), Named());

/// Stops at the third failure.
template <class Make>
void runDealtCases(BlockShape shape, int cases, const Make& make)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", effort(cases));
  int failures = 0;
  const SmallSamples small;
  for (std::int64_t seed = first; seed < first + count && failures < 3; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 1);
    const Cloud cloud = make(random);
    const int blocks = random.integer(1, 6);
    const int axes = shape == BlockShape::Hull ? 3 : 2;
    const Dealing dealing = seed % 3
      ? dealAtRandom(cloud, blocks, axes, static_cast<std::uint64_t>(seed))
      : dealInHalves(cloud, blocks, axes);
    const std::string found =
      fault(shape, cloud, dealing, blocks, seed % 2 ? FacetMode::Polygons : FacetMode::Triangles);
    if (!found.empty())
    {
      ++failures;
      std::string dealt;
      for (const int block : dealing)
      {
        dealt += std::to_string(block) + " ";
      }
      ADD_FAILURE() << "seed " << seed << ": " << found << "\n" << toString(cloud) << dealt;
    }
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

TEST(BlocksRandom, SmallIntegersWithWeights)
{
  runDealtCases(BlockShape::RegularTriangulation, 6000,
    [](Random& r) { return smallIntegerSites(r.integer(1, 24), 0, r.integer(1, 6), -3, 3, r); });
}

TEST(BlocksRandom, SmallIntegersWithGreatWeights)
{
  runDealtCases(BlockShape::RegularTriangulation, 3000,
    [](Random& r) { return smallIntegerSites(r.integer(1, 40), 0, 6, -40, 40, r); });
}

TEST(BlocksRandom, SmallIntegersWithoutWeights)
{
  runDealtCases(BlockShape::Delaunay, 6000,
    [](Random& r) { return smallIntegerSites(r.integer(1, 40), 0, r.integer(1, 7), 0, 0, r); });
}

TEST(BlocksRandom, SmallIntegersInSpace)
{
  runDealtCases(BlockShape::Hull, 6000,
    [](Random& r)
    {
      Cloud cloud(static_cast<std::size_t>(r.integer(1, 40)));
      const int side = r.integer(1, 5);
      for (Point& p : cloud)
      {
        p = { double(r.integer(0, side)), double(r.integer(0, side)), double(r.integer(0, side)) };
      }
      return cloud;
    });
}

TEST(BlocksRandom, Ulps)
{
  runDealtCases(
    BlockShape::RegularTriangulation, 3000, [](Random& r) { return withUlps(0x1p-52, 3, r); });
  runDealtCases(BlockShape::Hull, 3000, [](Random& r) { return withUlps(0x1p-52, 3, r); });
}

}

}
}
