// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The box that a power diagram has by default.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <flipflop/PowerDiagram.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

using Box = std::array<double, 4>;

Box boxOf(const Cloud& cloud)
{
  const Triangulation triangulation = regularTriangulation(viewOf(cloud), weightsOf(cloud));
  return powerDiagramBox(viewOf(cloud), triangulation);
}

TEST(PowerDiagramBox, IsThatOfAllPoints)
{
  for (const char* family : { "uniform", "uniformHiding", "oneGiant", "grid", "circle" })
  {
    SCOPED_TRACE(family);
    const Cloud cloud = fromWeightedFamily(family, 500, 3).make();
    Box expected{ HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL };
    for (const Point& p : cloud)
    {
      expected = { std::min(expected[0], p[0]), std::max(expected[1], p[0]),
        std::min(expected[2], p[1]), std::max(expected[3], p[1]) };
    }
    EXPECT_EQ(boxOf(cloud), expected);
    EXPECT_EQ(powerDiagramBox(viewOf(cloud)), expected);
  }
}

TEST(PowerDiagramBox, OfFloats)
{
  const Cloud cloud{ { 0.25, 1, 0 }, { 3, -2, 0 }, { 1, 4.5, 0 } };
  const std::vector<float> floats = floatsOf(cloud);
  PointView view;
  view.type = ScalarType::Float32;
  view.data = floats.data();
  view.count = 3;
  view.stride = 3;
  EXPECT_EQ(
    powerDiagramBox(view, regularTriangulation(view, WeightView())), (Box{ 0.25, 3, -2, 4.5 }));
}

TEST(PowerDiagramBox, HasAnInside)
{
  constexpr double most = std::numeric_limits<double>::max();
  EXPECT_EQ(boxOf({ { 5, 7, 0 } }), (Box{ 4.5, 5.5, 6.5, 7.5 }));
  EXPECT_EQ(boxOf({ { 1, 7, 0 }, { 5, 7, 0 } }), (Box{ 1, 5, 5, 9 }));
  EXPECT_EQ(boxOf({ { 1, 7, 0 }, { 1, 8, 0 } }), (Box{ 0.5, 1.5, 7, 8 }));
  for (const double x : { 1e20, 0x1p900, -most, most })
  {
    const Box box = boxOf({ { x, 0, 0 } });
    EXPECT_LT(box[0], box[1]) << x;
    EXPECT_TRUE(box[0] >= -most && box[1] <= most) << x;
  }
}

TEST(PowerDiagramBox, OfPointsAlone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Cloud cloud{ { 9, nan, 0 }, { 5, 7, 0 }, { -HUGE_VAL, 0, 0 } };
  EXPECT_EQ(powerDiagramBox(viewOf(cloud)), (Box{ 4.5, 5.5, 6.5, 7.5 }));
  EXPECT_EQ(powerDiagramBox(PointView()), (Box{ 0, 1, 0, 1 }));
  EXPECT_EQ(powerDiagramBox(viewOf(Cloud{ { nan, nan, 0 } })), (Box{ 0, 1, 0, 1 }));
}

TEST(PowerDiagramBox, RefusesIdsOutOfRange)
{
  const Cloud cloud{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  Triangulation triangulation = regularTriangulation(viewOf(cloud), weightsOf(cloud));
  for (const std::int64_t id : { -1, 3 })
  {
    triangulation.pointIds[1] = id;
    try
    {
      powerDiagramBox(viewOf(cloud), triangulation);
      ADD_FAILURE() << id;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::BadArgument);
      EXPECT_EQ(error.index(), 1);
    }
  }
  EXPECT_THROW(powerDiagramBox(viewOf(cloud), Triangulation()), Error);
}

}
}
}
