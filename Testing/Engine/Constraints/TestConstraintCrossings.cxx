// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Crossing constraints in pieces: beside rationals and a brute force of all pairs, on grids, on
/// doubles, and where so few doubles are near that pieces cross anew.
#include "Constraints/CrossingPairs.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Constraints/SplitCases.h"

#include <flipflop/ConstraintCrossings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// The most rounds of all.
/// @param make void (Random&, Cloud&): points
template <class Make>
std::int64_t runBruteForce(int cases, const Make& make)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", effort(cases));
  int failures = 0;
  std::int64_t rounds = 0;
  for (std::int64_t seed = first; seed < first + count && failures < 3; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15u + 1);
    Case given;
    make(random, given.cloud);
    const int last = static_cast<int>(given.cloud.size()) - 1;
    for (int i = random.integer(1, 12); i > 0; --i)
    {
      given.segments.push_back({ random.integer(0, last), random.integer(0, last) });
    }
    if (random.integer(0, 3) == 0)
    {
      given.segments.push_back({ given.segments[0][1], given.segments[0][0] });
      given.segments.push_back(given.segments[0]);
    }
    given.sides = random.integer(0, static_cast<int>(given.segments.size()));
    const SplitConstraints result = split(given, seed % 16 ? 1 : 2);
    rounds = std::max(rounds, result.rounds);
    std::string fault = faultOf(given, result);
    fault = fault.empty() ? faultOfOrder(given, result, random) : fault;
    if (!fault.empty())
    {
      ++failures;
      ADD_FAILURE() << "seed " << seed << ": " << fault << "\n"
                    << toString(given.cloud) << textOf(given.segments);
    }
  }
  return rounds;
}

TEST(ConstraintCrossingsByForce, OnGrids)
{
  EXPECT_GE(
    runBruteForce(150,
      [](Random& random, Cloud& cloud)
      {
        const int side = random.integer(1, 12);
        for (int i = random.integer(2, 16); i > 0; --i)
        {
          cloud.push_back({ double(random.integer(0, side)), double(random.integer(0, side)), 0 });
        }
      }),
    1);
}

TEST(ConstraintCrossingsByForce, InGeneralPosition)
{
  EXPECT_GE(runBruteForce(100,
              [](Random& random, Cloud& cloud)
              {
                for (int i = random.integer(4, 16); i > 0; --i)
                {
                  cloud.push_back({ random.uniform(-1, 1), random.uniform(-1, 1), 0 });
                }
              }),
    1);
}

/// Where the doubles are so few that each is a small integer times a unit: crossings move by much,
/// and pieces cross again.
TEST(ConstraintCrossingsByForce, AmongFewDoubles)
{
  EXPECT_GE(runBruteForce(200,
              [](Random& random, Cloud& cloud)
              {
                const bool isDenormal = random.integer(0, 1) == 0;
                const double unit = isDenormal ? 0x1p-1074 : 1;
                const double base = isDenormal ? -3 * unit : 0x1p52;
                const int side = random.integer(2, 12);
                for (int i = random.integer(4, 24); i > 0; --i)
                {
                  cloud.push_back({ base + random.integer(0, side) * unit,
                    base + random.integer(0, side) * unit, 0 });
                }
              }),
    1);
}

TEST(ConstraintCrossingsByForce, NearlyParallel)
{
  EXPECT_GE(runBruteForce(200,
              [](Random& random, Cloud& cloud)
              {
                const double ulp = std::ldexp(1.0, random.integer(-52, -40));
                const double slope = random.integer(0, 2) * 0.5;
                const double units = random.integer(1, 8);
                for (int i = random.integer(4, 20); i > 0; --i)
                {
                  const double x = random.integer(0, 1) + random.uniform(-0.1, 0.1);
                  cloud.push_back({ x, 1 + slope * x + ulp * random.uniform(0, units), 0 });
                }
              }),
    1);
}

TEST(ConstraintCrossingsByForce, AtAnyRange)
{
  EXPECT_GE(runBruteForce(100,
              [](Random& random, Cloud& cloud)
              {
                const bool isMixed = random.integer(0, 1) == 0;
                const double scale = random.integer(0, 1) ? 1e300 : 1e-300;
                for (int i = random.integer(4, 12); i > 0; --i)
                {
                  cloud.emplace_back();
                  for (std::size_t k = 0; k < 2; ++k)
                  {
                    cloud.back()[k] = random.uniform(-1, 1) *
                      (isMixed ? std::pow(10.0, random.integer(-307, 307)) : scale);
                  }
                }
              }),
    1);
}

