// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What must not change the hull: the points' order, their layout in memory, exact scaling,
/// exact mirroring, adding points that are inside, leaving out points that are not extreme.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <cmath>
#include <numeric>

namespace flipflop
{
namespace test
{

namespace
{

Options polygons(int threads = 2)
{
  Options options;
  options.facets = FacetMode::Polygons;
  options.threads = threads;
  return options;
}

/// Cells in terms of the lowest id at each position, in canonical order.
std::vector<Cell> renamed(std::vector<Cell> cells, const std::vector<std::int64_t>& names)
{
  for (Cell& cell : cells)
  {
    for (std::int64_t& id : cell)
    {
      id = names[id];
    }
  }
  canonicalise(cells);
  return cells;
}

class Invariance : public ::testing::TestWithParam<Input>
{
};

TEST_P(Invariance, UnderPermutation)
{
  const Cloud cloud = this->GetParam().make();
  const std::vector<Cell> wanted = cellsOf(convexHull(viewOf(cloud), polygons()));
  const std::vector<std::int64_t> lowest = lowestIds(cloud);
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    const std::vector<int> order = orderOf(cloud, seed);
    std::vector<std::int64_t> names(cloud.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      names[i] = lowest[order[i]];
    }
    const Cloud other = permuted(cloud, order);
    // A dimension-2 polygon keeps its side: the rule speaks of the normal, not of the order.
    EXPECT_EQ(renamed(cellsOf(convexHull(viewOf(other), polygons())), names), wanted)
      << "order " << seed;
  }
}

TEST_P(Invariance, UnderScalingByPowersOfTwo)
{
  const Cloud cloud = this->GetParam().make();
  const Scale scale = commonScale(cloud);
  const std::vector<Cell> wanted = cellsOf(convexHull(viewOf(cloud), polygons()));
  for (int power : { -900, -300, -40, -1, 1, 40, 300, 900 })
  {
    const double s = std::ldexp(1.0, power);
    // Only where the scaling is exact: nothing overflows, nothing falls below the denormals.
    if (scale.exponent + power >= -1074 && scale.exponent + scale.bits + power <= 1024)
    {
      const Cloud other = scaled(cloud, s, s, s);
      EXPECT_EQ(cellsOf(convexHull(viewOf(other), polygons())), wanted) << "2^" << power;
    }
  }
}

TEST_P(Invariance, UnderTurningTheAxes)
{
  // (x, y, z) to (y, z, x): space keeps its orientation, so facets keep theirs.
  const Cloud cloud = this->GetParam().make();
  const Hull hull = convexHull(viewOf(cloud), polygons());
  Cloud other = cloud;
  for (Point& p : other)
  {
    p = { p[1], p[2], p[0] };
  }
  const Hull turned = convexHull(viewOf(other), polygons());
  EXPECT_EQ(turned.dimension, hull.dimension);
  EXPECT_EQ(Cell(turned.pointIds.begin(), turned.pointIds.end()),
    Cell(hull.pointIds.begin(), hull.pointIds.end()));
  if (hull.dimension == 3)
  {
    EXPECT_EQ(cellsOf(turned), cellsOf(hull));
  }
}

TEST_P(Invariance, UnderMirroring)
{
  const Cloud cloud = this->GetParam().make();
  const Hull hull = convexHull(viewOf(cloud), polygons());
  const Hull mirrored = convexHull(viewOf(scaled(cloud, -1, 1, 1)), polygons());
  EXPECT_EQ(mirrored.dimension, hull.dimension);
  std::vector<Cell> wanted = cellsOf(hull);
  if (hull.dimension == 3)
  {
    for (Cell& cell : wanted)
    {
      std::reverse(cell.begin(), cell.end());
    }
    canonicalise(wanted);
    EXPECT_EQ(cellsOf(mirrored), wanted);
  }
}

TEST_P(Invariance, UnderLeavingOutAllButTheHullsPoints)
{
  // The hull of the hull is the hull.
  const Cloud cloud = this->GetParam().make();
  const Hull hull = convexHull(viewOf(cloud), polygons());
  std::vector<std::int64_t> names(hull.pointIds.begin(), hull.pointIds.end());
  const Cloud kept = permuted(cloud, std::vector<int>(names.begin(), names.end()));
  EXPECT_EQ(renamed(cellsOf(convexHull(viewOf(kept), polygons())), names), cellsOf(hull));
}

TEST_P(Invariance, UnderAnyStrideAndType)
{
  const Cloud cloud = this->GetParam().make();
  const std::int64_t count = static_cast<std::int64_t>(cloud.size());
  const Hull wanted = convexHull(viewOf(cloud), polygons());
  const bool single = isFloat(cloud);
  for (std::int64_t stride : { 3, 4, 7 })
  {
    // What lies between the points must not be looked at.
    std::vector<double> doubles(stride * cloud.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<float> floats(stride * cloud.size(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        doubles[i * stride + c] = cloud[i][c];
        floats[i * stride + c] = static_cast<float>(single ? cloud[i][c] : 0);
      }
    }
    EXPECT_EQ(
      bitDifference(convexHull(PointView(doubles.data(), count, stride), polygons()), wanted), "");
    if (single)
    {
      EXPECT_EQ(
        bitDifference(convexHull(PointView(floats.data(), count, stride), polygons()), wanted), "");
    }
  }
}

std::vector<Input> inputs()
{
  std::vector<Input> all = smallSpecialInputs();
  for (const Family& family : families())
  {
    all.push_back(fromFamily(family.name, effort(4000), 8));
  }
  for (const Input& input : largeSpecialInputs())
  {
    if (input.name == "cubeSurfaceGrid20rotated" || input.name == "cospherical5201" ||
      input.name == "grid8times5" || input.name == "prism100" || input.name == "mostlyCoplanar")
    {
      all.push_back(input);
    }
  }
  all.push_back({ "cubeSurfaceGrid20floats", 0,
    []() { return roundedToFloat(rotated(cubeSurfaceGrid(20))); } });
  return all;
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, Invariance, ::testing::ValuesIn(inputs()),
  [](const auto& given) { return given.param.name; });

}
}
}
