// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Each means of the repair by itself, on cells made by hand; and what polygons are told to be.
#include "PowerDiagram/CellRepair.h"
#include "PowerDiagram/PlanarRings.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/References/Exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace flipflop
{
namespace test
{

namespace
{

using Rings = std::vector<Ring>;
using Positions = std::vector<std::array<double, 2>>;

/// Cells in the box from 0 to 8, by positions and rings.
RoundedCells cellsOf(const Positions& positions, const Rings& rings)
{
  RoundedCells cells;
  for (const auto& x : positions)
  {
    cells.positions.insert(cells.positions.end(), x.begin(), x.end());
  }
  cells.ends.push_back(0);
  for (const Ring& ring : rings)
  {
    cells.corners.insert(cells.corners.end(), ring.begin(), ring.end());
    cells.ends.push_back(static_cast<std::int64_t>(cells.corners.size()));
    cells.ids.push_back(10 * static_cast<std::int64_t>(cells.ids.size()));
  }
  return cells;
}

/// The positions of each cell's corners after the repair, by id / 10.
std::map<std::int64_t, Positions> repaired(const Positions& positions, const Rings& rings)
{
  RoundedCells cells = cellsOf(positions, rings);
  const double box[] = { 0, 8, 0, 8 };
  Options options;
  Monitor monitor(options);
  repairCells(cells, box, monitor);
  std::map<std::int64_t, Positions> result;
  for (std::size_t c = 0; c < cells.ids.size(); ++c)
  {
    for (std::int64_t i = cells.ends[c]; i < cells.ends[c + 1]; ++i)
    {
      const std::uint32_t v = cells.corners[i];
      result[cells.ids[c] / 10].push_back({ cells.positions[2 * v], cells.positions[2 * v + 1] });
    }
  }
  return result;
}

constexpr double Unit = 0x1p-50; // in the last place of numbers from 4 to 8

const Positions box = { { 0, 0 }, { 8, 0 }, { 8, 8 }, { 0, 8 } };

Positions with(Positions more)
{
  more.insert(more.begin(), box.begin(), box.end());
  return more;
}

TEST(CellRepair, ConvexCellsStayAsTheyAre)
{
  // Also with a corner within an edge.
  const Positions positions = with({ { 4, 0 }, { 4, 8 }, { 4, 4 }, { 8, 4 } });
  const Rings rings = { { 5, 3, 0, 4, 6 }, { 6, 4, 1, 7 }, { 7, 2, 5, 6 } };
  const RoundedCells before = cellsOf(positions, rings);
  RoundedCells after = before;
  const double sides[] = { 0, 8, 0, 8 };
  Options options;
  Monitor monitor(options);
  repairCells(after, sides, monitor);
  EXPECT_EQ(after.positions, before.positions);
  EXPECT_EQ(after.corners, before.corners);
  EXPECT_EQ(after.ends, before.ends);
  EXPECT_EQ(after.ids, before.ids);
}

TEST(CellRepair, AShortEdgeAtAReflexCornerIsMerged)
{
  // The middle of the left cell's right side is two corners, one a unit too far to the left.
  const Positions positions =
    with({ { 5, 0 }, { 5, 8 }, { 5 - Unit, 4 + Unit }, { 5, 4 }, { 8, 4 } });
  const auto cells =
    repaired(positions, { { 0, 4, 7, 6, 5, 3 }, { 4, 1, 8, 7 }, { 7, 8, 2, 5, 6 } });
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_EQ(cells.at(0), (Positions{ { 0, 0 }, { 5, 0 }, { 5, 4 }, { 5, 8 }, { 0, 8 } }));
  EXPECT_EQ(cells.at(1), (Positions{ { 5, 0 }, { 8, 0 }, { 8, 4 }, { 5, 4 } }));
  EXPECT_EQ(cells.at(2), (Positions{ { 5, 4 }, { 8, 4 }, { 8, 8 }, { 5, 8 } }));
}

TEST(CellRepair, ALongEdgeAtAReflexCornerStays)
{
  const Positions positions = with({ { 5, 0 }, { 5, 8 }, { 5 - Unit, 4 }, { 8, 4 } });
  const Rings rings = { { 0, 4, 6, 5, 3 }, { 4, 1, 7, 6 }, { 6, 7, 2, 5 } };
  const auto cells = repaired(positions, rings);
  for (std::size_t c = 0; c < rings.size(); ++c)
  {
    Positions expected;
    for (const std::uint32_t v : rings[c])
    {
      expected.push_back(positions[v]);
    }
    EXPECT_EQ(cells.at(static_cast<std::int64_t>(c)), expected);
  }
}

TEST(CellRepair, CornersOfTheBoxDoNotMove)
{
  // The diagonal has a corner two units from its end: that is merged into the box's.
  const auto cells =
    repaired(with({ { 8 - Unit, 8 - 2 * Unit } }), { { 0, 1, 2, 4 }, { 2, 3, 0, 4 } });
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells.at(0), (Positions{ { 0, 0 }, { 8, 0 }, { 8, 8 } }));
  EXPECT_EQ(cells.at(1), (Positions{ { 8, 8 }, { 0, 8 }, { 0, 0 } }));
}

TEST(CellRepair, AFlatCellGoesToANeighbour)
{
  // Three corners on a line: left out; its lower neighbour gets the corner between.
  const Positions positions = with({ { 0, 4 }, { 8, 4 }, { 3, 4 } });
  const auto cells = repaired(positions, { { 4, 0, 1, 5 }, { 4, 5, 6 }, { 4, 6, 5, 2, 3 } });
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells.at(0), (Positions{ { 0, 4 }, { 0, 0 }, { 8, 0 }, { 8, 4 }, { 3, 4 } }));
  EXPECT_EQ(cells.at(2), (Positions{ { 0, 4 }, { 3, 4 }, { 8, 4 }, { 8, 8 }, { 0, 8 } }));
}

TEST(CellRepair, AFlatCellOnASideIsLeftOut)
{
  const Positions positions = with({ { 3, 0 }, { 3, 8 } });
  const auto cells = repaired(positions, { { 0, 1, 4 }, { 0, 4, 5, 3 }, { 4, 1, 2, 5 } });
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells.count(0), 0u);
  EXPECT_EQ(cells.at(1).size(), 4u);
  EXPECT_EQ(cells.at(2).size(), 4u);
}

