// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which points are on segments, which segments are on one line, and what they have in common
/// there: beside a brute force of all pairs, in rationals.
#include "Constraints/CollinearUnions.h"
#include "Constraints/PointsOnSegments.h"
#include "Constraints/SegmentLinks.h"
#include "Testing/Engine/Constraints/SplitCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// The segments of constraints, from their lower positions.
std::vector<PositionSegment> segmentsOf(const Case& given, PositionNumbers& numbers)
{
  std::vector<PositionSegment> segments;
  for (const Segment& ends : given.segments)
  {
    Position at[2];
    for (const std::size_t end : { 0, 1 })
    {
      const Point& p = given.cloud[static_cast<std::size_t>(ends[end])];
      at[end] = { { p[0], p[1] } };
    }
    if (at[1] < at[0])
    {
      std::swap(at[0], at[1]);
    }
    const std::uint32_t from = numbers.add(at[0]);
    segments.push_back({ from, numbers.add(at[1]) });
  }
  return segments;
}

At atOf(const Position& position)
{
  return { position.x[0], position.x[1] };
}

/// Segments on a line, each inside the one before, and one that crosses them all at @p x.
Case nested(int count, double x)
{
  Case given;
  for (int i = 0; i < count; ++i)
  {
    for (const int at : { i, 2 * count - i })
    {
      given.cloud.push_back({ double(at), 2.0 * at, 0 });
    }
    given.segments.push_back({ 2 * i, 2 * i + 1 });
  }
  given.cloud.push_back({ x, 0, 0 });
  given.cloud.push_back({ x + 1, 4.0 * count, 0 });
  given.segments.push_back({ 2 * count, 2 * count + 1 });
  return given;
}

/// Each has as many points inside it as there are others in it: their sum is quadratic.
TEST(SegmentLinks, OfNestedSegmentsAreOneChain)
{
  constexpr int Count = 20000;
  const Case given = nested(Count, Count - 0.5);
  PositionNumbers numbers;
  const std::vector<PositionSegment> segments = segmentsOf(given, numbers);
  Monitor monitor{ Options() };
  const PointSource source(viewOf(given.cloud), WeightView());
  const CollinearUnions lines = collinearUnions(numbers.positions(), segments, monitor);
  ASSERT_EQ(lines.unions.size(), 2u);
  EXPECT_EQ(pointsOnSegments(numbers.positions(), lines.unions, source, monitor).size(),
    std::size_t(2 * Count - 2));
  SegmentLinks links;
  ASSERT_TRUE(divideSegments(
    numbers, segments, std::vector<char>(segments.size(), 1), source, monitor, links));
  EXPECT_EQ(links.ends.size(), std::size_t(2 * Count));
  ASSERT_EQ(links.chains.size(), std::size_t(2 * Count));
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    const SegmentLinks::Range& range = links.ofSegment[s];
    ASSERT_EQ(range.end - range.begin, s < Count ? 2 * (Count - s) - 1 : 1);
    ASSERT_EQ(links.ends[links.chains[range.begin]].from, segments[s].from);
    ASSERT_EQ(links.ends[links.chains[range.end - 1]].to, segments[s].to);
  }
}

/// A segment that is not chosen is a link of its own, or that of others between its ends.
TEST(SegmentLinks, AreThoseOfTheChosen)
{
  Case given;
  given.cloud = { { 0, 0, 0 }, { 2, 0, 0 }, { 4, 0, 0 }, { 6, 0, 0 } };
  given.segments = { { 0, 2 }, { 1, 0 }, { 3, 0 }, { 2, 3 } };
  PositionNumbers numbers;
  const std::vector<PositionSegment> segments = segmentsOf(given, numbers);
  Monitor monitor{ Options() };
  const PointSource source(viewOf(given.cloud), WeightView());
  SegmentLinks links;
  EXPECT_FALSE(divideSegments(numbers, segments, { 0, 1, 0, 1 }, source, monitor, links));
  ASSERT_TRUE(divideSegments(numbers, segments, { 1, 0, 0, 1 }, source, monitor, links));
  EXPECT_EQ(links.ends.size(), 4u);
  const auto linksOf = [&](std::size_t segment)
  {
    const auto begin = links.chains.begin();
    const SegmentLinks::Range& range = links.ofSegment[segment];
    return std::vector<std::uint32_t>(begin + static_cast<std::ptrdiff_t>(range.begin),
      begin + static_cast<std::ptrdiff_t>(range.end));
  };
  ASSERT_EQ(linksOf(0).size(), 2u);
  EXPECT_EQ(linksOf(1), std::vector<std::uint32_t>(1, linksOf(0)[0]));
  ASSERT_EQ(linksOf(2).size(), 1u);
  ASSERT_EQ(linksOf(3).size(), 1u);
  EXPECT_TRUE(links.isDivided[linksOf(1)[0]] && links.isDivided[linksOf(3)[0]]);
  EXPECT_FALSE(links.isDivided[linksOf(2)[0]]);
}

