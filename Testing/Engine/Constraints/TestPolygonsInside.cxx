// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is inside polygons: by either rule, to any depth, beside a count of the rectangles around
/// each cell.
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Constraints/ConstrainedCases.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

using Loop = std::vector<std::int64_t>;

/// Constraints, and after them the sides of polygons.
struct Sides
{
  std::vector<Segment> segments;
  std::int64_t count = 0;

  explicit Sides(const std::vector<Loop>& loops, std::vector<Segment> others = {})
    : segments(std::move(others))
  {
    for (const Loop& loop : loops)
    {
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        this->segments.push_back({ loop[i], loop[(i + 1) % loop.size()] });
        ++this->count;
      }
    }
  }

  ConstraintView view() const
  {
    ConstraintView result = viewOf(this->segments);
    result.sides = this->count;
    return result;
  }
};

std::vector<std::uint8_t> insideOf(
  const ConstrainedTriangulation& triangulation, const Options& options = Options())
{
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(triangulation.cellCount()), 7);
  const std::int64_t count = cellsInside(triangulation, inside.data(), options);
  EXPECT_EQ(count, std::count(inside.begin(), inside.end(), 1));
  return inside;
}

/// The cells that are inside, by ids.
std::vector<Cell> keptBy(
  const Cloud& cloud, const Sides& sides, PolygonRule rule = PolygonRule::Direction)
{
  Options options;
  options.polygons = rule;
  options.facets = FacetMode::Polygons;
  const ConstrainedTriangulation result =
    constrainedTriangulation(viewOf(cloud), sides.view(), options);
  EXPECT_TRUE(validate(viewOf(cloud), sides.view(), result));
  const std::vector<std::uint8_t> inside = insideOf(result, options);
  const std::vector<Cell> all = cellsOf(result);
  std::vector<Cell> kept;
  for (std::size_t c = 0; c < all.size(); ++c)
  {
    if (inside[c])
    {
      kept.push_back(all[c]);
    }
  }
  return kept;
}

/// By direction; by the even-odd rule there is an answer.
/// @param wrong a side of the polygon to be reversed
/// @param right a side of the other
void expectDisagreement(
  const Cloud& cloud, const Sides& sides, std::int64_t wrong, std::int64_t right)
{
  const ConstrainedTriangulation result = constrainedTriangulation(viewOf(cloud), sides.view());
  Options options;
  insideOf(result, options);
  options.polygons = PolygonRule::Direction;
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(result.cellCount()));
  expectError([&] { cellsInside(result, inside.data(), options); }, ErrorCode::PolygonsDisagree,
    wrong, right);
}

/// 0 to 15, in rows of four.
const Cloud grid = squareGrid(4);

const Loop around = { 0, 3, 15, 12 }, middle = { 5, 6, 10, 9 }, hole = { 9, 10, 6, 5 };
const Loop left = { 0, 1, 5, 4 }, right = { 1, 2, 6, 5 }, pair = { 0, 2, 6, 4 },
           line = { 0, 5, 10 };

struct KnownInside
{
  std::vector<Loop> loops;
  std::vector<Segment> others; ///< constraints that are no sides
  std::size_t count;           ///< cells inside
  std::vector<Cell> cells;     ///< these, where there are few; else none of these is
};

void expectKnown(const KnownInside& known, PolygonRule rule)
{
  const std::vector<Cell> kept = keptBy(grid, Sides(known.loops, known.others), rule);
  SCOPED_TRACE(testing::PrintToString(known.loops));
  EXPECT_EQ(kept.size(), known.count);
  for (const Cell& cell : known.cells)
  {
    EXPECT_EQ(std::count(kept.begin(), kept.end(), cell), known.count < 3 ? 1 : 0);
  }
}

TEST(PolygonsInside, IsWhatIsOnTheLeft)
{
  const KnownInside all[] = { { { middle }, {}, 1, { middle } }, { { hole }, {}, 8, { middle } },
    { {}, {}, 9, {} },
    // With a hole; the outer sides run through points.
    { { around, hole }, {}, 8, { middle } },
    // Other constraints, along the sides too, part nothing; nor do sides that two share.
    { { middle }, { { 6, 5 }, { 0, 12 }, { 1, 2 } }, 1, { middle } },
    { { left, right }, {}, 2, { left, right } }, { { pair }, {}, 2, { left, right } },
    // The same twice is the same; there and back is nothing.
    { { pair, { 4, 0, 2, 6 } }, {}, 2, { left, right } }, { { line }, {}, 11, {} } };
  for (const KnownInside& known : all)
  {
    expectKnown(known, PolygonRule::Direction);
  }
}

