// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells that no polygon's side parts are one region, and each side says of the regions beside it
/// whether they are inside. No coordinate is looked at.
#include <flipflop/ConstrainedTriangulation.h>

#include "PowerDiagram/TriangulationInput.h"
#include "Query/QueryRun.h"
#include "Surface/Sides.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

class Regions
{
public:
  explicit Regions(std::uint32_t cells)
    : up(cells)
  {
    for (std::uint32_t c = 0; c < cells; ++c)
    {
      this->up[c] = c;
    }
  }

  /// The lowest cell of the region.
  std::uint32_t operator()(std::uint32_t cell)
  {
    for (; this->up[cell] != cell; cell = this->up[cell])
    {
      this->up[cell] = this->up[this->up[cell]];
    }
    return cell;
  }

  void join(std::uint32_t a, std::uint32_t b)
  {
    a = (*this)(a);
    b = (*this)(b);
    this->up[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> up;
};

/// What an edge says of a cell beside it.
struct Vote
{
  std::uint32_t cell;
  std::uint32_t edge; ///< among the fixed ones
  bool isInside;
};

class InsideFinder
{
public:
  InsideFinder(const ConstrainedTriangulation& given, Monitor& toTell)
    : triangulation(given)
    , monitor(toTell)
    , cells(static_cast<std::size_t>(given.cellCount()))
    , regions(static_cast<std::uint32_t>(this->cells))
  {
    const std::size_t edges = given.constraintOf.size();
    const auto points = static_cast<std::int64_t>(given.pointIds.size());
    if (given.fixedEdges.size() != 2 * edges || given.balance.size() != edges ||
      std::any_of(given.fixedEdges.begin(), given.fixedEdges.end(),
        [points](std::int64_t corner) { return corner < 0 || corner >= points; }))
    {
      throw badArgument("the fixed edges must be as constrainedTriangulation() returned them");
    }
  }

  void find(std::uint8_t* inside)
  {
    // Below dimension 2 nothing is inside of anything: all stays.
    if (this->triangulation.dimension == 2)
    {
      this->lookAtEdges();
    }
    constexpr std::uint32_t None = NoIndex;
    std::vector<std::uint32_t> first(this->cells, None); // vote, by region
    for (std::size_t i = 0; i < this->votes.size(); ++i)
    {
      std::uint32_t& of = first[this->regions(this->votes[i].cell)];
      of = of == None ? static_cast<std::uint32_t>(i) : of;
      if (this->votes[of].isInside != this->votes[i].isInside)
      {
        const std::int64_t* const ends =
          this->triangulation.fixedEdges.data() + 2 * std::size_t(this->votes[i].edge);
        throw Error(ErrorCode::PolygonsDisagree,
          this->triangulation.pointIds[static_cast<std::size_t>(ends[0])],
          this->triangulation.pointIds[static_cast<std::size_t>(ends[1])]);
      }
    }
    for (std::size_t c = 0; c < this->cells; ++c)
    {
      const std::uint32_t vote = first[this->regions(static_cast<std::uint32_t>(c))];
      inside[c] = vote == None || this->votes[vote].isInside ? 1 : 0;
    }
  }

private:
  /// Edges and fixed edges are both in lexicographic order, so they are met side by side.
  void lookAtEdges()
  {
    const ConstrainedTriangulation& given = this->triangulation;
    Buffer<std::uint32_t> cellOf;
    Buffer<CellSide> sides = sidesOf(given, cellOf);
    StepPoll poll(this->monitor);
    std::uint32_t fixed = 0;
    const auto isBefore = [&given](std::uint32_t edge, const CellSide& side)
    {
      const auto low = static_cast<std::uint32_t>(given.fixedEdges[2 * std::size_t(edge)]);
      const auto high = static_cast<std::uint32_t>(given.fixedEdges[2 * std::size_t(edge) + 1]);
      return std::make_pair(low, high) < std::make_pair(side.low, side.high);
    };
    const auto count = static_cast<std::uint32_t>(given.constraintOf.size());
    eachEdge(sides,
      [&](const CellSide* begin, const CellSide* end)
      {
        poll.step();
        while (fixed < count && isBefore(fixed, *begin))
        {
          ++fixed;
        }
        const bool isFixed = fixed < count &&
          given.fixedEdges[2 * std::size_t(fixed)] == begin->low &&
          given.fixedEdges[2 * std::size_t(fixed) + 1] == begin->high;
        const std::int64_t balance = isFixed ? given.balance[fixed] : 0;
        for (const CellSide* side = begin; side != end; ++side)
        {
          const std::uint32_t cell = cellOf[side->place];
          if (balance != 0)
          {
            // A cell is on the left of its own sides.
            const bool isAlong = this->corner(side->place) == side->low;
            this->votes.push_back({ cell, fixed, isAlong == (balance > 0) });
          }
          else
          {
            this->regions.join(cellOf[begin->place], cell);
          }
        }
      });
  }

  std::uint32_t corner(std::size_t i) const
  {
    return static_cast<std::uint32_t>(this->triangulation.connectivity[i]);
  }

  const ConstrainedTriangulation& triangulation;
  Monitor& monitor;
  const std::size_t cells;
  Regions regions;
  std::vector<Vote> votes; ///< in the order of the edges
};

}

std::int64_t cellsInside(
  const ConstrainedTriangulation& triangulation, std::uint8_t* inside, const Options& options)
{
  const std::int64_t cells = triangulation.cellCount();
  if (cells > 0 && !inside)
  {
    throw badArgument("inside must have room for one byte a cell: a null pointer was given");
  }
  runOver(static_cast<std::size_t>(cells), options,
    [&](Monitor& monitor)
    {
      checkCells(triangulation);
      InsideFinder(triangulation, monitor).find(inside);
    });
  return static_cast<std::int64_t>(std::count(inside, inside + cells, std::uint8_t(1)));
}

}
