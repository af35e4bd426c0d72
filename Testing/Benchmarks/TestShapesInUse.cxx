// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The benchmarks' families: as many points as asked for, all finite, the same for the same seed;
/// and shuffled, the same points in another order. What a family promises beyond that is looked at
/// where it could be broken unseen.
#include "Plan.h"
#include "Shapes.h"
#include "ShapesInUse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace flipflop
{
namespace
{

std::vector<SpacePoint> pointsOf(const Coordinates& coordinates)
{
  std::vector<SpacePoint> points;
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    points.push_back({ coordinates[i], coordinates[i + 1], coordinates[i + 2] });
  }
  return points;
}

std::vector<SpacePoint> make(const std::string& name, std::int64_t count, std::uint64_t seed = 7)
{
  return pointsOf(makeShapeInUse(name, count, seed));
}

std::vector<SpacePoint> sorted(std::vector<SpacePoint> points)
{
  std::sort(points.begin(), points.end());
  return points;
}

std::vector<std::string> allNames()
{
  std::vector<std::string> names = shapesInUse(true);
  const std::vector<std::string> plane = shapesInUse(false);
  names.insert(names.end(), plane.begin(), plane.end());
  return names;
}

class ShapeInUse : public ::testing::TestWithParam<std::string>
{
};

TEST_P(ShapeInUse, HasAsManyPointsAsAskedForAllFinite)
{
  // The least that the programs take, odd ones, and fewer and more than there are vertices of
  // contours
  for (const std::int64_t count : { 8, 9, 1000, 4321, 50000 })
  {
    SCOPED_TRACE(count);
    const Coordinates points = makeShapeInUse(this->GetParam(), count, 7);
    EXPECT_EQ(points.size(), 3 * static_cast<std::size_t>(count));
    EXPECT_TRUE(
      std::all_of(points.begin(), points.end(), [](double x) { return std::isfinite(x); }));
  }
}

TEST_P(ShapeInUse, IsTheSameForTheSameSeed)
{
  for (const std::string& name : withShuffled({ this->GetParam() }))
  {
    EXPECT_EQ(make(name, 1000), make(name, 1000));
  }
}

TEST_P(ShapeInUse, HasTheSamePointsShuffled)
{
  const std::vector<SpacePoint> plain = make(this->GetParam(), 1000);
  const std::vector<SpacePoint> shuffled = make(this->GetParam() + "-shuffled", 1000);
  EXPECT_NE(shuffled, plain);
  EXPECT_NE(shuffled, make(this->GetParam() + "-shuffled", 1000, 8)) << "of another seed";
  EXPECT_EQ(sorted(shuffled), sorted(plain));
}

TEST_P(ShapeInUse, HasWeightsWhereItSaysSo)
{
  const std::vector<std::string> space = shapesInUse(true);
  const bool third = std::find(space.begin(), space.end(), this->GetParam()) != space.end() ||
    isWeightedShape(this->GetParam());
  EXPECT_EQ(isWeightedShape(this->GetParam() + "-shuffled"), isWeightedShape(this->GetParam()));
  double most = 0;
  for (const SpacePoint& p : make(this->GetParam(), 1000))
  {
    most = std::max(most, std::abs(p[2]));
  }
  EXPECT_EQ(most != 0, third);
}

INSTANTIATE_TEST_SUITE_P(ShapesInUse, ShapeInUse, ::testing::ValuesIn(allNames()),
  [](const auto& given)
  {
    std::string name = given.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });

TEST(ShapesInUse, HaveNamesOfTheirOwn)
{
  std::vector<std::string> names = withShuffled(allNames());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(ShapesInUse, OthersAreRefused)
{
  for (const char* name : { "", "sphere", "-shuffled", "hatch-shuffled-shuffled" })
  {
    EXPECT_THROW(makeShapeInUse(name, 100, 1), std::invalid_argument) << name;
    EXPECT_FALSE(isWeightedShape(name)) << name;
  }
}

TEST(ShapesInUse, PointsAlongLinesAreEquallyFarFromOneAnother)
{
  const std::vector<Line> lines = { { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2, 0 } }, { { 5, 5, 5 } },
    { { 0, 0, 1 }, { 0, 0, 4 } } };
  const std::vector<SpacePoint> places = { { 0.5, 0, 0 }, { 1.5, 0, 0 }, { 2.5, 0, 0 },
    { 3, 0.5, 0 }, { 3, 1.5, 0 }, { 0, 0, 1.5 }, { 0, 0, 2.5 }, { 0, 0, 3.5 } };
  EXPECT_EQ(pointsOf(evenlyAlong(lines, 8)), places);
}

TEST(ShapesInUse, DisksOfAPackingDoNotOverlap)
{
  const std::vector<SpacePoint> disks = make("packing", 1000);
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

TEST(ShapesInUse, VoxelsAreASurfaceWithoutRepeats)
{
  const std::vector<SpacePoint> voxels = sorted(make("voxels", 5000));
  EXPECT_EQ(std::adjacent_find(voxels.begin(), voxels.end()), voxels.end());
  const auto isIn = [&](const SpacePoint& p)
  { return std::binary_search(voxels.begin(), voxels.end(), p); };
  EXPECT_FALSE(isIn({ 0, 0, 0 }));
  for (const SpacePoint& p : voxels)
  {
    EXPECT_EQ(p[0], std::floor(p[0]));
    EXPECT_EQ(p[1], std::floor(p[1]));
    EXPECT_TRUE(isIn({ p[0], p[1], -p[2] }) || p[1] >= voxels.back()[1]);
  }
}

TEST(ShapesInUse, ContoursAreOnTheMap)
{
  for (const SpacePoint& p : make("contours", 10000))
  {
    EXPECT_TRUE(p[0] >= 557945 && p[0] <= 567665) << p[0];
    EXPECT_TRUE(p[1] >= 5107991.5 && p[1] <= 5121941.5) << p[1];
  }
}

TEST(ShapesInUse, TheWallIsFlatButForRounding)
{
  const std::vector<SpacePoint> wall = make("wall", 1000);
  const auto cross = [](const SpacePoint& a, const SpacePoint& b)
  {
    return SpacePoint{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
      a[0] * b[1] - a[1] * b[0] };
  };
  const auto from = [&](std::size_t i) {
    return SpacePoint{ wall[i][0] - wall[0][0], wall[i][1] - wall[0][1], wall[i][2] - wall[0][2] };
  };
  const SpacePoint normal = cross(from(1), from(2));
  double most = 0;
  for (std::size_t i = 3; i < wall.size(); ++i)
  {
    const SpacePoint p = from(i);
    most = std::max(most, std::abs(normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2]));
  }
  EXPECT_GT(most, 0);
  EXPECT_LT(most, 1e-12);
}

Suite suiteOf(Family family)
{
  Suite suite;
  suite.family = family;
  suite.distributions = family == Family::Space ? "cube" : "uniform:0";
  return suite;
}

std::vector<Distribution> asked(Family family, const char* list)
{
  const char* arguments[] = { "program", "--distributions", list };
  return Plan::parse(suiteOf(family), 3, arguments).distributions;
}

TEST(DistributionsInUse, AreAllByOneWord)
{
  for (const Family family : { Family::Space, Family::Plane })
  {
    const std::vector<std::string> names = withShuffled(shapesInUse(family == Family::Space));
    std::vector<std::string> got;
    for (const Distribution& distribution : asked(family, "in-use"))
    {
      got.push_back(distribution.label());
    }
    EXPECT_EQ(got, names);
  }
  EXPECT_EQ(asked(Family::Plane, "circle,in-use,scan").size(), 2 + 2 * shapesInUse(false).size());
}

TEST(DistributionsInUse, HaveWeightsWhereTheShapesHave)
{
  EXPECT_TRUE(Distribution::parse("packing-shuffled", Family::Plane).isWeighted());
  EXPECT_FALSE(Distribution::parse("hatch", Family::Plane).isWeighted());
  EXPECT_TRUE(Distribution::parse("weighted-grid", Family::Plane).isWeighted());
  // The file's points have none, whatever its name.
  EXPECT_FALSE(Distribution::parse("file:packing.f64", Family::Plane).isWeighted());
}

TEST(DistributionsInUse, AnErrorListsTheChoices)
{
  for (const char* text : { "hatches", "hatch-shuffled-shuffled", "box-edges", "uniform-shuffled" })
  {
    try
    {
      Distribution::parse(text, Family::Plane);
      ADD_FAILURE() << text << " was taken";
    }
    catch (const std::invalid_argument& error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find(text), std::string::npos) << message;
      EXPECT_NE(message.find("circle"), std::string::npos) << message;
      EXPECT_NE(message.find("hatch,"), std::string::npos) << message;
      EXPECT_NE(message.find("in-use"), std::string::npos) << message;
    }
  }
}

}
}
