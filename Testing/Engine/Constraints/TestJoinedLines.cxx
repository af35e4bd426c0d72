// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lines with points of their own: which points are added, and all heights, by brute force in
/// rationals.
#include "Testing/Engine/Constraints/SplitCases.h"

#include <flipflop/ClosedLines.h>
#include <flipflop/JoinedLines.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Points, lines, and what the engine makes of them.
struct Joining
{
  Cloud points;
  Case lines; ///< their points, and the constraints
  JoinedLines joined;
  SplitConstraints split;
  ConstrainedTriangulation triangulation;
  LineHeights heights;
  std::vector<At> positions; ///< of all points that are triangulated

  void run(int threads = 1, bool isSplit = true)
  {
    Options options;
    options.threads = threads;
    this->joined =
      joinLines(viewOf(this->points), viewOf(this->lines.cloud), this->lines.view(), options);
    this->positions.clear();
    const auto append = [&](const Buffer<double>& xy)
    {
      for (std::size_t i = 0; i < xy.size(); i += 2)
      {
        this->positions.push_back({ xy[i], xy[i + 1] });
      }
    };
    append(this->joined.positions);
    this->split = isSplit ? splitCrossings(this->joined.points(), this->joined.view(), options)
                          : SplitConstraints();
    append(this->split.positions);
    this->triangulation =
      constrainedTriangulation(PointView(this->positions.data()->data(),
                                 static_cast<std::int64_t>(this->positions.size()), 2),
        isSplit ? this->split.view() : this->joined.view(), options);
    this->heights = lineHeights(viewOf(this->points), viewOf(this->lines.cloud), this->lines.view(),
      this->joined, this->split, this->triangulation, options);
  }
};

/// On the line of a and b the height over q.
double heightOver(const At& q, const Point& a, const Point& b)
{
  const std::size_t axis = std::fabs(b[0] - a[0]) < std::fabs(b[1] - a[1]) ? 1 : 0;
  const mpq_class share =
    (mpq_class(q[axis]) - mpq_class(a[axis])) / (mpq_class(b[axis]) - mpq_class(a[axis]));
  return roundingOf(mpq_class(a[2]) + share * (mpq_class(b[2]) - mpq_class(a[2])));
}

/// What is wrong with the joined points: each position has its first point, those of the input
/// before those of lines, and no other is added.
std::string faultOfJoined(const Joining& run)
{
  std::map<At, std::int64_t> firstAt;
  for (std::size_t i = 0; i < run.points.size(); ++i)
  {
    firstAt.emplace(At{ run.points[i][0], run.points[i][1] }, static_cast<std::int64_t>(i));
  }
  std::vector<bool> isUsed(run.lines.cloud.size(), false);
  for (const Segment& ends : run.lines.segments)
  {
    isUsed[static_cast<std::size_t>(ends[0])] = isUsed[static_cast<std::size_t>(ends[1])] = true;
  }
  std::vector<std::int64_t> added;
  for (std::size_t p = 0; p < isUsed.size(); ++p)
  {
    const At at = { run.lines.cloud[p][0], run.lines.cloud[p][1] };
    if (isUsed[p] &&
      firstAt.emplace(at, static_cast<std::int64_t>(run.points.size() + added.size())).second)
    {
      added.push_back(static_cast<std::int64_t>(p));
    }
    if (run.joined.pointOf[p] != (isUsed[p] ? firstAt.at(at) : -1))
    {
      return "a line's point is another point";
    }
  }
  for (std::size_t i = 0; i < run.joined.ends.size(); ++i)
  {
    const auto p = static_cast<std::size_t>(run.lines.segments[i / 2][i % 2]);
    if (run.joined.ends[i] != run.joined.pointOf[p])
    {
      return "a constraint ends elsewhere";
    }
  }
  return std::equal(added.begin(), added.end(), run.joined.added.begin(), run.joined.added.end())
    ? ""
    : "other points are added";
}

