// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Each means of the repair by itself, on cells made by hand in the box from 0 to 8.
#include "PowerDiagram/CellRepair.h"
#include "PowerDiagram/PlanarRings.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace flipflop
{
namespace test
{

namespace
{

using Positions = std::vector<std::array<double, 2>>;
using Cells = std::map<std::int64_t, Positions>; ///< corners by id

const std::vector<double> Box = { 0, 0, 8, 0, 8, 8, 0, 8 };
constexpr double Unit = 0x1p-50; // in the last place of numbers from 4 to 8

/// @param more positions behind the corners of the box
RoundedCells cellsOf(const Positions& more, const std::vector<Ring>& rings)
{
  RoundedCells cells;
  cells.positions = { 0, 0, 8, 0, 8, 8, 0, 8 };
  for (const auto& x : more)
  {
    cells.positions.insert(cells.positions.end(), x.begin(), x.end());
  }
  cells.ends.push_back(0);
  for (const Ring& ring : rings)
  {
    cells.corners.insert(cells.corners.end(), ring.begin(), ring.end());
    cells.ends.push_back(static_cast<std::int64_t>(cells.corners.size()));
    cells.ids.push_back(static_cast<std::int64_t>(cells.ids.size()));
  }
  return cells;
}

Cells repaired(RoundedCells cells, const std::vector<double>& polygon = Box)
{
  Options options;
  Monitor monitor(options);
  repairCells(cells, polygon, monitor);
  Cells result;
  for (std::size_t c = 0; c < cells.ids.size(); ++c)
  {
    for (std::int64_t i = cells.ends[c]; i < cells.ends[c + 1]; ++i)
    {
      const std::uint32_t v = cells.corners[i];
      result[cells.ids[c]].push_back({ cells.positions[2 * v], cells.positions[2 * v + 1] });
    }
  }
  return result;
}

struct Case
{
  const char* name;
  Positions positions;
  std::vector<Ring> rings;
  Cells expected;
};

constexpr std::array<double, 2> BesideTip = { 4 + 8 * Unit, 4 - 3 * Unit };

const Case cases[] = {
  { "a corner within an edge: as it is", { { 4, 0 }, { 4, 8 }, { 4, 4 }, { 8, 4 } },
    { { 5, 3, 0, 4, 6 }, { 6, 4, 1, 7 }, { 7, 2, 5, 6 } },
    { { 0, { { 4, 8 }, { 0, 8 }, { 0, 0 }, { 4, 0 }, { 4, 4 } } },
      { 1, { { 4, 4 }, { 4, 0 }, { 8, 0 }, { 8, 4 } } },
      { 2, { { 8, 4 }, { 8, 8 }, { 4, 8 }, { 4, 4 } } } } },
  { "a short edge at a reflex corner: merged",
    { { 5, 0 }, { 5, 8 }, { 5 - Unit, 4 + Unit }, { 5, 4 }, { 8, 4 } },
    { { 0, 4, 7, 6, 5, 3 }, { 4, 1, 8, 7 }, { 7, 8, 2, 5, 6 } },
    { { 0, { { 0, 0 }, { 5, 0 }, { 5, 4 }, { 5, 8 }, { 0, 8 } } },
      { 1, { { 5, 0 }, { 8, 0 }, { 8, 4 }, { 5, 4 } } },
      { 2, { { 5, 4 }, { 8, 4 }, { 8, 8 }, { 5, 8 } } } } },
  { "a long edge at a reflex corner: as it is", { { 5, 0 }, { 5, 8 }, { 5 - Unit, 4 }, { 8, 4 } },
    { { 0, 4, 6, 5, 3 }, { 4, 1, 7, 6 }, { 6, 7, 2, 5 } },
    { { 0, { { 0, 0 }, { 5, 0 }, { 5 - Unit, 4 }, { 5, 8 }, { 0, 8 } } },
      { 1, { { 5, 0 }, { 8, 0 }, { 8, 4 }, { 5 - Unit, 4 } } },
      { 2, { { 5 - Unit, 4 }, { 8, 4 }, { 8, 8 }, { 5, 8 } } } } },
  { "a short edge at a corner of the box, which does not move", { { 8 - Unit, 8 - 2 * Unit } },
    { { 0, 1, 2, 4 }, { 2, 3, 0, 4 } },
    { { 0, { { 0, 0 }, { 8, 0 }, { 8, 8 } } }, { 1, { { 8, 8 }, { 0, 8 }, { 0, 0 } } } } },
  { "a flat cell: its neighbour gets the corner between", { { 0, 4 }, { 8, 4 }, { 3, 4 } },
    { { 4, 0, 1, 5 }, { 4, 5, 6 }, { 4, 6, 5, 2, 3 } },
    { { 0, { { 0, 4 }, { 0, 0 }, { 8, 0 }, { 8, 4 }, { 3, 4 } } },
      { 2, { { 0, 4 }, { 3, 4 }, { 8, 4 }, { 8, 8 }, { 0, 8 } } } } },
  { "a flat cell on a side: left out", { { 3, 0 }, { 3, 8 } },
    { { 0, 1, 4 }, { 0, 4, 5, 3 }, { 4, 1, 2, 5 } },
    { { 1, { { 0, 0 }, { 3, 0 }, { 3, 8 }, { 0, 8 } } },
      { 2, { { 3, 0 }, { 8, 0 }, { 8, 8 }, { 3, 8 } } } } },
  { "a needle whose upper side is below its lower one at the tip: without the tip",
    { { 4, 4 }, { 8, 3 }, { 8, 3.05 }, BesideTip, { 0, 5 } },
    { { 4, 5, 6, 7 }, { 0, 1, 5, 4, 8 }, { 8, 4, 7, 6, 2, 3 } },
    { { 0, { { 8, 3 }, { 8, 3.05 }, BesideTip } },
      { 1, { { 0, 0 }, { 8, 0 }, { 8, 3 }, BesideTip, { 4, 4 }, { 0, 5 } } },
      { 2, { { 0, 5 }, { 4, 4 }, BesideTip, { 8, 3.05 }, { 8, 8 }, { 0, 8 } } } } },
};

TEST(CellRepair, OfEachKind)
{
  for (const Case& c : cases)
  {
    EXPECT_EQ(repaired(cellsOf(c.positions, c.rings)), c.expected) << c.name;
  }
}

TEST(CellRepair, CornersOfAPolygonDoNotMove)
{
  const std::vector<double> polygon = { 0, 0, 8, 0, 7, 7, 0, 8 };
  const RoundedCells cells =
    cellsOf({ { 7, 7 }, { 7 - Unit, 7 - 2 * Unit } }, { { 0, 1, 4, 5 }, { 4, 3, 0, 5 } });
  const Cells expected = { { 0, { { 0, 0 }, { 8, 0 }, { 7, 7 } } },
    { 1, { { 7, 7 }, { 0, 8 }, { 0, 0 } } } };
  EXPECT_EQ(repaired(cells, polygon), expected);
}

TEST(CellRepair, WhatRoundingCannotDoIsRefused)
{
  // A corner beside the diagonal.
  for (const double off : { 0.0, Unit, -2 * Unit, 1e-9, -1e-3, 2.0 })
  {
    const RoundedCells cells = cellsOf({ { 4, 4 + off } }, { { 0, 1, 2, 4 }, { 2, 3, 0, 4 } });
    try
    {
      EXPECT_EQ(repaired(cells).size(), 2u);
      EXPECT_LE(std::fabs(off), 2 * Unit);
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::BadArgument);
      EXPECT_EQ(error.index(), off > 0 ? 1 : 0);
      EXPECT_GT(std::fabs(off), 2 * Unit);
    }
  }
}

}
}
}