/// The direction of rings does not count, nor where they begin; each side does.
TEST(PolygonsInside, EvenOddCountsSides)
{
  const KnownInside all[] = { { { middle }, {}, 1, { middle } }, { { around }, {}, 9, {} },
    { { around, middle }, {}, 8, { middle } },
    // Beside each other with a common side, and with a common corner.
    { { left, right }, {}, 2, { left, right } }, { { left, middle }, {}, 2, { left, middle } },
    // A hole that touches the ring from inside, in a corner and along a side.
    { { around, left }, {}, 8, { left } },
    // The same twice is nothing; three times, it is there. A ring without an inside has none.
    { { middle, middle }, {}, 0, {} }, { { middle, middle, middle }, {}, 1, { middle } },
    { { line }, {}, 0, {} }, { {}, {}, 9, {} },
    // Those that overlap along lines of the grid: what both have is outside.
    { { { 0, 2, 10, 8 }, { 5, 7, 15, 13 } }, {}, 6, { middle } } };
  for (const KnownInside& known : all)
  {
    for (std::size_t reversed = 0; reversed <= known.loops.size(); ++reversed)
    {
      KnownInside other = known;
      if (reversed < known.loops.size())
      {
        std::reverse(other.loops[reversed].begin(), other.loops[reversed].end());
      }
      expectKnown(other, PolygonRule::EvenOdd);
    }
  }
}

TEST(PolygonsInside, DisagreementNamesThePolygonToReverse)
{
  // Two around each other that run alike: the inner should run the other way.
  expectDisagreement(grid, Sides({ { 0, 3, 15, 12 }, { 5, 6, 10, 9 } }), 4, 0);
  expectDisagreement(grid, Sides({ { 5, 6, 10, 9 }, { 0, 3, 15, 12 } }), 0, 4);
  // Both clockwise: the outer should.
  expectDisagreement(grid, Sides({ { 0, 12, 15, 3 }, { 5, 9, 10, 6 } }), 3, 7);
  // A hole beside a part, behind constraints that are no sides.
  expectDisagreement(
    grid, Sides({ { 0, 1, 5, 4 }, { 14, 15, 11, 10 } }, { { 4, 0 }, { 10, 11 } }), 8, 3);
}

TEST(PolygonsInside, SidesMustClose)
{
  const std::vector<Segment> open = { { 5, 6 } };
  const ConstrainedTriangulation result =
    constrainedTriangulation(viewOf(grid), ConstraintView(open[0].data(), 1, 1));
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(result.cellCount()));
  for (const PolygonRule rule : { PolygonRule::EvenOdd, PolygonRule::Direction })
  {
    Options options;
    options.polygons = rule;
    expectError([&] { cellsInside(result, inside.data(), options); }, ErrorCode::BadArgument);
  }
  // One side of a triangle: no edge but those of the border shows it.
  const Cloud triangle = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const std::vector<Segment> side = { { 0, 1 } };
  expectError([&]
    { insideOf(constrainedTriangulation(viewOf(triangle), ConstraintView(side[0].data(), 1, 1))); },
    ErrorCode::BadArgument);
}

TEST(PolygonsInside, OfLowerDimensionsAllIs)
{
  const Cloud line = { { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } };
  for (const PolygonRule rule : { PolygonRule::EvenOdd, PolygonRule::Direction })
  {
    EXPECT_EQ(keptBy(line, Sides({ { 0, 2, 1 } }), rule).size(), 2u);
    EXPECT_EQ(keptBy({ { 1, 1, 0 } }, Sides({ { 0, 0, 0 } }), rule).size(), 1u);
    EXPECT_EQ(keptBy({}, Sides({}), rule).size(), 0u);
  }
}