/// What is wrong with the heights: at each point those of all points there, and of all lines.
std::string faultOfHeights(const Joining& run)
{
  const std::size_t given = run.points.size();
  std::vector<std::vector<double>> at(run.positions.size());
  std::vector<double> own;
  for (std::size_t i = 0; i < given; ++i)
  {
    at[i].push_back(run.points[i][2]);
  }
  for (std::size_t p = 0; p < run.lines.cloud.size(); ++p)
  {
    if (run.joined.pointOf[p] >= 0)
    {
      at[static_cast<std::size_t>(run.joined.pointOf[p])].push_back(run.lines.cloud[p][2]);
    }
  }
  const bool isSplit = !run.split.constraintOf.empty();
  const ConstraintView pieces = isSplit ? run.split.view() : run.joined.view();
  std::map<std::int64_t, std::int64_t> firstOf; // of new points, the first constraint
  for (std::int64_t piece = 0; piece < pieces.count; ++piece)
  {
    const std::int64_t c =
      isSplit ? run.split.constraintOf[static_cast<std::size_t>(piece)] : piece;
    const auto placeOf = [&](std::int64_t id)
    { return run.positions[static_cast<std::size_t>(id)]; };
    const std::int64_t from = pieces.ends[2 * piece], to = pieces.ends[2 * piece + 1];
    const bool goesOn =
      isSplit && piece > 0 && run.split.constraintOf[static_cast<std::size_t>(piece - 1)] == c;
    for (const std::int64_t id : run.triangulation.pointIds)
    {
      if ((goesOn && id == from) || isInside(placeOf(id), placeOf(from), placeOf(to)))
      {
        const Segment& ends = run.lines.segments[static_cast<std::size_t>(c)];
        at[static_cast<std::size_t>(id)].push_back(
          heightOver(placeOf(id), run.lines.cloud[static_cast<std::size_t>(ends[0])],
            run.lines.cloud[static_cast<std::size_t>(ends[1])]));
      }
    }
  }
  std::int64_t differing = 0;
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    const auto range = std::minmax_element(at[i].begin(), at[i].end());
    if (run.heights.ranges[2 * i] != *range.first || run.heights.ranges[2 * i + 1] != *range.second)
    {
      return "the range of point " + std::to_string(i) + " is wrong";
    }
    // Of a crossing, pieces come by ascending constraints.
    if (i >= given && run.heights.added[i - given] != at[i].front())
    {
      return "the height of point " + std::to_string(i) + " is not that of the first";
    }
    differing += *range.first < *range.second ? 1 : 0;
  }
  return differing == run.heights.differing ? "" : "the number that differ is wrong";
}

/// On few positions, with few heights: all kinds of meetings.
Joining smallCase(std::uint64_t seed)
{
  Random random(seed);
  const int side = 2 + static_cast<int>(seed % 6);
  const double unit = seed % 3 == 0 ? 0.1 : 1.0;
  const auto point = [&]
  {
    return Point{ unit * random.integer(0, side - 1), unit * random.integer(0, side - 1),
      unit * random.integer(0, 2) };
  };
  Joining result;
  for (int i = random.integer(0, 11); i > 0; --i)
  {
    result.points.push_back(point());
  }
  for (int i = random.integer(1, 9); i > 0; --i)
  {
    result.lines.cloud.push_back(point());
  }
  for (int i = random.integer(0, 7); i > 0; --i)
  {
    const auto id = [&]
    { return static_cast<std::int64_t>(random.pick(result.lines.cloud.size())); };
    result.lines.segments.push_back({ id(), id() });
  }
  return result;
}

TEST(JoinedLines, AreThoseByForce)
{
  std::int64_t crossings = 0, differing = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed)
  {
    Joining run = smallCase(seed);
    run.run();
    ASSERT_EQ(faultOfJoined(run) + faultOfHeights(run), "") << "seed " << seed;
    crossings += run.split.newPointCount();
    differing += run.heights.differing;
    if (run.split.rounds == 0)
    {
      run.run(1, false);
      ASSERT_EQ(faultOfHeights(run), "") << "seed " << seed << ", not split";
    }
  }
  EXPECT_GT(crossings, 100);
  EXPECT_GT(differing, 1000);
}

