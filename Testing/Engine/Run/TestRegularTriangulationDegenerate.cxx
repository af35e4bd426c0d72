// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The ladder of degenerate inputs, rung by rung, with the cells written out by hand.
#include "Testing/Engine/Conformance/Kind.h"

#include <limits>
#include <numeric>

namespace flipflop
{
namespace test
{

namespace
{

void expectCells(const Cloud& cloud, int dimension, std::vector<Cell> cells)
{
  expectCells(regularTriangulations, cloud, dimension, std::move(cells));
}

TEST(RegularTriangulationDegenerate, NoPoint)
{
  expectCells({}, -1, {});
  const Triangulation none = regularTriangulation(PointView());
  EXPECT_EQ(none.dimension, -1);
  EXPECT_EQ(none.cellCount(), 0);
  EXPECT_TRUE(none.pointIds.empty());
  EXPECT_TRUE(none.hiddenIds.empty());
  EXPECT_TRUE(none.connectivity.empty());
}

TEST(RegularTriangulationDegenerate, OnePosition)
{
  expectCells({ { 1, 2, 3 } }, 0, { { 0 } });
  expectCells(Cloud(2, Point{ -1, 1e300, 0 }), 0, { { 0 } });
  expectCells({ { 1, 2, 3 }, { 1, 2, 4 }, { 1, 2, 4 } }, 0, { { 1 } });
  expectCells({ { 1, 2, -1e300 }, { 1, 2, -1e-300 }, { 1, 2, 0 } }, 0, { { 2 } });
  expectCells({ { 0, -0.0, -0.0 }, { -0.0, 0, 0 } }, 0, { { 0 } });
  Cloud cloud(5000, Point{ 0.1, 0.2, -0.3 });
  expectCells(cloud, 0, { { 0 } });
  cloud[3999][2] = cloud[4001][2] = -0.2;
  expectCells(cloud, 0, { { 3999 } });
}

TEST(RegularTriangulationDegenerate, TwoPositions)
{
  const double least = std::numeric_limits<double>::denorm_min();
  const double greatest = std::numeric_limits<double>::max();
  expectCells({ { 0, 0, 0 }, { 0, 1, 0 } }, 1, { { 0, 1 } });
  // However heavy: both are ends, and both appear.
  expectCells({ { 0, 0, 0 }, { 0, 1, 1e300 } }, 1, { { 0, 1 } });
  expectCells({ { 0, 0, -greatest }, { least, 0, greatest } }, 1, { { 0, 1 } });
  expectCells({ { -greatest, 0, 0 }, { greatest, 0, 0 } }, 1, { { 0, 1 } });
  expectCells({ { 1, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } }, 1, { { 0, 3 } });
}

TEST(RegularTriangulationDegenerate, OneLine)
{
  expectCells(
    { { 2, 2, 0 }, { 0, 0, 0 }, { 1, 1, 0 }, { 3, 3, 0 } }, 1, { { 0, 2 }, { 0, 3 }, { 1, 2 } });
  // The middle of three is exactly tied when it is lighter by the product of its distances.
  expectCells({ { 0, 0, 0 }, { 3, 0, 0 }, { 1, 0, -2 } }, 1, { { 0, 1 } });
  expectCells({ { 0, 0, 0 }, { 3, 0, 0 }, { 1, 0, -2 + 0x1p-51 } }, 1, { { 0, 2 }, { 1, 2 } });
  expectCells({ { 0, 0, 0 }, { 3, 0, 0 }, { 1, 0, -2 - 0x1p-51 } }, 1, { { 0, 1 } });
  // The lifts of one line, in a line: no matter how many.
  Cloud cloud;
  for (int i = 0; i < 3000; ++i)
  {
    const double t = i * 7919 % 3000;
    cloud.push_back({ t, -2 * t, 5 * t * t });
  }
  const auto at = [&](double t)
  {
    return std::find_if(cloud.begin(), cloud.end(), [=](const Point& p) { return p[0] == t; }) -
      cloud.begin();
  };
  expectCells(cloud, 1, { { std::min(at(0), at(2999)), std::max(at(0), at(2999)) } });
  // One sinks below.
  cloud[at(1234)][2] += 1;
  std::vector<Cell> chain = { { at(0), at(1234) }, { at(1234), at(2999) } };
  for (Cell& cell : chain)
  {
    std::sort(cell.begin(), cell.end());
  }
  std::sort(chain.begin(), chain.end());
  expectCells(cloud, 1, chain);
}

TEST(RegularTriangulationDegenerate, LinesInEveryDirection)
{
  for (const Point& u : { Point{ 1, 0, 0 }, Point{ 0, 1, 0 }, Point{ -1, 0, 0 }, Point{ 0, -1, 0 },
         Point{ 1, 1, 0 }, Point{ -1, 1, 0 }, Point{ 3, -7, 0 }, Point{ 0x1p-300, 0x1p300, 0 },
         Point{ 0x1p500, 0x1p-500, 0 } })
  {
    // Delaunay on a line: neighbours along it.
    Cloud cloud;
    for (int t : { 4, 1, 3, 0, 2 })
    {
      cloud.push_back({ t * u[0], t * u[1], 0 });
    }
    expectCells(cloud, 1, { { 0, 2 }, { 1, 3 }, { 1, 4 }, { 2, 4 } });
  }
}

TEST(RegularTriangulationDegenerate, OneTriangle)
{
  expectCells({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, 2, { { 0, 1, 2 } });
  expectCells({ { 0, 0, 5 }, { 0, 1, -1e300 }, { 1, 0, 1e300 } }, 2, { { 0, 2, 1 } });
  // Exactly flat but for the least that doubles can say.
  expectCells({ { 1, 1, 0 }, { 2, 2, 0 }, { 1.5, 1.5 + 0x1p-52, 0 } }, 2, { { 0, 1, 2 } });
  const double least = std::numeric_limits<double>::denorm_min();
  expectCells({ { 0, 0, 0 }, { least, 0, 0 }, { 0, least, 0 } }, 2, { { 0, 1, 2 } });
  expectCells({ { 1e308, 0, 0 }, { -1e308, 0, 0 }, { 0, least, 0 } }, 2, { { 0, 2, 1 } });
}

TEST(RegularTriangulationDegenerate, APointOnAnEdge)
{
  const Cloud triangle = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } };
  // On the border: visible, tied, hidden. No triangle without area ever.
  for (double weight : { 0.0, -4 + 0x1p-50 })
  {
    expectCells(joined(triangle, { { 2, 0, weight } }), 2, { { 0, 3, 2 }, { 1, 2, 3 } });
  }
  for (double weight : { -4.0, -4 - 0x1p-50, -9.0 })
  {
    expectCells(joined(triangle, { { 2, 0, weight } }), 2, { { 0, 1, 2 } });
  }
  // On an inner edge, its lift on that edge's lift: hidden, though both sides bend.
  const Cloud kite = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 3, -9 }, { 2, -3, -9 } };
  expectCells(kite, 2, { { 0, 1, 2 }, { 0, 3, 1 } });
  expectCells(joined(kite, { { 2, 0, -4 } }), 2, { { 0, 1, 2 }, { 0, 3, 1 } });
  expectCells(joined(kite, { { 2, 0, -4 + 0x1p-50 } }), 2,
    { { 0, 3, 4 }, { 0, 4, 2 }, { 1, 2, 4 }, { 1, 4, 3 } });
}

