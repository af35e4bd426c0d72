// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The triangulation's oracle on what is visible and what is hidden, on lines, on ids and
/// dimensions; and whether anything but the right answer gets past it.
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/Validate/TriangulationClaims.h"

#include <cmath>
#include <set>

namespace flipflop
{
namespace test
{

namespace
{

TEST(ValidateTriangulation, NotExtreme)
{
  // A point that is exactly tied, in a facet, in an edge, on the border.
  const Cloud square = joined(squareGrid(2), { { 0.5, 0.5, -0.5 } });
  const std::vector<Cell> starred = { { 0, 1, 4 }, { 0, 4, 2 }, { 1, 3, 4 }, { 2, 4, 3 } };
  Fault fault = faultOf(square, claimTriangles(square, starred));
  EXPECT_TRUE(fault == Fault::NotExtreme || fault == Fault::Structure) << describe(fault);
  fault = faultOf(square, claim(square, 2, starred));
  EXPECT_TRUE(fault == Fault::NotExtreme || fault == Fault::NotConvex) << describe(fault);

  const Cloud kite = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 3, -9 }, { 2, -3, -9 }, { 2, 0, -4 } };
  EXPECT_EQ(faultOf(kite, claim(kite, 2, { { 0, 1, 2 }, { 0, 3, 1 } })), Fault::None);
  // A corner that does not turn is a fault of the polygon, too.
  fault = faultOf(kite, claim(kite, 2, { { 0, 4, 1, 2 }, { 0, 3, 1, 4 } }));
  EXPECT_TRUE(fault == Fault::NotExtreme || fault == Fault::NotConvex || fault == Fault::NotClosed)
    << describe(fault);
  fault =
    faultOf(kite, claimTriangles(kite, { { 0, 4, 2 }, { 1, 2, 4 }, { 0, 3, 4 }, { 1, 4, 3 } }));
  EXPECT_TRUE(fault == Fault::NotExtreme || fault == Fault::Structure) << describe(fault);

  const Cloud border = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 2, 0, -4 } };
  EXPECT_EQ(faultOf(border, claim(border, 2, { { 0, 1, 2 } })), Fault::None);
  fault = faultOf(border, claim(border, 2, { { 0, 3, 1, 2 } }));
  EXPECT_TRUE(fault == Fault::NotExtreme || fault == Fault::NotConvex) << describe(fault);
  // A sliver without area.
  fault = faultOf(border, claimTriangles(border, { { 0, 1, 2 }, { 0, 3, 1 } }));
  EXPECT_TRUE(fault == Fault::NotConvex || fault == Fault::NotExtreme) << describe(fault);
  // One that is hidden, in its corner's place: a reflex edge.
  Cloud above = squareGrid(2);
  above.push_back({ 0.5, 0.5, -0.5 - 0x1p-40 });
  EXPECT_NE(faultOf(above, claimTriangles(above, starred)), Fault::None);
}

TEST(ValidateTriangulation, PointOutside)
{
  // The triangulation without one of its points, that point being said to be hidden.
  for (const char* name : { "uniformHeavy", "uniform", "far15", "clusters", "smallIntegersLight" })
  {
    const Cloud cloud = fromWeightedFamily(name, 300, 11).make();
    const ReferenceTriangulation right = cgalTriangulation(cloud);
    int tried = 0;
    for (std::size_t k = 0; k < right.ids.size(); k += 7)
    {
      const std::int64_t gone = right.ids[k];
      Cloud less = cloud;
      less[gone][2] = -1e30;
      const ReferenceTriangulation part = cgalTriangulation(less);
      if (std::binary_search(part.ids.begin(), part.ids.end(), gone))
      {
        continue; // a corner of the border
      }
      if (lowestIds(cloud)[gone] != gone || part.ids.size() == right.ids.size())
      {
        continue; // another one took its place
      }
      ++tried;
      for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
      {
        const Validation valid =
          validate(viewOf(cloud), weightsOf(cloud), makeTriangulation(part, 300, facets), 2);
        EXPECT_EQ(valid.fault, Fault::PointOutside) << name;
        EXPECT_EQ(valid.index, gone) << name;
      }
    }
    EXPECT_GT(tried, 2) << name;
  }
}

