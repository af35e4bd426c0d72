// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Power diagrams in boxes fill the box edge to edge with the cells of the sites, and have the same
/// bits on any number of threads: on every family of sites, on those whose corners round past each
/// other, and where ties, ranges or the box are awkward. Sites are a Cloud of (x, y, weight).
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsRounded.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/PowerDiagram/DiagramFault.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double most = std::numeric_limits<double>::max();
const Box unitBox = { 0, 1, 0, 1 };

Triangulation triangulate(const Cloud& sites, FacetMode facets = FacetMode::Polygons)
{
  Options options;
  options.facets = facets;
  return regularTriangulation(viewOf(sites), weightsOf(sites), options);
}

PowerDiagram diagramOf(const Cloud& sites, const Triangulation& of, const Box& box, int threads = 1)
{
  Options options;
  options.threads = threads;
  return powerDiagram(viewOf(sites), weightsOf(sites), of, box.data(), options);
}

/// The diagram, after a check of all that it promises.
PowerDiagram expectRight(const Cloud& sites, const Box& box)
{
  const Triangulation triangulation = triangulate(sites);
  PowerDiagram diagram = diagramOf(sites, triangulation, box);
  EXPECT_EQ(diagramFault(diagram, sites, triangulation, box), "");
  // Fans of triangles in place of polygons change nothing.
  EXPECT_EQ(polygonsOf(diagramOf(sites, triangulate(sites, FacetMode::Triangles), box)),
    polygonsOf(diagram));
  return diagram;
}

/// The bounds of the sites, wider or narrower by chance.
Box boxFor(const Cloud& sites, Random& random)
{
  Box box = powerDiagramBox(viewOf(sites));
  const int kind = random.integer(0, 2);
  for (std::size_t k = 0; k < 4; k += 2)
  {
    const double size = box[k + 1] - box[k];
    const double inwards = kind == 0 ? 0 : kind == 1 ? -1 : random.uniform(0, 0.45);
    box[k] += inwards * size;
    box[k + 1] -= inwards * size;
    if (!(box[k] < box[k + 1]))
    {
      const double more = 1 + std::fabs(box[k]);
      box[k] -= more;
      box[k + 1] += more;
    }
  }
  return box;
}

struct FamilyIn
{
  const std::vector<Family>& (*list)();
  std::string name;
  std::uint64_t seeds;
};
void PrintTo(const FamilyIn& family, std::ostream* out)
{
  *out << family.name;
}

class PowerDiagrams : public testing::TestWithParam<FamilyIn>
{
};

TEST_P(PowerDiagrams, CellsAreSimpleAndFillTheBox)
{
  for (std::uint64_t seed = 1; seed <= this->GetParam().seeds; ++seed)
  {
    Random random(seed);
    const int count = seed % 30 == 0 ? 400 : random.integer(3, 60);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", sites " + std::to_string(count));
    const Cloud sites =
      fromFamilies(this->GetParam().list(), this->GetParam().name, count, seed).make();
    expectRight(sites, boxFor(sites, random));
    ASSERT_FALSE(HasFailure());
  }
}

std::vector<FamilyIn> familiesIn(const std::vector<Family>& (*list)(), std::uint64_t seeds)
{
  std::vector<FamilyIn> all;
  for (const Family& family : list())
  {
    all.push_back({ list, family.name, seeds });
  }
  return all;
}

const auto byName = [](const testing::TestParamInfo<FamilyIn>& given) { return given.param.name; };
INSTANTIATE_TEST_SUITE_P(
  Rounded, PowerDiagrams, testing::ValuesIn(familiesIn(roundedFamilies, 60)), byName);
INSTANTIATE_TEST_SUITE_P(
  Weighted, PowerDiagrams, testing::ValuesIn(familiesIn(weightedFamilies, 10)), byName);

TEST(PowerDiagram, SmallLatticesAreFullOfTies)
{
  Random random(9);
  for (int round = 0; round < 150; ++round)
  {
    SCOPED_TRACE("round " + std::to_string(round));
    const int range = random.integer(1, 6);
    Cloud sites = smallIntegerSites(random.integer(0, 30), 0, range, 0, range, random);
    sites.insert(sites.end(), { { 0, 0, 0 }, { 1.0 * range, 0, 0 }, { 0, 1.0 * range, 0 } });
    for (int b = 0; b < 6; ++b)
    {
      const double x = random.integer(-2, 2 * range) / 2.0;
      const double y = random.integer(-2, 2 * range) / 2.0;
      expectRight(sites,
        { x, x + random.integer(1, range + 4) / 2.0, y, y + random.integer(1, range + 4) / 2.0 });
    }
  }
}

