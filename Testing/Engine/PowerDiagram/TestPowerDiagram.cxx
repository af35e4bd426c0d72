// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Power diagrams fill the box, agree with the power distance, and share their corners.
/// Sites are a Cloud of (x, y, weight); their triangulations come from CGAL.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"

#include <flipflop/PowerDiagram.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace flipflop
{
namespace test
{

namespace
{

struct Box
{
  double side[4];
};
constexpr Box unitBox = { { 0, 1, 0, 1 } };

Point at(double x, double y, double weight)
{
  return { x, y, weight };
}

Triangulation triangulate(const Cloud& sites)
{
  const ReferenceTriangulation found = cgalTriangulation(sites, kernelForWeighted(sites));
  return makeTriangulation(found, static_cast<std::int64_t>(sites.size()));
}

long double areaOf(const PowerDiagram& diagram, std::size_t cell)
{
  long double area = 0;
  const std::int64_t begin = diagram.offsets[cell];
  const std::int64_t end = diagram.offsets[cell + 1];
  const auto at = [&](std::int64_t i, int axis)
  { return static_cast<long double>(diagram.corners[2 * diagram.connectivity[i] + axis]); };
  for (std::int64_t i = begin + 1; i + 1 < end; ++i)
  {
    area += (at(i, 0) - at(begin, 0)) * (at(i + 1, 1) - at(begin, 1)) -
      (at(i, 1) - at(begin, 1)) * (at(i + 1, 0) - at(begin, 0));
  }
  return area / 2;
}

/// The form, and that the cells fill the box edge to edge.
void expectPartition(const PowerDiagram& diagram, const Box& box)
{
  const std::size_t cells = diagram.siteIds.size();
  const std::int64_t corners = static_cast<std::int64_t>(diagram.corners.size()) / 2;
  ASSERT_EQ(diagram.offsets.size(), cells + 1);
  ASSERT_EQ(diagram.offsets[0], 0);
  ASSERT_EQ(diagram.offsets[cells], static_cast<std::int64_t>(diagram.connectivity.size()));
  EXPECT_TRUE(std::is_sorted(diagram.siteIds.begin(), diagram.siteIds.end()));
  std::set<std::array<double, 2>> positions;
  for (std::int64_t i = 0; i < corners; ++i)
  {
    const double* p = diagram.corners.data() + 2 * i;
    ASSERT_TRUE(
      p[0] >= box.side[0] && p[0] <= box.side[1] && p[1] >= box.side[2] && p[1] <= box.side[3]);
    EXPECT_TRUE(positions.insert({ p[0], p[1] }).second) << "a position has two numbers";
  }
  std::int64_t used = 0;
  std::map<std::pair<std::int64_t, std::int64_t>, int> edges;
  long double area = 0;
  for (std::size_t c = 0; c < cells; ++c)
  {
    const std::int64_t begin = diagram.offsets[c];
    const std::int64_t end = diagram.offsets[c + 1];
    ASSERT_GE(end - begin, 3);
    for (std::int64_t i = begin; i < end; ++i)
    {
      const std::int64_t a = diagram.connectivity[i];
      const std::int64_t b = diagram.connectivity[i + 1 < end ? i + 1 : begin];
      ASSERT_TRUE(a >= 0 && a <= used) << "corners come in order of first use";
      used = std::max(used, a + 1);
      EXPECT_NE(a, b);
      EXPECT_EQ((++edges[{ a, b }]), 1);
    }
    EXPECT_GT(areaOf(diagram, c), 0);
    area += areaOf(diagram, c);
  }
  EXPECT_EQ(used, corners);
  const long double whole = (static_cast<long double>(box.side[1]) - box.side[0]) *
    (static_cast<long double>(box.side[3]) - box.side[2]);
  EXPECT_NEAR(static_cast<double>(area / whole), 1.0, 1e-12);
  for (const auto& edge : edges)
  {
    const std::int64_t a = edge.first.first;
    const std::int64_t b = edge.first.second;
    bool border = false;
    for (int k = 0; k < 4; ++k)
    {
      border = border ||
        (diagram.corners[2 * a + k / 2] == box.side[k] &&
          diagram.corners[2 * b + k / 2] == box.side[k]);
    }
    EXPECT_EQ(edges.count({ b, a }), border ? 0u : 1u);
  }
}

/// Points of the box lie in the cell of the site of least power distance.
void expectLeastPower(const PowerDiagram& diagram, const Cloud& sites, const Box& box, int samples)
{
  const std::map<std::int64_t, Polygon> polygons = polygonsOf(diagram);
  Random random(71);
  const double width = box.side[1] - box.side[0];
  const double height = box.side[3] - box.side[2];
  int tested = 0;
  for (int s = 0; s < samples; ++s)
  {
    const double x = random.uniform(box.side[0], box.side[1]);
    const double y = random.uniform(box.side[2], box.side[3]);
    // Sites of least power, and the second of those that have cells: hidden ones may be level.
    long double least = HUGE_VALL;
    long double second = HUGE_VALL;
    long double nearest = HUGE_VALL;
    const Polygon* polygon = nullptr;
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      const long double u = static_cast<long double>(x) - sites[i][0];
      const long double v = static_cast<long double>(y) - sites[i][1];
      const long double power = u * u + v * v - sites[i][2];
      least = std::min(least, power);
      const auto found = polygons.find(static_cast<std::int64_t>(i));
      if (found == polygons.end())
      {
        continue;
      }
      second = std::min(second, std::max(power, nearest));
      if (power < nearest)
      {
        nearest = power;
        polygon = &found->second;
      }
    }
    ASSERT_TRUE(polygon && nearest <= least + 1e-15L) << "the nearest site has no cell";
    if (second - nearest < 1e-9L * width * height)
    {
      continue;
    }
    ++tested;
    for (std::size_t i = 0; i < polygon->size(); ++i)
    {
      const auto& a = (*polygon)[i];
      const auto& b = (*polygon)[(i + 1) % polygon->size()];
      const double turn = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
      ASSERT_GT(turn, -1e-14 * width * height);
    }
  }
  EXPECT_GT(tested, samples / 2);
}

PowerDiagram diagramOf(const Cloud& sites, const Triangulation& triangulation, const Box& box)
{
  PowerDiagram diagram = powerDiagram(viewOf(sites), weightsOf(sites), triangulation, box.side);
  expectPartition(diagram, box);
  for (const std::int64_t id : diagram.siteIds)
  {
    EXPECT_TRUE(
      std::binary_search(triangulation.pointIds.begin(), triangulation.pointIds.end(), id));
  }
  return diagram;
}

Cloud gridSites(int side)
{
  Cloud sites;
  for (int i = 0; i < side * side; ++i)
  {
    sites.push_back(at(i % side, i / side, 0));
  }
  return sites;
}

/// In how many cells every corner is, by position.
std::map<std::array<double, 2>, int> degreesOf(const PowerDiagram& diagram)
{
  std::map<std::array<double, 2>, int> result;
  for (const std::int64_t corner : diagram.connectivity)
  {
    ++result[{ diagram.corners[2 * corner], diagram.corners[2 * corner + 1] }];
  }
  return result;
}

TEST(PowerDiagram, AGridHasSquareCells)
{
  const int side = 7;
  const Cloud sites = gridSites(side);
  const Box box = { { -0.5, side - 0.5, -0.5, side - 0.5 } };
  const PowerDiagram diagram = diagramOf(sites, triangulate(sites), box);
  ASSERT_EQ(diagram.siteIds.size(), static_cast<std::size_t>(side * side));
  for (const auto& cell : polygonsOf(diagram))
  {
    const double x = sites[cell.first][0];
    const double y = sites[cell.first][1];
    const Polygon square = { { x - 0.5, y - 0.5 }, { x + 0.5, y - 0.5 }, { x + 0.5, y + 0.5 },
      { x - 0.5, y + 0.5 } };
    EXPECT_EQ(cell.second, square);
  }
  for (const auto& corner : degreesOf(diagram))
  {
    int sides = 0;
    for (int k = 0; k < 4; ++k)
    {
      sides += corner.first[k / 2] == box.side[k] ? 1 : 0;
    }
    EXPECT_EQ(corner.second, 4 >> sides);
  }
}

TEST(PowerDiagram, ABoxAlongCellsCutsNoSlivers)
{
  // The sides run along edges of the diagram, or through corners.
  const Cloud sites = gridSites(6);
  const Triangulation triangulation = triangulate(sites);
  const PowerDiagram aligned = diagramOf(sites, triangulation, { { 0.5, 3.5, 1.5, 4.5 } });
  EXPECT_EQ(aligned.siteIds.size(), 9u);
  EXPECT_EQ(aligned.corners.size(), 32u);
  const PowerDiagram between = diagramOf(sites, triangulation, { { 1, 3, 1.5, 4 } });
  EXPECT_EQ(between.siteIds.size(), 9u);
  EXPECT_EQ(between.corners.size(), 32u);
  // Within one cell: the box itself.
  const PowerDiagram within = diagramOf(sites, triangulation, { { 1.75, 2.25, 2.5, 3.25 } });
  ASSERT_EQ(within.siteIds.size(), 1u);
  EXPECT_EQ(within.siteIds[0], 3 * 6 + 2);
  EXPECT_EQ(within.connectivity.size(), 4u);
}

TEST(PowerDiagram, CocircularSitesMeetInOneCorner)
{
  // All integer points at distance 65 of (100, 100): 36 of them.
  Cloud sites;
  for (int x = -65; x <= 65; ++x)
  {
    for (int y = -65; y <= 65; ++y)
    {
      if (x * x + y * y == 65 * 65)
      {
        sites.push_back(at(100 + x, 100 + y, 0));
      }
    }
  }
  const PowerDiagram diagram = diagramOf(sites, triangulate(sites), { { 0, 200, 10, 190 } });
  EXPECT_EQ(diagram.siteIds.size(), 36u);
  const auto degrees = degreesOf(diagram);
  const std::array<double, 2> center = { 100, 100 };
  ASSERT_EQ(degrees.count(center), 1u);
  for (const auto& corner : degrees)
  {
    EXPECT_TRUE(corner.first == center ? corner.second == 36 : corner.second <= 2);
  }
  expectLeastPower(diagram, sites, { { 0, 200, 10, 190 } }, 500);
}

TEST(PowerDiagram, RandomSitesFillTheBox)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const int count = seed % 4 == 0 ? 3 : static_cast<int>(3 * seed * seed);
    for (const double weight : { 0.0, 0.19 / count, 27.0 / count })
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", weight " + std::to_string(weight));
      const Cloud sites = randomSites(count, weight, seed);
      const Triangulation triangulation = triangulate(sites);
      for (const Box& box : { unitBox, Box{ { -3, 5, -2, 2 } }, Box{ { 0.25, 0.5, 0.3, 0.8 } },
             Box{ { 2, 2.5, 0, 10 } } })
      {
        const PowerDiagram diagram = diagramOf(sites, triangulation, box);
        expectLeastPower(diagram, sites, box, 100);
      }
    }
  }
}

