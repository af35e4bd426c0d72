// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The power cells of a block, from the facets around its points alone, are those of the diagram of
/// all points, bit for bit.
#include "Testing/Engine/Blocks/BlocksInProcess.h"
#include "Testing/Engine/Conformance/Kind.h"
#include <flipflop/PowerDiagram.h>

#include <algorithm>
#include <map>

namespace flipflop
{
namespace test
{

namespace
{

/// By site: the places of a cell's corners, in their order.
using Cells = std::map<std::int64_t, std::vector<double>>;

void addCells(const PowerDiagram& diagram, Cells& cells)
{
  for (std::size_t i = 0; i < diagram.siteIds.size(); ++i)
  {
    std::vector<double>& cell = cells[diagram.siteIds[i]];
    for (auto k = static_cast<std::size_t>(diagram.offsets[i]);
         k < static_cast<std::size_t>(diagram.offsets[i + 1]); ++k)
    {
      const auto corner = static_cast<std::size_t>(diagram.connectivity[k]);
      cell.push_back(diagram.corners[2 * corner]);
      cell.push_back(diagram.corners[2 * corner + 1]);
    }
  }
}

/// The facets that have a corner in a block, in canonical form.
CellComplex facetsAround(const CellComplex& all, const Dealing& dealing, int block)
{
  std::vector<Cell> cells;
  std::vector<std::int64_t> ids;
  for (const Cell& cell : cellsOf(all))
  {
    if (std::any_of(cell.begin(), cell.end(),
          [&](std::int64_t id) { return dealing[static_cast<std::size_t>(id)] == block; }))
    {
      cells.push_back(cell);
      ids.insert(ids.end(), cell.begin(), cell.end());
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  CellComplex facets;
  facets.dimension = all.dimension;
  facets.pointIds.allocate(ids.size());
  std::copy(ids.begin(), ids.end(), facets.pointIds.begin());
  facets.offsets.allocate(cells.size() + 1);
  std::vector<std::int64_t> corners;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    facets.offsets[i] = static_cast<std::int64_t>(corners.size());
    for (const std::int64_t id : cells[i])
    {
      corners.push_back(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
    }
  }
  facets.offsets[cells.size()] = static_cast<std::int64_t>(corners.size());
  facets.connectivity.allocate(corners.size());
  std::copy(corners.begin(), corners.end(), facets.connectivity.begin());
  return facets;
}

/// Whether no cell is broken.
bool expectSameCells(const Cloud& cloud)
{
  Options options;
  options.facets = FacetMode::Polygons;
  const PointView points = viewOf(cloud);
  const WeightView weights = weightsOf(cloud);
  const Triangulation whole = regularTriangulation(points, weights, options);
  if (whole.dimension < 0)
  {
    return true;
  }
  const std::array<double, 4> box = powerDiagramBox(points, whole);
  const int blocks = 4;
  const Dealing dealing = dealInHalves(cloud, blocks, 2);
  Cells found;
  for (int block = 0; block < blocks; ++block)
  {
    const CellComplex facets = facetsAround(whole, dealing, block);
    std::vector<std::uint8_t> wanted;
    for (const std::int64_t id : facets.pointIds)
    {
      wanted.push_back(dealing[static_cast<std::size_t>(id)] == block);
    }
    PowerDiagram cells;
    if (!powerCells(points, weights, facets, wanted.data(), box.data(), cells, options))
    {
      EXPECT_TRUE(cells.siteIds.empty());
      return false;
    }
    addCells(cells, found);
  }
  Cells all;
  addCells(powerDiagram(points, weights, whole, box.data(), options), all);
  EXPECT_EQ(found, all);
  return true;
}

class BlockPowerCells : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(BlockPowerCells, AreThoseOfTheDiagram)
{
  const FamilyOf& of = this->GetParam();
  expectSameCells(of.kind->family(of.name, of.count, 1).make());
}

INSTANTIATE_TEST_SUITE_P(Families, BlockPowerCells,
  ::testing::ValuesIn(familiesOf(regularTriangulations, { 300 })), Named());

TEST(BlockPowerCellsInBulk, SmallIntegers)
{
  const int cases = effort(1000);
  int whole = 0;
  for (int seed = 0; seed < cases; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed) + 1);
    whole += expectSameCells(smallIntegerSites(random.integer(1, 30), 0, 6, -3, 3, random));
  }
  EXPECT_GT(whole, cases * 9 / 10) << "nearly all cells are convex as rounded";
}

}

}
}