/// Lines through one place that no double names, and through one that is a point.
TEST(ConstraintCrossings, OfAStarAreOne)
{
  Random random(4);
  for (const bool isPoint : { false, true })
  {
    // Through (1/3, 2/3), or (2, 4) after that times 6: from there by (i, j) and by -2 (i, j).
    Case star;
    const double third = isPoint ? 6 : 1;
    star.cloud = { { 100, 100, 0 }, { 2, 4, 0 }, { 2, 4, 0 } };
    for (int i = 1; i <= 40; ++i)
    {
      // p = c + s d, q = c - t d, with integer 3 c: multiples of d that make both integers.
      const double dx = i, dy = 41 - i;
      const auto at = [&](double s) {
        return Point{ (1 + s * (3 * dx - 1)) / 3 * third, (2 + s * (3 * dy - 2)) / 3 * third, 0 };
      };
      const auto id = static_cast<std::int64_t>(star.cloud.size());
      star.cloud.push_back(at(1));
      star.cloud.push_back(at(-2));
      star.segments.push_back({ id, id + 1 });
    }
    const SplitConstraints result = split(star, 2);
    EXPECT_EQ(faultOf(star, result), "");
    EXPECT_EQ(result.rounds, 1);
    EXPECT_EQ(result.newPointCount(), isPoint ? 0 : 1);
    EXPECT_EQ(result.constraintOf.size(), 80u);
    if (isPoint)
    {
      EXPECT_EQ(result.ends[1], 1);
    }
    else
    {
      EXPECT_EQ(result.positions[0], 1.0 / 3);
      EXPECT_EQ(result.positions[1], 2.0 / 3);
    }
  }
}

/// Bundles within a few units of the last place: what is bent crosses others.
TEST(ConstraintCrossings, OfBentPiecesAreSplitAnew)
{
  std::int64_t rounds = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed)
  {
    Random random(seed);
    Case bundle;
    for (int i = 0; i < 20; ++i)
    {
      for (const double end : { 0.0, 1.0 })
      {
        const double x = end + random.uniform(-0.1, 0.1);
        bundle.cloud.push_back({ x, 1 + 0.5 * x + random.uniform(0, 0x1p-50), 0 });
      }
      bundle.segments.push_back({ 2 * i, 2 * i + 1 });
    }
    const SplitConstraints result = split(bundle);
    rounds = std::max(rounds, result.rounds);
    EXPECT_EQ(faultOf(bundle, result), "") << seed;
    EXPECT_EQ(faultOfOrder(bundle, result, random), "") << seed;
  }
  EXPECT_GE(rounds, 2);
}

/// How many boxes are compared for each piece of a bundle that has been split: lines whose ends are
/// in any order on either side, units in the last place apart.
double comparisonsOf(int lines, double slope)
{
  Random random(7);
  std::vector<int> order(static_cast<std::size_t>(lines));
  std::iota(order.begin(), order.end(), 0);
  for (int i = lines - 1; i > 0; --i)
  {
    std::swap(
      order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(random.integer(0, i))]);
  }
  Case given;
  for (int i = 0; i < lines; ++i)
  {
    const double unit = 0x1p-52;
    given.cloud.push_back({ 1, 1 + i * unit, 0 });
    given.cloud.push_back({ 1.9, 1 + 0.9 * slope + order[static_cast<std::size_t>(i)] * unit, 0 });
    given.segments.push_back({ 2 * i, 2 * i + 1 });
  }
  const SplitConstraints result = split(given, 1);
  std::vector<Position> positions;
  for (const Point& p : given.cloud)
  {
    positions.push_back({ { p[0], p[1] } });
  }
  for (std::size_t k = 0; k < result.positions.size(); k += 2)
  {
    positions.push_back({ { result.positions[k], result.positions[k + 1] } });
  }
  std::vector<PositionSegment> pieces;
  for (std::size_t k = 0; k < result.ends.size(); k += 2)
  {
    pieces.push_back({ static_cast<std::uint32_t>(result.ends[k]),
      static_cast<std::uint32_t>(result.ends[k + 1]) });
  }
  EXPECT_GT(pieces.size(), static_cast<std::size_t>(lines * lines / 3));
  Monitor monitor{ Options() };
  std::int64_t comparisons = 0;
  EXPECT_TRUE(crossingPairs(positions, pieces, monitor, &comparisons).empty());
  return static_cast<double>(comparisons) / static_cast<double>(pieces.size());
}

/// The work for a piece does not grow with the number of lines that are as near.
TEST(ConstraintCrossings, OfBundlesTakeTheTimeOfTheirPieces)
{
  for (const double slope : { 0.0, 1.0, -0.3 })
  {
    EXPECT_LT(comparisonsOf(300, slope), 100) << slope;
  }
}

TEST(ConstraintCrossings, AreNoCommonEndsNorOverlaps)
{
  Case given;
  given.cloud = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 0, 0 }, { 2, 3, 0 }, { 6, 0, 0 }, { 0, 0, 0 } };
  given.segments = { { 0, 1 }, { 2, 3 }, { 2, 4 }, { 1, 0 }, { 5, 0 }, { 3, 3 }, { 3, 0 } };
  given.sides = 2;
  const SplitConstraints result = split(given);
  EXPECT_EQ(result.rounds, 0);
  EXPECT_EQ(result.newPointCount(), 0);
  EXPECT_EQ(result.sides, 2);
  EXPECT_EQ(faultOf(given, result), "");
  ASSERT_EQ(result.constraintOf.size(), given.segments.size());
  EXPECT_TRUE(std::equal(result.ends.begin(), result.ends.end(), given.segments.front().data()));
  EXPECT_EQ(split({}).constraintOf.size(), 0u);
}

