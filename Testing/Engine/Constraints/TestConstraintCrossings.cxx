// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Crossing constraints in pieces: stars, bundles and streets, what does not cross, and errors. On
/// points of every kind they are compared with brute force in TestConstraintsByReference.
#include "Constraints/CrossingPairs.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Constraints/SplitCases.h"
#include "Testing/Engine/Inputs/InputsConstrained.h"

#include <flipflop/ConstraintCrossings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

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
  random.shuffle(order);
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

/// Lines through lattice points, of which some are given; they end on each other, overlap, and are
/// there twice.
Case network(Random& random)
{
  static const int sizes[] = { 12, 1000, 100000 };
  const int size = sizes[random.pick(3)];
  Case given;
  const auto add = [&](int x, int y)
  {
    given.cloud.push_back({ double(x), double(y), 0 });
    return static_cast<std::int64_t>(given.cloud.size()) - 1;
  };
  for (int lines = random.integer(3, 12); lines > 0; --lines)
  {
    int at[2] = { random.integer(0, size / 2), random.integer(0, size / 2) };
    if (!given.cloud.empty() && random.integer(0, 2) == 0)
    {
      const Point& other = given.cloud[random.pick(given.cloud.size())];
      std::copy_n(other.begin(), 2, at);
    }
    const int step[2] = { random.integer(-size / 6, size / 6),
      random.integer(-size / 6, size / 6) };
    const auto along = [&](int k) { return add(at[0] + k * step[0], at[1] + k * step[1]); };
    const int last = random.integer(1, 6);
    given.segments.push_back({ along(0), along(last) });
    for (int more = random.integer(0, 3); more > 0; --more)
    {
      along(random.integer(0, last));
    }
    if (random.integer(0, 3) == 0)
    {
      given.segments.push_back({ along(random.integer(0, last)), along(last + 1) });
    }
  }
  given.sides = random.integer(0, static_cast<int>(given.segments.size()));
  return given;
}

/// Two that are not on one line have one position in common if they meet, and none if not.
std::string faultOfMeetings(const Case& given, const SplitConstraints& result)
{
  const Cloud cloud = allPoints(given, result);
  const auto of = chains(result, given.segments.size());
  const auto placeOf = [&](std::int64_t id) {
    return At{ cloud[static_cast<std::size_t>(id)][0], cloud[static_cast<std::size_t>(id)][1] };
  };
  std::vector<std::set<At>> on(of.size());
  for (std::size_t c = 0; c < of.size(); ++c)
  {
    for (std::size_t i = 0; i < of[c].size(); ++i)
    {
      on[c].insert(placeOf(of[c][i]));
      for (std::size_t id = 0; i > 0 && id < cloud.size(); ++id)
      {
        const At position = placeOf(static_cast<std::int64_t>(id));
        if (isInside(position, placeOf(of[c][i - 1]), placeOf(of[c][i])))
        {
          on[c].insert(position);
        }
      }
    }
  }
  for (std::size_t c = 0; c < of.size(); ++c)
  {
    const At a = placeOf(of[c].front()), b = placeOf(of[c].back());
    for (std::size_t d = 0; d < c; ++d)
    {
      const At p = placeOf(of[d].front()), q = placeOf(of[d].back());
      if ((b[0] - a[0]) * (q[1] - p[1]) == (b[1] - a[1]) * (q[0] - p[0]))
      {
        continue; // integers are exact
      }
      const auto isOn = [](const At& x, const At& y, const At& z)
      { return x == y || x == z || isInside(x, y, z); };
      At rounded;
      const bool meet = isOn(a, p, q) || isOn(b, p, q) || isOn(p, a, b) || isOn(q, a, b) ||
        crossing(given.cloud, given.segments[c], given.segments[d], rounded);
      const auto common = std::count_if(
        on[c].begin(), on[c].end(), [&](const At& position) { return on[d].count(position) != 0; });
      if (common != (meet ? 1 : 0))
      {
        return std::to_string(c) + " and " + std::to_string(d) + " meet in " +
          std::to_string(common) + " positions";
      }
    }
  }
  return "";
}

/// All in rationals; FLIPFLOP_TEST_CASES of them.
TEST(ConstraintCrossings, OfNetworksKeepThePointsOnLines)
{
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", effort(300));
  std::int64_t points = 0;
  for (std::int64_t seed = 0; seed < count; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const Case given = network(random);
    const SplitConstraints result = split(given);
    ASSERT_EQ(faultOf(given, result) + faultOfMeetings(given, result), "") << "seed " << seed;
    ASSERT_EQ(faultOfOrder(given, result, random), "") << "seed " << seed;
    for (const int threads : { 2, 4 })
    {
      const SplitConstraints other = split(given, threads);
      ASSERT_TRUE(sameBits(other.ends, result.ends) &&
        sameBits(other.positions, result.positions) && sameBits(other.crossing, result.crossing))
        << "seed " << seed;
    }
    points += result.newPointCount();
  }
  EXPECT_GT(points, count);
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
  const ConstrainedInput town = streets(3000, random);
  Case given = { town.cloud, town.segments };
  given.sides = 1000;
  const SplitConstraints first = split(given, 1);
  EXPECT_GT(first.newPointCount(), 1000);
  EXPECT_EQ(faultOfPoints(given, first, allPoints(given, first)), "");
  const Cloud cloud = allPoints(given, first);
  EXPECT_TRUE(
    validate(viewOf(cloud), first.view(), constrainedTriangulation(viewOf(cloud), first.view())));
  for (const int threads : threadsTried())
  {
    const SplitConstraints other = split(given, threads);
    EXPECT_EQ(other.sides, first.sides);
    EXPECT_TRUE(sameBits(other.ends, first.ends) && sameBits(other.positions, first.positions) &&
      sameBits(other.crossing, first.crossing) && sameBits(other.offsets, first.offsets) &&
      sameBits(other.constraintOf, first.constraintOf));
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
