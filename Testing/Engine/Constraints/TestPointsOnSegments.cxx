// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which points are on segments: beside a brute force of all pairs, in rationals.
#include "Constraints/PointsOnSegments.h"
#include "Constraints/PositionNumbers.h"
#include "Testing/Engine/Constraints/SplitCases.h"

#include <gtest/gtest.h>

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

}

}
}
