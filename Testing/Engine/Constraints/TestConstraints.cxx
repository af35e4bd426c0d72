// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a caller of constrained triangulations relies on: errors that name the place, every input
/// of a lower dimension, any range, and that faults of a result are found.
#include "Testing/Engine/Constraints/ConstrainedCases.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();

ConstrainedTriangulation run(const Cloud& cloud, const std::vector<Segment>& constraints,
  FacetMode facets = FacetMode::Triangles, int threads = 1)
{
  Options options;
  options.facets = facets;
  options.threads = threads;
  return constrainedTriangulation(viewOf(cloud), viewOf(constraints), options);
}

std::vector<Cell> cellsBy(const Cloud& cloud, const std::vector<Segment>& constraints)
{
  return cellsOf(run(cloud, constraints, FacetMode::Polygons));
}

void expectError(const Cloud& cloud, const std::vector<Segment>& constraints, ErrorCode code,
  std::int64_t index, std::int64_t count, const Options& options = Options())
{
  test::expectError([&] { constrainedTriangulation(viewOf(cloud), viewOf(constraints), options); },
    code, index, count);
}

TEST(Constraints, WithoutAnyAreTheDelaunayTriangulation)
{
  for (const Input& input : smallWeightedInputs())
  {
    Cloud cloud = input.make();
    for (Point& p : cloud)
    {
      p[2] = 0;
    }
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      Options options;
      options.facets = facets;
      const ConstrainedTriangulation result = run(cloud, {}, facets);
      EXPECT_EQ(
        bitDifference(result, regularTriangulation(viewOf(cloud), WeightView(), options)), "")
        << input.name;
      EXPECT_TRUE(result.fixedEdges.empty());
    }
  }
}

TEST(Constraints, TurnADiagonal)
{
  // The Delaunay diagonal is 1-3, the short one.
  const Cloud kite = { { 0, -3, 0 }, { 1, 0, 0 }, { 0, 3, 0 }, { -1, 0, 0 } };
  EXPECT_EQ(cellsBy(kite, {}), (std::vector<Cell>{ { 0, 1, 3 }, { 1, 2, 3 } }));
  const std::vector<Cell> turned = { { 0, 1, 2 }, { 0, 2, 3 } };
  EXPECT_EQ(cellsBy(kite, { { 0, 2 } }), turned);
  EXPECT_EQ(cellsBy(kite, { { 2, 0 } }), turned);
  EXPECT_EQ(cellsBy(kite, { { 2, 0 }, { 1, 1 }, { 0, 2 }, { 0, 2 } }), turned);
  const ConstrainedTriangulation result = run(kite, { { 1, 1 }, { 2, 0 }, { 0, 2 } });
  EXPECT_TRUE(fixedOf(result) == (std::vector<FixedSegment>{ { { 0, 2 }, 1 } }));
}

TEST(Constraints, PartACircle)
{
  const Cloud square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  EXPECT_EQ(cellsBy(square, {}), (std::vector<Cell>{ { 0, 1, 2, 3 } }));
  EXPECT_EQ(cellsBy(square, { { 1, 3 } }), (std::vector<Cell>{ { 0, 1, 3 }, { 1, 2, 3 } }));
  EXPECT_EQ(cellsBy(square, { { 1, 2 } }), (std::vector<Cell>{ { 0, 1, 2, 3 } }));
}

TEST(Constraints, ArePartedAtPoints)
{
  const Cloud grid = squareGrid(4);
  const ConstrainedTriangulation result = run(grid, { { 0, 15 }, { 3, 15 }, { 10, 0 } });
  EXPECT_TRUE(fixedOf(result) ==
    (std::vector<FixedSegment>{ { { 0, 5 }, 0 }, { { 3, 7 }, 1 }, { { 5, 10 }, 0 },
      { { 7, 11 }, 1 }, { { 10, 15 }, 0 }, { { 11, 15 }, 1 } }));
}

TEST(Constraints, FollowTheLowestDuplicate)
{
  const Cloud kite = { { -0.0, -3, 0 }, { 1, 0, 0 }, { 0, 3, 0 }, { -1, -0.0, 0 }, { 0, -3, 0 },
    { -0.0, 3, 0 } };
  const ConstrainedTriangulation result = run(kite, { { 4, 0 }, { 5, 4 } });
  EXPECT_TRUE(fixedOf(result) == (std::vector<FixedSegment>{ { { 0, 2 }, 1 } }));
  EXPECT_EQ(cellsOf(result), (std::vector<Cell>{ { 0, 1, 2 }, { 0, 2, 3 } }));
}

