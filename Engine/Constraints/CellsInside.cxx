// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells that no polygon's side parts are one region. By the even-odd rule, the sides between a
/// region and the outside count; by direction, each side says of the regions next to it whether
/// they are inside. No coordinate is examined.
#include <flipflop/ConstrainedTriangulation.h>

#include "Mesh/VertexStars.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

/// Cells in regions; of two cells of one region, it is decided whether an odd number of sides parts
/// them.
class Regions
{
public:
  explicit Regions(std::uint32_t cells)
    : links(cells)
  {
    for (std::uint32_t c = 0; c < cells; ++c)
    {
      this->links[c] = { c, false };
    }
  }

  /// The lowest cell of the region, and whether an odd number of sides parts this cell from it.
  std::pair<std::uint32_t, bool> operator()(std::uint32_t cell)
  {
    bool isOdd = false;
    while (this->links[cell].up != cell)
    {
      Link& link = this->links[cell];
      const Link& above = this->links[link.up];
      link = { above.up, link.isOdd != above.isOdd };
      isOdd = isOdd != link.isOdd;
      cell = link.up;
    }
    return { cell, isOdd };
  }

  /// @return false: they are of one region, in which they are parted otherwise
  bool join(std::uint32_t a, std::uint32_t b, bool areParted)
  {
    const auto [rootA, oddA] = (*this)(a);
    const auto [rootB, oddB] = (*this)(b);
    const bool isOdd = (oddA != oddB) != areParted;
    this->links[std::max(rootA, rootB)] = { std::min(rootA, rootB), rootA != rootB && isOdd };
    return rootA != rootB || !isOdd;
  }

private:
  struct Link
  {
    std::uint32_t up;
    bool isOdd; ///< an odd number of sides parts them
  };
  std::vector<Link> links;
};

/// Whether the cell next to a fixed edge is inside, by the direction of the edge.
struct Vote
{
  std::uint32_t cell;
  std::uint32_t edge; ///< among the fixed ones
  bool isInside;
};

class InsideFinder
{
public:
  InsideFinder(const ConstrainedTriangulation& given, Monitor& monitorToUse)
    : triangulation(given)
    , monitor(monitorToUse)
    , cells(static_cast<std::uint32_t>(given.cellCount()))
  {
    const std::size_t edges = given.constraintOf.size();
    const auto points = static_cast<std::int64_t>(given.pointIds.size());
    if (given.sides < 0 || given.fixedEdges.size() != 2 * edges || given.balance.size() != edges ||
      given.sideOf.size() != edges ||
      std::any_of(given.fixedEdges.begin(), given.fixedEdges.end(),
        [points](std::int64_t corner) { return corner < 0 || corner >= points; }))
    {
      throw badArgument("the fixed edges must be as constrainedTriangulation() returned them");
    }
  }

  void find(PolygonRule rule, std::uint8_t* inside)
  {
    // Below dimension 2 nothing is inside of anything: all stays.
    if (this->triangulation.dimension < 2 || this->triangulation.sides == 0)
    {
      std::fill_n(inside, this->cells, std::uint8_t(1));
    }
    else if (rule == PolygonRule::EvenOdd)
    {
      this->findOdd(inside);
    }
    else
    {
      this->findLeft(inside);
    }
  }

private:
  /// What an odd number of sides parts from the outside.
  void findOdd(std::uint8_t* inside)
  {
    const std::uint32_t outside = this->cells;
    Regions regions(this->cells + 1);
    this->eachEdge(
      [&](const LinkedEdge& edge, std::uint32_t fixed)
      {
        const std::uint32_t first = this->cellOf(edge.sides[0]);
        bool fits = edge.count > 1 || regions.join(first, outside, this->isOdd(fixed));
        for (std::size_t i = 1; fits && i < edge.count; ++i)
        {
          fits = regions.join(first, this->cellOf(edge.sides[i]), this->isOdd(fixed));
        }
        if (!fits)
        {
          throw badArgument("the sides of polygons must close: an even number of them ends at each "
                            "point");
        }
      });
    const auto out = regions(outside);
    for (std::uint32_t c = 0; c < this->cells; ++c)
    {
      const auto own = regions(c);
      inside[c] = own.first == out.first && own.second != out.second ? 1 : 0;
    }
  }