TEST(RegularTriangulationDegenerate, OneCircle)
{
  // Exactly cocircular: one polygon, whatever is inside and tied.
  const Cloud circle = cocircularIntegers(325);
  const ReferenceTriangulation all = bruteForceTriangulation(circle);
  ASSERT_EQ(all.cells.size(), 1u);
  EXPECT_EQ(all.cells[0].size(), 24u);
  expectCells(circle, 2, all.cells);
  Cloud cloud = circle;
  for (int x = -17; x <= 17; ++x)
  {
    for (int y = -17; y <= 17; ++y)
    {
      if (x * x + y * y < 325)
      {
        cloud.push_back({ double(x), double(y), double(x * x + y * y - 325) });
      }
    }
  }
  expectCells(cloud, 2, all.cells);
}

TEST(RegularTriangulationDegenerate, AllLiftsInOnePlane)
{
  for (int side : { 2, 3, 7, 70 })
  {
    Cloud cloud = squareGrid(side);
    for (Point& p : cloud)
    {
      p[2] = p[0] * p[0] + p[1] * p[1];
    }
    const std::int64_t n = side;
    expectCells(cloud, 2, { { 0, n - 1, n * n - 1, n * n - n } });
    // A tilted plane too.
    for (Point& p : cloud)
    {
      p[2] += 3 * p[0] - 100 * p[1] + 17;
    }
    expectCells(cloud, 2, { { 0, n - 1, n * n - 1, n * n - n } });
  }
}

