// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What must not change a result: the points' order, exact scaling, moving, turning and mirroring,
/// one weight more for all, leaving out points that it does not have. And that triangulations are
/// the lower side of the lifted points' hull.
#include "Testing/Engine/Conformance/Kind.h"

#include <cmath>
#include <limits>

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

std::vector<Input> inputsFor(const Kind& kind)
{
  const bool isHull = kind.dimension == 3;
  std::vector<Input> all = kind.smallInputs();
  for (const Family& family : kind.families())
  {
    all.push_back(kind.family(family.name, effort(isHull ? 2000 : 1000), 8));
  }
  if (isHull)
  {
    for (const Input& input : largeSpecialInputs())
    {
      if (input.name == "cubeSurfaceGrid20rotated" || input.name == "cospherical5201" ||
        input.name == "grid8times5" || input.name == "prism100" || input.name == "mostlyCoplanar" ||
        input.name == "cubeSurfaceGrid20float")
      {
        all.push_back(input);
      }
    }
  }
  else
  {
    for (const char* name :
      { "uniformHeavy", "smallIntegersLight", "gridOfTwoWeights", "clusters" })
    {
      all.push_back(kind.family(name, effort(5000), 9));
    }
  }
  return all;
}

class Invariance : public ::testing::TestWithParam<InputOf>
{
protected:
  Invariance()
    : Of(*GetParam().kind)
    , IsHull(this->Of.dimension == 3)
    , Points(GetParam().input.make())
    , Whole(this->Of.run(this->Points, polygons()))
    , Wanted(cellsOf(complexOf(this->Whole)))
  {
  }

  /// Another cloud has the same cells, by other names, or seen in a mirror.
  void expectSame(const Cloud& other, const std::string& what, bool mirrored = false,
    const std::vector<std::int64_t>& names = {})
  {
    const Result found = this->Of.run(other, polygons());
    std::vector<Cell> cells = cellsOf(complexOf(found));
    for (Cell& cell : cells)
    {
      for (std::int64_t& id : cell)
      {
        id = names.empty() ? id : names[static_cast<std::size_t>(id)];
      }
      if (mirrored)
      {
        std::reverse(cell.begin(), cell.end());
      }
    }
    canonicalise(cells);
    EXPECT_EQ(cells, this->Wanted) << what;
  }

  /// Turned or mirrored: which side of a flat hull is its polygon's depends on the axes.
  void expectTurned(const Cloud& other, const std::string& what, bool mirrored)
  {
    if (this->IsHull && complexOf(this->Whole).dimension < 3)
    {
      const Result found = this->Of.run(other, polygons());
      EXPECT_EQ(idsIn(cellsOf(complexOf(found))), idsIn(this->Wanted)) << what;
    }
    else
    {
      this->expectSame(other, what, mirrored);
    }
  }

  const Kind& Of;
  const bool IsHull;
  const Cloud Points;
  const Result Whole;
  const std::vector<Cell> Wanted;
};

TEST_P(Invariance, UnderPermutation)
{
  const std::vector<std::int64_t> lowest = lowestIds(this->Points);
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    const std::vector<int> order = orderOf(this->Points, seed);
    std::vector<std::int64_t> names;
    for (const int i : order)
    {
      names.push_back(lowest[static_cast<std::size_t>(i)]);
    }
    this->expectSame(permuted(this->Points, order), "order " + std::to_string(seed), false, names);
  }
}

TEST_P(Invariance, UnderScalingByPowersOfTwo)
{
  const auto times = [&](const Cloud& from, double s)
  { return this->IsHull ? scaled(from, s, s, s) : magnified(from, s); };
  for (int power : { -900, -500, -300, -40, -1, 1, 40, 300, 500, 900 })
  {
    const double s = std::ldexp(1.0, power);
    const Cloud other = times(this->Points, s);
    // Only where the scaling is exact: nothing overflows, nothing falls below the denormals.
    if (times(other, 1 / s) == this->Points)
    {
      this->expectSame(other, "2^" + std::to_string(power));
    }
  }
}

TEST_P(Invariance, UnderMovingAndRaising)
{
  for (const Point& by :
    { Point{ 1, 0, 0 }, Point{ 0, 0, 1 }, Point{ -0.5, 3, -2 }, Point{ 0x1p20, -0x1p20, 0x1p20 },
      Point{ 0x1p30, 0x1p40, -0x1p35 }, Point{ 0, 0, 0x1p45 } })
  {
    const Cloud other = moved(this->Points, by[0], by[1], by[2]);
    // Only where nothing is rounded.
    bool isExact = true;
    for (std::size_t i = 0; i < other.size(); ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double sum = other[i][k], a = this->Points[i][k], part = sum - a;
        isExact = isExact && std::isfinite(sum) && (a - (sum - part)) + (by[k] - part) == 0;
      }
    }
    if (isExact)
    {
      this->expectSame(other, toString(Cloud{ by }));
    }
  }
}

TEST_P(Invariance, UnderTurningAndMirroring)
{
  for (int variant = 1; variant < (this->IsHull ? 16 : 8); ++variant)
  {
    Cloud other = this->Points;
    for (Point& p : other)
    {
      if (variant & 8) // a turn: space keeps its orientation
      {
        p = { p[1], p[2], p[0] };
      }
      if (variant & 4)
      {
        std::swap(p[0], p[1]);
      }
      p[0] = variant & 1 ? -p[0] : p[0];
      p[1] = variant & 2 ? -p[1] : p[1];
    }
    this->expectTurned(other, "variant " + std::to_string(variant),
      ((variant & 1) + (variant >> 1 & 1) + (variant >> 2 & 1)) % 2 == 1);
  }
}

TEST_P(Invariance, UnderLeavingOutAllButTheResultsPoints)
{
  // The hull of the hull is the hull; what is hidden hides nothing.
  const auto& ids = complexOf(this->Whole).pointIds;
  this->expectSame(permuted(this->Points, std::vector<int>(ids.begin(), ids.end())), "", false,
    { ids.begin(), ids.end() });
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, Invariance,
  ::testing::ValuesIn(inputsOf(convexHulls, inputsFor(convexHulls))), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, Invariance,
  ::testing::ValuesIn(inputsOf(regularTriangulations, inputsFor(regularTriangulations))), Named());

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
    const Result found = regularTriangulations.run(cloud, polygons());
    EXPECT_EQ(difference(found, wanted, FacetMode::Polygons, count), "") << "seed " << seed;
  }
  EXPECT_GT(planes, 0);
}

TEST(ConvexHull, HasMeasuresAsLargeAsItsCoordinates)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const auto boxOf = [](double x, double y, double z)
  {
    Cloud cloud = { { 0x1p-1074, 0, 0 } }; // so that no power of two scales all
    for (int corner = 0; corner < 8; ++corner)
    {
      cloud.push_back({ corner & 1 ? x : -x, corner & 2 ? y : -y, corner & 4 ? z : -z });
    }
    return convexHull(viewOf(cloud));
  };
  const double most = std::numeric_limits<double>::max();
  for (const double half : { most, 0x1p1023, 0x1p1022 })
  {
    const Hull cube = boxOf(half, half, half);
    EXPECT_EQ(cube.volume, infinity) << half;
    EXPECT_EQ(cube.area, infinity) << half;
  }
  EXPECT_EQ(boxOf(0x1p1023, 0x1p1023, 0x1p-1070).volume, 0x1p979);
  EXPECT_EQ(boxOf(0x1p1023, 0x1p-4, 0x1p-4).volume, 0x1p1018);
}

}
}
}