TEST(PowerDiagram, ManySites)
{
  // Of the engine's own triangulation.
  const int count = 20000;
  Options options;
  options.facets = FacetMode::Polygons;
  for (const double weight : { 0.0, 0.19 / count, 27.0 / count })
  {
    const Cloud sites = randomSites(count, weight, 5);
    const Triangulation triangulation =
      regularTriangulation(viewOf(sites), weightsOf(sites), options);
    const PowerDiagram diagram = diagramOf(sites, triangulation, unitBox);
    expectLeastPower(diagram, sites, unitBox, 200);
    // Without a box in the way, every visible site has its cell.
    const PowerDiagram all = diagramOf(sites, triangulation, { { -1e12, 1e12, -1e12, 1e12 } });
    EXPECT_EQ(all.siteIds.size(), triangulation.pointIds.size());
  }
}

TEST(PowerDiagram, SmallLatticesAreFullOfTies)
{
  Random random(9);
  for (int round = 0; round < 300; ++round)
  {
    Cloud sites;
    const int range = random.integer(1, 6);
    const int count = random.integer(3, 30);
    for (int i = 0; i < count; ++i)
    {
      sites.push_back(
        at(random.integer(0, range), random.integer(0, range), random.integer(0, range)));
    }
    sites.push_back(at(0, 0, 0));
    sites.push_back(at(range, 0, 0));
    sites.push_back(at(0, range, 0));
    SCOPED_TRACE("round " + std::to_string(round));
    const Triangulation triangulation = triangulate(sites);
    for (int b = 0; b < 6; ++b)
    {
      const double x = random.integer(-2, 2 * range) / 2.0;
      const double y = random.integer(-2, 2 * range) / 2.0;
      const Box box = { { x, x + random.integer(1, range + 4) / 2.0, y,
        y + random.integer(1, range + 4) / 2.0 } };
      const PowerDiagram diagram = diagramOf(sites, triangulation, box);
      expectLeastPower(diagram, sites, box, 20);
    }
  }
}