  /// What is on the left of sides.
  void findLeft(std::uint8_t* inside)
  {
    Regions regions(this->cells);
    std::vector<Vote> votes; // in the order of the edges
    this->eachEdge(
      [&](const LinkedEdge& edge, std::uint32_t fixed)
      {
        const std::int64_t balance = this->balanceOf(fixed);
        for (std::size_t i = 0; i < edge.count; ++i)
        {
          const std::uint32_t cell = this->cellOf(edge.sides[i]);
          if (balance != 0)
          {
            // A cell is on the left of its own sides.
            const bool isAlong = this->stars->of().origin(edge.sides[i]) == edge.low;
            votes.push_back({ cell, fixed, isAlong == (balance > 0) });
          }
          else
          {
            regions.join(this->cellOf(edge.sides[0]), cell, false);
          }
        }
      });
    std::vector<const Vote*> first(this->cells, nullptr); // by region
    for (const Vote& vote : votes)
    {
      const Vote*& known = first[regions(vote.cell).first];
      known = known ? known : &vote;
      if (known->isInside != vote.isInside)
      {
        this->throwDisagreement(*known, vote);
      }
    }
    for (std::uint32_t c = 0; c < this->cells; ++c)
    {
      const Vote* const vote = first[regions(c).first];
      inside[c] = !vote || vote->isInside ? 1 : 0;
    }
  }

  /// Both are of one region, which an even number of sides parts: the even-odd rule says which of
  /// them is wrong.
  [[noreturn]] void throwDisagreement(const Vote& one, const Vote& other)
  {
    std::vector<std::uint8_t> isOdd(this->cells);
    this->findOdd(isOdd.data());
    const bool isOneRight = one.isInside == (isOdd[one.cell] != 0);
    const auto sideOf = [this](const Vote& vote) { return this->triangulation.sideOf[vote.edge]; };
    throw Error(ErrorCode::PolygonsDisagree, sideOf(isOneRight ? other : one),
      sideOf(isOneRight ? one : other));
  }

  /// use (LinkedEdge, fixed edge or NoIndex) for each edge. Edges and fixed edges are both in
  /// lexicographic order, so they are met side by side.
  template <class Use>
  void eachEdge(const Use& use)
  {
    const Buffer<std::int64_t>& ends = this->triangulation.fixedEdges;
    const auto count = static_cast<std::uint32_t>(this->triangulation.constraintOf.size());
    StepPoll poll(this->monitor);
    std::uint32_t fixed = 0;
    if (!this->stars)
    {
      this->stars.emplace(CellSides(this->triangulation));
    }
    this->stars->eachEdge(
      [&](const LinkedEdge& edge)
      {
        poll.step();
        const std::pair<std::int64_t, std::int64_t> here(edge.low, edge.high);
        const auto at = [&ends](std::size_t i)
        { return std::make_pair(ends[2 * i], ends[2 * i + 1]); };
        while (fixed < count && at(fixed) < here)
        {
          ++fixed;
        }
        use(edge, fixed < count && at(fixed) == here ? fixed : NoIndex);
      });
  }

  std::int64_t balanceOf(std::uint32_t fixed) const
  {
    return fixed == NoIndex ? 0 : this->triangulation.balance[fixed];
  }

  bool isOdd(std::uint32_t fixed) const { return this->balanceOf(fixed) % 2 != 0; }

  std::uint32_t cellOf(std::uint32_t side) const { return this->stars->of().cell(side); }

  const ConstrainedTriangulation& triangulation;
  Monitor& monitor;
  const std::uint32_t cells;
  std::optional<VertexStars<CellSides>> stars; ///< once edges are asked for
};

}

std::int64_t cellsInside(
  const ConstrainedTriangulation& triangulation, std::uint8_t* inside, const Options& options)
{
  return engineCall(
    [&]
    {
      const std::int64_t cells = triangulation.cellCount();
      if (cells > 0 && !inside)
      {
        throw badArgument("inside must have room for one byte a cell: a null pointer was given");
      }
      runOver(static_cast<std::size_t>(cells), options,
        [&](Monitor& monitor)
        {
          requireCells(triangulation);
          InsideFinder(triangulation, monitor).find(options.polygons, inside);
        });
      return static_cast<std::int64_t>(std::count(inside, inside + cells, std::uint8_t(1)));
    });
}

}
