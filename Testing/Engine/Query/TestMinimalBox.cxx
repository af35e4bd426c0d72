// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Boxes hold the hull, are not larger than the one along the axes, and are the known ones where
/// the least is known.
#include "Testing/Engine/Query/QueryCases.h"
#include <flipflop/HullQueries.h>

#include <cstring>

namespace flipflop
{
namespace test
{

namespace
{

OrientedBox boxOf(const Cloud& cloud, int threads = 1)
{
  return HullQueries(viewOf(cloud), hullOf(cloud, FacetMode::Triangles))
    .minimalBox(onThreads(threads));
}

double dot(const double* a, const double* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void expectBox(const std::string& name, const Cloud& cloud)
{
  const Hull hull = hullOf(cloud, FacetMode::Triangles);
  const OrientedBox box = HullQueries(viewOf(cloud), hull).minimalBox();
  double largest = box.lengths[0];
  Point low = cloud[static_cast<std::size_t>(hull.pointIds[0])];
  Point high = low;
  for (const std::int64_t id : hull.pointIds)
  {
    const Point& p = cloud[static_cast<std::size_t>(id)];
    for (std::size_t i = 0; i < 3; ++i)
    {
      largest = std::max(largest, std::fabs(p[i]));
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    // Beside a side of 1e300 there is none of 1e-300.
    EXPECT_EQ(box.lengths[i] > 0, i < hull.dimension && (i < 2 || name != "mixed")) << name;
    EXPECT_LE(box.lengths[i], i > 0 ? box.lengths[i - 1] : largest * 4) << name;
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(dot(box.axes[i], box.axes[k]), i == k ? 1 : 0, 1e-15) << name;
    }
    for (const std::int64_t id : hull.pointIds)
    {
      const Point& p = cloud[static_cast<std::size_t>(id)];
      const double offset[3] = { p[0] - box.center[0], p[1] - box.center[1], p[2] - box.center[2] };
      EXPECT_LE(
        std::fabs(dot(box.axes[i], offset)), 0.5 * box.lengths[i] + 1e-14 * largest + 5e-324)
        << name;
    }
  }
  const double* const a = box.axes[0];
  const double* const b = box.axes[1];
  const double* const c = box.axes[2];
  EXPECT_GT((a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1] +
      (a[0] * b[1] - a[1] * b[0]) * c[2],
    0.9)
    << name;
  EXPECT_LE(box.lowerBound, box.volume) << name;
  if (hull.dimension == 3)
  {
    const double straight = (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
    EXPECT_LE(box.volume, straight * (1 + 1e-14)) << name;
    EXPECT_TRUE(box.lowerBound >= hull.volume * (1 - 1e-9) - 1e-10 * straight || name == "mixed" ||
      name == "huge")
      << name;
  }
  else
  {
    EXPECT_EQ(box.volume, 0) << name;
    EXPECT_EQ(box.lowerBound, 0) << name;
  }
}

TEST(MinimalBox, HoldsTheHull)
{
  for (const auto& [name, cloud] : queryClouds())
  {
    if (name != "largest") // the offsets overflow here, in the test
    {
      expectBox(name, cloud);
    }
  }
  expectBox("many", fromFamily("shell1e1", effort(6000), 3).make());
}

TEST(MinimalBox, OfACuboidInAnyPosition)
{
  Random random(5);
  for (int attempt = 0; attempt < effort(20); ++attempt)
  {
    const double sides[3] = { random.uniform(0.5, 1), random.uniform(0.1, 0.5),
      random.uniform(0.01, 0.1) };
    const Cloud cloud =
      moved(rotated(scaled(joined(integerGrid(2), scaled(integerGrid(3), 0.5, 0.5, 0.5)), sides[0],
              sides[1], sides[2])),
        random.uniform(-3, 3), 1, 2);
    const OrientedBox box = boxOf(cloud);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(box.lengths[i], sides[i], 1e-14);
    }
    EXPECT_NEAR(box.volume, sides[0] * sides[1] * sides[2], 1e-13);
    EXPECT_NEAR(box.lowerBound, box.volume, 1e-12);
  }
}

TEST(MinimalBox, OfARegularTetrahedron)
{
  // In a cube of side 1, and nothing smaller: it has a third of the cube's volume.
  const Cloud cloud = { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 } };
  for (const Cloud& some : { cloud, rotated(cloud) })
  {
    const OrientedBox box = boxOf(some);
    EXPECT_NEAR(box.volume, 1, 1e-9);
    EXPECT_NEAR(box.lowerBound, 1, 1e-12);
  }
}

TEST(MinimalBox, OfARegularOctahedron)
{
  const Cloud cloud = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  EXPECT_LE(boxOf(cloud).volume, 4 * (1 + 1e-12)); // sqrt(2) by sqrt(2) by 2
  EXPECT_LE(boxOf(rotated(cloud)).volume, 4 * (1 + 1e-9));
}

TEST(MinimalBox, NoSampledRotationIsBetter)
{
  Random random(6);
  for (const char* name : { "ball", "gaussian", "smallIntegers" })
  {
    for (int seed = 0; seed < effort(8); ++seed)
    {
      const Cloud cloud = fromFamily(name, 8 + seed, static_cast<std::uint64_t>(seed)).make();
      const OrientedBox box = boxOf(cloud);
      double best = std::numeric_limits<double>::infinity();
      for (int i = 0; i < 20000; ++i)
      {
        const Point a = random.direction();
        const Point d = random.direction();
        const double along = dot(a.data(), d.data());
        double axes[3][3];
        double length = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
          axes[0][k] = a[k];
          axes[1][k] = d[k] - along * a[k];
          length += axes[1][k] * axes[1][k];
        }
        for (std::size_t k = 0; k < 3; ++k)
        {
          axes[1][k] /= std::sqrt(length);
        }
        double volume = 1;
        for (std::size_t k = 0; k < 3; ++k)
        {
          axes[2][k] = axes[0][(k + 1) % 3] * axes[1][(k + 2) % 3] -
            axes[0][(k + 2) % 3] * axes[1][(k + 1) % 3];
        }
        for (const double* axis : axes)
        {
          double low = std::numeric_limits<double>::infinity();
          double high = -low;
          for (const Point& p : cloud)
          {
            low = std::min(low, dot(axis, p.data()));
            high = std::max(high, dot(axis, p.data()));
          }
          volume *= high - low;
        }
        best = std::min(best, volume);
      }
      EXPECT_LE(box.volume, best * (1 + 1e-9)) << name << ", seed " << seed;
    }
  }
}

TEST(MinimalBox, OfAPolygon)
{
  // A right triangle: along its longest side, or along the two others, the area is the same.
  const Cloud triangle = { { 0, 0, 1 }, { 3, 0, 1 }, { 0, 4, 1 } };
  const OrientedBox box = boxOf(triangle);
  EXPECT_NEAR(box.lengths[0] * box.lengths[1], 12, 1e-12);
  EXPECT_EQ(box.lengths[2], 0);
  EXPECT_EQ(std::fabs(box.axes[2][2]), 1);
  const OrientedBox turned = boxOf(rotated(scaled(integerGrid(2), 2, 3, 0)));
  EXPECT_NEAR(turned.lengths[0], 3, 1e-14);
  EXPECT_NEAR(turned.lengths[1], 2, 1e-14);
}

/// Right-handed within the plane, the longest side first.
TEST(MinimalBox, InThePlane)
{
  const std::vector<Cloud> clouds = { { { 5, 7, 0 } }, { { 0, 0, 0 }, { 2, 0, 0 } },
    { { 0, 0, 0 }, { 0, 2, 0 } }, { { 0, 0, 0 }, { -3, -4, 0 } }, scaled(integerGrid(2), 2, 1, 0),
    scaled(integerGrid(2), 1, 2, 0), scaled(integerGrid(2), 1, 1e-300, 0),
    scaled(integerGrid(2), 5e-324, 1e-323, 0), scaled(integerGrid(2), 1.7e308, 1e308, 0),
    { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 }, { 1, 1, 0 } } };
  for (const Cloud& cloud : clouds)
  {
    const HullQueries plane(
      viewOf(cloud), hullOf(cloud, FacetMode::Triangles), Options(), PointSpace::Plane);
    const OrientedBox box = plane.minimalBox();
    const double* const a = box.axes[0];
    const double* const b = box.axes[1];
    EXPECT_NEAR(a[0] * b[1] - a[1] * b[0], 1, 1e-15) << toString(cloud);
    EXPECT_NEAR(dot(a, a), 1, 1e-15);
    EXPECT_NEAR(dot(a, b), 0, 1e-15);
    EXPECT_EQ(std::fabs(a[2]) + std::fabs(b[2]) + std::fabs(box.axes[2][2] - 1), 0);
    EXPECT_GE(box.lengths[0], box.lengths[1]);
    EXPECT_EQ(box.lengths[2], 0);
    EXPECT_EQ(box.volume, box.lowerBound);
    for (const Point& p : cloud)
    {
      for (int i = 0; i < 2; ++i)
      {
        const double x = 0.5 * p[0] - 0.5 * box.center[0];
        const double y = 0.5 * p[1] - 0.5 * box.center[1];
        EXPECT_LE(std::fabs(box.axes[i][0] * x + box.axes[i][1] * y),
          0.25 * box.lengths[i] + 1e-14 * box.lengths[0] + 5e-324)
          << toString(cloud);
      }
    }
  }
  const Cloud rectangle = scaled(integerGrid(2), 3, 2, 0);
  EXPECT_EQ(HullQueries(viewOf(rectangle), hullOf(rectangle, FacetMode::Triangles), Options(),
              PointSpace::Plane)
              .minimalBox()
              .volume,
    6);
}

TEST(MinimalBox, AtAnyMagnitude)
{
  for (const auto& [name, cloud] : extremeClouds())
  {
    const Hull hull = hullOf(cloud, FacetMode::Triangles);
    const OrientedBox box = HullQueries(viewOf(cloud), hull).minimalBox();
    EXPECT_EQ(box.lengths[0] > 0, hull.dimension > 0) << name;
    EXPECT_LE(box.lowerBound, box.volume) << name;
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(dot(box.axes[i], box.axes[k]), i == k ? 1 : 0, 1e-15) << name;
      }
    }
    // In quarters, which do not overflow.
    const double largest = std::max(0.25 * box.lengths[0], 0x1p-1000);
    for (const std::int64_t id : hull.pointIds)
    {
      const Point& p = cloud[static_cast<std::size_t>(id)];
      double offset[3];
      double size = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        offset[k] = 0.25 * p[k] - 0.25 * box.center[k];
        size = std::max(size, std::fabs(0.25 * p[k]));
      }
      for (int i = 0; i < 3 && std::isfinite(box.lengths[i]); ++i)
      {
        EXPECT_LE(std::fabs(dot(box.axes[i], offset)),
          0.125 * box.lengths[i] + 1e-14 * std::max(size, std::min(largest, 1e308)) + 5e-324)
          << name;
      }
    }
  }
}

TEST(MinimalBox, OfNothing)
{
  const OrientedBox box = HullQueries(PointView(), Hull()).minimalBox();
  EXPECT_EQ(box.volume, 0);
  EXPECT_EQ(box.lengths[0], 0);
}

}
}
}
