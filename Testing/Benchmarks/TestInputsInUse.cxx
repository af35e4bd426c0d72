// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The families in use: as many points as asked for, all finite, the same for the same seed; and
/// shuffled, the same points in another order. Other properties are tested where a fault would
/// change no result.
#include "Testing/Engine/Inputs/InputMaking.h"
#include "Testing/Engine/Inputs/InputsInUse.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace flipflop
{
namespace test
{
namespace
{

Cloud sorted(Cloud cloud)
{
  std::sort(cloud.begin(), cloud.end());
  return cloud;
}

struct Named
{
  std::string name;
  bool isPlane;
};

std::vector<Named> allNames()
{
  std::vector<Named> all;
  for (const bool isPlane : { false, true })
  {
    for (const std::string& name : namesInUse(isPlane))
    {
      all.push_back({ name, isPlane });
    }
  }
  return all;
}

class InputInUse : public ::testing::TestWithParam<Named>
{
public:
  Cloud make(int count, std::uint64_t seed = 7, const std::string& ending = "") const
  {
    return makeCloud(this->GetParam().name + ending, this->GetParam().isPlane, count, seed);
  }
};

TEST_P(InputInUse, HasAsManyPointsAsAskedForAllFinite)
{
  // Odd numbers, and fewer and more than there are vertices of contours
  for (const int count : { 8, 9, 4321, 50000 })
  {
    const Cloud cloud = this->make(count);
    EXPECT_EQ(cloud.size(), static_cast<std::size_t>(count));
    for (const Point& p : cloud)
    {
      ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
    }
  }
}

TEST_P(InputInUse, HasTheSamePointsForTheSameSeedAndShuffled)
{
  const Cloud plain = this->make(1000);
  const Cloud shuffled = this->make(1000, 7, "-shuffled");
  EXPECT_EQ(this->make(1000), plain);
  EXPECT_EQ(this->make(1000, 7, "-shuffled"), shuffled);
  EXPECT_NE(shuffled, plain);
  EXPECT_NE(shuffled, this->make(1000, 8, "-shuffled")) << "of another seed";
  EXPECT_EQ(sorted(shuffled), sorted(plain));
}

INSTANTIATE_TEST_SUITE_P(InputsInUse, InputInUse, ::testing::ValuesIn(allNames()),
  [](const auto& given)
  {
    std::string name = given.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });

TEST(InputsInUse, OthersAreRefusedByAListOfNames)
{
  for (const char* name : { "", "sphere", "-shuffled", "hatch-shuffled-shuffled", "box-edges" })
  {
    try
    {
      makeCloud(name, true, 100, 1);
      ADD_FAILURE() << name << " was accepted";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find("hatch, "), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("uniformHeavy"), std::string::npos) << error.what();
    }
  }
}

TEST(InputsInUse, NamesAreUnique)
{
  for (const bool isPlane : { false, true })
  {
    // A name of the tests' families and of those in use would mean the latter alone.
    for (const std::string& name : namesInUse(isPlane))
    {
      EXPECT_THROW(
        isPlane ? fromWeightedFamily(name, 8, 1) : fromFamily(name, 8, 1), std::invalid_argument)
        << name;
    }
  }
}

TEST(InputsInUse, PointsAlongLinesAreEquallyFarFromOneAnother)
{
  const std::vector<Line> lines = { { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2, 0 } }, { { 5, 5, 5 } },
    { { 0, 0, 1 }, { 0, 0, 4 } } };
  const Cloud expected = { { 0.5, 0, 0 }, { 1.5, 0, 0 }, { 2.5, 0, 0 }, { 3, 0.5, 0 },
    { 3, 1.5, 0 }, { 0, 0, 1.5 }, { 0, 0, 2.5 }, { 0, 0, 3.5 } };
  EXPECT_EQ(evenlyAlong(lines, 8), expected);
}

TEST(InputsInUse, DisksOfAPackingDoNotOverlap)
{
  const Cloud disks = makeCloud("packing", true, 1000, 7);
  double least = disks[0][2];
  double most = least;
  for (std::size_t i = 0; i < disks.size(); ++i)
  {
    least = std::min(least, disks[i][2]);
    most = std::max(most, disks[i][2]);
    for (std::size_t k = 0; k < i; ++k)
    {
      const double apart = std::hypot(disks[i][0] - disks[k][0], disks[i][1] - disks[k][1]);
      ASSERT_GE(apart, (std::sqrt(disks[i][2]) + std::sqrt(disks[k][2])) * (1 - 1e-12));
    }
  }
  EXPECT_GT(most, 100 * least);
}

TEST(InputsInUse, VoxelsAreASurfaceWithoutRepeats)
{
  const Cloud voxels = sorted(makeCloud("voxels", false, 5000, 7));
  EXPECT_EQ(std::adjacent_find(voxels.begin(), voxels.end()), voxels.end());
  const auto isIn = [&](const Point& p)
  { return std::binary_search(voxels.begin(), voxels.end(), p); };
  EXPECT_FALSE(isIn({ 0, 0, 0 }));
  for (const Point& p : voxels)
  {
    EXPECT_EQ(p[0], std::floor(p[0]));
    EXPECT_EQ(p[1], std::floor(p[1]));
    EXPECT_TRUE(isIn({ p[0], p[1], -p[2] }) || p[1] >= voxels.back()[1]);
  }
}

TEST(InputsInUse, ContoursAreOnTheMap)
{
  for (const Point& p : makeCloud("contours", true, 10000, 7))
  {
    EXPECT_TRUE(p[0] >= 557945 && p[0] <= 567665) << p[0];
    EXPECT_TRUE(p[1] >= 5107991.5 && p[1] <= 5121941.5) << p[1];
  }
}

TEST(InputsInUse, TheWallIsFlatButForRounding)
{
  const Cloud wall = makeCloud("wall", false, 1000, 7);
  const auto cross = [](const Point& a, const Point& b)
  {
    return Point{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  };
  const auto from = [&](std::size_t i) {
    return Point{ wall[i][0] - wall[0][0], wall[i][1] - wall[0][1], wall[i][2] - wall[0][2] };
  };
  const Point normal = cross(from(1), from(2));
  double most = 0;
  for (std::size_t i = 3; i < wall.size(); ++i)
  {
    const Point p = from(i);
    most = std::max(most, std::abs(normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2]));
  }
  EXPECT_GT(most, 0);
  EXPECT_LT(most, 1e-12);
}

TEST(InputsInUse, SurfaceGridsAreTheSurfaceOfIntegerGrids)
{
  for (const int side : { 1, 2, 3, 6 })
  {
    Cloud surface;
    for (const Point& p : integerGrid(side))
    {
      const auto isAtEnd = [&](double x) { return x == 0 || x == side - 1; };
      if (isAtEnd(p[0]) || isAtEnd(p[1]) || isAtEnd(p[2]))
      {
        surface.push_back(p);
      }
    }
    EXPECT_EQ(cubeSurfaceGrid(side), surface);
  }
}

}
}
}