TEST(RegularTriangulationDegenerate, TheGrid)
{
  for (int side : { 2, 3, 8, 50 })
  {
    std::vector<Cell> squares;
    for (std::int64_t y = 0; y + 1 < side; ++y)
    {
      for (std::int64_t x = 0; x + 1 < side; ++x)
      {
        const std::int64_t a = y * side + x;
        squares.push_back({ a, a + 1, a + 1 + side, a + side });
      }
    }
    expectCells(squareGrid(side), 2, squares);
    expectCells(moved(squareGrid(side), 0x1p50, -0x1p50, -7), 2, squares);
    expectCells(magnified(squareGrid(side), 0x1p-500), 2, squares);
    expectCells(scaled(squareGrid(side), 0x1p1000, 0x1p1000, 1), 2, squares);
  }
}

TEST(RegularTriangulationDegenerate, AllButTheHeaviestHidden)
{
  // A triangle so heavy that it hides all others, and one that is not.
  Cloud cloud = moved(squareGrid(60), -30, -30, 0);
  cloud = joined(std::move(cloud), { { -200, -200, 1e6 }, { 200, -200, 1e6 }, { 0, 200, 1e6 } });
  expectCells(cloud, 2, { { 3600, 3601, 3602 } });
  cloud.push_back({ 0, 0, 1e6 });
  expectCells(cloud, 2, { { 3600, 3601, 3603 }, { 3600, 3603, 3602 }, { 3601, 3602, 3603 } });
}

TEST(RegularTriangulationDegenerate, DuplicatesOfAnyWeight)
{
  // Four corners, each three times; the heaviest appears, and of equals the lowest id.
  Cloud cloud;
  for (double weight : { 1.0, 2.0, 2.0 })
  {
    for (Point p : squareGrid(2))
    {
      p[2] = weight;
      cloud.push_back(p);
    }
  }
  expectCells(cloud, 2, { { 4, 5, 7, 6 } });
  cloud[0][2] = 2;
  expectCells(cloud, 2, { { 0, 5, 7, 6 } });
  // The differences of weights below the last place of the squares.
  for (Point& p : cloud)
  {
    p = { p[0] + 0x1p50, p[1] - 0x1p50, p[2] * 0x1p-1070 };
  }
  expectCells(cloud, 2, { { 0, 5, 7, 6 } });
}

TEST(RegularTriangulationDegenerate, GiantWeights)
{
  // One giant within hides all but the border: there the chain of each side is as it was.
  const double greatest = std::numeric_limits<double>::max();
  const int side = 40;
  Cloud cloud = squareGrid(side);
  const std::int64_t giant = side * 17 + 21;
  cloud[giant][2] = greatest;
  std::vector<Cell> fan;
  for (std::int64_t i = 0; i + 1 < side; ++i)
  {
    const std::int64_t last = side * (side - 1);
    fan.push_back({ i, i + 1, giant });
    fan.push_back({ last + i + 1, last + i, giant });
    fan.push_back({ (i + 1) * side, i * side, giant });
    fan.push_back({ i * side + side - 1, (i + 1) * side + side - 1, giant });
  }
  canonicalise(fan);
  expectCells(cloud, 2, fan);
  // As light as can be: it goes, if it is no corner.
  cloud = squareGrid(3);
  cloud[4][2] = -greatest;
  expectCells(cloud, 2, { { 0, 1, 3 }, { 1, 2, 5 }, { 1, 5, 7, 3 }, { 3, 7, 6 }, { 5, 8, 7 } });
  cloud = squareGrid(2);
  cloud[3][2] = -greatest;
  expectCells(cloud, 2, { { 0, 1, 2 }, { 1, 3, 2 } });
}

TEST(RegularTriangulationDegenerate, ConstantWeightsDoNotCount)
{
  const std::vector<Cell> delaunay = bruteForceTriangulation(squareGrid(5)).cells;
  for (double weight : { 0.0, 1.0, -1.0, 1e300, -1e300, 1e-300 })
  {
    Cloud cloud = squareGrid(5);
    for (Point& p : cloud)
    {
      p[2] = weight;
    }
    expectCells(cloud, 2, delaunay);
  }
}

}
}
}
