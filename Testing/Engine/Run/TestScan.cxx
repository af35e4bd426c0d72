// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What a look at the input tells: the lattice that all points are on.
#include "Run/Scan.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <cmath>
#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

double unitOf(const Cloud& cloud, double least, double most, bool checkFinite = false)
{
  const Options options;
  Monitor monitor(options);
  return commonUnit(PointSource(viewOf(cloud)), least, most, checkFinite, monitor);
}

TEST(CommonUnit, IsTheLargestOfWhichAllAreMultiples)
{
  const Cloud quarters = { { 1, -2, 3 }, { 0.5, 8, 0 }, { -0.75, 16, 1024 } };
  EXPECT_EQ(unitOf(quarters, 0x1p-10, 4), 0.25);
  EXPECT_EQ(unitOf(quarters, 0x1p-10, 0.125), 0.125) << "no more than asked for";
  EXPECT_EQ(unitOf(quarters, 0.5, 4), 0) << "less than asked for";
  EXPECT_EQ(unitOf({ { 0.1, 0, 0 } }, 0x1p-10, 1), 0);
  EXPECT_EQ(unitOf({ { 0, 0, 0 } }, 1, 4), 4);
}

TEST(CommonUnit, SeesFractionsOfLargeCoordinates)
{
  // Doubles have halves up to 2^52, and quarters up to 2^51.
  int halves = 0;
  int quarters = 0;
  for (int exponent = 40; exponent <= 60; ++exponent)
  {
    for (const double offset : { 0.0, 0.25, 0.5, 1.25, -0.25, -0.5, -1.5 })
    {
      for (const double sign : { 1.0, -1.0 })
      {
        const double x = sign * (std::ldexp(1, exponent) + offset);
        const double expected =
          std::fmod(x, 1) == 0 ? 1 : (std::fmod(x, 0.5) == 0 ? 0.5 : 0.25); // fmod is exact
        halves += expected == 0.5 && exponent >= 51 ? 1 : 0;
        quarters += expected == 0.25 && exponent >= 50 ? 1 : 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          SCOPED_TRACE("2^" + std::to_string(exponent) + " + " + std::to_string(offset));
          Cloud cloud(3, Point{ 0, 0, 0 });
          cloud[1][axis] = x;
          EXPECT_EQ(unitOf(cloud, 0.25, 1), expected);
        }
      }
    }
  }
  EXPECT_GT(halves, 5);
  EXPECT_GT(quarters, 5);
}

TEST(CommonUnit, SkipsWhatIsNotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(unitOf({ { 1, 2, 3 }, { nan, 0.1, 0 }, { 0.5, 0, 0 } }, 0.25, 1, true), 0.5);
}

TEST(CommonUnit, OfWeightsIsItsSquare)
{
  const Options options;
  Monitor monitor(options);
  const auto unit = [&](double weight)
  {
    const Cloud cloud = { { 1, 0, weight }, { 2, 1, 0 } };
    return commonUnit(PointSource(viewOf(cloud), weightsOf(cloud)), 0x1p-4, 1, false, monitor);
  };
  EXPECT_EQ(unit(3), 1);
  EXPECT_EQ(unit(0.25), 0.5);
  EXPECT_EQ(unit(0.125), 0.25);
  EXPECT_EQ(unit(0.1), 0);
}

}
}
}
