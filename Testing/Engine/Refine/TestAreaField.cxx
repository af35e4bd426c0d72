// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Areas that change with the position: no triangle is larger than the field lets it be at its
/// centroid. And values of the input at new points: linear functions are reproduced.
#include "Testing/Engine/Calls/Bits.h"

#include <flipflop/RefinedMesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

using Field = std::function<double(double x, double y)>;

/// An L of six corners, with a point inside.
const std::vector<double> corners = { 0, 0, 4, 0, 4, 2, 2, 2, 2, 4, 0, 4, 1, 1 };
const std::vector<std::int64_t> ends = { 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 0 };

RefinedMesh meshOf(const RefinementOptions& refinement, int threads = 1)
{
  Options options;
  options.threads = threads;
  return refinedMesh(
    PointView(corners.data(), 7, 2), ConstraintView(ends.data(), 6, 6), refinement, options);
}

/// The field at the points.
std::vector<double> atPoints(const Field& field)
{
  std::vector<double> values;
  for (std::size_t i = 0; i < corners.size(); i += 2)
  {
    values.push_back(field(corners[i], corners[i + 1]));
  }
  return values;
}

RefinementOptions refinementBy(const Field& field)
{
  RefinementOptions refinement;
  refinement.areaAt = [field](const double* positions, std::int64_t count, double* areas)
  {
    for (std::int64_t i = 0; i < count; ++i)
    {
      areas[i] = field(positions[2 * i], positions[2 * i + 1]);
    }
  };
  return refinement;
}

/// The greatest area of a triangle, in parts of what the field allows at its centroid.
double greatestShare(const RefinedMesh& mesh, const Field& field)
{
  double greatest = 0;
  for (std::size_t cell = 0; cell < mesh.region.size(); ++cell)
  {
    const double* x[3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto at = static_cast<std::size_t>(mesh.connectivity[3 * cell + i]);
      x[i] = &mesh.points[2 * static_cast<std::size_t>(mesh.pointIds[at])];
    }
    const double area =
      0.5 * ((x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0]));
    const double most = field((x[0][0] + x[1][0] + x[2][0]) / 3, (x[0][1] + x[1][1] + x[2][1]) / 3);
    greatest = mesh.region[cell] < 0 ? greatest : std::max(greatest, area / most);
  }
  return greatest;
}

constexpr double rounded = 1 + 1e-9;

double linearArea(double x, double y)
{
  return 0.002 + 0.01 * x + 0.005 * y;
}

std::string refusal(const RefinementOptions& refinement)
{
  try
  {
    meshOf(refinement);
  }
  catch (const Error& error)
  {
    return error.what() + std::string(" ") + std::to_string(error.index());
  }
  return "none";
}

}

TEST(AreaField, OfAFunction)
{
  const Field field = [](double x, double y) { return 1e-4 + 0.02 * std::hypot(x - 2, y - 2); };
  const RefinedMesh mesh = meshOf(refinementBy(field));
  EXPECT_TRUE(mesh.isComplete);
  EXPECT_EQ(mesh.keptTriangles, 0);
  EXPECT_LE(greatestShare(mesh, field), rounded);
  EXPECT_GT(greatestShare(mesh, field), 0.8);
  EXPECT_GT(mesh.cellCount(), 500);
  for (const int threads : { 2, 4 })
  {
    EXPECT_EQ(bitsOf(meshOf(refinementBy(field), threads)), bitsOf(mesh)) << threads;
  }
}

TEST(AreaField, OfPointsAndOfPixels)
{
  const std::vector<double> values = atPoints(linearArea);
  RefinementOptions ofPoints;
  ofPoints.areaOfPoint = values.data();
  EXPECT_LE(greatestShare(meshOf(ofPoints), linearArea), rounded);
  EXPECT_GT(greatestShare(meshOf(ofPoints), linearArea), 0.8);

  // Rows from the top on, half a pixel short of the border: there it is that of the nearest pixel.
  std::vector<double> pixels;
  RefinementOptions ofPixels;
  ofPixels.areaGrid.size[0] = 8;
  ofPixels.areaGrid.size[1] = 4;
  ofPixels.areaGrid.origin[0] = 0.25;
  ofPixels.areaGrid.origin[1] = 3.5;
  ofPixels.areaGrid.spacing[0] = 0.5;
  ofPixels.areaGrid.spacing[1] = -1;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 8; ++column)
    {
      pixels.push_back(linearArea(0.25 + 0.5 * column, 3.5 - row));
    }
  }
  ofPixels.areaOfPixel = pixels.data();
  const auto clamped = [](double x, double y)
  { return linearArea(std::clamp(x, 0.25, 3.75), std::clamp(y, 0.5, 3.5)); };
  EXPECT_LE(greatestShare(meshOf(ofPixels), clamped), rounded);
  EXPECT_GT(greatestShare(meshOf(ofPixels), clamped), 0.8);

  // The least of all.
  RefinementOptions all = refinementBy([](double x, double) { return x < 1 ? 1e-3 : 1.0; });
  all.areaOfPoint = values.data();
  all.maxArea = 0.02;
  const auto least = [](double x, double y) {
    return std::min({ x < 1 ? 1e-3 : 1.0, linearArea(x, y), 0.02 });
  };
  EXPECT_LE(greatestShare(meshOf(all), least), rounded);
}

