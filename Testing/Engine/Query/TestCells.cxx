// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lengths, measures and borders of cells: ties, pinches, cells left out, and what is refused. On
/// every kind of sites they are compared with their definitions in TestPlaneResults.
#include "Testing/Engine/Query/PlaneQueries.h"
#include "Testing/Engine/Validate/TriangulationClaims.h"

#include <flipflop/EdgeLengths.h>
#include <flipflop/Measures.h>
#include <flipflop/PowerDiagram.h>

#include <gtest/gtest.h>

#include <functional>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

// ---- Edges' lengths ----------------------------------------------------------------------------

/// Is the one cell of the sites within the limit?
bool isWithin(const Cloud& sites, double limit, FacetMode facets = FacetMode::Triangles)
{
  const Triangulation triangulation = triangulationOf(sites, facets);
  std::uint8_t within[2] = { 7, 7 };
  cellsWithinEdgeLength(viewOf(sites), triangulation, limit, within);
  return within[0] != 0;
}

/// A length that is the limit's, to the last bit, is not longer.
TEST(EdgeLengths, TieStays)
{
  for (const int exponent : { -1070, -600, -300, 0, 300, 600, 1018 })
  {
    const double unit = std::ldexp(1.0, exponent);
    const Cloud sites = { { 0, 0, 0 }, { 3 * unit, 0, 0 }, { 0, 4 * unit, 0 } };
    EXPECT_TRUE(isWithin(sites, 5 * unit)) << exponent;
    EXPECT_FALSE(isWithin(sites, std::nextafter(5 * unit, 0))) << exponent;
  }
  // The same away from the origin, where differences are exact and squares are not.
  const double far = 0x1p52;
  const Cloud sites = { { far, far, 0 }, { far + 300000001.0, far, 0 }, { far, far + 1, 0 } };
  EXPECT_FALSE(isWithin(sites, 300000001.0));
  EXPECT_TRUE(isWithin(sites, 300000001.0 + 0x1p-24));
  // Far apart, the difference of coordinates is no double.
  const Cloud apart = { { -0x1p-60, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.25, 0 } };
  EXPECT_FALSE(isWithin(apart, 1.0));
  EXPECT_TRUE(isWithin(apart, std::nextafter(1.0, 2.0)));
}

TEST(EdgeLengths, OfPolygonsAreThoseOfTheirSides)
{
  const Cloud square = squareGrid(2);
  EXPECT_TRUE(isWithin(square, 1, FacetMode::Polygons));
  EXPECT_FALSE(isWithin(square, 1, FacetMode::Triangles));
}

TEST(EdgeLengths, BadArguments)
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

// ---- Cells that are left out, and borders ------------------------------------------------------

/// Some at random, and squares beside them.
Cloud sitesAndSquares()
{
  return joined(randomSites(60, 1e-3, 5), moved(squareGrid(6), 2, 2, 0));
}

TEST(CellBoundary, OfCellsThatAreKept)
{
  const Cloud line = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 } };
  Random random(6);
  for (int round = 0; round < effort(200); ++round)
  {
    for (const Cloud& sites : { sitesAndSquares(), line, Cloud{ { 1, 2, 3 } }, Cloud() })
    {
      for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
      {
        Triangulation triangulation = triangulationOf(sites, facets);
        const std::size_t ids = triangulation.pointIds.size();
        std::vector<std::uint8_t> kept;
        std::vector<Cell> wanted;
        for (const Cell& cell : cellsOf(triangulation))
        {
          kept.push_back(random.integer(0, 9) < round % 11 ? 1 : 0);
          if (kept.back())
          {
            wanted.push_back(cell);
          }
        }
        keepCells(triangulation, kept.data());
        EXPECT_EQ(cellsOf(triangulation), wanted);
        EXPECT_EQ(triangulation.cellCount(), static_cast<std::int64_t>(wanted.size()));
        EXPECT_EQ(triangulation.pointIds.size(), ids);
        ASSERT_EQ(ringsFault(cellBoundary(triangulation), triangulation), "") << "round " << round;
      }
    }
  }
}

/// Of squares of a grid, by their lower left corners, the rings; by numbers of the grid's points.
std::vector<Cell> ringsOf(int side, const std::vector<std::int64_t>& corners)
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
  const CellBoundary boundary = cellBoundary(complex);
  EXPECT_EQ(ringsFault(boundary, complex), "");
  std::vector<Cell> rings;
  for (std::int64_t i = 0; i < boundary.ringCount(); ++i)
  {
    rings.emplace_back(boundary.connectivity.begin() + boundary.offsets[i],
      boundary.connectivity.begin() + boundary.offsets[i + 1]);
  }
  return rings;
}

