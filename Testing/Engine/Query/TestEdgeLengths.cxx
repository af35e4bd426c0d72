// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells without long edges are those that rationals tell, at every range and at every tie; and
/// cells that are left out leave the others as they were.
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/EdgeLengths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<std::uint8_t> withinOf(const Cloud& sites, const Triangulation& triangulation,
  double limit, const Options& options = Options())
{
  std::vector<std::uint8_t> within(static_cast<std::size_t>(triangulation.cellCount()), 7);
  const std::int64_t count =
    cellsWithinEdgeLength(viewOf(sites), triangulation, limit, within.data(), options);
  EXPECT_EQ(count, std::count(within.begin(), within.end(), 1));
  return within;
}

/// Limits at which something happens: edges' lengths, rounded, and their neighbours.
std::vector<double> limitsAmong(const Cloud& sites, const std::vector<Cell>& cells)
{
  std::vector<double> limits = { 0, std::numeric_limits<double>::denorm_min(), 1e-200, 1, 1e200,
    std::numeric_limits<double>::max() };
  const std::size_t step = std::max<std::size_t>(1, cells.size() / 20);
  for (std::size_t c = 0; c < cells.size(); c += step)
  {
    const Point& a = sites[static_cast<std::size_t>(cells[c].front())];
    const Point& b = sites[static_cast<std::size_t>(cells[c].back())];
    const double length = std::hypot(a[0] - b[0], a[1] - b[1]);
    for (const double limit :
      { std::nextafter(length, 0), length, std::nextafter(length, infinite) })
    {
      if (std::isfinite(limit))
      {
        limits.push_back(limit);
      }
    }
  }
  return limits;
}

class EdgeLengths : public testing::TestWithParam<Input>
{
};

TEST_P(EdgeLengths, AreThoseOfRationals)
{
  const Cloud sites = GetParam().make();
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    const Triangulation triangulation = triangulationOf(sites, facets);
    const std::vector<Cell> cells = cellsOf(triangulation);
    for (const double limit : limitsAmong(sites, cells))
    {
      ASSERT_EQ(withinOf(sites, triangulation, limit), withinByForce(sites, cells, limit)) << limit;
    }
    const auto all = withinOf(sites, triangulation, infinite);
    EXPECT_EQ(std::count(all.begin(), all.end(), 1), triangulation.cellCount());
  }
}

INSTANTIATE_TEST_SUITE_P(OfSites, EdgeLengths, testing::ValuesIn(smallWeightedInputs()));

/// A length that is the limit's, to the last bit, is not longer.
TEST(EdgeLengths, TieStays)
{
  for (const int exponent : { -1070, -600, -300, 0, 300, 600, 1018 })
  {
    const double unit = std::ldexp(1.0, exponent);
    const Cloud sites = { { 0, 0, 0 }, { 3 * unit, 0, 0 }, { 0, 4 * unit, 0 } };
    const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
    ASSERT_EQ(triangulation.cellCount(), 1);
    EXPECT_EQ(withinOf(sites, triangulation, 5 * unit)[0], 1) << exponent;
    EXPECT_EQ(withinOf(sites, triangulation, std::nextafter(5 * unit, 0))[0], 0) << exponent;
  }
  // The same away from the origin, where differences are exact and squares are not.
  const double far = 0x1p52;
  const Cloud sites = { { far, far, 0 }, { far + 300000001.0, far, 0 }, { far, far + 1, 0 } };
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  EXPECT_EQ(withinOf(sites, triangulation, 300000001.0)[0], 0);
  EXPECT_EQ(withinOf(sites, triangulation, 300000001.0 + 0x1p-24)[0], 1);
}

/// Far apart, the difference of coordinates is no double.
TEST(EdgeLengths, RoundedDifferences)
{
  const double least = 0x1p-60;
  const Cloud sites = { { -least, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.25, 0 } };
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  EXPECT_EQ(1.0 + least, 1.0);
  EXPECT_EQ(withinOf(sites, triangulation, 1.0)[0], 0);
  EXPECT_EQ(withinOf(sites, triangulation, std::nextafter(1.0, 2.0))[0], 1);
}

/// A polygon's diagonals are no edges.
TEST(EdgeLengths, OfPolygons)
{
  const Cloud square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  EXPECT_EQ(withinOf(square, triangulationOf(square, FacetMode::Polygons), 1)[0], 1);
  EXPECT_EQ(withinOf(square, triangulationOf(square, FacetMode::Triangles), 1)[0], 0);
}

TEST(EdgeLengths, KeptCells)
{
  Cloud sites = randomSites(60, 0, 13);
  for (int i = 0; i < 16; ++i)
  {
    sites.push_back({ 2.0 + i % 4, 2.0 + i / 4, 0 }); // squares
  }
  Cloud line;
  for (int i = 0; i < 9; ++i)
  {
    line.push_back({ double(i), 0, 0 });
  }
  for (const Cloud& cloud : { sites, line, Cloud{ { 1, 2, 3 } }, Cloud() })
  {
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      for (const int left : { 0, 1, 2, 3 })
      {
        Triangulation triangulation = triangulationOf(cloud, facets);
        const auto ids = triangulation.pointIds.size();
        const std::vector<Cell> cells = cellsOf(triangulation);
        std::vector<std::uint8_t> kept;
        std::vector<Cell> expected;
        for (std::size_t c = 0; c < cells.size(); ++c)
        {
          kept.push_back(left == 1 || (left > 1 && c % 3 == std::size_t(left - 2)) ? 1 : 0);
          if (kept.back())
          {
            expected.push_back(cells[c]);
          }
        }
        keepCells(triangulation, kept.data());
        EXPECT_EQ(cellsOf(triangulation), expected);
        EXPECT_EQ(triangulation.cellCount(), static_cast<std::int64_t>(expected.size()));
        EXPECT_EQ(triangulation.pointIds.size(), ids);
      }
    }
  }
}

TEST(EdgeLengths, Errors)
{
  const Cloud sites = randomSites(20, 0, 11);
  const Triangulation right = triangulationOf(sites, FacetMode::Triangles);
  std::vector<std::uint8_t> within(static_cast<std::size_t>(right.cellCount()));
  for (const double limit : { -1.0, -5e-324, -infinite, std::nan("") })
  {
    expectError([&] { cellsWithinEdgeLength(viewOf(sites), right, limit, within.data()); },
      ErrorCode::BadArgument);
  }
  expectError(
    [&] { cellsWithinEdgeLength(viewOf(sites), right, 1, nullptr); }, ErrorCode::BadArgument);
}

}
}
}
