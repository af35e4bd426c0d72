// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The plane that fits points best: it is that plane, its frame is as promised, and the way into it
/// and back leads home.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <flipflop/PlaneFit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector normalOf(const FittedPlane& plane)
{
  const Vector& a = plane.first;
  const Vector& b = plane.second;
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// Points of a plane with some noise, far from the origin if asked for.
Cloud tilted(const Vector& normal, const Vector& center, double noise)
{
  Cloud cloud = fromFamily("gaussian", 800, 5).make();
  Vector unit = normal;
  for (double& n : unit)
  {
    n /= std::sqrt(dot(normal, normal));
  }
  for (Point& p : cloud)
  {
    const Vector place{ p[0], p[1], p[2] };
    const double height = dot(place, unit) * (1.0 - noise);
    for (std::size_t k = 0; k < 3; ++k)
    {
      p[k] = center[k] + place[k] - height * unit[k];
    }
  }
  return cloud;
}

void expectFrame(const FittedPlane& plane)
{
  const double few = 1e-15;
  EXPECT_NEAR(dot(plane.first, plane.first), 1.0, few);
  EXPECT_NEAR(dot(plane.second, plane.second), 1.0, few);
  EXPECT_NEAR(dot(plane.first, plane.second), 0.0, few);
  const Vector normal = normalOf(plane);
  std::size_t main = 2;
  for (std::size_t k : { std::size_t(1), std::size_t(0) })
  {
    main = std::fabs(normal[k]) > std::fabs(normal[main]) + few ? k : main;
  }
  EXPECT_GT(normal[main], 0.0);
  // The next coordinate axis, as seen in the plane.
  EXPECT_GT(plane.first[(main + 1) % 3], 0.0);
  EXPECT_NEAR(plane.second[(main + 1) % 3], 0.0, few);
}

TEST(PlaneFit, IsThePlaneOfPointsNearIt)
{
  for (const Vector& normal : { Vector{ 1, 2, 3 }, Vector{ -5, 1, 1 }, Vector{ 0.1, -7, 2 },
         Vector{ 1, 1, 1 }, Vector{ 0, 1, 0 } })
  {
    for (const double far : { 0.0, 1e6 })
    {
      const Cloud cloud = tilted(normal, { far, -far, 2 * far }, 1e-9);
      const FittedPlane plane = fitPlane(viewOf(cloud));
      expectFrame(plane);
      EXPECT_NEAR(std::fabs(dot(normalOf(plane), normal)), std::sqrt(dot(normal, normal)), 1e-7);
    }
  }
}

TEST(PlaneFit, OfACoordinatePlaneIsExact)
{
  // A grid of 5 by 7, at a height; on each of the three coordinate planes.
  for (std::size_t flat = 0; flat < 3; ++flat)
  {
    Cloud cloud;
    for (int i = 0; i < 35; ++i)
    {
      Point p{ 0, 0, 0 };
      p[flat] = 2.5;
      p[(flat + 1) % 3] = i % 5;
      p[(flat + 2) % 3] = i / 5;
      cloud.push_back(p);
    }
    const FittedPlane plane = fitPlane(viewOf(cloud));
    Vector first{};
    Vector second{};
    first[(flat + 1) % 3] = 1.0;
    second[(flat + 2) % 3] = 1.0;
    EXPECT_EQ(plane.first, first);
    EXPECT_EQ(plane.second, second);
    const Buffer<double> places = positionsInPlane(viewOf(cloud), plane);
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      EXPECT_EQ(places[2 * i], static_cast<double>(i % 5));
      EXPECT_EQ(places[2 * i + 1], static_cast<double>(i / 5));
      EXPECT_EQ(positionOf(plane, places[2 * i], places[2 * i + 1]),
        (Vector{ cloud[i][0], cloud[i][1], cloud[i][2] }));
    }
  }
}

TEST(PlaneFit, OfEqualComponentsTheLastIsPositive)
{
  for (std::size_t other = 0; other < 3; ++other)
  {
    // A grid on the plane where two coordinates are equal.
    const std::size_t last = other == 2 ? 1 : 2;
    const std::size_t first = 3 - last - other;
    Cloud cloud(35);
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      cloud[i][first] = cloud[i][last] = static_cast<double>(i % 5);
      cloud[i][other] = static_cast<double>(i / 5);
    }
    const Vector normal = normalOf(fitPlane(viewOf(cloud)));
    EXPECT_GT(normal[last], 0.5) << "beside axis " << other;
    EXPECT_LT(normal[first], -0.5);
  }
}

TEST(PlaneFit, NoOtherPlaneIsCloser)
{
  const Cloud cloud = fromFamily("gaussian", 500, 9).make();
  const FittedPlane plane = fitPlane(viewOf(cloud));
  Vector mean{};
  for (const Point& p : cloud)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      mean[k] += p[k] / static_cast<double>(cloud.size());
    }
  }
  const auto spreadAlong = [&](const Vector& n)
  {
    double sum = 0.0;
    for (const Point& p : cloud)
    {
      const double height = dot({ p[0] - mean[0], p[1] - mean[1], p[2] - mean[2] }, n);
      sum += height * height;
    }
    return sum / dot(n, n);
  };
  const Vector normal = normalOf(plane);
  const double least = spreadAlong(normal);
  for (int i = 0; i < 1000; ++i)
  {
    Vector other = normal;
    for (std::size_t k = 0; k < 3; ++k)
    {
      other[k] += 0.5 * std::sin(i * (1.0 + static_cast<double>(k)) + static_cast<double>(k));
    }
    EXPECT_GE(spreadAlong(other), least * (1.0 - 1e-12));
  }
}