TEST(PowerDiagram, OneSiteHasTheBox)
{
  Cloud sites;
  sites.push_back(at(5, 5, 0));
  sites.push_back(at(70, 7, 1e300));
  const PowerDiagram diagram = diagramOf(sites, triangulate(sites), unitBox);
  ASSERT_EQ(diagram.siteIds.size(), 1u);
  EXPECT_EQ(diagram.siteIds[0], 1);
  const Polygon square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  EXPECT_EQ(polygonsOf(diagram).begin()->second, square);
}

TEST(PowerDiagram, NoSiteHasNoCell)
{
  const PowerDiagram diagram =
    powerDiagram(PointView(), WeightView(), Triangulation(), unitBox.side);
  EXPECT_EQ(diagram.siteIds.size(), 0u);
  EXPECT_EQ(diagram.corners.size(), 0u);
  EXPECT_EQ(diagram.offsets.size(), 1u);
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
        sites.push_back(at(step[0] * i, step[1] * i, i % 2 ? 0.25 : 0));
      }
      for (const Box& box : { Box{ { -20, 20, -20, 20 } }, Box{ { 0, 1, 0, 1 } },
             Box{ { -1, 1.5, -1, 0.5 } }, Box{ { 3, 4, 7, 9 } }, Box{ { 0.5, 2.5, -0.5, 2.5 } } })
      {
        const PowerDiagram diagram = diagramOf(sites, triangulate(sites), box);
        expectLeastPower(diagram, sites, box, 100);
        for (const auto& cell : polygonsOf(diagram))
        {
          EXPECT_LE(cell.second.size(), 6u);
        }
      }
    }
  }
  Cloud row;
  row.push_back(at(0, 0, 0));
  row.push_back(at(1, 0, 0));
  row.push_back(at(2, 0, 0));
  const PowerDiagram diagram = diagramOf(row, triangulate(row), { { -1, 3, -1, 1 } });
  EXPECT_EQ(diagram.connectivity.size(), 12u);
  EXPECT_EQ(diagram.corners.size(), 16u);
}