TEST(ValidateTriangulation, PointOutsideByTheLeastWeight)
{
  Cloud cloud = joined(squareGrid(2), { { 0.5, 0.5, -0.5 } });
  const Triangulation square = claim(cloud, 2, { { 0, 1, 3, 2 } });
  EXPECT_EQ(faultOf(cloud, square), Fault::None);
  cloud[4][2] = -0.5 + 0x1p-54;
  EXPECT_EQ(faultOf(cloud, square), Fault::PointOutside);
  const Validation valid = validate(viewOf(cloud), weightsOf(cloud), square);
  EXPECT_EQ(valid.index, 4);
  // Outside in the plane.
  for (const Point& p : { Point{ 2, 0, -100 }, Point{ 1 + 0x1p-52, 0.5, -1e300 },
         Point{ 0.5, -0x1p-1074, 0 }, Point{ -1e300, 1e300, -1e300 } })
  {
    cloud[4] = p;
    EXPECT_EQ(faultOf(cloud, square), Fault::PointOutside) << toString(Cloud{ p });
  }
  // On its border: tied, or not.
  cloud[4] = { 0.5, 0, -0.25 };
  EXPECT_EQ(faultOf(cloud, square), Fault::None);
  cloud[4] = { 0.5, 0, -0.25 + 0x1p-54 };
  EXPECT_EQ(faultOf(cloud, square), Fault::PointOutside);
  // At a corner, heavier than it.
  cloud[4] = { 1, 1, 0x1p-1074 };
  EXPECT_EQ(faultOf(cloud, square), Fault::PointOutside);
  cloud[4] = { 1, 1, 0 };
  EXPECT_EQ(faultOf(cloud, square), Fault::None);
}

TEST(ValidateTriangulation, Lines)
{
  const Cloud cloud = { { 2, 2, 0 }, { 0, 0, 0 }, { 1, 1, 0 }, { 4, 4, 0 }, { 3, 3, -2 } };
  EXPECT_EQ(faultOf(cloud, claim(cloud, 1, { { 0, 2 }, { 0, 3 }, { 1, 2 } })), Fault::None);
  // The tied one as a corner, a visible one hidden, and both.
  EXPECT_EQ(
    faultOf(cloud, claim(cloud, 1, { { 0, 2 }, { 0, 4 }, { 3, 4 }, { 1, 2 } })), Fault::NotExtreme);
  EXPECT_EQ(faultOf(cloud, claim(cloud, 1, { { 0, 1 }, { 0, 3 } })), Fault::PointOutside);
  EXPECT_NE(faultOf(cloud, claim(cloud, 1, { { 0, 1 }, { 0, 4 }, { 3, 4 } })), Fault::None);
  // An end too few, a link too few, a link too many, links astray.
  EXPECT_EQ(faultOf(cloud, claim(cloud, 1, { { 0, 2 }, { 1, 2 } })), Fault::PointOutside);
  EXPECT_NE(faultOf(cloud, claim(cloud, 1, { { 0, 3 }, { 1, 2 } })), Fault::None);
  EXPECT_NE(
    faultOf(cloud, claim(cloud, 1, { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 } })), Fault::None);
  EXPECT_NE(faultOf(cloud, claim(cloud, 1, { { 0, 1 }, { 0, 3 }, { 1, 2 } })), Fault::None);
  EXPECT_NE(faultOf(cloud, claim(cloud, 1, {})), Fault::None);
  // A reflex corner: hidden by its neighbours.
  Cloud reflex = cloud;
  reflex[0][2] = -9;
  EXPECT_NE(faultOf(reflex, claim(reflex, 1, { { 0, 2 }, { 0, 3 }, { 1, 2 } })), Fault::None);
  // The form.
  const Triangulation right = claim(cloud, 1, { { 0, 2 }, { 0, 3 }, { 1, 2 } });
  const Breaker expectStructure(cloud, right);
  expectStructure("the higher index first",
    [](Triangulation& t) { std::swap(t.connectivity[0], t.connectivity[1]); });
  expectStructure("links out of order",
    [](Triangulation& t)
    { std::swap_ranges(&t.connectivity[0], &t.connectivity[2], &t.connectivity[2]); });
  expectStructure("a corner out of range", [](Triangulation& t) { t.connectivity[5] = 4; });
  // Not on the line at all, if by the least.
  Cloud off = cloud;
  off[4] = { 3, 3 + 0x1p-51, -1e9 };
  const Fault fault = faultOf(off, right);
  EXPECT_TRUE(fault == Fault::WrongDimension || fault == Fault::PointOutside) << describe(fault);
}