TEST(PolygonsInside, BadArguments)
{
  const std::vector<Segment> one = { { 0, 1 } };
  for (const std::int64_t sides : { -1, 2 })
  {
    expectError([&]
      { constrainedTriangulation(viewOf(grid), ConstraintView(one[0].data(), 1, sides)); },
      ErrorCode::BadArgument);
  }
  ConstrainedTriangulation result = constrainedTriangulation(viewOf(grid), viewOf(one));
  expectError([&] { cellsInside(result, nullptr); }, ErrorCode::BadArgument);
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(result.cellCount()));
  result.fixedEdges[1] = 16;
  expectError([&] { cellsInside(result, inside.data()); }, ErrorCode::BadArgument);
  result.fixedEdges[1] = 1;
  result.sides = -1;
  expectError([&] { cellsInside(result, inside.data()); }, ErrorCode::BadArgument);
  result.sides = 0;
  result.sideOf.allocate(0);
  expectError([&] { cellsInside(result, inside.data()); }, ErrorCode::BadArgument);
  result.sideOf.allocate(1);
  result.balance.allocate(0);
  expectError([&] { cellsInside(result, inside.data()); }, ErrorCode::BadArgument);
}

/// Random polygons of a few features: a cell is inside the union if it is inside one of them, whose
/// sides alone are sides.
TEST(PolygonsInside, OfFeaturesIsTheirUnion)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    Random random(seed);
    std::vector<Loop> loops;
    std::vector<std::int64_t> loopOf;
    for (std::int64_t loop = 0; loop < random.integer(2, 6); ++loop)
    {
      // Along lines of the grid, so that none cross between points; a few are there again.
      const int x = random.integer(0, 2), y = random.integer(0, 2);
      const int right = random.integer(x + 1, 3), top = random.integer(y + 1, 3);
      const Loop ring = { 4 * y + x, 4 * y + right, 4 * top + right, 4 * top + x };
      loops.push_back(loop > 0 && random.integer(0, 3) == 0 ? loops[0] : ring);
      loopOf.push_back(random.integer(0, 2) - 1);
    }
    const Sides sides(loops, { { 5, 6 } });
    std::vector<std::int64_t> featureOf;
    for (const std::int64_t feature : loopOf)
    {
      featureOf.insert(featureOf.end(), 4, feature);
    }
    Options options;
    options.facets = seed % 2 ? FacetMode::Polygons : FacetMode::Triangles;
    const ConstrainedTriangulation result =
      constrainedTriangulation(viewOf(grid), sides.view(), options);
    std::vector<std::uint8_t> inside(static_cast<std::size_t>(result.cellCount()), 7);
    std::vector<std::uint8_t> expected(inside.size(), 0);
    cellsInsideFeatures(
      result, viewOf(grid), sides.view(), featureOf.data(), inside.data(), options);
    for (std::int64_t feature = -1; feature < 2; ++feature)
    {
      std::vector<Loop> own;
      std::vector<Segment> others = { { 5, 6 } };
      for (std::size_t i = 0; i < loops.size(); ++i)
      {
        const Sides segments({ loops[i] });
        loopOf[i] == feature ? own.push_back(loops[i])
                             : static_cast<void>(others.insert(
                                 others.end(), segments.segments.begin(), segments.segments.end()));
      }
      if (own.empty())
      {
        continue;
      }
      const ConstrainedTriangulation same =
        constrainedTriangulation(viewOf(grid), Sides(own, others).view(), options);
      ASSERT_EQ(cellsOf(same), cellsOf(result));
      const std::vector<std::uint8_t> one = insideOf(same, options);
      for (std::size_t c = 0; c < one.size(); ++c)
      {
        expected[c] |= one[c];
      }
    }
    ASSERT_EQ(inside, expected) << "seed " << seed;
  }
}

TEST(PolygonsInside, OfFeaturesRefusesWhatDoesNotFit)
{
  const Sides sides({ middle });
  const std::int64_t features[] = { 0, 0, 0, 1 };
  ConstrainedTriangulation result = constrainedTriangulation(viewOf(grid), sides.view());
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(result.cellCount()));
  const auto run = [&](const Cloud& cloud, const ConstraintView& view, const std::int64_t* of)
  { cellsInsideFeatures(result, viewOf(cloud), view, of, inside.data()); };
  expectError([&] { run(grid, sides.view(), features); }, ErrorCode::BadArgument); // do not close
  expectError([&] { run(grid, sides.view(), nullptr); }, ErrorCode::BadArgument);
  expectError([&] { run(grid, ConstraintView(), features); }, ErrorCode::BadArgument);
  const Cloud few(grid.begin(), grid.end() - 1);
  expectError([&] { run(few, sides.view(), features); }, ErrorCode::BadArgument);
  result.fixedEdges.truncate(0);
  expectError([&] { run(grid, sides.view(), features); }, ErrorCode::BadArgument);
}