/// Points are 0 to 3 in the lowest row, and so on.
TEST(CellBoundary, Pinches)
{
  const Cell around = { 0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4 };
  const Cell hole = { 5, 9, 10, 6 };
  // Two squares that meet in a corner.
  EXPECT_EQ(ringsOf(4, { 0, 5 }), (std::vector<Cell>{ { 0, 1, 5, 4 }, { 5, 6, 10, 9 } }));
  // A ring of squares around a hole.
  EXPECT_EQ(ringsOf(4, { 0, 1, 2, 4, 6, 8, 9, 10 }), (std::vector<Cell>{ around, hole }));
  // The same without a corner's square: the hole touches the outer border in 5.
  EXPECT_EQ(ringsOf(4, { 1, 2, 4, 6, 8, 9, 10 }),
    (std::vector<Cell>{ { 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4, 5 }, hole }));
  // Two holes that meet in a corner.
  EXPECT_EQ(ringsOf(5, { 0, 1, 2, 3, 5, 7, 8, 10, 11, 13, 15, 16, 17, 18 }).size(), 3u);
}

TEST(CellBoundary, BadCells)
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

// ---- Measures ----------------------------------------------------------------------------------

PowerDiagram diagramOf(const Cloud& sites)
{
  const double box[] = { 0.25, 1, -0.5, 1.25 };
  return powerDiagram(
    viewOf(sites), weightsOf(sites), triangulationOf(sites, FacetMode::Polygons), box);
}

TEST(Measures, OfPowerCells)
{
  for (const double weight : { 0.0, 0.01 })
  {
    const PowerDiagram diagram = diagramOf(randomSites(300, weight, 8));
    const std::size_t count = diagram.siteIds.size();
    std::vector<double> areas(count);
    std::vector<double> centroids(2 * count);
    cellMeasures(diagram, areas.data(), centroids.data());
    for (std::size_t c = 0; c < count; ++c)
    {
      std::vector<Point> corners;
      for (std::int64_t i = diagram.offsets[c]; i < diagram.offsets[c + 1]; ++i)
      {
        const double* const x =
          diagram.corners.data() + 2 * diagram.connectivity[static_cast<std::size_t>(i)];
        corners.push_back({ x[0], x[1], 0 });
      }
      EXPECT_EQ(measuresFault(corners, areas[c], &centroids[2 * c]), "") << c;
    }
  }
}

TEST(Measures, OneAlone)
{
  const Cloud sites = randomSites(20, 0, 9);
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const auto count = static_cast<std::size_t>(triangulation.cellCount());
  std::vector<double> areas(count), centroids(2 * count), alone(count), others(2 * count);
  cellMeasures(viewOf(sites), triangulation, areas.data(), centroids.data());
  cellMeasures(viewOf(sites), triangulation, alone.data(), nullptr);
  cellMeasures(viewOf(sites), triangulation, nullptr, others.data());
  EXPECT_EQ(areas, alone);
  EXPECT_EQ(centroids, others);
  cellMeasures(viewOf(sites), triangulation, nullptr, nullptr);
  cellMeasures(PowerDiagram(), nullptr, nullptr);
}

TEST(Measures, BadDiagrams)
{
  const std::function<void(PowerDiagram&)> changes[] = { [](PowerDiagram& d) { d.offsets[0] = 1; },
    [](PowerDiagram& d) { d.offsets[1] = 0; }, [](PowerDiagram& d) { d.offsets.truncate(3); },
    [](PowerDiagram& d) { d.offsets[2] = 1000000; },
    [](PowerDiagram& d) { d.connectivity[2] = -1; },
    [](PowerDiagram& d) { d.connectivity[2] = static_cast<std::int64_t>(d.corners.size()) / 2; },
    [](PowerDiagram& d) { d.corners[1] = std::nan(""); } };
  for (const auto& change : changes)
  {
    PowerDiagram diagram = diagramOf(randomSites(20, 0, 11));
    change(diagram);
    expectError([&] { cellMeasures(diagram, nullptr, nullptr); }, ErrorCode::BadArgument);
  }
}

}
}
}