TEST(ConstraintCrossings, HaveTheIdOfAGivenPoint)
{
  Case given;
  given.cloud = { { -1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 }, { 1, -1, 0 }, { 7, 7, 0 },
    { -0.0, 0, 0 }, { 0, -0.0, 0 } };
  given.segments = { { 0, 1 }, { 3, 2 } };
  const SplitConstraints result = split(given);
  EXPECT_EQ(result.newPointCount(), 0);
  EXPECT_EQ(
    chains(result, 2), (std::vector<std::vector<std::int64_t>>{ { 0, 5, 1 }, { 3, 5, 2 } }));
  given.cloud.resize(5);
  const SplitConstraints added = split(given);
  EXPECT_EQ(chains(added, 2), (std::vector<std::vector<std::int64_t>>{ { 0, 5, 1 }, { 3, 5, 2 } }));
  ASSERT_EQ(added.positions.size(), 2u);
  EXPECT_FALSE(std::signbit(added.positions[0]) || std::signbit(added.positions[1]));
}

/// Streets of all lengths, in bulk; and by any number of threads the same bits.
TEST(ConstraintCrossings, OfStreetsHaveOneAnswer)
{
  Random random(8);
  Case given;
  for (int i = 0; i < 3000; ++i)
  {
    const double reach = i % 50 ? 0.02 : 1.0;
    const double x = random.uniform(), y = random.uniform();
    const auto id = static_cast<std::int64_t>(given.cloud.size());
    given.cloud.push_back({ x, y, 0 });
    given.cloud.push_back(
      { x + random.uniform(-reach, reach), y + random.uniform(-reach, reach), 0 });
    given.segments.push_back({ id, id + 1 });
  }
  given.sides = 1000;
  const SplitConstraints first = split(given, 1);
  std::int64_t crossings = 0;
  for (std::size_t s = 0; s < given.segments.size(); ++s)
  {
    for (std::size_t t = 0; t < s; ++t)
    {
      const auto side = [&](const Segment& line, std::int64_t p)
      {
        const auto at = [&](std::int64_t id) -> const Point&
        { return given.cloud[static_cast<std::size_t>(id)]; };
        const Point &a = at(line[0]), &b = at(line[1]), &c = at(p);
        return (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]); // no ties here
      };
      const Segment &a = given.segments[s], &b = given.segments[t];
      crossings += side(a, b[0]) != side(a, b[1]) && side(b, a[0]) != side(b, a[1]) ? 1 : 0;
    }
  }
  EXPECT_EQ(first.newPointCount(), crossings);
  EXPECT_EQ(first.rounds, 1);
  const Cloud cloud = allPoints(given, first);
  EXPECT_TRUE(
    validate(viewOf(cloud), first.view(), constrainedTriangulation(viewOf(cloud), first.view())));
  for (const int threads : threadsTried())
  {
    const SplitConstraints other = split(given, threads);
    EXPECT_EQ(other.sides, first.sides);
    const auto isSame = [](const auto& a, const auto& b)
    { return std::equal(a.begin(), a.end(), b.begin(), b.end()); };
    EXPECT_TRUE(isSame(other.ends, first.ends) && isSame(other.positions, first.positions) &&
      isSame(other.crossing, first.crossing) && isSame(other.offsets, first.offsets) &&
      isSame(other.constraintOf, first.constraintOf));
  }
  EXPECT_EQ(faultOfOrder(given, first, random), "");
}

TEST(ConstraintCrossings, ErrorsNameThePlace)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Case given;
  given.cloud = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, nan, 0 } };
  given.segments = { { 0, 1 }, { 0, 4 } };
  const auto run = [&](const Options& options = Options())
  { return splitCrossings(viewOf(given.cloud), given.view(), options); };
  expectError([&] { run(); }, ErrorCode::ConstraintPoint, 1, 4);
  given.segments[1] = { 2, 3 };
  expectError([&] { run(); }, ErrorCode::NonFinite, 3, 1);
  Options ignoring;
  ignoring.nonFinite = NonFinitePolicy::Ignore;
  expectError([&] { run(ignoring); }, ErrorCode::ConstraintPoint, 1, 3);
  given.segments[1] = { 2, 0 };
  EXPECT_EQ(run(ignoring).rounds, 0);
  const std::int64_t none = 0;
  for (const ConstraintView& bad : { ConstraintView(nullptr, 1), ConstraintView(&none, -1),
         ConstraintView(&none, 0, 1), ConstraintView(&none, 0, -1) })
  {
    expectError([&] { splitCrossings(viewOf(given.cloud), bad); }, ErrorCode::BadArgument);
  }
}

}

}
}
