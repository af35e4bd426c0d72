// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The box that a power diagram has by default; boxes that are none, polygons that are not convex,
/// and triangulations of other points or weights, which are refused.
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/PowerDiagram/DiagramFault.h"
#include "Testing/Engine/Validate/TriangulationClaims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double most = std::numeric_limits<double>::max();
const Box unitBox = { 0, 1, 0, 1 };

Box boxOf(const Cloud& cloud)
{
  return powerDiagramBox(viewOf(cloud), regularTriangulation(viewOf(cloud), weightsOf(cloud)));
}

TEST(PowerDiagramBox, IsThatOfAllPoints)
{
  for (const char* family : { "uniform", "uniformHiding", "oneGiant", "grid", "circle" })
  {
    const Cloud cloud = fromWeightedFamily(family, 500, 3).make();
    const auto x = std::minmax_element(
      cloud.begin(), cloud.end(), [](const Point& a, const Point& b) { return a[0] < b[0]; });
    const auto y = std::minmax_element(
      cloud.begin(), cloud.end(), [](const Point& a, const Point& b) { return a[1] < b[1]; });
    const Box wanted = { (*x.first)[0], (*x.second)[0], (*y.first)[1], (*y.second)[1] };
    EXPECT_EQ(boxOf(cloud), wanted) << family;
    EXPECT_EQ(powerDiagramBox(viewOf(cloud)), wanted) << family;
  }
  const Cloud cloud{ { 0.25, 1, 0 }, { 3, -2, 0 }, { 1, 4.5, 0 } };
  const std::vector<float> floats = floatsOf(cloud);
  EXPECT_EQ(powerDiagramBox(PointView(floats.data(), 3, 3)), (Box{ 0.25, 3, -2, 4.5 }));
}

TEST(PowerDiagramBox, HasAnInside)
{
  EXPECT_EQ(boxOf({ { 5, 7, 0 } }), (Box{ 4.5, 5.5, 6.5, 7.5 }));
  EXPECT_EQ(boxOf({ { 1, 7, 0 }, { 5, 7, 0 } }), (Box{ 1, 5, 5, 9 }));
  EXPECT_EQ(boxOf({ { 1, 7, 0 }, { 1, 8, 0 } }), (Box{ 0.5, 1.5, 7, 8 }));
  for (const double x : { 1e20, 0x1p900, -most, most })
  {
    const Box box = boxOf({ { x, 0, 0 } });
    EXPECT_LT(box[0], box[1]) << x;
    EXPECT_TRUE(box[0] >= -most && box[1] <= most) << x;
  }
  // Of points alone, what is not finite is left out.
  EXPECT_EQ(powerDiagramBox(viewOf(Cloud{ { 9, nan, 0 }, { 5, 7, 0 }, { -HUGE_VAL, 0, 0 } })),
    (Box{ 4.5, 5.5, 6.5, 7.5 }));
  EXPECT_EQ(powerDiagramBox(PointView()), unitBox);
  EXPECT_EQ(powerDiagramBox(viewOf(Cloud{ { nan, nan, 0 } })), unitBox);
}

TEST(PowerDiagramBox, RefusesIdsOutOfRange)
{
  const Cloud cloud{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  Triangulation triangulation = regularTriangulation(viewOf(cloud));
  for (const std::int64_t id : { -1, 3 })
  {
    triangulation.pointIds[1] = id;
    expectError([&] { powerDiagramBox(viewOf(cloud), triangulation); }, ErrorCode::BadArgument, 1);
  }
  expectError([&] { powerDiagramBox(viewOf(cloud), Triangulation()); }, ErrorCode::BadArgument);
}

const Cloud square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };

void expectRefused(const Triangulation& triangulation, const ConvexDomain& domain = unitBox.data())
{
  expectError([&] { powerDiagram(viewOf(square), weightsOf(square), triangulation, domain); },
    ErrorCode::BadArgument);
}

TEST(FacetCenters, AreTheCornersWithinAnyBox)
{
  for (const bool isWeighted : { false, true })
  {
    Random random(7);
    Cloud sites;
    for (int i = 0; i < 200; ++i)
    {
      const double weight = isWeighted ? 1e-3 * static_cast<double>(random.pick(10)) : 0;
      sites.push_back(
        { static_cast<double>(random.pick(30)), static_cast<double>(random.pick(30)), weight });
    }
    Options options;
    options.facets = FacetMode::Polygons;
    const WeightView weights = isWeighted ? weightsOf(sites) : WeightView();
    const Triangulation facets = regularTriangulation(viewOf(sites), weights, options);
    std::vector<double> centers(2 * static_cast<std::size_t>(facets.cellCount()));
    facetCenters(viewOf(sites), weights, facets, centers.data());
    double most = 0;
    for (const double x : centers)
    {
      most = std::max(most, std::fabs(x));
    }
    const double box[4] = { -2 * most, 2 * most, -2 * most, 2 * most };
    const PowerDiagram diagram = powerDiagram(viewOf(sites), weights, facets, box);
    std::set<std::array<double, 2>> corners;
    for (std::size_t i = 0; i < diagram.corners.size(); i += 2)
    {
      corners.insert({ diagram.corners[i], diagram.corners[i + 1] });
    }
    for (std::size_t i = 0; i < centers.size(); i += 2)
    {
      EXPECT_EQ(corners.count({ centers[i], centers[i + 1] }), 1u) << i;
    }
  }
  EXPECT_NO_THROW(facetCenters(PointView(), WeightView(), Triangulation(), nullptr));
}

