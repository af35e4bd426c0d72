// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constraints as maps have them, beside CGAL and the validator: a coast with lakes, islands in
/// them and ponds on these; the contours of a mountain; streets that cross and are split.
#include "Testing/Engine/Constraints/ConstrainedCases.h"
#include "Testing/Engine/Inputs/InputsConstrained.h"

#include <flipflop/ConstraintCrossings.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

ConstraintView constraintsOf(const ConstrainedInput& map)
{
  ConstraintView view = viewOf(map.segments);
  view.sides = map.sides;
  return view;
}

/// The triangulation, which is CGAL's, and right.
ConstrainedTriangulation expectRight(const ConstrainedInput& map, FacetMode facets)
{
  Options options;
  options.facets = facets;
  ConstrainedTriangulation result =
    constrainedTriangulation(viewOf(map.cloud), constraintsOf(map), options);
  EXPECT_TRUE(validate(viewOf(map.cloud), constraintsOf(map), result));
  const ReferenceConstrained wanted = cgalConstrained(map.cloud, map.segments);
  EXPECT_EQ(
    difference(result, wanted.triangulation, facets, static_cast<std::int64_t>(map.cloud.size())),
    "");
  std::vector<FixedSegment> fixed = fixedOf(result);
  for (FixedSegment& edge : fixed)
  {
    edge.constraint = -1; // CGAL does not tell
  }
  EXPECT_TRUE(fixed == wanted.fixed);
  return result;
}

double areaOf(const ConstrainedInput& map, const std::int64_t* corners)
{
  const auto at = [&](int i) -> const Point&
  { return map.cloud[static_cast<std::size_t>(corners[i])]; };
  const Point &a = at(0), &b = at(1), &c = at(2);
  return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

/// The area that polygons enclose, where holes count against it.
double enclosed(const ConstrainedInput& map)
{
  double sum = 0;
  for (std::size_t i = map.segments.size() - static_cast<std::size_t>(map.sides);
       i < map.segments.size(); ++i)
  {
    const Point& a = map.cloud[static_cast<std::size_t>(map.segments[i][0])];
    const Point& b = map.cloud[static_cast<std::size_t>(map.segments[i][1])];
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

TEST(ConstrainedMaps, ACoastWithLakesAndIslands)
{
  Random random(11);
  for (const int corners : { 40, 400, 4000 })
  {
    const ConstrainedInput map = coast(corners, random);
    const ConstrainedTriangulation result = expectRight(map, FacetMode::Triangles);
    std::vector<std::uint8_t> inside(static_cast<std::size_t>(result.cellCount()));
    cellsInside(result, inside.data());
    double land = 0;
    for (std::size_t c = 0; c < inside.size(); ++c)
    {
      std::int64_t corner[3];
      for (std::size_t k = 0; k < 3; ++k)
      {
        corner[k] = result.pointIds[static_cast<std::size_t>(result.connectivity[3 * c + k])];
      }
      land += inside[c] ? areaOf(map, corner) : 0;
    }
    EXPECT_NEAR(land, enclosed(map), 1e-9);
    EXPECT_GT(land, 50);
  }
}

TEST(ConstrainedMaps, TheContoursOfAMountain)
{
  const ConstrainedInput map = contours();
  ASSERT_EQ(map.cloud.size(), 35764u);
  EXPECT_EQ(splitCrossings(viewOf(map.cloud), constraintsOf(map)).rounds, 0);
  expectRight(map, FacetMode::Polygons);
}

TEST(ConstrainedMaps, StreetsInPieces)
{
  Random random(12);
  ConstrainedInput map = streets(6000, random);
  const SplitConstraints split = splitCrossings(viewOf(map.cloud), constraintsOf(map));
  EXPECT_GT(split.newPointCount(), 2000);
  for (std::size_t k = 0; k < split.positions.size(); k += 2)
  {
    map.cloud.push_back({ split.positions[k], split.positions[k + 1], 0 });
  }
  map.segments.clear();
  for (std::size_t p = 0; p < split.ends.size(); p += 2)
  {
    map.segments.push_back({ split.ends[p], split.ends[p + 1] });
  }
  expectRight(map, FacetMode::Triangles);
}

}

}
}
