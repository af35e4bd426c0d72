// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The power cells of a block, from the facets around its points alone, are those of the diagram of
/// all points, bit for bit.
#include "Testing/Engine/Blocks/BlocksInProcess.h"
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/Validate/TriangulationClaims.h"
#include <flipflop/PowerDiagram.h>

#include <algorithm>
#include <map>

namespace flipflop
{
namespace test
{

namespace
{

/// By site: the corners of a cell, in their order.
using Cells = std::map<std::int64_t, std::vector<double>>;

void addCells(const PowerDiagram& diagram, Cells& cells)
{
  for (std::size_t i = 0; i < diagram.siteIds.size(); ++i)
  {
    for (std::int64_t k = diagram.offsets[i]; k < diagram.offsets[i + 1]; ++k)
    {
      const double* const x =
        diagram.corners.data() + 2 * diagram.connectivity[static_cast<std::size_t>(k)];
      cells[diagram.siteIds[i]].insert(cells[diagram.siteIds[i]].end(), x, x + 2);
    }
  }
}

/// The facets that have a corner in a block, in canonical form.
Triangulation facetsAround(
  const Cloud& cloud, const CellComplex& all, const Dealing& dealing, int block)
{
  std::vector<Cell> cells = cellsOf(all);
  cells.erase(std::remove_if(cells.begin(), cells.end(),
                [&](const Cell& cell)
                {
                  return std::none_of(cell.begin(), cell.end(),
                    [&](std::int64_t id)
                    { return dealing[static_cast<std::size_t>(id)] == block; });
                }),
    cells.end());
  return claim(cloud, all.dimension, cells);
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
    const Triangulation facets = facetsAround(cloud, whole, dealing, block);
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