/// The same constraint again and again takes no more time for the points on it.
TEST(Constraints, ThroughManyPointsAgainAndAgain)
{
  constexpr std::int64_t Count = 20000;
  Cloud cloud;
  for (std::int64_t i = 0; i < Count; ++i)
  {
    cloud.push_back({ double(i), 0, 0 });
  }
  cloud.push_back({ 7, 1, 0 });
  cloud.push_back({ 7, -1, 0 });
  std::vector<Segment> constraints = { { 5, 9 }, { Count - 1, 0 } };
  constraints.resize(Count, { 0, Count - 1 });
  // The first of the sides runs back, all others forth.
  const ConstraintView view(constraints[0].data(), Count, Count - 1);
  const ConstrainedTriangulation result = constrainedTriangulation(viewOf(cloud), view);
  ASSERT_EQ(result.constraintOf.size(), std::size_t(Count - 1));
  for (std::int64_t i = 0; i + 1 < Count; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    ASSERT_EQ(result.fixedEdges[2 * k], i);
    ASSERT_EQ(result.constraintOf[k], 5 <= i && i < 9 ? 0 : 1);
    ASSERT_EQ(result.balance[k], Count - 3);
    ASSERT_EQ(result.sideOf[k], 2);
  }
}

TEST(Constraints, OfLowerDimensions)
{
  EXPECT_EQ(run({}, {}).dimension, -1);
  const ConstrainedTriangulation position = run({ { 1, 2, 0 }, { 1, 2, 0 } }, { { 0, 1 } });
  EXPECT_EQ(position.dimension, 0);
  EXPECT_TRUE(position.fixedEdges.empty());
  const Cloud line = { { 3, 3, 0 }, { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 }, { 1, 1, 0 } };
  const std::vector<Segment> constraints = { { 4, 4 }, { 3, 4 }, { 0, 2 } };
  const ConstrainedTriangulation chain = run(line, constraints);
  EXPECT_EQ(chain.dimension, 1);
  EXPECT_TRUE(fixedOf(chain) == (std::vector<FixedSegment>{ { { 0, 3 }, 2 }, { { 2, 3 }, 1 } }));
  EXPECT_TRUE(validate(viewOf(line), viewOf(constraints), chain));
}

TEST(Constraints, AtAnyRange)
{
  for (const double scale : { 5e-324, 1e-300, 1e-160, 1e150, 1e300 })
  {
    const Cloud kite = { { 0, -3 * scale, 0 }, { scale, 0, 0 }, { 0, 3 * scale, 0 },
      { -scale, 0, 0 } };
    EXPECT_EQ(cellsBy(kite, { { 0, 2 } }), (std::vector<Cell>{ { 0, 1, 2 }, { 0, 2, 3 } }));
  }
  // 1e-300 beside 1e300: a point that far from the segment is crossed by none.
  const Cloud wide = { { -1e300, 0, 0 }, { 1e300, 0, 0 }, { 0, 1e-300, 0 }, { 0, -1, 0 },
    { 0, 1e300, 0 } };
  const std::vector<Segment> constraints = { { 0, 1 } };
  const ConstrainedTriangulation result = run(wide, constraints);
  EXPECT_TRUE(fixedOf(result) == (std::vector<FixedSegment>{ { { 0, 1 }, 0 } }));
  EXPECT_TRUE(validate(viewOf(wide), viewOf(constraints), result));
}

TEST(Constraints, ErrorsNameThePlace)
{
  const Cloud square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  expectError(square, { { 0, 1 }, { 0, 4 } }, ErrorCode::ConstraintPoint, 1, 4);
  expectError(square, { { 0, 1 }, { -1, 2 } }, ErrorCode::ConstraintPoint, 1, -1);
  expectError({}, { { 0, 0 } }, ErrorCode::ConstraintPoint, 0, 0);
  expectError(square, { { 0, 1 }, { 2, 0 }, { 1, 3 } }, ErrorCode::ConstraintsCross, 2, 1);
  expectError(square, { { 1, 3 }, { 1, 3 }, { 2, 0 } }, ErrorCode::ConstraintsCross, 2, 0);
  const auto badView = [](const std::int64_t* ends, std::int64_t count)
  { constrainedTriangulation(PointView(), ConstraintView(ends, count)); };
  const std::int64_t none = 0;
  test::expectError([&] { badView(nullptr, 1); }, ErrorCode::BadArgument);
  test::expectError([&] { badView(&none, -1); }, ErrorCode::BadArgument);

  for (const Cloud& points : { Cloud{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, nan, 0 }, { 0, 1, 0 } },
         Cloud{ { 0, 0, 0 }, { 1, 0, 0 }, { nan, 1, 0 } },
         Cloud{ { nan, 0, 0 }, { nan, 0, 0 }, { 0, nan, 0 } } })
  {
    expectError(points, { { 1, 0 } }, ErrorCode::NonFinite, std::isnan(points[0][0]) ? 0 : 2,
      std::isnan(points[0][0]) ? 3 : 1);
    Options options;
    options.nonFinite = NonFinitePolicy::Ignore;
    expectError(points, { { 2, 2 } }, ErrorCode::ConstraintPoint, 0, 2, options);
  }
}