TEST(CellRepair, TheTipOfANeedleIsCutOff)
{
  // Cell 0 is a wedge from the right side to its tip at (4, 4). Its upper corner beside the tip
  // lies below its lower side, by a unit; further right it is wide. Without the tip it is well.
  const std::array<double, 2> upper = { 4 + 8 * Unit, 4 - 3 * Unit };
  const Positions positions = with({ { 4, 4 }, { 8, 3 }, { 8, 3.05 }, upper, { 0, 5 } });
  const auto cells =
    repaired(positions, { { 4, 5, 6, 7 }, { 0, 1, 5, 4, 8 }, { 8, 4, 7, 6, 2, 3 } });
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_EQ(cells.at(0), (Positions{ { 8, 3 }, { 8, 3.05 }, upper }));
  EXPECT_EQ(cells.at(1), (Positions{ { 0, 0 }, { 8, 0 }, { 8, 3 }, upper, { 4, 4 }, { 0, 5 } }));
  EXPECT_EQ(cells.at(2), (Positions{ { 0, 5 }, { 4, 4 }, upper, { 8, 3.05 }, { 8, 8 }, { 0, 8 } }));
}

TEST(CellRepair, WhatRoundingCannotDoIsRefused)
{
  // A corner beside the diagonal.
  for (const double off : { 0.0, Unit, -2 * Unit, 1e-9, -1e-3, 2.0 })
  {
    RoundedCells cells = cellsOf(with({ { 4, 4 + off } }), { { 0, 1, 2, 4 }, { 2, 3, 0, 4 } });
    const double sides[] = { 0, 8, 0, 8 };
    Options options;
    Monitor monitor(options);
    try
    {
      repairCells(cells, sides, monitor);
      EXPECT_LE(std::fabs(off), 2 * Unit);
      EXPECT_EQ(cells.ids.size(), 2u);
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::BadArgument);
      EXPECT_EQ(error.index(), off > 0 ? 10 : 0);
      EXPECT_GT(std::fabs(off), 2 * Unit);
    }
  }
}