TEST(PowerDiagram, CollinearSitesHaveStrips)
{
  for (const std::array<int, 2> step : { std::array<int, 2>{ 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 },
         { 1, 1 }, { -1, 2 }, { 3, -1 }, { -2, -5 } })
  {
    for (int count : { 2, 3, 6 })
    {
      SCOPED_TRACE(testing::Message() << step[0] << ' ' << step[1] << ", " << count);
      Cloud sites;
      for (int i = 0; i < count; ++i)
      {
        sites.push_back({ 1.0 * step[0] * i, 1.0 * step[1] * i, i % 2 ? 0.25 : 0 });
      }
      for (const Box& box : { Box{ -20, 20, -20, 20 }, unitBox, Box{ -1, 1.5, -1, 0.5 },
             Box{ 3, 4, 7, 9 }, Box{ 0.5, 2.5, -0.5, 2.5 } })
      {
        for (const auto& cell : polygonsOf(expectRight(sites, box)))
        {
          EXPECT_LE(cell.second.size(), 6u);
        }
      }
    }
  }
}

/// In a box that cuts off the position where a cell would start.
TEST(PowerDiagram, CellsStartWhereTheirBorderComesIn)
{
  const auto startsOf = [](const Cloud& sites, const Box& box)
  {
    std::vector<std::array<double, 2>> starts;
    const PowerDiagram diagram = expectRight(sites, box);
    for (std::size_t c = 0; c < diagram.siteIds.size(); ++c)
    {
      const std::int64_t corner = diagram.connectivity[diagram.offsets[c]];
      starts.push_back({ diagram.corners[2 * corner], diagram.corners[2 * corner + 1] });
    }
    return starts;
  };
  using Starts = std::vector<std::array<double, 2>>;
  const Cloud row = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  EXPECT_EQ(startsOf(row, { -1, 3, -1, 1 }), (Starts{ { 0.5, 1 }, { 0.5, -1 }, { 1.5, -1 } }));
  EXPECT_EQ(startsOf(row, { -1, 3, 1, 2 }), (Starts{ { 0.5, 1 }, { 1.5, 1 }, { 3, 1 } }));
  EXPECT_EQ(startsOf(row, { 0.5, 3, 0, 2 }), (Starts{ { 0.5, 0 }, { 1.5, 0 } }));
  const Cloud slanted = { { 0, 0, 0 }, { 2, 1, 0 }, { 4, 2, 0 } };
  EXPECT_EQ(startsOf(slanted, { 1.5, 9, 2, 9 }), (Starts{ { 2.75, 2 }, { 9, 2 } }));
  EXPECT_EQ(startsOf(slanted, { -9, 0, -9, 1 }), (Starts{ { -9, 1 } }));
  EXPECT_EQ(startsOf(squareGrid(3), { 0.25, 1.5, 0.5, 1.75 }),
    (Starts{ { 0.5, 0.5 }, { 0.5, 0.5 }, { 0.5, 1.5 }, { 0.5, 1.5 } }));
  EXPECT_EQ(startsOf(squareGrid(3), { 0.5, 1.5, 0.75, 1 }), (Starts{ { 1.5, 0.75 } }));
  EXPECT_EQ(startsOf({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 4, 4, 0 }, { 2, 2, 1 } },
              { 1, 3, 0.5, 2.5 }),
    (Starts{ { 1.25, 0.5 }, { 3, 0.75 }, { 2.75, 0.5 } }));
}

/// A corner that rounds to a side may be within the box or beyond.
TEST(PowerDiagram, ABoxThroughRoundedCorners)
{
  for (const Family& family : roundedFamilies())
  {
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      SCOPED_TRACE(std::string(family.name) + ", seed " + std::to_string(seed));
      Random random(seed);
      const Cloud sites =
        fromFamilies(roundedFamilies(), family.name, random.integer(3, 60), seed).make();
      const PowerDiagram whole =
        diagramOf(sites, triangulate(sites), powerDiagramBox(viewOf(sites)));
      const auto bound = [&](std::size_t axis)
      { return whole.corners[2 * random.pick(whole.corners.size() / 2) + axis]; };
      for (int i = 0; i < 4; ++i)
      {
        const auto x = std::minmax({ bound(0), bound(0) });
        const auto y = std::minmax({ bound(1), bound(1) });
        if (x.first < x.second && y.first < y.second)
        {
          expectRight(sites, { x.first, x.second, y.first, y.second });
        }
      }
      ASSERT_FALSE(HasFailure());
    }
  }
}

/// What has a known number of cells and corners.
struct KnownDiagram
{
  const char* name;
  Cloud sites;
  Box box;
  std::size_t cells;
  std::size_t corners; ///< 0: unknown
};

