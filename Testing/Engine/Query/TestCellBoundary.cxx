// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rings of a border are simple, run along each edge that only one cell has, with the cell on
/// their left, and come in their canonical order.
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Query/PlaneQueries.h"
#include "Testing/Engine/Validate/TriangulationClaims.h"

#include <flipflop/CellBoundary.h>
#include <flipflop/EdgeLengths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace flipflop
{
namespace test
{

namespace
{

std::vector<Cell> ringsOf(const CellComplex& cells)
{
  const CellBoundary boundary = cellBoundary(cells);
  std::vector<Cell> rings;
  for (std::int64_t i = 0; i < boundary.ringCount(); ++i)
  {
    rings.emplace_back();
    for (std::int64_t k = boundary.offsets[i]; k < boundary.offsets[i + 1]; ++k)
    {
      rings.back().push_back(cells.pointIds[boundary.connectivity[k]]);
    }
  }
  return rings;
}

Rational twiceAreaOf(const Cloud& sites, const Cell& ring)
{
  Rational twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Point& a = sites[static_cast<std::size_t>(ring[i])];
    const Point& b = sites[static_cast<std::size_t>(ring[(i + 1) % ring.size()])];
    twice += Rational(a[0]) * b[1] - Rational(a[1]) * b[0];
  }
  return twice;
}

/// All that CellBoundary promises of some cells.
void expectRings(const Cloud& sites, const CellComplex& cells)
{
  std::multiset<std::pair<std::int64_t, std::int64_t>> sides;
  Rational area = 0;
  for (const Cell& cell : cellsOf(cells))
  {
    area += twiceAreaOf(sites, cell);
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      sides.insert({ cell[i], cell[(i + 1) % cell.size()] });
    }
  }
  std::set<std::pair<std::int64_t, std::int64_t>> border;
  for (const auto& side : sides)
  {
    if (sides.count({ side.second, side.first }) == 0)
    {
      border.insert(side);
    }
  }
  const std::vector<Cell> rings = ringsOf(cells);
  Rational enclosed = 0;
  for (const Cell& ring : rings)
  {
    EXPECT_GE(ring.size(), 3u);
    EXPECT_EQ(std::set<std::int64_t>(ring.begin(), ring.end()).size(), ring.size());
    EXPECT_EQ(*std::min_element(ring.begin(), ring.end()), ring.front());
    enclosed += twiceAreaOf(sites, ring);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      EXPECT_EQ(border.erase({ ring[i], ring[(i + 1) % ring.size()] }), 1u);
    }
  }
  EXPECT_TRUE(border.empty());
  EXPECT_EQ(enclosed, area);
  EXPECT_TRUE(std::is_sorted(rings.begin(), rings.end()));
}

TEST(CellBoundary, OfRandomCells)
{
  Cloud sites = randomSites(60, 1e-3, 5);
  for (int i = 0; i < 36; ++i)
  {
    sites.push_back({ 2.0 + i % 6, 2.0 + i / 6, 0 }); // squares
  }
  Random random(6);
  for (int round = 0; round < effort(200); ++round)
  {
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      Triangulation triangulation = triangulationOf(sites, facets);
      std::vector<std::uint8_t> kept;
      for (std::int64_t c = 0; c < triangulation.cellCount(); ++c)
      {
        kept.push_back(random.integer(0, 9) < round % 11 ? 1 : 0);
      }
      keepCells(triangulation, kept.data());
      expectRings(sites, triangulation);
      ASSERT_FALSE(testing::Test::HasFailure()) << "round " << round;
    }
  }
}

TEST(CellBoundary, OfAllIsTheHull)
{
  const Cloud sites = randomSites(5000, 0, 7);
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  EXPECT_EQ(ringsOf(triangulation).size(), 1u);
  expectRings(sites, triangulation);
}

/// Squares of a grid, by their lower left corners.
CellComplex squares(int side, const std::vector<std::int64_t>& corners)
{
  CellComplex complex;
  complex.dimension = 2;
  complex.cellSize = 4;
  complex.pointIds.allocate(static_cast<std::size_t>(side * side));
  for (std::size_t i = 0; i < complex.pointIds.size(); ++i)
  {
    complex.pointIds[i] = static_cast<std::int64_t>(i);
  }
  complex.connectivity.allocate(4 * corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const std::int64_t from = corners[i];
    const std::int64_t cell[4] = { from, from + 1, from + side + 1, from + side };
    std::copy(cell, cell + 4, complex.connectivity.begin() + 4 * i);
  }
  return complex;
}

/// Points are 0 to 3 in the lowest row, and so on.
TEST(CellBoundary, Pinches)
{
  // Two squares that meet in a corner.
  EXPECT_EQ(ringsOf(squares(4, { 0, 5 })), (std::vector<Cell>{ { 0, 1, 5, 4 }, { 5, 6, 10, 9 } }));
  // A ring of squares around a hole.
  EXPECT_EQ(ringsOf(squares(4, { 0, 1, 2, 4, 6, 8, 9, 10 })),
    (std::vector<Cell>{ { 0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4 }, { 5, 9, 10, 6 } }));
  // The same without a corner's square: the hole touches the outer border in 5.
  EXPECT_EQ(ringsOf(squares(4, { 1, 2, 4, 6, 8, 9, 10 })),
    (std::vector<Cell>{ { 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4, 5 }, { 5, 9, 10, 6 } }));
  // Two holes that meet in a corner.
  EXPECT_EQ(ringsOf(squares(5, { 0, 1, 2, 3, 5, 7, 8, 10, 11, 13, 15, 16, 17, 18 })).size(), 3u);
}

TEST(CellBoundary, BelowDimensionTwo)
{
  for (const Cloud& sites :
    { Cloud(), Cloud{ { 1, 2, 0 } }, Cloud{ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } } })
  {
    EXPECT_EQ(cellBoundary(triangulationOf(sites, FacetMode::Triangles)).ringCount(), 0);
  }
}

TEST(CellBoundary, Errors)
{
  const Cloud sites = randomSites(20, 0, 11);
  Triangulation turned = triangulationOf(sites, FacetMode::Triangles);
  std::swap(turned.connectivity[1], turned.connectivity[2]); // along its neighbours' sides
  expectError([&] { cellBoundary(turned); }, ErrorCode::BadArgument);
  // An edge of three cells, which run along it both ways.
  expectError(
    [] {
      cellBoundary(claim(Cloud(5), 2, { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 1, 4 } }));
    },
    ErrorCode::BadArgument);
}

}
}
}