TEST(JoinedLines, HaveTheSameBitsOnAllThreads)
{
  Random random(5);
  Joining run;
  const auto point = [&] {
    return Point{ random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1) };
  };
  for (int i = 0; i < 50000; ++i)
  {
    run.points.push_back(point());
  }
  for (std::int64_t i = 0; i < 600; i += 2)
  {
    run.lines.cloud.push_back(i % 4 == 0 ? run.points[static_cast<std::size_t>(i)] : point());
    run.lines.cloud.push_back(point());
    run.lines.segments.push_back({ i, i + 1 });
  }
  run.run(1);
  const Joining first = std::move(run);
  EXPECT_EQ(first.joined.added.size(), 450u);
  EXPECT_GT(first.split.newPointCount(), 1000);
  for (const int threads : { 2, 4 })
  {
    Joining other;
    other.points = first.points;
    other.lines = first.lines;
    other.run(threads);
    EXPECT_TRUE(sameBits(other.joined.pointOf, first.joined.pointOf) &&
      sameBits(other.joined.positions, first.joined.positions) &&
      sameBits(other.heights.added, first.heights.added) &&
      sameBits(other.heights.ranges, first.heights.ranges));
    EXPECT_EQ(other.heights.differing, first.heights.differing);
  }
}

/// A height that is NaN is none: it wins over no other.
TEST(JoinedLines, UnknownHeightsAreNone)
{
  Joining run;
  run.points = { { 0, 0, NaN }, { 5, 5, 1 } };
  run.lines.cloud = { { 0, 0, 3 }, { 4, 0, NaN }, { 2, -1, 7 }, { 2, 1, 7 } };
  run.lines.segments = { { 0, 1 }, { 2, 3 } };
  run.run();
  EXPECT_EQ(run.heights.differing, 0);
  EXPECT_EQ(run.heights.ranges[0], 3);
  ASSERT_EQ(run.positions.size(), 6u);
  EXPECT_TRUE(std::isnan(run.heights.added[0]) && std::isnan(run.heights.added[3]));
  EXPECT_EQ(run.heights.ranges[10], 7); // of the crossing, from the second line
}

TEST(JoinedLines, ErrorsNameThePlace)
{
  Joining run;
  run.points = { { 0, 0, 0 }, { 1, NaN, 0 }, { 1, 1, 0 } };
  run.lines.cloud = { { 0, 0, 0 }, { 1, 2, 0 }, { NaN, 1, 0 } };
  run.lines.segments = { { 0, 1 } };
  const auto join = [&](const Options& options = Options())
  { return joinLines(viewOf(run.points), viewOf(run.lines.cloud), run.lines.view(), options); };
  expectError([&] { join(); }, ErrorCode::NonFinite, 1, 1);
  Options ignoring;
  ignoring.nonFinite = NonFinitePolicy::Ignore;
  EXPECT_EQ(join(ignoring).added.size(), 1u);
  run.lines.segments = { { 0, 1 }, { 1, 2 } };
  expectError([&] { join(ignoring); }, ErrorCode::ConstraintPoint, 1, 2);
  run.lines.segments = { { 0, 3 } };
  expectError([&] { join(ignoring); }, ErrorCode::ConstraintPoint, 0, 3);

  run.points[1] = { 1, 0, 0 };
  run.lines.segments = { { 0, 1 } };
  run.run();
  const auto heights = [&]
  {
    return lineHeights(viewOf(run.points), viewOf(run.lines.cloud), run.lines.view(), run.joined,
      run.split, run.triangulation);
  };
  EXPECT_EQ(heights().differing, 0);
  run.triangulation.fixedEdges.truncate(0); // no constraint is in it
  expectError([&] { heights(); }, ErrorCode::BadArgument);
  run.points.pop_back();
  expectError([&] { heights(); }, ErrorCode::BadArgument);
}

using Chains = std::vector<std::vector<At>>;