TEST(PowerDiagram, PowersOfTwoScaleTheCorners)
{
  const Cloud sites = randomSites(300, 0.05, 8);
  const Triangulation triangulation = triangulate(sites);
  const PowerDiagram diagram = diagramOf(sites, triangulation, unitBox);
  for (const int exponent : { 20, -20, 100, -100, 300, -300, 500, -480 })
  {
    const double factor = std::ldexp(1.0, exponent);
    const Cloud larger = [&]
    {
      Cloud result = sites;
      for (Point& p : result)
      {
        p = { p[0] * factor, p[1] * factor, std::ldexp(p[2], 2 * exponent) };
      }
      return result;
    }();
    const double box[] = { 0, factor, 0, factor };
    const PowerDiagram other = powerDiagram(viewOf(larger), weightsOf(larger), triangulation, box);
    EXPECT_TRUE(std::equal(other.connectivity.begin(), other.connectivity.end(),
      diagram.connectivity.begin(), diagram.connectivity.end()));
    ASSERT_EQ(other.corners.size(), diagram.corners.size());
    for (std::size_t i = 0; i < other.corners.size(); ++i)
    {
      EXPECT_EQ(other.corners[i], diagram.corners[i] * factor);
    }
  }
}

TEST(PowerDiagram, ExtremeRanges)
{
  // Tiny beside huge: half of 1e-300 is a corner, and so is half of 1e300.
  Cloud sites = { { 0, 0, 0 }, { 1e-300, 0, 0 }, { 0, 1e300, 0 }, { -1e300, 0, 0 } };
  Box box = { { -1e300, 1e300, -1e300, 1e300 } };
  PowerDiagram diagram = diagramOf(sites, triangulate(sites), box);
  EXPECT_EQ(diagram.siteIds.size(), 4u);
  const auto degrees = degreesOf(diagram);
  EXPECT_EQ(degrees.count({ 5e-301, 5e299 }), 1u);
  EXPECT_EQ(degrees.count({ -5e299, 5e299 }), 1u);

  // A center beyond all doubles.
  sites = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1e-320, 0 } };
  box = { { -1, 3, -1, 1 } };
  diagram = diagramOf(sites, triangulate(sites), box);
  EXPECT_EQ(diagram.connectivity.size(), 12u);
  expectLeastPower(diagram, sites, box, 200);

  // The box as large as boxes get.
  const double most = std::numeric_limits<double>::max();
  sites = randomSites(50, 0.1, 3);
  const Triangulation triangulation = triangulate(sites);
  const double whole[] = { -most, most, -most, most };
  diagram = powerDiagram(viewOf(sites), weightsOf(sites), triangulation, whole);
  EXPECT_EQ(diagram.siteIds.size(), triangulation.pointIds.size());
  for (const double corner : diagram.corners)
  {
    EXPECT_TRUE(std::isfinite(corner));
  }
}

