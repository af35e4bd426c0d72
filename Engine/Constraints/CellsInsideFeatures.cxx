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
    , stars(CellSides(given))
    , twin(given.connectivity.size())
  {
    std::fill(this->twin.begin(), this->twin.end(), NoIndex); // also of sides without an edge
    LinkFaults faults;
    linkTwins(
      this->stars, [this] { this->monitor.poll(); },
      [this](std::uint32_t side, std::uint32_t other) { this->twin[side] = other; }, faults);
    if (faults.crowded.count() > 0)
    {
      throw badTriangulation();
    }
    this->findBorders(features);
  }

  void mark(std::uint8_t* inside)
  {
    std::vector<char> isIn(this->featureCount, 0);
    std::int64_t depth = 0;
    const auto cross = [&](std::uint32_t side)
    {
      const std::pair<std::int64_t, std::int64_t> ends = std::minmax(
        this->idAt(this->stars.of().origin(side)), this->idAt(this->stars.destination(side)));
      for (auto at = std::lower_bound(
             this->borders.begin(), this->borders.end(), Border(ends.first, ends.second, 0));
           at != this->borders.end() && std::get<0>(*at) == ends.first &&
           std::get<1>(*at) == ends.second;
           ++at)
      {
        char& is = isIn[std::get<2>(*at)];
        is = !is;
        depth += is ? 1 : -1;
      }
    };
    struct Step
    {
      std::int64_t next, end; ///< sides of a cell
      std::uint32_t by;       ///< the one by which it was entered
    };
    std::vector<Step> steps;
    const auto cells = static_cast<std::size_t>(this->triangulation.cellCount());
    std::vector<char> isMet(cells, 0);
    std::fill_n(inside, cells, std::uint8_t(0));
    const auto enter = [&](std::uint32_t side)
    {
      const std::uint32_t cell = this->stars.of().cell(side);
      if (!isMet[cell])
      {
        isMet[cell] = 1;
        cross(side);
        inside[cell] = depth > 0 ? 1 : 0;
        steps.push_back({ this->triangulation.cellBegin(cell),
          this->triangulation.cellBegin(std::int64_t(cell) + 1), side });
      }
    };
    StepPoll poll(this->monitor);
    for (std::uint32_t first = 0; first < this->twin.size(); ++first)
    {
      if (this->twin[first] == NoIndex)
      {
        enter(first);
      }
      while (!steps.empty())
      {
        poll.step();
        Step& step = steps.back();
        if (step.next == step.end)
        {
          cross(step.by); // back
          steps.pop_back();
          continue;
        }
        const std::uint32_t other = this->twin[static_cast<std::size_t>(step.next++)];
        if (other != NoIndex)
        {
          enter(other);
        }
      }
    }
  }

private:
  /// The ends of an edge, the lower one first, and a feature that ends there.
  using Border = std::tuple<std::int64_t, std::int64_t, std::uint32_t>;

  std::int64_t idAt(std::uint32_t v) const { return this->triangulation.pointIds[v]; }

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

  const ConstrainedTriangulation& triangulation;
  const PointSource source;
  const ConstraintView constraints;
  Monitor& monitor;
  const VertexStars<CellSides> stars;
  Buffer<std::uint32_t> twin; ///< by side; NoIndex: outside is beyond it
  std::size_t featureCount = 0;
  std::vector<Border> borders; ///< ascending
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
          requireCells(triangulation);
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