/// For each line its sign.
std::vector<int> closedOf(const Chains& lines, const Chains& polygons = {}, double lastHeight = 0)
{
  Cloud points;
  std::vector<std::int64_t> offsets(1, 0);
  for (const Chains* chains : { &lines, &polygons })
  {
    for (const std::vector<At>& chain : *chains)
    {
      for (const At& at : chain)
      {
        points.push_back({ at[0], at[1], 0 });
      }
      offsets.push_back(static_cast<std::int64_t>(points.size()));
    }
  }
  points.back()[2] = lastHeight;
  LineView view;
  view.points = viewOf(points);
  view.offsets = offsets.data();
  view.lines = static_cast<std::int64_t>(lines.size());
  view.polygons = static_cast<std::int64_t>(polygons.size());
  const Buffer<std::int8_t> found = closedLines(view, lastHeight == 0 ? 2 : 3);
  return { found.begin(), found.end() };
}

TEST(ClosedLines, AreJoinedEndToEnd)
{
  const At a = { 0, 0 }, b = { 4, 0 }, c = { 4, 4 }, d = { -0.0, 4 }, e = { 9, 9 };
  struct Known
  {
    Chains lines, polygons;
    std::vector<int> signs;
  };
  const Known all[] = { { { { a, b, c, a } }, {}, { 1 } },
    { { { a, b }, { b, c }, { c, d }, { { 0.0, 4 }, { -0.0, 0 } } }, {}, { 1, 1, 1, 1 } },
    // It runs as its first line does; lines of no length are no part of it.
    { { { a, b }, { c, b }, { c, c }, { a, d, c }, { a, a } }, {}, { 1, -1, 0, -1, 0 } },
    { { { a, b }, { b, c }, { c, d } }, {}, { 0, 0, 0 } },
    { { { a }, {}, { a, b } }, {}, { 0, 0, 0 } },
    // What encloses nothing.
    { { { a, b }, { b, a } }, {}, { 0, 0 } }, { { { a, b, c, b, a } }, {}, { 0 } },
    { { { a, b, c }, { a, b, c } }, {}, { 0, 0 } },
    // A third end at a; two rings that meet there; two ways from a to c, and a third.
    { { { e, a }, { b, a }, { c, b }, { a, c } }, {}, { 0, 1, 1, 1 } },
    { { { a, b }, { b, c, a }, { a, d }, { d, e, a } }, {}, { 1, 1, 1, 1 } },
    { { { a, b, c }, { c, d, a }, { a, c } }, {}, { 0, 0, 0 } },
    // There twice, in any form; the outline of a polygon, and of two; a side of one is none.
    { { { c, a, b, c }, { a, b }, { b, c, a } }, {}, { 1, 0, 0 } },
    { { { b, c, a, b } }, { { a, b, c } }, { 0 } },
    { { { a, b, c, d, a }, { a, b, c, a } }, { { a, b, c }, { a, c, d, a } }, { 0, 1 } } };
  for (const Known& known : all)
  {
    EXPECT_EQ(closedOf(known.lines, known.polygons), known.signs)
      << testing::PrintToString(known.lines);
  }
  EXPECT_EQ(closedOf({ { a, b, c, a } }, {}, 7), std::vector<int>(1, 0));
  // What is not finite equals nothing, and costs no more than what is.
  const double infinity = std::numeric_limits<double>::infinity();
  const At n = { NaN, NaN }, i = { infinity, 0 };
  EXPECT_EQ(
    closedOf({ { n, a, n }, { i, b, c, i }, { i, a }, { a, i } }, {}), std::vector<int>(4, 0));
  EXPECT_EQ(closedOf({ std::vector<At>(100000, n) }, {}), std::vector<int>(1, 0));
  LineView bad;
  bad.lines = -1;
  expectError([&] { closedLines(bad, 2); }, ErrorCode::BadArgument);
  const std::int64_t offsets[] = { 0, 3 };
  bad.lines = 1;
  bad.offsets = offsets;
  expectError([&] { closedLines(bad, 2); }, ErrorCode::BadArgument);
  expectError([&] { closedLines(LineView(), 4); }, ErrorCode::BadArgument);
}

}

}
}