TEST(CellRepair, StopsWhenAsked)
{
  RoundedCells cells = cellsOf(
    with({ { 0, 4 }, { 8, 4 }, { 3, 4 } }), { { 4, 0, 1, 5 }, { 4, 5, 6 }, { 4, 6, 5, 2, 3 } });
  const double sides[] = { 0, 8, 0, 8 };
  Options options;
  options.progress = [](double, void*) { return false; };
  Monitor monitor(options);
  try
  {
    repairCells(cells, sides, monitor);
    ADD_FAILURE() << "not stopped";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Aborted);
  }
}

// ---- Polygons ----------------------------------------------------------------------------------

/// Pairs of edges that touch, one by one, in integers.
std::size_t touchingPairs(const Positions& x)
{
  const std::size_t count = x.size();
  const auto turn = [&x](std::size_t a, std::size_t b, std::size_t c)
  {
    return sign(
      (x[b][0] - x[a][0]) * (x[c][1] - x[a][1]) - (x[b][1] - x[a][1]) * (x[c][0] - x[a][0]));
  };
  const auto within = [&](std::size_t a, std::size_t b, std::size_t p)
  { return turn(a, b, p) == 0 && std::min(x[a], x[b]) <= x[p] && x[p] <= std::max(x[a], x[b]); };
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t j = (i + 1) % count;
    const std::size_t next = (i + 2) % count;
    found += turn(i, j, next) == 0 && !within(i, next, j) ? 1 : 0;
    for (std::size_t k = i + 2; k < count && (k + 1) % count != i; ++k)
    {
      const std::size_t l = (k + 1) % count;
      const bool cross = turn(i, j, k) * turn(i, j, l) < 0 && turn(k, l, i) * turn(k, l, j) < 0;
      found +=
        cross || within(i, j, k) || within(i, j, l) || within(k, l, i) || within(k, l, j) ? 1 : 0;
    }
  }
  return found;
}

TEST(PlanarRings, CrossingsAreThoseOfAllPairs)
{
  Random random(31);
  int convex = 0;
  int simple = 0;
  for (int round = 0; round < 20000; ++round)
  {
    const int range = random.integer(1, 6);
    std::set<std::array<double, 2>> different;
    Positions x;
    for (int i = random.integer(3, 8); i > 0; --i)
    {
      const double u = random.integer(0, range);
      const double v = random.integer(0, range);
      if (different.insert({ u, v }).second)
      {
        x.push_back({ u, v });
      }
    }
    if (x.size() < 3)
    {
      continue;
    }
    std::vector<double> positions;
    Ring ring;
    double area = 0;
    bool reflex = false;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const auto& a = x[i];
      const auto& b = x[(i + 1) % x.size()];
      const auto& c = x[(i + 2) % x.size()];
      positions.insert(positions.end(), a.begin(), a.end());
      ring.push_back(static_cast<std::uint32_t>(i));
      area += a[0] * b[1] - a[1] * b[0];
      reflex = reflex || (b[0] - a[0]) * (c[1] - a[1]) < (b[1] - a[1]) * (c[0] - a[0]);
    }
    const PlanarRings plane(positions);
    const std::size_t crossings = touchingPairs(x);
    ASSERT_EQ(plane.crossings(ring), crossings) << "round " << round;
    ASSERT_EQ(plane.isSimple(ring), crossings == 0 && area > 0) << "round " << round;
    ASSERT_EQ(plane.isConvex(ring.data(), ring.size()), crossings == 0 && area > 0 && !reflex)
      << "round " << round;
    simple += plane.isSimple(ring) ? 1 : 0;
    convex += plane.isConvex(ring.data(), ring.size()) ? 1 : 0;
  }
  EXPECT_GT(convex, 1000);
  EXPECT_GT(simple, convex);
}

TEST(PlanarRings, TurnsAreExactAtAnyRange)
{
  const double tiny = 0x1p-1074;
  const double most = std::numeric_limits<double>::max();
  const std::vector<double> positions = { -most, -most, most, most, 0, tiny, 0, 0, tiny, 0 };
  const PlanarRings plane(positions);
  EXPECT_EQ(plane.orientation(0, 1, 2), 1);
  EXPECT_EQ(plane.orientation(0, 1, 3), 0);
  EXPECT_EQ(plane.orientation(0, 1, 4), -1);
  EXPECT_EQ(plane.orientation(3, 4, 2), 1);
}

}
}
}
