// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A walk over all cells, from outside, into each and back. It keeps in which features it is: an
/// edge is crossed into or out of those of which an odd number of sides runs along it. No
/// coordinate is examined, but to find the edges of a side that runs through points.
#include <flipflop/ConstrainedTriangulation.h>

#include "Constraints/FixedPaths.h"
#include "Constraints/OddItems.h"
#include "Mesh/VertexStars.h"
#include "Points/ConstraintInput.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

class FeatureWalk
{
public:
  FeatureWalk(const ConstrainedTriangulation& given, const PointView& points,
    const ConstraintView& toUse, const std::int64_t* features, Monitor& monitorToUse)
    : triangulation(given)
    , source(points, WeightView())
    , constraints(toUse)
    , monitor(monitorToUse)
    , outside(static_cast<std::size_t>(given.cellCount()))
  {
    this->findBorders(features);
    this->findWays();
  }

  void mark(std::uint8_t* inside)
  {
    struct Step
    {
      std::size_t cell, next; ///< way
      const Way* by;
    };
    std::vector<char> isIn(this->featureCount, 0);
    std::int64_t depth = 0;
    const auto cross = [&](const Way* way)
    {
      for (std::size_t i = way ? way->begin : 0; i < (way ? way->end : 0); ++i)
      {
        char& is = isIn[std::get<2>(this->borders[i])];
        is = !is;
        depth += is ? 1 : -1;
      }
    };
    std::vector<char> isMet(this->outside + 1, 0);
    isMet[this->outside] = 1;
    std::fill_n(inside, this->outside, std::uint8_t(0));
    StepPoll poll(this->monitor);
    std::vector<Step> steps{ { this->outside, this->firstWay[this->outside], nullptr } };
    while (!steps.empty())
    {
      poll.step();
      Step& step = steps.back();
      if (step.next == this->firstWay[step.cell + 1])
      {
        cross(step.by); // back
        steps.pop_back();
        continue;
      }
      const Way* const way = &this->ways[step.next++];
      if (!isMet[way->to])
      {
        isMet[way->to] = 1;
        cross(way);
        inside[way->to] = depth > 0 ? 1 : 0;
        steps.push_back({ way->to, this->firstWay[way->to], way });
      }
    }
  }

private:
  /// The ends of an edge, the lower one first, and a feature that ends there.
  using Border = std::tuple<std::int64_t, std::int64_t, std::uint32_t>;

  /// From a cell to another, or outside, across some borders.
  struct Way
  {
    std::size_t to;
    std::size_t begin, end;
  };

  void findBorders(const std::int64_t* features)
  {
    const FixedPaths paths(this->triangulation);
    std::map<std::int64_t, std::uint32_t> numbers;
    std::vector<std::pair<std::uint32_t, std::int64_t>> corners;
    const auto at = [this](std::int64_t id)
    { return positionOf(this->source.vertex(static_cast<std::uint32_t>(id))); };
    StepPoll poll(this->monitor);
    for (std::int64_t k = 0; k < this->constraints.sides; ++k)
    {
      poll.step();
      const std::uint32_t feature =
        numbers.emplace(features[k], static_cast<std::uint32_t>(numbers.size())).first->second;
      const std::int64_t* const side =
        this->constraints.ends + 2 * (this->constraints.count - this->constraints.sides + k);
      paths.walk(side[0], side[1], at, poll,
        [&](std::int64_t a, std::int64_t b)
        { this->borders.emplace_back(std::min(a, b), std::max(a, b), feature); });
      corners.emplace_back(feature, side[0]);
      corners.emplace_back(feature, side[1]);
    }
    this->featureCount = numbers.size();
    keepOdd(this->borders);
    keepOdd(corners);
    if (!corners.empty())
    {
      throw badArgument("the sides of a feature must close: an even number of them ends at each "
                        "point");
    }
  }

