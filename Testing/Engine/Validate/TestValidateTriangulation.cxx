// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The triangulation's oracle is put to the test: right ones pass, and each way to break one is
/// found and named.
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/Validate/TriangulationClaims.h"

#include <cmath>
#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

/// A cloud with some hidden points, in general position.
Cloud general(int count, std::uint64_t seed)
{
  return fromWeightedFamily("uniformHeavy", count, seed).make();
}

TEST(ValidateTriangulation, TakesThoseMadeByHand)
{
  for (const Input& input : smallWeightedInputs())
  {
    SCOPED_TRACE(input.name);
    const Cloud cloud = input.make();
    const ReferenceTriangulation reference = bruteForceTriangulation(cloud);
    for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      const std::int64_t count = static_cast<std::int64_t>(cloud.size());
      EXPECT_EQ(faultOf(cloud, makeTriangulation(reference, count, facets)), Fault::None);
    }
  }
  for (const Family& family : weightedFamilies())
  {
    for (int count : { 0, 1, 2, 3, 10, 3000 })
    {
      const Input input = fromWeightedFamily(family.name, effort(count), 3);
      SCOPED_TRACE(input.name + ", seed 3");
      const Cloud cloud = input.make();
      EXPECT_EQ(faultOf(cloud, whole(cloud, FacetMode::Triangles)), Fault::None);
      EXPECT_EQ(faultOf(cloud, whole(cloud, FacetMode::Polygons)), Fault::None);
    }
  }
}

TEST(ValidateTriangulation, TakesWeightsOfZeroForNone)
{
  const Cloud cloud = squareGrid(9);
  EXPECT_TRUE(validate(viewOf(cloud), WeightView(), whole(cloud)));
}

TEST(ValidateTriangulation, LeavesOutNonFinitePoints)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Cloud cloud = joined(squareGrid(3), { { infinity, 0, 0 }, { 0, 0, -infinity }, { 7, NAN, 0 } });
  Triangulation found = whole(squareGrid(3));
  EXPECT_EQ(faultOf(cloud, found), Fault::None);
  // They are not hidden either.
  const ReferenceTriangulation reference = bruteForceTriangulation(squareGrid(3));
  EXPECT_NE(faultOf(cloud, makeTriangulation(reference, 12)), Fault::None);
  EXPECT_NE(faultOf(cloud, makeTriangulation(reference, 10)), Fault::None);
}

TEST(ValidateTriangulation, Structure)
{
  const Cloud cloud = general(200, 5);
  const Triangulation right = whole(cloud, FacetMode::Triangles);
  const Breaker expectStructure(cloud, right);
  const std::int64_t points = static_cast<std::int64_t>(right.pointIds.size());
  const std::int64_t input = static_cast<std::int64_t>(cloud.size());
  for (std::int64_t bad :
    { std::int64_t(-1), points, std::int64_t(1) << 40, std::numeric_limits<std::int64_t>::min() })
  {
    expectStructure("a corner out of range", [=](Triangulation& t) { t.connectivity[4] = bad; });
  }
  for (std::int64_t bad : { std::int64_t(-1), input, std::int64_t(1) << 40 })
  {
    expectStructure("an id out of range", [=](Triangulation& t) { t.pointIds[points - 1] = bad; });
  }
  expectStructure(
    "ids out of order", [](Triangulation& t) { std::swap(t.pointIds[1], t.pointIds[2]); });
  expectStructure("an id twice", [](Triangulation& t) { t.pointIds[3] = t.pointIds[2]; });
  expectStructure("a cell turned",
    [](Triangulation& t)
    { std::rotate(&t.connectivity[6], &t.connectivity[7], &t.connectivity[9]); });
  expectStructure("two cells exchanged",
    [](Triangulation& t)
    { std::swap_ranges(&t.connectivity[3], &t.connectivity[6], &t.connectivity[6]); });
  expectStructure("connectivity cut short",
    [](Triangulation& t) { t.connectivity.truncate(t.connectivity.size() - 1); });
  expectStructure("a negative cell size", [](Triangulation& t) { t.cellSize = -3; });
  expectStructure("a dimension too many", [](Triangulation& t) { t.dimension = 3; });
  expectStructure("a dimension too few", [](Triangulation& t) { t.dimension = -2; });
}

TEST(ValidateTriangulation, StructureOfOffsets)
{
  const Cloud cloud = squareGrid(4);
  const Triangulation right = whole(cloud);
  const Breaker expectStructure(cloud, right);
  expectStructure("offsets do not begin at 0", [](Triangulation& t) { t.offsets[0] = 1; });
  expectStructure("offsets fall", [](Triangulation& t) { t.offsets[2] = 30; });
  expectStructure("offsets below 0", [](Triangulation& t) { t.offsets[1] = -4; });
  expectStructure("offsets go too far", [](Triangulation& t) { t.offsets[9] = 40; });
  expectStructure("offsets stop early", [](Triangulation& t) { t.offsets[9] = 35; });
  expectStructure("a cell of no corner", [](Triangulation& t) { t.offsets[1] = 0; });
  expectStructure("a cell of two corners", [](Triangulation& t) { t.offsets[1] = 2; });
}