/// Where they bend, all of them do; else they stay whole.
TEST(ConstraintCrossings, OfNestedSegmentsAreShared)
{
  constexpr int Count = 30;
  Random random(3);
  for (const double x : { Count - 0.5, Count - 0.7, Count + 0.1 })
  {
    Case given = nested(Count, x);
    const SplitConstraints once = split(given);
    EXPECT_EQ(once.newPointCount(), 1) << x;
    EXPECT_EQ(once.crossing.size(), std::size_t(Count + 1)) << x;
    EXPECT_LE(once.constraintOf.size(), std::size_t(4 * Count + 2)) << x;
    EXPECT_EQ(faultOf(given, once), "") << x;
    // Some cross only the longer ones, and one ends on the line.
    for (const double at : { 3.3, 11.5, 17.0, 40.25, 44.7 })
    {
      const auto id = static_cast<std::int64_t>(given.cloud.size());
      given.cloud.push_back({ at, 2 * at + 5, 0 });
      given.cloud.push_back({ at, at == 17 ? 34 : 2 * at - random.uniform(1, 9), 0 });
      given.segments.push_back({ id, id + 1 });
    }
    given.sides = 20;
    const SplitConstraints result = split(given, 2);
    EXPECT_EQ(faultOf(given, result), "") << x;
    EXPECT_EQ(faultOfOrder(given, result, random), "") << x;
  }
}

/// Few segments, which are cut finely, and many points, some of them there twice, in any chunks.
TEST(PointsOnSegments, AreThoseOfAllPairs)
{
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed)
  {
    Random random(seed);
    const int size = random.integer(8, 40);
    Case given;
    const auto add = [&](int x, int y) { given.cloud.push_back({ double(x), double(y), 0 }); };
    for (int i = 0; i < 4; ++i)
    {
      const int x = random.integer(0, size), y = random.integer(0, size);
      add(x, y);
      add(x + 6 * random.integer(-size / 8, size / 8), y + 6 * random.integer(-size / 8, size / 8));
      given.segments.push_back({ 2 * i, 2 * i + 1 });
    }
    while (given.cloud.size() < 3000)
    {
      add(random.integer(0, size), random.integer(0, size));
    }
    PositionNumbers numbers;
    const std::vector<PositionSegment> segments = segmentsOf(given, numbers);
    std::set<At> all;
    for (const Point& p : given.cloud)
    {
      all.insert({ p[0], p[1] });
    }
    std::vector<std::pair<std::uint32_t, At>> expected;
    for (std::uint32_t s = 0; s < segments.size(); ++s)
    {
      const At a = atOf(numbers.positions()[segments[s].from]);
      const At b = atOf(numbers.positions()[segments[s].to]);
      for (const At& at : all)
      {
        if (isInside(at, a, b))
        {
          expected.emplace_back(s, at);
        }
      }
    }
    Monitor monitor{ Options() };
    const PointSource source(viewOf(given.cloud), WeightView());
    const auto found = [&](auto... pointsPerTask)
    {
      std::vector<std::pair<std::uint32_t, At>> pairs;
      for (const PositionOnSegment& one :
        pointsOnSegments(numbers.positions(), segments, source, monitor, pointsPerTask...))
      {
        pairs.emplace_back(one.segment, atOf(one.position));
      }
      return pairs;
    };
    count += expected.size();
    EXPECT_EQ(found(), expected) << "seed " << seed;
    for (const std::size_t pointsPerTask : { 1, 7, 64, 1000, 2999, 3000 })
    {
      EXPECT_EQ(found(pointsPerTask), expected) << "seed " << seed << ", " << pointsPerTask;
    }
  }
  EXPECT_GT(count, 100u);
}