TEST(ValidateTriangulation, WrongId)
{
  const Cloud cloud = joined(squareGrid(2), squareGrid(2));
  EXPECT_EQ(faultOf(cloud, claim(cloud, 2, { { 0, 1, 3, 2 } })), Fault::None);
  EXPECT_EQ(faultOf(cloud, claim(cloud, 2, { { 0, 1, 7, 2 } })), Fault::WrongId);
  EXPECT_EQ(faultOf(cloud, claimTriangles(cloud, { { 0, 1, 7 }, { 0, 7, 2 } })), Fault::WrongId);
  const Cloud line = { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 0, 1 }, { 0, 0, 0 } };
  EXPECT_EQ(faultOf(line, claim(line, 1, { { 0, 1 } })), Fault::None);
  EXPECT_EQ(faultOf(line, claim(line, 1, { { 0, 2 } })), Fault::WrongId);
  const Cloud one(3, Point{ 1, 1, 1 });
  EXPECT_EQ(faultOf(one, claim(one, 0, { { 0 } })), Fault::None);
  EXPECT_EQ(faultOf(one, claim(one, 0, { { 1 } })), Fault::WrongId);
  // A lighter one at the same place: another point than it should be.
  const Fault lighter[] = { faultOf(line, claim(line, 1, { { 1, 3 } })),
    faultOf({ { 5, 5, 0 }, { 5, 5, 1 } }, claim(Cloud(2), 0, { { 0 } })),
    faultOf(joined(squareGrid(2), { { 1, 1, 1 } }), claim(Cloud(5), 2, { { 0, 1, 3, 2 } })) };
  for (Fault fault : lighter)
  {
    EXPECT_TRUE(
      fault == Fault::WrongId || fault == Fault::PointOutside || fault == Fault::NotExtreme)
      << describe(fault);
  }
}

TEST(ValidateTriangulation, WrongDimension)
{
  const Cloud square = squareGrid(2);
  const Cloud segment = { { 0, 0, 0 }, { 1, 0, 0 } };
  const Cloud one = { { 0, 0, 0 } };
  EXPECT_EQ(faultOf({}, Triangulation()), Fault::None);
  EXPECT_EQ(faultOf(one, claim(one, 0, { { 0 } })), Fault::None);
  EXPECT_EQ(faultOf(segment, claim(segment, 1, { { 0, 1 } })), Fault::None);
  EXPECT_EQ(faultOf(square, claim(square, 2, { { 0, 1, 3, 2 } })), Fault::None);
  for (const Cloud& cloud : { one, segment, square })
  {
    // Nothing, all being said to be hidden.
    EXPECT_EQ(faultOf(cloud, claim(cloud, -1, {})), Fault::WrongDimension);
  }
  // Too low a dimension leaves points outside: either name is right.
  const Fault tooLow[] = { faultOf(segment, claim(segment, 0, { { 0 } })),
    faultOf(square, claim(square, 1, { { 0, 1 } })), faultOf(square, claim(square, 0, { { 0 } })) };
  for (Fault fault : tooLow)
  {
    EXPECT_TRUE(fault == Fault::WrongDimension || fault == Fault::PointOutside) << describe(fault);
  }
  // Too high: triangles without area, a link of no length.
  const Cloud three = { { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } };
  const Fault tooHigh[] = { faultOf(three, claim(three, 2, { { 0, 1, 2 } })),
    faultOf(Cloud(2, Point{ 1, 2, 0 }), claim(Cloud(2), 1, { { 0, 1 } })) };
  for (Fault fault : tooHigh)
  {
    EXPECT_NE(fault, Fault::None);
  }
  EXPECT_NE(faultOf({}, claim(one, 0, { { 0 } })), Fault::None);
}

TEST(ValidateTriangulation, WindsOnce)
{
  // A fan wound twice around its centre is counter-clockwise and regular at every edge, its border
  // turns left everywhere; but it covers all twice.
  Cloud cloud = { { 0, 0, 10 } };
  for (int round = 0; round < 2; ++round)
  {
    for (int i = 0; i < 5; ++i)
    {
      const double angle = 6.283185307179586 * i / 5;
      const double r = 1 + round * 0x1p-30;
      cloud.push_back({ r * std::cos(angle), r * std::sin(angle), 0 });
    }
  }
  std::vector<Cell> cells;
  for (int i = 0; i < 10; ++i)
  {
    cells.push_back({ 0, 1 + i, 1 + (i + 1) % 10 });
  }
  EXPECT_NE(faultOf(cloud, claimTriangles(cloud, cells)), Fault::None);
  EXPECT_NE(faultOf(cloud, claim(cloud, 2, cells)), Fault::None);
  // The same with equal positions.
  for (int i = 0; i < 5; ++i)
  {
    cloud[6 + i] = cloud[1 + i];
  }
  EXPECT_NE(faultOf(cloud, claimTriangles(cloud, cells)), Fault::None);
}

