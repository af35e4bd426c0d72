// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What must not change a result: the points' order, their layout in memory, exact scaling, exact
/// turning and mirroring, leaving out points that it does not have. And of triangulations: exact
/// moving, one weight more for all, and that they are the lower side of the lifted points' hull.
#include "Testing/Engine/Conformance/Kind.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace flipflop
{
namespace test
{

namespace
{

Options polygons()
{
  Options options;
  options.facets = FacetMode::Polygons;
  options.threads = 2;
  return options;
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

std::vector<Input> hullInputs()
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

std::vector<Input> weightedInputs()
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

/// Of both kinds.
class Invariance : public ::testing::TestWithParam<InputOf>
{
protected:
  const Kind& kind() const { return *this->GetParam().kind; }
  Cloud make() const { return this->GetParam().input.make(); }
  Result run(const Cloud& cloud) const { return this->kind().run(cloud, polygons()); }
  std::vector<Cell> cells(const Cloud& cloud) const { return cellsOf(complexOf(this->run(cloud))); }
};

/// What the tests of floats are made of. (A compiler has left some numbers as they were.)
TEST(Floats, AreFloats)
{
  for (int count = 1; count < 60; ++count)
  {
    EXPECT_TRUE(isFloat(roundedToFloat(fromFamily("ball", count, 1).make()))) << count << " points";
  }
}

TEST_P(Invariance, UnderPermutation)
{
  const Cloud cloud = this->make();
  const std::vector<Cell> wanted = this->cells(cloud);
  const std::vector<std::int64_t> lowest = lowestIds(cloud);
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    const std::vector<int> order = orderOf(cloud, seed);
    std::vector<std::int64_t> names(cloud.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      names[i] = lowest[order[i]];
    }
    // A hull's only polygon keeps its side: the rule speaks of the normal, not of the order.
    EXPECT_EQ(renamed(this->cells(permuted(cloud, order)), names), wanted) << "order " << seed;
  }
}

TEST_P(Invariance, UnderScalingByPowersOfTwo)
{
  const Cloud cloud = this->make();
  const std::vector<Cell> wanted = this->cells(cloud);
  const auto times = [&](const Cloud& from, double s)
  { return this->kind().dimension == 3 ? scaled(from, s, s, s) : magnified(from, s); };
  for (int power : { -900, -500, -300, -40, -1, 1, 40, 300, 500, 900 })
  {
    const double s = std::ldexp(1.0, power);
    const Cloud other = times(cloud, s);
    // Only where the scaling is exact: nothing overflows, nothing falls below the denormals.
    if (times(other, 1 / s) == cloud)
    {
      EXPECT_EQ(this->cells(other), wanted) << "2^" << power;
    }
  }
}

TEST_P(Invariance, UnderLeavingOutAllButTheResultsPoints)
{
  // The hull of the hull is the hull; what is hidden hides nothing.
  const Cloud cloud = this->make();
  const Result whole = this->run(cloud);
  const auto& ids = complexOf(whole).pointIds;
  const std::vector<std::int64_t> names(ids.begin(), ids.end());
  const Result again = this->run(permuted(cloud, std::vector<int>(names.begin(), names.end())));
  EXPECT_EQ(renamed(cellsOf(complexOf(again)), names), cellsOf(complexOf(whole)));
  EXPECT_EQ(complexOf(again).pointIds.size(), names.size());
  const auto* triangulation = std::get_if<Triangulation>(&again);
  EXPECT_TRUE(!triangulation || triangulation->hiddenIds.empty());
}

INSTANTIATE_TEST_SUITE_P(
  ConvexHull, Invariance, ::testing::ValuesIn(inputsOf(convexHulls, hullInputs())), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, Invariance,
  ::testing::ValuesIn(inputsOf(regularTriangulations, weightedInputs())), Named());

class HullInvariance : public ::testing::TestWithParam<Input>
{
};

TEST_P(HullInvariance, UnderTurningTheAxes)
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

TEST_P(HullInvariance, UnderMirroring)
{
  const Cloud cloud = this->GetParam().make();
  const Hull hull = convexHull(viewOf(cloud), polygons());
  const Hull mirrored = convexHull(viewOf(scaled(cloud, -1, 1, 1)), polygons());
  EXPECT_EQ(mirrored.dimension, hull.dimension);
  if (hull.dimension == 3)
  {
    EXPECT_EQ(cellsOf(mirrored), reversed(cellsOf(hull)));
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, HullInvariance, ::testing::ValuesIn(hullInputs()),
  [](const auto& given) { return given.param.name; });

Triangulation triangulated(const Cloud& weighted)
{
  return regularTriangulation(viewOf(weighted), weightsOf(weighted), polygons());
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

TEST_P(TriangulationInvariance, UnderMovingAndRaising)
{
  const Cloud cloud = this->GetParam().make();
  const std::vector<Cell> wanted = cellsOf(triangulated(cloud));
  for (const Point& by :
    { Point{ 1, 0, 0 }, Point{ 0, 0, 1 }, Point{ -0.5, 3, -2 }, Point{ 0x1p20, -0x1p20, 0x1p20 },
      Point{ 0x1p30, 0x1p40, -0x1p35 }, Point{ 0, 0, 0x1p45 } })
  {
    const Cloud other = movedExactly(cloud, by[0], by[1], by[2]);
    if (!other.empty())
    {
      EXPECT_EQ(cellsOf(triangulated(other)), wanted) << toString(Cloud{ by });
    }
  }
}

TEST_P(TriangulationInvariance, UnderTurningAndMirroring)
{
  const Cloud cloud = this->GetParam().make();
  const std::vector<Cell> wanted = cellsOf(triangulated(cloud));
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
    EXPECT_EQ(cellsOf(triangulated(other)), isMirror ? backwards : wanted) << "variant " << variant;
  }
}

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, TriangulationInvariance,
  ::testing::ValuesIn(weightedInputs()), [](const auto& given) { return given.param.name; });

/// The lower facets of the hull of the lifts, as seen from above. Lifts must be doubles.
ReferenceTriangulation lowerHull(const Cloud& weighted)
{
  Cloud lifts = weighted;
  for (Point& p : lifts)
  {
    p[2] = p[0] * p[0] + p[1] * p[1] - p[2];
  }
  const Hull hull = convexHull(viewOf(lifts), polygons());
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
  lower.ids = idsIn(lower.cells);
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
    EXPECT_EQ(difference(triangulated(cloud), wanted, FacetMode::Polygons, count), "")
      << "seed " << seed;
  }
  EXPECT_GT(planes, 0);
}

}
}
}