/// Segments of a few lines, some a unit of the last place apart, whose differences are not exact.
Case onFewLines(Random& random)
{
  const int exponent = std::vector<int>{ 0, 900, -1000, -1060 }[random.pick(4)];
  const auto number = [&]
  { return std::ldexp(random.uniform(-1, 1), exponent + random.integer(-8, 8)); };
  std::vector<double> xs;
  for (int i = 0; i < 8; ++i)
  {
    xs.push_back(number());
  }
  const double offset = number();
  Case given;
  for (int i = 0; i < 24; ++i)
  {
    const int line = random.integer(0, 5);
    const bool isNudged = random.integer(0, 7) == 0;
    for (int end = 0; end < 2; ++end)
    {
      const double x = xs[random.pick(xs.size())];
      const double y = line == 0 ? 2 * x : line == 1 ? -x : line == 2 ? 0.25 * x : offset;
      const bool isUpright = line == 4;
      const double nudged =
        isNudged && end ? std::nextafter(y, std::numeric_limits<double>::max()) : y;
      given.cloud.push_back(isUpright ? Point{ nudged, x, 0 } : Point{ x, nudged, 0 });
    }
    given.segments.push_back({ 2 * i, 2 * i + 1 });
  }
  return given;
}

/// Do they have more than an end in common?
bool doOverlap(const At& a, const At& b, const At& c, const At& d)
{
  const auto side = [&](const At& p)
  {
    return sgn(mpq_class((mpq_class(b[0]) - a[0]) * (mpq_class(p[1]) - a[1]) -
      (mpq_class(b[1]) - a[1]) * (mpq_class(p[0]) - a[0])));
  };
  return std::max(a, c) < std::min(b, d) && side(c) == 0 && side(d) == 0;
}

TEST(CollinearUnions, AreThoseOfAllPairs)
{
  int larger = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed)
  {
    Random random(seed);
    const Case given = onFewLines(random);
    PositionNumbers numbers;
    std::vector<PositionSegment> segments = segmentsOf(given, numbers);
    segments.erase(std::remove_if(segments.begin(), segments.end(),
                     [](const PositionSegment& s) { return s.from == s.to; }),
      segments.end());
    const auto at = [&](std::uint32_t index) { return atOf(numbers.positions()[index]); };
    Monitor monitor{ Options() };
    const CollinearUnions result = collinearUnions(numbers.positions(), segments, monitor);
    std::vector<std::size_t> lowest(segments.size()); // of those in its union
    std::iota(lowest.begin(), lowest.end(), std::size_t(0));
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      for (std::size_t t = 0; t < s; ++t)
      {
        if (lowest[s] != lowest[t] &&
          doOverlap(
            at(segments[s].from), at(segments[s].to), at(segments[t].from), at(segments[t].to)))
        {
          std::replace(
            lowest.begin(), lowest.end(), std::size_t(lowest[s]), std::size_t(lowest[t]));
        }
      }
    }
    std::vector<std::pair<At, At>> extents(
      segments.size(), { At{ HUGE_VAL, 0 }, At{ -HUGE_VAL, 0 } });
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      std::pair<At, At>& extent = extents[lowest[s]];
      extent.first = std::min(extent.first, at(segments[s].from));
      extent.second = std::max(extent.second, at(segments[s].to));
      for (std::size_t t = 0; t < s; ++t)
      {
        ASSERT_EQ(result.unionOf[s] == result.unionOf[t], lowest[s] == lowest[t])
          << "seed " << seed;
      }
    }
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      const PositionSegment& own = result.unions[result.unionOf[s]];
      ASSERT_EQ(std::make_pair(at(own.from), at(own.to)), extents[lowest[s]]) << "seed " << seed;
      larger += own.from != segments[s].from || own.to != segments[s].to ? 1 : 0;
    }
  }
  EXPECT_GT(larger, 1000);
}

}

}
}