TEST(PowerDiagram, HasTheKnownCells)
{
  Cloud giant = randomSites(100, 0.01, 4);
  giant[17][2] = 1e200;
  const KnownDiagram known[] = { { "a grid has square cells", squareGrid(7),
                                   { -0.5, 6.5, -0.5, 6.5 }, 49, 64 },
    { "a box along cells cuts no slivers", squareGrid(6), { 0.5, 3.5, 1.5, 4.5 }, 9, 16 },
    { "and one between", squareGrid(6), { 1, 3, 1.5, 4 }, 9, 16 },
    { "within one cell", squareGrid(6), { 1.75, 2.25, 2.5, 3.25 }, 1, 4 },
    { "cocircular sites", moved(cocircularIntegers(65 * 65), 100, 100, 0), { 0, 200, 10, 190 }, 36,
      0 },
    { "a heavy one has the box", { { 5, 5, 0 }, { 70, 7, 1e300 } }, unitBox, 1, 4 },
    { "of two heavy ones, one", { { 0, 0, 1e300 }, { 1, 0, 1.0000001e300 } }, unitBox, 1, 4 },
    { "a giant hides all", giant, unitBox, 1, 4 },
    { "a row", { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { -1, 3, -1, 1 }, 3, 8 },
    { "a center beyond all doubles", { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1e-320, 0 } },
      { -1, 3, -1, 1 }, 3, 8 },
    { "tiny beside huge", { { 0, 0, 0 }, { 1e-300, 0, 0 }, { 0, 1e300, 0 }, { -1e300, 0, 0 } },
      { -1e300, 1e300, -1e300, 1e300 }, 4, 0 },
    { "as large as boxes get", randomSites(50, 0, 3), { -most, most, -most, most }, 50, 0 },
    { "nothing", {}, unitBox, 0, 0 } };
  for (const KnownDiagram& one : known)
  {
    SCOPED_TRACE(one.name);
    const PowerDiagram diagram = expectRight(one.sites, one.box);
    EXPECT_EQ(diagram.siteIds.size(), one.cells);
    EXPECT_TRUE(one.corners == 0 || diagram.corners.size() == 2 * one.corners)
      << diagram.corners.size() / 2;
  }
}

TEST(PowerDiagram, PowersOfTwoScaleTheCorners)
{
  const Cloud sites = randomSites(300, 0.05, 8);
  const PowerDiagram wanted = expectRight(sites, unitBox);
  for (const int exponent : { 20, -20, 100, -100, 300, -300, 500, -480 })
  {
    const double factor = std::ldexp(1.0, exponent);
    const Cloud larger = magnified(sites, factor);
    PowerDiagram other = diagramOf(larger, triangulate(larger), { 0, factor, 0, factor });
    for (double& x : other.corners)
    {
      x /= factor;
    }
    EXPECT_EQ(bitDifference(other, wanted), "") << exponent;
  }
}

/// The tips of its cells cross near the center; further out they are wide.
TEST(PowerDiagram, NoCellOfACircleIsLost)
{
  for (int count = 480; count <= 510; count += 10)
  {
    SCOPED_TRACE(count);
    const Cloud sites = circleAt(count, 1e3, 1e3);
    EXPECT_EQ(expectRight(sites, { 998, 1002, 998, 1002 }).siteIds.size(), sites.size());
  }
}

/// Sides of the box run along edges that are not quite straight, and corners just outside of it are
/// rounded to it.
TEST(PowerDiagram, ABoxAlongTheCells)
{
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double noise = std::ldexp(1.0, -random.integer(48, 56));
    const double origin = random.integer(0, 3);
    Cloud sites = squareGrid(6);
    for (Point& p : sites)
    {
      p = { origin + p[0] + random.uniform(-noise, noise),
        origin + p[1] + random.uniform(-noise, noise), 0 };
    }
    const double low = origin + random.integer(-1, 2) + 0.5;
    const double high = origin + random.integer(3, 5) + 0.5;
    const double side = std::min(high, origin + 5.5) - std::max(low, origin - 0.5);
    EXPECT_GE(expectRight(sites, { low, high, low, high }).siteIds.size(),
      static_cast<std::size_t>(side * side));
  }
}

/// Each vertex of the grid is two corners or one; an edge of a unit or two has any direction.
TEST(PowerDiagram, CellsOfARotatedGridAreConvex)
{
  for (int step = 1; step <= 15; ++step)
  {
    SCOPED_TRACE(step);
    const double a = angleOf(0.053 * step);
    Cloud sites = squareGrid(15);
    for (Point& p : sites)
    {
      p = { p[0] * std::cos(a) - p[1] * std::sin(a), p[0] * std::sin(a) + p[1] * std::cos(a), 0 };
    }
    EXPECT_FALSE(hasReflexCorner(expectRight(sites, powerDiagramBox(viewOf(sites)))));
  }
}

