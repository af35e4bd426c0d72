// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What must not change the triangulation: the points' order, their layout in memory, exact
/// scaling, moving, turning and mirroring, one weight more for all, leaving out what is hidden; and
/// that it is the lower side of the lifted points' hull.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include <flipflop/ConvexHull.h>

#include <cmath>
#include <numeric>

namespace flipflop
{
namespace test
{

namespace
{

Triangulation run(const Cloud& weighted)
{
  Options options;
  options.facets = FacetMode::Polygons;
  options.threads = 2;
  return regularTriangulation(viewOf(weighted), weightsOf(weighted), options);
}

/// Cells by other names, in canonical order.
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

std::vector<Cell> reversed(std::vector<Cell> cells)
{
  for (Cell& cell : cells)
  {
    std::reverse(cell.begin(), cell.end());
  }
  canonicalise(cells);
  return cells;
}

/// Is a + b a double?
bool isExactSum(double a, double b)
{
  const double sum = a + b;
  const double part = sum - a;
  return std::isfinite(sum) && (a - (sum - part)) + (b - part) == 0;
}

/// The cloud moved, and all weights raised, if nothing is rounded; empty otherwise.
Cloud movedExactly(const Cloud& weighted, double x, double y, double w)
{
  for (const Point& p : weighted)
  {
    if (!isExactSum(p[0], x) || !isExactSum(p[1], y) || !isExactSum(p[2], w))
    {
      return {};
    }
  }
  return moved(weighted, x, y, w);
}

class TriangulationInvariance : public ::testing::TestWithParam<Input>
{
};

TEST_P(TriangulationInvariance, UnderPermutation)
{
  const Cloud cloud = this->GetParam().make();
  const std::vector<Cell> wanted = cellsOf(run(cloud));
  const std::vector<std::int64_t> lowest = lowestIds(cloud);
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    const std::vector<int> order = orderOf(cloud, seed);
    std::vector<std::int64_t> names(cloud.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      names[i] = lowest[order[i]];
    }
    EXPECT_EQ(renamed(cellsOf(run(permuted(cloud, order))), names), wanted) << "order " << seed;
  }
}

TEST_P(TriangulationInvariance, UnderScalingByPowersOfTwo)
{
  const Cloud cloud = this->GetParam().make();
  const std::vector<Cell> wanted = cellsOf(run(cloud));
  for (int power : { -500, -300, -40, -1, 1, 40, 300, 500 })
  {
    const double s = std::ldexp(1.0, power);
    const Cloud other = magnified(cloud, s);
    // Only where the scaling is exact: nothing overflows, nothing falls below the denormals.
    if (magnified(other, 1 / s) == cloud)
    {
      EXPECT_EQ(cellsOf(run(other)), wanted) << "2^" << power;
    }
  }
}

TEST_P(TriangulationInvariance, UnderMovingAndRaising)
{
  const Cloud cloud = this->GetParam().make();
  const std::vector<Cell> wanted = cellsOf(run(cloud));
  for (const Point& by :
    { Point{ 1, 0, 0 }, Point{ 0, 0, 1 }, Point{ -0.5, 3, -2 }, Point{ 0x1p20, -0x1p20, 0x1p20 },
      Point{ 0x1p30, 0x1p40, -0x1p35 }, Point{ 0, 0, 0x1p45 } })
  {
    const Cloud other = movedExactly(cloud, by[0], by[1], by[2]);
    if (!other.empty())
    {
      EXPECT_EQ(cellsOf(run(other)), wanted) << toString(Cloud{ by });
    }
  }
}

TEST_P(TriangulationInvariance, UnderTurningAndMirroring)
{
  const Cloud cloud = this->GetParam().make();
  const std::vector<Cell> wanted = cellsOf(run(cloud));
  const std::vector<Cell> backwards = reversed(wanted);
  for (int variant = 1; variant < 8; ++variant)
  {
    Cloud other = cloud;
    for (Point& p : other)
    {
      if (variant & 4)
      {
        std::swap(p[0], p[1]);
      }
      p[0] = variant & 1 ? -p[0] : p[0];
      p[1] = variant & 2 ? -p[1] : p[1];
    }
    const bool isMirror = ((variant & 1) + (variant >> 1 & 1) + (variant >> 2)) % 2 == 1;
    EXPECT_EQ(cellsOf(run(other)), isMirror ? backwards : wanted) << "variant " << variant;
  }
}

TEST_P(TriangulationInvariance, UnderLeavingOutTheHidden)
{
  const Cloud cloud = this->GetParam().make();
  const Triangulation whole = run(cloud);
  const std::vector<std::int64_t> names(whole.pointIds.begin(), whole.pointIds.end());
  const Cloud kept = permuted(cloud, std::vector<int>(names.begin(), names.end()));
  const Triangulation again = run(kept);
  EXPECT_EQ(renamed(cellsOf(again), names), cellsOf(whole));
  EXPECT_TRUE(again.hiddenIds.empty());
}

TEST_P(TriangulationInvariance, UnderAnyStrideAndType)
{
  const Cloud cloud = this->GetParam().make();
  const std::int64_t count = static_cast<std::int64_t>(cloud.size());
  const Triangulation wanted = run(cloud);
  const bool single = isFloat(cloud);
  Options options;
  options.facets = FacetMode::Polygons;
  for (std::int64_t stride : { 2, 3, 5 })
  {
    // What lies between must not be looked at.
    std::vector<double> doubles(stride * cloud.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<float> floats(stride * cloud.size(), std::numeric_limits<float>::infinity());
    std::vector<double> weights = doubles;
    std::vector<float> floatWeights = floats;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      for (int c = 0; c < 2; ++c)
      {
        doubles[i * stride + c] = cloud[i][c];
        floats[i * stride + c] = static_cast<float>(single ? cloud[i][c] : 0);
      }
      weights[i * stride] = cloud[i][2];
      floatWeights[i * stride] = static_cast<float>(single ? cloud[i][2] : 0);
    }
    EXPECT_EQ(bitDifference(regularTriangulation(PointView(doubles.data(), count, stride),
                              WeightView(weights.data(), count, stride), options),
                wanted),
      "");
    if (single)
    {
      EXPECT_EQ(bitDifference(regularTriangulation(PointView(floats.data(), count, stride),
                                WeightView(floatWeights.data(), count, stride), options),
                  wanted),
        "");
    }
  }
}

std::vector<Input> inputs()
{
  std::vector<Input> all = smallWeightedInputs();
  for (const Family& family : weightedFamilies())
  {
    all.push_back(fromWeightedFamily(family.name, effort(1000), 8));
  }
  for (const char* name : { "uniformHeavy", "smallIntegersLight", "gridOfTwoWeights", "clusters" })
  {
    all.push_back(fromWeightedFamily(name, effort(5000), 9));
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, TriangulationInvariance,
  ::testing::ValuesIn(inputs()), [](const auto& given) { return given.param.name; });

/// The lower facets of the hull of the lifts, as seen from above. Lifts must be doubles.
ReferenceTriangulation lowerHull(const Cloud& weighted)
{
  Cloud lifts = weighted;
  for (Point& p : lifts)
  {
    p[2] = p[0] * p[0] + p[1] * p[1] - p[2];
  }
  Options options;
  options.facets = FacetMode::Polygons;
  options.threads = 2;
  const Hull hull = convexHull(viewOf(lifts), options);
  ReferenceTriangulation lower;
  lower.dimension = 2;
  for (Cell cell : cellsOf(hull))
  {
    const Point& p = lifts[cell[0]];
    const Point& q = lifts[cell[1]];
    const Point& r = lifts[cell[2]];
    const double turn = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    // Lifts in one plane are one polygon, which looks up.
    if (hull.dimension == 2 || turn < 0)
    {
      if (hull.dimension == 3)
      {
        std::reverse(cell.begin(), cell.end());
      }
      lower.cells.push_back(std::move(cell));
    }
  }
  canonicalise(lower.cells);
  for (const Cell& cell : lower.cells)
  {
    lower.ids.insert(lower.ids.end(), cell.begin(), cell.end());
  }
  std::sort(lower.ids.begin(), lower.ids.end());
  lower.ids.erase(std::unique(lower.ids.begin(), lower.ids.end()), lower.ids.end());
  return lower;
}

TEST(RegularTriangulation, IsTheLowerHullOfTheLifts)
{
  int planes = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(effort(150)); ++seed)
  {
    Random random(seed);
    const int side = random.integer(1, 8) == 1 ? random.integer(2, 5) : random.integer(10, 1000);
    const int weight = random.integer(0, 3) * random.integer(0, side * side);
    const int count = random.integer(20, 3000);
    Cloud cloud = smallIntegerSites(count, -side, side, -weight, weight, random);
    if (seed % 5 == 0)
    {
      for (Point& p : cloud)
      {
        p[2] = p[0] * p[0] + p[1] * p[1] - (seed % 2 ? 0 : random.integer(0, 2));
      }
    }
    const ReferenceTriangulation wanted = lowerHull(cloud);
    planes += wanted.cells.size() == 1;
    EXPECT_EQ(difference(run(cloud), wanted, FacetMode::Polygons, count), "") << "seed " << seed;
  }
  EXPECT_GT(planes, 0);
}

}
}
}