/// The first of all that it crosses, wherever on the way that is met.
TEST(Constraints, CrossingIsOfTheFirst)
{
  Cloud fence = { { -1, 0, 0 }, { 10, 0, 0 } };
  std::vector<Segment> constraints;
  for (int i = 0; i < 9; ++i)
  {
    fence.push_back({ double(i), 1, 0 });
    fence.push_back({ i + 0.5, -1, 0 });
    constraints.push_back({ 2 + 2 * ((i + 5) % 9), 3 + 2 * ((i + 5) % 9) });
  }
  constraints.push_back({ 0, 1 });
  for (int turn = 0; turn < 9; ++turn)
  {
    // The one of index 9 crosses all.
    std::rotate(constraints.begin(), constraints.begin() + 1, constraints.begin() + 9);
    std::vector<Segment> reversed = constraints;
    std::swap(reversed[9][0], reversed[9][1]);
    expectError(fence, constraints, ErrorCode::ConstraintsCross, 9, 0);
    expectError(fence, reversed, ErrorCode::ConstraintsCross, 9, 0);
  }
}

/// What is wrong with a result does not pass.
TEST(Constraints, FaultsAreFound)
{
  const Cloud kite = { { 0, -3, 0 }, { 1, 0, 0 }, { 0, 3, 0 }, { -1, 0, 0 } };
  const std::vector<Segment> constraints = { { 0, 2 } };
  const auto faultOf = [&](const ConstrainedTriangulation& result)
  { return validate(viewOf(kite), viewOf(constraints), result).fault; };
  EXPECT_EQ(faultOf(run(kite, constraints)), Fault::None);
  EXPECT_EQ(faultOf(run(kite, {})), Fault::NotFixed);
  EXPECT_EQ(
    validate(viewOf(kite), ConstraintView(), run(kite, constraints)).fault, Fault::NotFixed);
  ConstrainedTriangulation loose = run(kite, constraints);
  loose.fixedEdges.allocate(0);
  loose.constraintOf.allocate(0);
  loose.balance.allocate(0);
  loose.sideOf.allocate(0);
  EXPECT_EQ(faultOf(loose), Fault::NotConvex);
  ConstrainedTriangulation another = run(kite, constraints);
  another.constraintOf[0] = 1;
  EXPECT_EQ(faultOf(another), Fault::NotFixed);
  ConstrainedTriangulation away = run(kite, {});
  away.fixedEdges.allocate(2);
  away.constraintOf.allocate(1);
  away.balance.allocate(1);
  away.sideOf.allocate(1);
  away.fixedEdges[0] = away.constraintOf[0] = away.balance[0] = 0;
  away.fixedEdges[1] = 2;
  away.sideOf[0] = -1;
  EXPECT_EQ(faultOf(away), Fault::NotFixed);
  ConstrainedTriangulation side = run(kite, constraints);
  side.sideOf[0] = 0;
  EXPECT_EQ(faultOf(side), Fault::NotFixed);
  side.sideOf.allocate(0);
  EXPECT_EQ(faultOf(side), Fault::Structure);
  Cloud more = kite;
  more.push_back({ 0, 0, 0 });
  EXPECT_EQ(
    validate(viewOf(more), viewOf(constraints), run(kite, constraints)).fault, Fault::PointOutside);
  // No facet has a fixed edge inside.
  const Cloud square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  ConstrainedTriangulation whole = run(square, constraints);
  EXPECT_EQ(validate(viewOf(square), viewOf(constraints), whole).fault, Fault::None);
  whole.cellSize = 4;
  whole.offsets.allocate(0);
  whole.connectivity.allocate(4);
  std::iota(whole.connectivity.begin(), whole.connectivity.end(), std::int64_t(0));
  EXPECT_EQ(validate(viewOf(square), viewOf(constraints), whole).fault, Fault::NotConvex);
  // On a line, too, a fixed edge leads from a point to the next one.
  const Cloud line = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  ConstrainedTriangulation chain = run(line, constraints);
  EXPECT_EQ(validate(viewOf(line), viewOf(constraints), chain).fault, Fault::None);
  for (Buffer<std::int64_t>* values :
    { &chain.fixedEdges, &chain.constraintOf, &chain.balance, &chain.sideOf })
  {
    values->truncate(values->size() / 2);
  }
  chain.fixedEdges[1] = 2;
  EXPECT_EQ(validate(viewOf(line), viewOf(constraints), chain).fault, Fault::NotFixed);
}

}

}
}