/// The triangulation has one id of a position, so features must have that one, too.
TEST(PolygonsInside, OfFeaturesNamesAnIdThatIsNotTheLowest)
{
  Cloud cloud = grid;
  cloud.push_back(grid[10]);
  const std::vector<std::int64_t> features(4, 0);
  std::vector<std::uint8_t> inside;
  const auto run = [&](const Loop& loop)
  {
    const Sides sides({ loop });
    const ConstrainedTriangulation result = constrainedTriangulation(viewOf(cloud), sides.view());
    inside.assign(static_cast<std::size_t>(result.cellCount()), 7);
    cellsInsideFeatures(result, viewOf(cloud), sides.view(), features.data(), inside.data());
  };
  expectError([&] { run({ 5, 6, 16, 9 }); }, ErrorCode::BadArgument, 16);
  run({ 5, 6, 10, 9 });
  EXPECT_EQ(std::count(inside.begin(), inside.end(), 1), 2);
}

/// Rectangles in rectangles and beside each other, that take turns from depth to depth.
void nest(
  int x0, int y0, int x1, int y1, int side, bool solid, Random& random, std::vector<Loop>& loops)
{
  const auto id = [side](int x, int y) { return std::int64_t(y) * side + x; };
  if (x1 - x0 < 2 || y1 - y0 < 2 || random.integer(0, 9) == 0)
  {
    return;
  }
  if (x1 - x0 >= 7 && random.integer(0, 1))
  {
    const int middle = (x0 + x1) / 2;
    nest(x0, y0, middle, y1, side, solid, random, loops);
    nest(middle + 1, y0, x1, y1, side, solid, random, loops);
    return;
  }
  Loop loop = { id(x0, y0), id(x1, y0), id(x1, y1), id(x0, y1) };
  if (!solid)
  {
    std::reverse(loop.begin(), loop.end());
  }
  loops.push_back(loop);
  nest(x0 + 1, y0 + 1, x1 - 1, y1 - 1, side, !solid, random, loops);
}

TEST(PolygonsInside, IsThatOfTheDepth)
{
  constexpr int Side = 24;
  const Cloud cloud = squareGrid(Side);
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    Random random(seed);
    std::vector<Loop> loops;
    nest(1, 1, Side - 2, Side - 2, Side, true, random, loops);
    if (loops.empty())
    {
      continue;
    }
    std::vector<Loop> turned = loops;
    for (Loop& loop : turned)
    {
      if (random.integer(0, 1))
      {
        std::reverse(loop.begin(), loop.end());
      }
    }
    for (const int kind : { 0, 1, 2, 3 })
    {
      Options options;
      options.facets = kind < 2 ? FacetMode::Triangles : FacetMode::Polygons;
      options.polygons = kind % 2 ? PolygonRule::Direction : PolygonRule::EvenOdd;
      const Sides sides(kind % 2 ? loops : turned);
      const ConstrainedTriangulation result =
        constrainedTriangulation(viewOf(cloud), sides.view(), options);
      options.threads = 2;
      const std::vector<std::uint8_t> inside = insideOf(result, options);
      const std::vector<Cell> cells = cellsOf(result);
      for (std::size_t c = 0; c < cells.size(); ++c)
      {
        double x = 0;
        double y = 0;
        for (const std::int64_t id : cells[c])
        {
          x += double(id % Side) / double(cells[c].size());
          y += double(id / Side) / double(cells[c].size());
        }
        const auto depth = std::count_if(loops.begin(), loops.end(),
          [&](const Loop& loop)
          {
            // Of opposite corners.
            const auto across = std::minmax({ loop[0] % Side, loop[2] % Side });
            const auto up = std::minmax({ loop[0] / Side, loop[2] / Side });
            return double(across.first) < x && x < double(across.second) && double(up.first) < y &&
              y < double(up.second);
          });
        ASSERT_EQ(inside[c], depth % 2) << "seed " << seed << ", cell " << toString(cells[c]);
      }
    }
  }
}

}

}
}
