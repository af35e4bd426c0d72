// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Power diagrams in convex polygons: cells fill the polygon edge to edge, and each point of it is
/// in the cell of the site that brute force finds nearest.
#include "Testing/Engine/PowerDiagram/PolygonCells.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"

#include <flipflop/Error.h>
#include <flipflop/RegularTriangulation.h>

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

PowerDiagram diagramOf(const std::vector<double>& sites, const std::vector<double>& weights,
  const ConvexDomain& domain, int threads = 1)
{
  Options options;
  options.threads = threads;
  options.facets = FacetMode::Polygons;
  const auto count = static_cast<std::int64_t>(sites.size() / 2);
  const PointView points(sites.data(), count, 2);
  const WeightView heavy = weights.empty()
    ? WeightView()
    : WeightView(weights.data(), static_cast<std::int64_t>(weights.size()));
  return powerDiagram(points, heavy, regularTriangulation(points, heavy, options), domain, options);
}

PowerDiagram expectFilled(const std::vector<double>& sites, const std::vector<double>& weights,
  const std::vector<double>& polygon)
{
  const ConvexDomain domain(polygon.data(), static_cast<std::int64_t>(polygon.size() / 2));
  PowerDiagram diagram = diagramOf(sites, weights, domain);
  expectFills(diagram, polygon);
  expectNearest(diagram, sites, weights, polygon);
  EXPECT_EQ(bitDifference(diagram, diagramOf(sites, weights, domain, 2)), "");
  return diagram;
}

TEST(PowerDiagramPolygon, RandomSites)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int corners = 3; corners < 12; ++corners)
  {
    std::vector<double> sites;
    std::vector<double> weights;
    for (int i = 0; i < 60; ++i)
    {
      sites.insert(sites.end(), { 3 * unit(random) - 1.5, 3 * unit(random) - 1.5 });
      weights.push_back(0.1 * unit(random));
    }
    expectFilled(sites, {}, regularPolygon(corners, 0.3));
    expectFilled(sites, weights, regularPolygon(corners, 0.7));
  }
}

TEST(PowerDiagramPolygon, Grid)
{
  // Sides through corners of cells, along edges, and across.
  std::vector<double> sites;
  for (int i = 0; i < 12; ++i)
  {
    for (int j = 0; j < 12; ++j)
    {
      sites.insert(sites.end(), { 1.0 * i, 1.0 * j });
    }
  }
  expectFilled(sites, {}, { 0.5, 0.5, 10.5, 0.5, 10.5, 10.5 });
  expectFilled(sites, {}, { 0.0, 5.5, 5.5, 0.0, 11.0, 5.5, 5.5, 11.0 });
  expectFilled(sites, {}, { 0.25, 0.1, 9.3, 1.0 / 3.0, 7.7, 10.1 });
}

TEST(PowerDiagramPolygon, FewSites)
{
  const std::vector<double> polygon = regularPolygon(5, 0.1);
  EXPECT_EQ(expectFilled({ 7.0, 8.0 }, {}, polygon).siteIds.size(), 1u);
  EXPECT_EQ(expectFilled({ 0.0, 0.1, 0.2, 0.1 }, {}, polygon).siteIds.size(), 2u);
  EXPECT_EQ(expectFilled({ 5.0, 0.0, 6.0, 0.0, 9.0, 1.0 }, {}, polygon).siteIds.size(), 1u);
  EXPECT_EQ(diagramOf({}, {}, ConvexDomain(polygon.data(), 5)).siteIds.size(), 0u);
}

TEST(PowerDiagramPolygon, FarFromTheOrigin)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<double> sites;
  for (int i = 0; i < 100; ++i)
  {
    sites.insert(sites.end(), { 1e6 + unit(random), 5e6 + unit(random) });
  }
  std::vector<double> polygon = regularPolygon(7, 0.2);
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    polygon[i] += i % 2 ? 5e6 : 1e6;
  }
  expectFilled(sites, {}, polygon);
}

TEST(PowerDiagramPolygon, StraightCornersAreDropped)
{
  const std::vector<double> sites{ 0.2, 0.3, 0.7, 0.6, 0.4, 0.9 };
  const std::vector<double> plain{ 0, 0, 1, 0, 1, 1, 0, 1 };
  const std::vector<double> more{ 0, 0, 0.5, 0, 1, 0, 1, 1, 0, 1, 0, 0.5 };
  EXPECT_EQ(bitDifference(diagramOf(sites, {}, ConvexDomain(plain.data(), 4)),
              diagramOf(sites, {}, ConvexDomain(more.data(), 6))),
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
    const PowerDiagram diagram = diagramOf(sites, {}, ConvexDomain(polygon.data(), 4));
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
      diagramOf({ 0.1, 0.1, 0.5, 0.2 }, {},
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