TEST(AreaField, MayBeInfinite)
{
  const Field field = [](double x, double) { return x < 1 ? 1e-3 : HUGE_VAL; };
  const RefinedMesh mesh = meshOf(refinementBy(field));
  EXPECT_LE(greatestShare(mesh, field), rounded);
  EXPECT_EQ(bitsOf(meshOf(refinementBy([](double, double) { return HUGE_VAL; }))),
    bitsOf(meshOf(RefinementOptions())));
}

TEST(AreaField, MayShrinkWithoutEnd)
{
  const RefinedMesh mesh = meshOf(refinementBy(
    [](double x, double y) { return std::max(1e-300, 0.01 * ((x - 1) * (x - 1) + y * y)); }));
  EXPECT_TRUE(mesh.isComplete);
  EXPECT_LT(mesh.newPoints, 200000);
  RefinementOptions tiny = refinementBy([](double, double) { return 1e-300; });
  tiny.maxPoints = 1000;
  EXPECT_FALSE(meshOf(tiny).isComplete);
}

TEST(AreaField, RefusesWhatIsNoArea)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : { 0.0, -1.0, nan })
  {
    EXPECT_EQ(refusal(refinementBy([wrong](double, double) { return wrong; })),
      "areas that a function gives must be above 0, or infinite 0");
    std::vector<double> values(7, 1.0);
    values[3] = wrong;
    RefinementOptions refinement;
    refinement.areaOfPoint = values.data();
    EXPECT_EQ(refusal(refinement), "areas of points must be above 0, or infinite (any) 3");
    refinement.areaOfPoint = nullptr;
    refinement.areaOfPixel = values.data();
    refinement.areaGrid.size[0] = 7;
    EXPECT_EQ(refusal(refinement), "an image of areas must have pixels, at finite positions -1");
    refinement.areaGrid.size[1] = 1;
    EXPECT_EQ(refusal(refinement), "areas of pixels must be above 0, or infinite (any) 3");
  }
  RefinementOptions thrown;
  thrown.areaAt = [](const double*, std::int64_t, double*) { throw std::out_of_range("mine"); };
  EXPECT_THROW(meshOf(thrown), std::out_of_range);
}

TEST(InputShares, ReproduceLinearFunctions)
{
  const std::vector<double> values = atPoints(linearArea);
  RefinementOptions refinement;
  refinement.maxArea = 0.01;
  EXPECT_TRUE(meshOf(refinement).shares.offsets.empty());
  refinement.findsShares = true;
  const RefinedMesh mesh = meshOf(refinement);
  const SiteShares& shares = mesh.shares;
  ASSERT_EQ(shares.offsets.size(), static_cast<std::size_t>(mesh.newPoints + 1));
  for (std::size_t i = 0; i + 1 < shares.offsets.size(); ++i)
  {
    double found = 0;
    const auto begin = static_cast<std::size_t>(shares.offsets[i]);
    const auto end = static_cast<std::size_t>(shares.offsets[i + 1]);
    for (std::size_t k = begin; k < end; ++k)
    {
      EXPECT_GE(shares.shares[k], 0);
      EXPECT_TRUE(k == begin || shares.ids[k - 1] < shares.ids[k]);
      found += shares.shares[k] * values[static_cast<std::size_t>(shares.ids[k])];
    }
    EXPECT_LE(end - begin, mesh.constraintOfPoint[i] >= 0 ? 2u : 3u);
    EXPECT_NEAR(found, linearArea(mesh.points[14 + 2 * i], mesh.points[15 + 2 * i]), 1e-15);
  }
}

}
}