  /// Edges of cells and borders are both in lexicographic order: ids ascend as indices do.
  void findWays()
  {
    const VertexStars<CellSides> stars{ CellSides(this->triangulation) };
    struct Crossing
    {
      std::size_t cells[2];
      std::size_t begin, end; ///< of borders
    };
    std::vector<Crossing> crossings;
    this->firstWay.assign(this->outside + 2, 0);
    std::size_t border = 0;
    stars.eachEdge(
      [&](const LinkedEdge& linked)
      {
        const Border edge(
          this->triangulation.pointIds[linked.low], this->triangulation.pointIds[linked.high], 0);
        while (border < this->borders.size() && this->borders[border] < edge)
        {
          ++border;
        }
        std::size_t last = border;
        while (last < this->borders.size() &&
          std::get<0>(this->borders[last]) == std::get<0>(edge) &&
          std::get<1>(this->borders[last]) == std::get<1>(edge))
        {
          ++last;
        }
        crossings.push_back(
          { { stars.of().cell(linked.sides[0]),
              linked.count > 1 ? stars.of().cell(linked.sides[1]) : this->outside },
            border, last });
        for (const std::size_t cell : crossings.back().cells)
        {
          ++this->firstWay[cell + 1];
        }
      });
    std::partial_sum(this->firstWay.begin(), this->firstWay.end(), this->firstWay.begin());
    this->ways.resize(this->firstWay.back());
    std::vector<std::size_t> next(this->firstWay.begin(), this->firstWay.end() - 1);
    for (const Crossing& crossing : crossings)
    {
      for (const int i : { 0, 1 })
      {
        this->ways[next[crossing.cells[i]]++] = { crossing.cells[1 - i], crossing.begin,
          crossing.end };
      }
    }
  }

  const ConstrainedTriangulation& triangulation;
  const PointSource source;
  const ConstraintView constraints;
  Monitor& monitor;
  const std::size_t outside; ///< the number of what is no cell
  std::size_t featureCount = 0;
  std::vector<Border> borders; ///< ascending
  std::vector<Way> ways;       ///< of each cell, and of the outside
  std::vector<std::size_t> firstWay;
};

void requireFit(const ConstrainedTriangulation& triangulation, std::int64_t points,
  const ConstraintView& constraints)
{
  const auto areBelow = [](const Buffer<std::int64_t>& numbers, std::int64_t end)
  {
    return std::all_of(
      numbers.begin(), numbers.end(), [end](std::int64_t i) { return i >= 0 && i < end; });
  };
  if (triangulation.sides != constraints.sides || !areBelow(triangulation.pointIds, points) ||
    !areBelow(triangulation.fixedEdges, static_cast<std::int64_t>(triangulation.pointIds.size())) ||
    triangulation.fixedEdges.size() % 2 != 0)
  {
    throw badTriangulation();
  }
}

}

std::int64_t cellsInsideFeatures(const ConstrainedTriangulation& triangulation,
  const PointView& points, const ConstraintView& constraints, const std::int64_t* featureOf,
  std::uint8_t* inside, const Options& options)
{
  return engineCall(
    [&]
    {
      requireValid(points, 2);
      requireValid(constraints, points.count);
      const std::int64_t cells = triangulation.cellCount();
      if ((cells > 0 && !inside) || (constraints.sides > 0 && !featureOf))
      {
        throw badArgument("there must be a feature for each side of a polygon, and room for one "
                          "byte a cell: a null pointer was given");
      }
      requireFit(triangulation, points.count, constraints);
      runOver(static_cast<std::size_t>(cells), options,
        [&](Monitor& monitor)
        {
          checkCells(triangulation);
          if (triangulation.dimension < 2 || constraints.sides == 0)
          {
            std::fill_n(inside, cells, std::uint8_t(1));
          }
          else
          {
            FeatureWalk(triangulation, points, constraints, featureOf, monitor).mark(inside);
          }
        });
      return static_cast<std::int64_t>(std::count(inside, inside + cells, std::uint8_t(1)));
    });
}

}