TEST(PlaneFit, OfPointsThatSpanLess)
{
  for (const Cloud& cloud : { Cloud{}, Cloud{ { 1, 2, 3 } }, Cloud{ { 1, 2, 3 }, { 1, 2, 3 } },
         Cloud{ { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 } }, Cloud{ { 4, 0, 0 }, { -1, 0, 0 } } })
  {
    const FittedPlane plane = fitPlane(viewOf(cloud));
    expectFrame(plane);
    const Buffer<double> places = positionsInPlane(viewOf(cloud), plane);
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      const Vector position = positionOf(plane, places[2 * i], places[2 * i + 1]);
      for (std::size_t k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(position[k], cloud[i][k], 1e-14);
      }
    }
  }
}

TEST(PlaneFit, IsOfAnyScaleAndLeavesOutWhatIsNotFinite)
{
  Cloud cloud = tilted({ 1, 2, 3 }, { 0, 0, 0 }, 0.0);
  const FittedPlane expected = fitPlane(viewOf(cloud));
  for (const double s : { 0x1p-900, 0x1p900 })
  {
    const FittedPlane plane = fitPlane(viewOf(scaled(cloud, s, s, s)));
    EXPECT_EQ(plane.first, expected.first);
    EXPECT_EQ(plane.second, expected.second);
  }
  cloud.insert(cloud.begin(), { 1, std::numeric_limits<double>::quiet_NaN(), 3 });
  cloud.push_back({ HUGE_VAL, 0, 0 });
  const FittedPlane plane = fitPlane(viewOf(cloud));
  EXPECT_EQ(plane.start, expected.start);
  EXPECT_EQ(plane.origin, expected.origin);
  EXPECT_EQ(plane.first, expected.first);
  const Buffer<double> places = positionsInPlane(viewOf(cloud), plane);
  EXPECT_TRUE(std::isnan(places[0]) && std::isnan(places[1]));
  EXPECT_EQ(places[2], 0.0);
  EXPECT_TRUE(std::isnan(places[places.size() - 1]));
}

TEST(PlaneFit, IsTheSameOfPointsInParts)
{
  Cloud cloud = tilted({ 1, 2, 3 }, { 10, 20, 0.1 }, 1e-3);
  cloud.insert(cloud.begin(), 3, { 1, std::numeric_limits<double>::quiet_NaN(), 3 });
  const PointView whole = viewOf(cloud);
  const FittedPlane expected = fitPlane(whole);
  for (const std::int64_t length : { 1, 2, 100, 1000 })
  {
    std::vector<PointView> parts{ PointView() };
    for (std::int64_t begin = 0; begin < whole.count; begin += length)
    {
      parts.emplace_back(static_cast<const double*>(whole.data) + begin * whole.stride,
        std::min(length, whole.count - begin), whole.stride);
    }
    PlaneSums sums;
    for (const PointView& part : parts)
    {
      PlaneSums own;
      addExtent(own, part);
      joinExtent(sums, own);
    }
    for (const PointView& part : parts)
    {
      addToSum(sums, part);
    }
    for (const PointView& part : parts)
    {
      addToSpread(sums, part);
    }
    const FittedPlane plane = planeOf(sums);
    EXPECT_EQ(plane.start, expected.start);
    EXPECT_EQ(plane.origin, expected.origin);
    EXPECT_EQ(plane.first, expected.first);
    EXPECT_EQ(plane.second, expected.second);
  }
}

TEST(PlaneFit, InTheXYPlane)
{
  constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> cloud{ 0, 1, 5, 2, 3, -0.0, 4, NaN, 0.0 };
  const PointView points(cloud.data(), 3);
  EXPECT_TRUE(positionsInXY(points).empty());
  for (const double height : { NaN, HUGE_VAL })
  {
    cloud[2] = height;
    const Buffer<double> places = positionsInXY(points);
    ASSERT_EQ(places.size(), 6u);
    EXPECT_TRUE(std::isnan(places[0]));
    EXPECT_TRUE(std::equal(
      places.begin() + 1, places.begin() + 5, std::vector<double>{ 1, 2, 3, 4 }.begin()));
    EXPECT_TRUE(std::isnan(places[5]));
  }

  Triangulation triangulation;
  EXPECT_EQ(heightBelow(points, triangulation), 0.0);
  triangulation.pointIds.allocate(1);
  triangulation.hiddenIds.allocate(1);
  triangulation.pointIds[0] = 2;
  triangulation.hiddenIds[0] = 1;
  EXPECT_FALSE(std::signbit(heightBelow(points, triangulation)));
  std::swap(triangulation.pointIds[0], triangulation.hiddenIds[0]);
  EXPECT_FALSE(std::signbit(heightBelow(points, triangulation)));
  std::swap(triangulation.pointIds[0], triangulation.hiddenIds[0]);
  const std::vector<float> narrow{ 0, 0, 0, 0, 0, -3, 0, 0, 2 };
  EXPECT_EQ(heightBelow({ narrow.data(), 3 }, triangulation), -3.0);
}

}

}
}