TEST(ValidateTriangulation, HiddenPoints)
{
  // All points that do not appear, once each, in order: nothing else will do.
  const Cloud cloud = general(200, 6);
  const Triangulation right = whole(cloud);
  ASSERT_GT(right.hiddenIds.size(), 20u);
  ASSERT_EQ(faultOf(cloud, right), Fault::None);
  const auto expectFault = [&](const char* what, const std::function<void(Cell&)>& change)
  {
    Cell hidden(right.hiddenIds.begin(), right.hiddenIds.end());
    change(hidden);
    Triangulation copy = clone(right);
    copy.hiddenIds.allocate(hidden.size());
    std::copy(hidden.begin(), hidden.end(), copy.hiddenIds.begin());
    EXPECT_EQ(faultOf(cloud, copy), Fault::Structure) << what;
  };
  expectFault("the first is missing", [](Cell& h) { h.erase(h.begin()); });
  expectFault("the last is missing", [](Cell& h) { h.pop_back(); });
  expectFault("one is missing", [](Cell& h) { h.erase(h.begin() + 7); });
  expectFault("all are missing", [](Cell& h) { h.clear(); });
  expectFault("one is there twice", [](Cell& h) { h.insert(h.begin() + 5, h[5]); });
  expectFault("one stands for another", [](Cell& h) { h[6] = h[5]; });
  expectFault("two are exchanged", [](Cell& h) { std::swap(h[2], h[3]); });
  expectFault("the last is out of range", [](Cell& h) { h.back() = 200; });
  expectFault("one too many", [](Cell& h) { h.push_back(200); });
  expectFault("a negative one", [](Cell& h) { h.front() = -1; });
  expectFault("a visible one, too",
    [&](Cell& h)
    {
      h.push_back(right.pointIds[9]);
      std::sort(h.begin(), h.end());
    });
  expectFault("a visible one instead",
    [&](Cell& h)
    {
      h[4] = right.pointIds[9];
      std::sort(h.begin(), h.end());
    });
}

TEST(ValidateTriangulation, NotClosedWhereACellIsMissing)
{
  const Cloud cloud = general(120, 7);
  const std::vector<Cell> all = cgalTriangulation(cloud).cells;
  for (std::size_t missing = 0; missing < all.size(); ++missing)
  {
    std::vector<Cell> some = all;
    some.erase(some.begin() + static_cast<std::ptrdiff_t>(missing));
    for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      const Fault fault = faultOf(cloud, claim(cloud, 2, some, facets));
      // A gap at the border leaves it reflex.
      EXPECT_TRUE(
        fault == Fault::NotClosed || fault == Fault::NotConvex || fault == Fault::PointOutside)
        << "cell " << missing << ": " << describe(fault);
    }
  }
  EXPECT_NE(faultOf(cloud, claim(cloud, 2, {})), Fault::None);
}

TEST(ValidateTriangulation, NotClosedWhereATriangleIsTurnedOver)
{
  const Cloud cloud = general(120, 8);
  const std::vector<Cell> all = cgalTriangulation(cloud).cells;
  for (std::size_t i = 0; i < all.size(); i += 5)
  {
    std::vector<Cell> turned = all;
    std::swap(turned[i][1], turned[i][2]);
    const Fault fault = faultOf(cloud, claimTriangles(cloud, turned));
    EXPECT_TRUE(fault == Fault::NotClosed || fault == Fault::NotConvex) << describe(fault);
  }
  // All of them.
  std::vector<Cell> turned = all;
  for (Cell& cell : turned)
  {
    std::swap(cell[1], cell[2]);
  }
  EXPECT_EQ(faultOf(cloud, claimTriangles(cloud, turned)), Fault::NotConvex);
}

TEST(ValidateTriangulation, ACellTwice)
{
  const Cloud cloud = general(60, 9);
  std::vector<Cell> cells = cgalTriangulation(cloud).cells;
  cells.insert(cells.begin() + 5, cells[5]);
  const Fault fault = faultOf(cloud, claim(cloud, 2, cells));
  EXPECT_TRUE(fault == Fault::Structure || fault == Fault::NotClosed) << describe(fault);
}

