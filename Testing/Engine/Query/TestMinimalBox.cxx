// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Boxes are the known ones where the least is known, and no rotation that is tried gives a smaller
/// one. That a box holds the hull is in TestHullResults.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Query/HullReference.h"

#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

/// After a check of all that boxes promise.
OrientedBox boxOf(const Cloud& cloud, PointSpace space = PointSpace::Space)
{
  const HullReference reference(cloud, space);
  OrientedBox box =
    HullQueries(viewOf(cloud), hullOf(cloud, FacetMode::Triangles), Options(), space).minimalBox();
  EXPECT_EQ(reference.boxFault(box), "") << toString(cloud);
  return box;
}

const Cloud octahedron = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
  { 0, 0, -1 } };
/// In a cube of side 1, and nothing smaller: it has a third of the cube's volume.
const Cloud tetrahedron = { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 } };

TEST(MinimalBox, IsTheKnownOne)
{
  struct Known
  {
    const char* name;
    Cloud cloud;
    double area;   ///< of the two longer sides; 0: unknown
    double volume; ///< no less than that of any box
  };
  const Known known[] = { { "tetrahedron", tetrahedron, 1, 1 },
    { "octahedron", octahedron, 16.0 / 9, 64.0 / 27 },
    { "right triangle", { { 0, 0, 1 }, { 3, 0, 1 }, { 0, 4, 1 } }, 12, 0 },
    { "rectangle", scaled(integerGrid(2), 2, 3, 0), 6, 0 } };
  for (const Known& one : known)
  {
    for (const Cloud& cloud : { one.cloud, rotated(one.cloud) })
    {
      const OrientedBox box = boxOf(cloud);
      EXPECT_NEAR(box.volume, one.volume, 1e-9) << one.name;
      EXPECT_NEAR(box.lengths[0] * box.lengths[1], one.area, 1e-9) << one.name;
    }
  }
  EXPECT_NEAR(boxOf(rotated(tetrahedron)).lowerBound, 1, 1e-12);
  EXPECT_EQ(boxOf(scaled(integerGrid(2), 3, 2, 0), PointSpace::Plane).volume, 6);
}

/// As shares of the longest side, the sides' product is no double.
TEST(MinimalBox, OfAVeryThinCuboid)
{
  for (const double longest : { 0x1p600, 0x1p1000 })
  {
    const OrientedBox box = boxOf(scaled(integerGrid(2), longest, 3, 0.5));
    EXPECT_EQ(box.volume, 1.5 * longest);
    EXPECT_NEAR(box.lowerBound / longest, 1.5, 1e-9);
  }
}

TEST(MinimalBox, OfACuboidInAnyPosition)
{
  Random random(5);
  for (int attempt = 0; attempt < effort(20); ++attempt)
  {
    const double sides[3] = { random.uniform(0.5, 1), random.uniform(0.1, 0.5),
      random.uniform(0.01, 0.1) };
    const Cloud cuboid = scaled(
      joined(integerGrid(2), scaled(integerGrid(3), 0.5, 0.5, 0.5)), sides[0], sides[1], sides[2]);
    const OrientedBox box = boxOf(moved(rotated(cuboid), random.uniform(-3, 3), 1, 2));
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(box.lengths[i], sides[i], 1e-14);
    }
    EXPECT_NEAR(box.volume, sides[0] * sides[1] * sides[2], 1e-13);
    EXPECT_NEAR(box.lowerBound, box.volume, 1e-12);
  }
}

/// The volume of the box along two directions, the second made upright on the first.
double volumeAlong(const Cloud& cloud, const Point& a, const Point& d)
{
  const double along = a[0] * d[0] + a[1] * d[1] + a[2] * d[2];
  const double length = std::sqrt(1 - along * along);
  Point axes[3] = { a, a, a };
  for (std::size_t k = 0; k < 3; ++k)
  {
    axes[1][k] = (d[k] - along * a[k]) / length;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    axes[2][k] =
      axes[0][(k + 1) % 3] * axes[1][(k + 2) % 3] - axes[0][(k + 2) % 3] * axes[1][(k + 1) % 3];
  }
  double volume = 1;
  for (const Point& axis : axes)
  {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const Point& p : cloud)
    {
      const double x = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
      low = std::min(low, x);
      high = std::max(high, x);
    }
    volume *= high - low;
  }
  return volume;
}

TEST(MinimalBox, NoSampledRotationIsBetter)
{
  Random random(6);
  for (const char* name : { "ball", "gaussian", "smallIntegers" })
  {
    for (int seed = 0; seed < effort(8); ++seed)
    {
      const Cloud cloud = fromFamily(name, 8 + seed, static_cast<std::uint64_t>(seed)).make();
      double best = HUGE_VAL;
      for (int i = 0; i < 20000; ++i)
      {
        best = std::min(best, volumeAlong(cloud, random.direction(), random.direction()));
      }
      EXPECT_LE(boxOf(cloud).volume, best * (1 + 1e-9)) << name << ", seed " << seed;
    }
  }
}

TEST(MinimalBox, OfVeryManyCorners)
{
  boxOf(fromFamily("shell1e1", effort(6000), 3).make());
}

TEST(MinimalBox, InThePlane)
{
  for (const Cloud& cloud :
    { Cloud{ { 5, 7, 0 } }, { { 0, 0, 0 }, { 2, 0, 0 } }, { { 0, 0, 0 }, { 0, 2, 0 } },
      { { 0, 0, 0 }, { -3, -4, 0 } }, scaled(integerGrid(2), 2, 1, 0),
      scaled(integerGrid(2), 1, 2, 0), scaled(integerGrid(2), 1, 1e-300, 0),
      scaled(integerGrid(2), 5e-324, 1e-323, 0), scaled(integerGrid(2), 1.7e308, 1e308, 0) })
  {
    boxOf(cloud, PointSpace::Plane);
  }
}

}
}
}