/// Here doubles are whole numbers, and so are corners, but sites are neighbours.
TEST(PowerDiagram, CellsBelowTheUnitOfTheLastPlaceVanish)
{
  const double origin = 0x1p52;
  Random random(14);
  for (int round = 0; round < 50; ++round)
  {
    const Cloud sites = moved(
      withWeights(smallIntegerSites(300, 0, 25, 0, 0, random), -3, 3, random), origin, origin, 0);
    const Triangulation triangulation = triangulate(sites);
    const Box box = { origin, origin + 25, origin, origin + 25 };
    const PowerDiagram diagram = diagramOf(sites, triangulation, box);
    EXPECT_LT(diagram.siteIds.size(), triangulation.pointIds.size());
    EXPECT_EQ(diagramFault(diagram, sites, triangulation, box), "");
  }
}

// ---- Several tasks' worth of sites -------------------------------------------------------------

const int Many = isSanitized() ? 9000 : 20000;

/// Around each of a hundred places, a ring of sites almost on a circle.
Cloud manyRings()
{
  Random random(72);
  Cloud sites;
  for (int i = 0; i < Many; ++i)
  {
    const double angle = random.uniform(0, 6.28);
    const double place = 10 + 3 * (i % 100);
    sites.push_back({ place + std::cos(angle), place + std::sin(angle), 0 });
  }
  return sites;
}

/// A grid; around its holes facets have up to eight corners and more.
Cloud gridOfMany(bool hasHoles)
{
  Random random(73);
  Cloud sites;
  for (int i = 0; i < Many; ++i)
  {
    if (!hasHoles || random.integer(0, 2) > 0)
    {
      sites.push_back({ i % 200 / 4.0, i / 200 / 4.0, 0 });
    }
  }
  return sites;
}

/// Corners at one position, of cells that different threads make, are one.
TEST(PowerDiagram, OfManySitesOnAnyThreads)
{
  Cloud line;
  for (int i = 0; i < Many; ++i)
  {
    line.push_back({ i / 4.0, i / 8.0, 0 });
  }
  const std::pair<Cloud, Box> cases[] = { { randomSites(Many, 0, 71), { 0.3, 0.7, 0.4, 0.6 } },
    { randomSites(Many, 1.0 / Many, 71), unitBox },
    { randomSites(Many, 27.0 / Many, 5), { -1e12, 1e12, -1e12, 1e12 } },
    // Its lower border goes through corners, whose positions so come of facets and the box.
    { gridOfMany(false), { -1, 60, 0.125, 60 } }, { gridOfMany(true), { 0, 40, 0, 20 } },
    { line, { 0, 40, -1, 20 } }, { manyRings(), { 0, 400, 0, 400 } } };
  for (const auto& [sites, box] : cases)
  {
    const Triangulation triangulation = triangulate(sites);
    const PowerDiagram alone = diagramOf(sites, triangulation, box);
    EXPECT_EQ(diagramFault(alone, sites, triangulation, box), "");
    for (const int threads : threadsTried())
    {
      EXPECT_EQ(bitDifference(diagramOf(sites, triangulation, box, threads), alone), "");
    }
  }
}

TEST(PowerDiagram, TheFirstFaultIsTold)
{
  const Cloud sites = randomSites(Many, 0.0, 71);
  for (const std::int64_t from : { Many / 4, Many / 3, Many / 2 })
  {
    // Two facets are there twice, so no ring closes at their corners.
    Triangulation triangulation = triangulate(sites);
    ASSERT_EQ(triangulation.cellSize, 3);
    std::vector<std::int64_t> corners(
      triangulation.connectivity.begin(), triangulation.connectivity.end());
    for (const std::int64_t lowest : { std::int64_t(Many / 5 * 4), from })
    {
      std::size_t at = 0;
      while (triangulation.connectivity[at] < lowest)
      {
        at += 3;
      }
      corners.insert(corners.end(), triangulation.connectivity.begin() + at,
        triangulation.connectivity.begin() + at + 3);
    }
    const std::int64_t first = triangulation.pointIds[corners[corners.size() - 3]];
    triangulation.connectivity.allocate(corners.size());
    std::copy(corners.begin(), corners.end(), triangulation.connectivity.begin());
    for (const int threads : { 1, 2, 4, 4, 4, 4 })
    {
      expectError(
        [&] { diagramOf(sites, triangulation, unitBox, threads); }, ErrorCode::BadArgument, first);
    }
  }
}

}
}
}