TEST(ValidateTriangulation, NotConvexAtAFlippedEdge)
{
  // Flip each edge in turn that can be: it is not regular then.
  const Cloud cloud = general(150, 10);
  const std::vector<Cell> all = cgalTriangulation(cloud).cells;
  const auto turn = [&](std::int64_t i, std::int64_t j, std::int64_t k)
  {
    const Point& p = cloud[i];
    return (cloud[j][0] - p[0]) * (cloud[k][1] - p[1]) -
      (cloud[j][1] - p[1]) * (cloud[k][0] - p[0]);
  };
  int flipped = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (std::size_t j = i + 1; j < all.size(); ++j)
    {
      for (int e = 0; e < 9; ++e)
      {
        const Cell& s = all[i];
        const Cell& t = all[j];
        const std::int64_t a = s[e % 3];
        const std::int64_t b = s[(e + 1) % 3];
        const std::int64_t c = s[(e + 2) % 3];
        const std::int64_t d = t[(e / 3 + 2) % 3];
        if (t[e / 3] == b && t[(e / 3 + 1) % 3] == a && turn(c, d, b) > 1e-9 &&
          turn(d, c, a) > 1e-9)
        {
          std::vector<Cell> other = all;
          other[i] = { a, d, c };
          other[j] = { d, b, c };
          EXPECT_EQ(faultOf(cloud, claim(cloud, 2, other)), Fault::NotConvex);
          EXPECT_EQ(faultOf(cloud, claimTriangles(cloud, other)), Fault::NotConvex);
          ++flipped;
        }
      }
    }
  }
  EXPECT_GT(flipped, 20);
}

TEST(ValidateTriangulation, NotConvexWherePolygonsAreFlatOrBent)
{
  const Cloud square = squareGrid(2);
  EXPECT_EQ(faultOf(square, claim(square, 2, { { 0, 1, 2 }, { 1, 3, 2 } })), Fault::NotConvex);
  EXPECT_EQ(faultOf(square, claim(square, 2, { { 0, 1, 3 }, { 0, 3, 2 } })), Fault::NotConvex);
  // One polygon that bends by very little.
  for (double weight : { 0x1p-1000, -0x1p-1000 })
  {
    Cloud bent = square;
    bent[3][2] = weight;
    EXPECT_EQ(faultOf(bent, claim(bent, 2, { { 0, 1, 3, 2 } })), Fault::NotConvex) << weight;
    // And as triangles with the wrong diagonal, or the right one.
    const bool bulges = weight > 0;
    EXPECT_EQ(
      faultOf(bent, claimTriangles(bent, { { 0, 1, 3 }, { 0, 3, 2 } })) == Fault::None, bulges);
    EXPECT_EQ(
      faultOf(bent, claimTriangles(bent, { { 0, 1, 2 }, { 1, 3, 2 } })) == Fault::None, !bulges);
  }
}

TEST(ValidateTriangulation, NotConvexWhereAPolygonCrossesItself)
{
  const Cloud circle = cocircularIntegers(25);
  const Cell polygon = bruteForceTriangulation(circle).cells.at(0);
  ASSERT_EQ(polygon.size(), 12u);
  EXPECT_EQ(faultOf(circle, claim(circle, 2, { polygon })), Fault::None);
  Cell crossed = polygon;
  std::swap(crossed[4], crossed[5]);
  EXPECT_EQ(faultOf(circle, claim(circle, 2, { crossed })), Fault::NotConvex);
  // Round by round of five corners: all left turns, but five rounds.
  Cell star;
  for (std::size_t i = 0; i < 12; ++i)
  {
    star.push_back(polygon[5 * i % 12]);
  }
  EXPECT_EQ(faultOf(circle, claim(circle, 2, { star })), Fault::NotConvex);
  Cell backwards = polygon;
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_EQ(faultOf(circle, claim(circle, 2, { backwards })), Fault::NotConvex);
}

TEST(ValidateTriangulation, TrianglesMustBeTheCanonicalFan)
{
  const Cloud cloud = squareGrid(2);
  EXPECT_EQ(faultOf(cloud, claimTriangles(cloud, { { 0, 1, 3 }, { 0, 3, 2 } })), Fault::None);
  EXPECT_EQ(faultOf(cloud, claimTriangles(cloud, { { 0, 1, 2 }, { 1, 3, 2 } })), Fault::Structure);
  // A circle's other triangulations.
  const Cloud circle = cocircularIntegers(25);
  const Cell polygon = bruteForceTriangulation(circle).cells.at(0);
  for (std::size_t apex = 1; apex < polygon.size(); ++apex)
  {
    std::vector<Cell> fan;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    {
      fan.push_back({ polygon[apex], polygon[(apex + i) % 12], polygon[(apex + i + 1) % 12] });
    }
    EXPECT_EQ(faultOf(circle, claimTriangles(circle, fan)), Fault::Structure) << apex;
  }
}

}
}
}
