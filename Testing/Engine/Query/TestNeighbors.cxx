// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Neighbours share the edge that each names the other for, and no edge with a partner is left out.
#include "Testing/Engine/Query/QueryCases.h"
#include <flipflop/Neighbors.h>
#include <flipflop/RegularTriangulation.h>

#include <map>

namespace flipflop
{
namespace test
{

namespace
{

/// By a map from directed edges to cells; a segment's ends are edges from a corner to itself.
std::vector<std::int64_t> neighborsByMap(const CellComplex& complex)
{
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::int64_t>> cellsOn;
  std::vector<std::pair<std::int64_t, std::pair<std::int64_t, std::int64_t>>> entries;
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    const std::int64_t begin = complex.cellBegin(cell);
    const std::int64_t end = complex.cellBegin(cell + 1);
    for (std::int64_t k = begin; k < end; ++k)
    {
      const std::int64_t a = complex.connectivity[static_cast<std::size_t>(k)];
      const std::int64_t b =
        complex.connectivity[static_cast<std::size_t>(k + 1 < end ? k + 1 : begin)];
      const auto edge = complex.dimension < 2 ? std::make_pair(a, a)
                                              : std::make_pair(std::min(a, b), std::max(a, b));
      cellsOn[edge].push_back(cell);
      entries.emplace_back(cell, edge);
    }
  }
  std::vector<std::int64_t> result;
  for (const auto& [cell, edge] : entries)
  {
    const std::vector<std::int64_t>& cells = cellsOn[edge];
    EXPECT_LE(cells.size(), 2u);
    result.push_back(cells.size() == 1 ? -1 : cells[0] == cell ? cells[1] : cells[0]);
  }
  return result;
}

std::vector<std::int64_t> neighborsOf(const CellComplex& complex)
{
  const Buffer<std::int64_t> found = cellNeighbors(complex);
  return std::vector<std::int64_t>(found.begin(), found.end());
}

TEST(Neighbors, OfHulls)
{
  for (const auto& [name, cloud] : queryClouds())
  {
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      const Hull hull = hullOf(cloud, facets);
      const std::vector<std::int64_t> found = neighborsOf(hull);
      EXPECT_EQ(found, neighborsByMap(hull)) << name;
      EXPECT_EQ(std::count(found.begin(), found.end(), -1) > 0, hull.dimension < 3) << name;
    }
  }
}

TEST(Neighbors, OfTriangulations)
{
  for (const char* name : { "ball", "smallIntegers", "planeXyz0" })
  {
    for (const int count : { 1, 2, 3, 4, 50, 900 })
    {
      const Cloud cloud = fromFamily(name, count, 3).make();
      for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
      {
        Options options;
        options.facets = facets;
        const Triangulation triangulation =
          regularTriangulation(viewOf(cloud), WeightView(), options);
        const std::vector<std::int64_t> found = neighborsOf(triangulation);
        EXPECT_EQ(found, neighborsByMap(triangulation)) << name;
        EXPECT_GT(std::count(found.begin(), found.end(), -1), 0) << name;
      }
    }
  }
}

TEST(Neighbors, OfAChain)
{
  const Cloud cloud = { { 3, 3, 0 }, { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } };
  const Triangulation chain = regularTriangulation(viewOf(cloud), WeightView());
  ASSERT_EQ(chain.dimension, 1);
  // Cells 0-3, 1-2, 2-3.
  EXPECT_EQ(neighborsOf(chain), (std::vector<std::int64_t>{ -1, 2, -1, 2, 1, 0 }));
}

TEST(Neighbors, OfNothing)
{
  EXPECT_TRUE(cellNeighbors(Hull()).empty());
}

TEST(Neighbors, OfALargeHull)
{
  const Cloud cloud = fromFamily("shell0", effort(9000), 6).make();
  const Hull hull = hullOf(cloud, FacetMode::Triangles);
  EXPECT_EQ(neighborsOf(hull), neighborsByMap(hull));
}

TEST(Neighbors, AnEdgeOfThreeCellsIsAnError)
{
  Hull hull;
  hull.dimension = 3;
  hull.cellSize = 3;
  hull.pointIds.allocate(5);
  for (int i = 0; i < 5; ++i)
  {
    hull.pointIds[static_cast<std::size_t>(i)] = i;
  }
  const std::int64_t corners[] = { 0, 1, 2, 1, 2, 3, 1, 2, 4 };
  hull.connectivity.allocate(9);
  std::copy(corners, corners + 9, hull.connectivity.begin());
  expectError([&] { cellNeighbors(hull); }, ErrorCode::BadArgument, 0);
  hull.connectivity[8] = 7;
  expectError([&] { cellNeighbors(hull); }, ErrorCode::BadArgument, -1);
}

}
}
}