TEST(ValidateTriangulation, TwoPieces)
{
  // Each is whole for itself.
  const Cloud cloud = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 5, 0 }, { 6, 5, 0 },
    { 5, 6, 0 } };
  EXPECT_NE(faultOf(cloud, claimTriangles(cloud, { { 0, 1, 2 }, { 3, 4, 5 } })), Fault::None);
  // One over the other.
  const Cloud over = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 0 }, { 2, 1, 0 },
    { 1, 2, 0 } };
  EXPECT_NE(faultOf(over, claimTriangles(over, { { 0, 1, 2 }, { 3, 4, 5 } })), Fault::None);
  // They touch in a corner.
  const Cloud touching = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } };
  EXPECT_NE(faultOf(touching, claimTriangles(touching, { { 0, 1, 2 }, { 0, 3, 4 } })), Fault::None);
}

TEST(ValidateTriangulation, OtherWeights)
{
  // The triangulation of one cloud is not that of a cloud with another weight.
  for (const Family& family : weightedFamilies())
  {
    Cloud cloud = fromWeightedFamily(family.name, 300, 12).make();
    const Triangulation right = whole(cloud);
    ASSERT_EQ(faultOf(cloud, right), Fault::None) << family.name;
    const std::int64_t last = static_cast<std::int64_t>(right.pointIds.size()) - 1;
    cloud[right.pointIds[last / 2]][2] += 1e9;
    const Triangulation other = whole(cloud);
    EXPECT_EQ(faultOf(cloud, right) == Fault::None, bitDifference(right, other).empty())
      << family.name;
  }
}

TEST(ValidateTriangulation, RandomChanges)
{
  // Whatever is changed in a right answer makes it wrong: there is one right answer.
  std::set<Fault> seen;
  for (int i = 0; i < effort(40000); ++i)
  {
    Random random(static_cast<std::uint64_t>(i));
    const int count = random.integer(1, 14);
    const Cloud cloud = smallIntegerSites(count, 0, 4, -2, 3, random);
    const ReferenceTriangulation reference = bruteForceTriangulation(cloud);
    const FacetMode facets = random.integer(0, 1) ? FacetMode::Polygons : FacetMode::Triangles;
    const Triangulation right = makeTriangulation(reference, count, facets);
    Triangulation other = clone(right);
    for (int changes = random.integer(1, 3); changes > 0; --changes)
    {
      const auto any = [&](Buffer<std::int64_t>& values) -> std::int64_t&
      {
        static std::int64_t none;
        return values.empty() ? none
                              : values[random.integer(0, static_cast<int>(values.size()) - 1)];
      };
      const int value = random.integer(-1, count);
      switch (random.integer(0, 6))
      {
        case 0:
          std::swap(any(other.connectivity), any(other.connectivity));
          break;
        case 1:
          any(other.connectivity) = value;
          break;
        case 2:
          any(other.pointIds) = value;
          break;
        case 3:
          any(other.hiddenIds) = value;
          break;
        case 4:
          std::swap(any(other.pointIds), any(other.hiddenIds));
          break;
        case 5:
          any(other.offsets) += random.integer(-1, 1);
          break;
        default:
          other.dimension = random.integer(-1, 2);
          break;
      }
    }
    const Validation valid = validate(viewOf(cloud), weightsOf(cloud), other, 1);
    ASSERT_EQ(valid.fault == Fault::None, bitDifference(right, other).empty())
      << "case " << i << ": " << describe(valid.fault) << "\n"
      << toString(cloud);
    seen.insert(valid.fault);
  }
  EXPECT_GE(seen.size(), 5u);
}

TEST(ValidateTriangulation, RandomTriangulations)
{
  // The right answer for other weights, called the answer for these.
  for (int i = 0; i < effort(40000); ++i)
  {
    Random random(static_cast<std::uint64_t>(i));
    const int count = random.integer(2, 10);
    const Cloud cloud = smallIntegerSites(count, 0, 3, -1, 1, random);
    Cloud other = cloud;
    for (int changes = random.integer(1, 3); changes > 0; --changes)
    {
      other[random.integer(0, count - 1)][random.integer(0, 5) == 0 ? 0 : 2] +=
        random.integer(-2, 2);
    }
    const FacetMode facets = random.integer(0, 1) ? FacetMode::Polygons : FacetMode::Triangles;
    const Triangulation right = makeTriangulation(bruteForceTriangulation(cloud), count, facets);
    const Triangulation wrong = makeTriangulation(bruteForceTriangulation(other), count, facets);
    const Validation valid = validate(viewOf(cloud), weightsOf(cloud), wrong, 1);
    ASSERT_EQ(valid.fault == Fault::None, bitDifference(right, wrong).empty())
      << "case " << i << ": " << describe(valid.fault) << "\n"
      << toString(cloud) << "with the answer for\n"
      << toString(other);
  }
}

}
}
}
