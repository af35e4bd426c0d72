// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Convex polygons that bend by nearly nothing, or not at all; and polygons that are refused.
#include "Testing/Engine/PowerDiagram/PolygonCells.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"
#include "Testing/Engine/Transport/TransportCases.h"

#include <flipflop/Error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using namespace flipflop;
using namespace flipflop::test;

PowerDiagram diagramOf(const Numbers& sites, const ConvexDomain& domain)
{
  return cellsOf(sites, WeightView(), domain);
}

TEST(PowerDiagramPolygon, StraightCornersAreDropped)
{
  const std::vector<double> sites{ 0.2, 0.3, 0.7, 0.6, 0.4, 0.9 };
  const std::vector<double> plain{ 0, 0, 1, 0, 1, 1, 0, 1 };
  const std::vector<double> more{ 0, 0, 0.5, 0, 1, 0, 1, 1, 0, 1, 0, 0.5 };
  EXPECT_EQ(bitDifference(diagramOf(sites, ConvexDomain(plain.data(), 4)),
              diagramOf(sites, ConvexDomain(more.data(), 6))),
    "");
}

TEST(PowerDiagramPolygon, ABendOfNearlyNone)
{
  // Sites on a circle, and sides through its center, where nearly all cells meet.
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 40; ++trial)
  {
    std::vector<double> sites;
    for (int i = 0; i < 10 + 4 * trial; ++i)
    {
      const double angle = 6.3 * unit(random);
      sites.insert(sites.end(), { 0.5 * std::cos(angle) + 0.5, 0.5 * std::sin(angle) + 0.5 });
    }
    const double off = 0x1p-52 * trial;
    const std::vector<double> polygon{ 0.5 + off, 0.5 + off, -1, 2, -1, -1, 2, -1 };
    const PowerDiagram diagram = diagramOf(sites, ConvexDomain(polygon.data(), 4));
    std::vector<double> areas(diagram.siteIds.size());
    cellMeasures(diagram, areas.data(), nullptr);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 4.5, 1e-12);
  }
}

TEST(PowerDiagramPolygon, BadDomains)
{
  const auto expectCode = [](const std::vector<double>& polygon, ErrorCode code, std::int64_t index)
  {
    try
    {
      diagramOf({ 0.1, 0.1, 0.5, 0.2 },
        ConvexDomain(polygon.data(), static_cast<std::int64_t>(polygon.size() / 2)));
      ADD_FAILURE() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), code);
      EXPECT_EQ(error.index(), index);
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectCode({ 0, 0, 1, 0, nan, 1 }, ErrorCode::NotConvex, 2);
  expectCode({ 0, 0, 1, 0 }, ErrorCode::NotConvex, 0);
  expectCode({ 0, 0, 1, 0, 2, 0 }, ErrorCode::NotConvex, 0);
  expectCode({ 0, 0, 0, 1, 1, 0 }, ErrorCode::NotConvex, 0);
  expectCode({ 0, 0, 1, 0, 1, 0, 0, 1 }, ErrorCode::NotConvex, 2);
  expectCode({ 0, 0, 2, 0, 1, 0.5, 2, 2, 0, 2 }, ErrorCode::NotConvex, 2);
  // A star goes around twice.
  std::vector<double> star;
  for (int i = 0; i < 5; ++i)
  {
    star.insert(star.end(), { std::cos(i * 0.8 * M_PI), std::sin(i * 0.8 * M_PI) });
  }
  expectCode(star, ErrorCode::NotConvex, -1);
}

}