TEST(PowerDiagram, GiantWeights)
{
  // Of two heavy sites one has the box; a heavy one hides the light ones around it.
  Cloud sites = { { 0, 0, 1e300 }, { 1, 0, 1.0000001e300 } };
  PowerDiagram diagram = diagramOf(sites, triangulate(sites), unitBox);
  ASSERT_EQ(diagram.siteIds.size(), 1u);
  EXPECT_EQ(diagram.siteIds[0], 1);

  sites = randomSites(100, 0.01, 4);
  sites[17][2] = 1e200;
  diagram = diagramOf(sites, triangulate(sites), unitBox);
  ASSERT_EQ(diagram.siteIds.size(), 1u);
  EXPECT_EQ(diagram.siteIds[0], 17);

  // Negative weights are weights.
  sites = randomSites(100, -0.02, 5);
  const Box box = { { -1, 2, -1, 2 } };
  diagram = diagramOf(sites, triangulate(sites), box);
  expectLeastPower(diagram, sites, box, 200);
}

TEST(PowerDiagram, CellsBelowTheUnitOfTheLastPlaceVanish)
{
  // Here doubles are whole numbers, and so are corners, but sites are neighbours.
  const double origin = 0x1p52;
  Random random(14);
  for (int round = 0; round < 50; ++round)
  {
    Cloud sites;
    for (int i = 0; i < 300; ++i)
    {
      sites.push_back(
        { origin + random.integer(0, 25), origin + random.integer(0, 25), random.uniform(-3, 3) });
    }
    const Triangulation triangulation = triangulate(sites);
    const double box[] = { origin, origin + 25, origin, origin + 25 };
    const PowerDiagram diagram = powerDiagram(viewOf(sites), weightsOf(sites), triangulation, box);
    EXPECT_LT(diagram.siteIds.size(), triangulation.pointIds.size());
    std::set<std::array<double, 2>> positions;
    for (std::size_t i = 0; i < diagram.corners.size(); i += 2)
    {
      EXPECT_TRUE(positions.insert({ diagram.corners[i], diagram.corners[i + 1] }).second);
    }
    for (std::size_t c = 0; c < diagram.siteIds.size(); ++c)
    {
      EXPECT_GT(areaOf(diagram, c), 0);
    }
  }
}

}
}
}