TEST(PowerDiagramErrors, Boxes)
{
  const Triangulation good = claim(square, 2, { { 0, 1, 2, 3 } });
  EXPECT_EQ(powerDiagram(viewOf(square), WeightView(), good, unitBox.data()).siteIds.size(), 4u);
  expectRefused(good, nullptr);
  for (const Box& wrong : { Box{ 1, 0, 0, 1 }, { 0, 0, 0, 1 }, { 0, 1, 1, 1 }, { nan, 1, 0, 1 },
         { 0, 1, 0, HUGE_VAL }, { -HUGE_VAL, 1, 0, 1 } })
  {
    expectRefused(good, wrong.data());
  }
  expectError([&]
    { powerDiagram(PointView(square[0].data(), 3), WeightView(), good, unitBox.data()); },
    ErrorCode::BadArgument);
}

TEST(PowerDiagramErrors, TriangulationsOfSomethingElse)
{
  const std::pair<int, std::vector<Cell>> claims[] = { { 3, { { 0, 1, 2, 3 } } }, { -1, { { 0 } } },
    { 0, { { 0 }, { 1 } } }, { 1, { { 0 } } }, { 1, { { 0, 1 }, { 0, 2 }, { 0, 3 } } },
    { 1, { { 0, 0 }, { 1, 1 } } }, { 2, { { 0, 1 } } }, { 2, { { 0, 2, 1 } } },
    { 2, { { 0, 1, 2 }, { 0, 1, 3 } } }, { 2, { { 0, 1, 2 }, { 0, 1, 2 } } },
    { 2, { { 0, 0, 1 } } } };
  for (const auto& [dimension, cells] : claims)
  {
    expectRefused(claim(square, dimension, cells));
  }
  const std::function<void(Triangulation&)> changes[] = { [](Triangulation& t)
    { t.connectivity[4] = 4; },
    [](Triangulation& t) { t.connectivity[0] = -1; }, [](Triangulation& t) { t.pointIds[3] = 4; },
    [](Triangulation& t) { t.pointIds[3] = 2; }, [](Triangulation& t) { t.offsets[0] = 1; },
    [](Triangulation& t) { t.offsets[1] = 7; }, [](Triangulation& t) { t.offsets[2] = 5; },
    [](Triangulation& t) { t.cellSize = -1; }, [](Triangulation& t) { t.cellSize = 4; } };
  for (const auto& change : changes)
  {
    Triangulation broken = claim(square, 2, { { 0, 1, 2 }, { 0, 2, 3 } });
    change(broken);
    expectRefused(broken);
  }
}

/// Corners of another diagram than the triangulation's turn cells over.
TEST(PowerDiagramErrors, OtherWeights)
{
  const double polygon[] = { 0, 0, 1, 0, 1, 1, 0, 1 };
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Triangulation of = regularTriangulation(viewOf(randomSites(200, 0, seed)));
    const Cloud sites = randomSites(200, 1, seed);
    for (const ConvexDomain& domain : { ConvexDomain(unitBox.data()), ConvexDomain(polygon, 4) })
    {
      expectError(
        [&] { powerDiagram(viewOf(sites), weightsOf(sites), of, domain); }, ErrorCode::BadArgument);
    }
  }
}

TEST(PowerDiagramErrors, PolygonsThatAreNotConvex)
{
  std::vector<double> star; // goes around twice
  for (int i = 0; i < 5; ++i)
  {
    star.insert(star.end(), { std::cos(i * 0.8 * M_PI), std::sin(i * 0.8 * M_PI) });
  }
  const std::pair<std::vector<double>, std::int64_t> cases[] = { { { 0, 0, 1, 0, nan, 1 }, 2 },
    { { 0, 0, 1, 0 }, 0 }, { { 0, 0, 1, 0, 2, 0 }, 0 }, { { 0, 0, 0, 1, 1, 0 }, 0 },
    { { 0, 0, 1, 0, 1, 0, 0, 1 }, 2 }, { { 0, 0, 2, 0, 1, 0.5, 2, 2, 0, 2 }, 2 }, { star, -1 } };
  const Triangulation good = claim(square, 2, { { 0, 1, 2, 3 } });
  for (const auto& [polygon, index] : cases)
  {
    const ConvexDomain domain(polygon.data(), static_cast<std::int64_t>(polygon.size() / 2));
    expectError([&] { powerDiagram(viewOf(square), WeightView(), good, domain); },
      ErrorCode::NotConvex, index);
  }
}

}
}
}
