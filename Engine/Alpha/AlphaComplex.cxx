// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells are judged by their circles alone. An edge or a point beside them is in the complex by its
/// own circle if that holds no neighbour: those of a regular triangulation tell of all points.
#include <flipflop/AlphaComplex.h>

#include "Alpha/CircleSquare.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Query/QueryRun.h"
#include "Surface/Sides.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

namespace
{

class AlphaRun
{
public:
  /// @throw Error BadArgument, WeightCount, TooManyPoints
  AlphaRun(
    const PointView& points, const WeightView& weights, const CellComplex& cells, Monitor& toTell)
    : triangulation(cells)
    , isWeighted(weights.data != nullptr)
    , monitor(toTell)
    , sites(loadSites(points, weights, cells))
  {
    checkCells(cells);
  }

  /// use (cell, circle), side by side.
  template <class Use>
  void eachCell(const Use& use)
  {
    eachCheckedRun(static_cast<std::size_t>(this->triangulation.cellCount()), CellsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t cell = begin; cell < end; ++cell)
        {
          use(cell, this->circleOf(cell));
        }
        this->monitor.advance(static_cast<std::int64_t>(end - begin));
      });
  }

  /// The edges and vertices that no cell of the complex has.
  void findSingular(double alpha, AlphaComplex& complex)
  {
    this->isOut.assign(this->sites.size(), 0);
    std::vector<std::int64_t> edges;
    std::vector<double> alphas;
    if (this->triangulation.dimension == 2)
    {
      this->eachEdgeOfCells(complex,
        [&](const CellSide& side)
        {
          const CircleSquare circle(this->sites[side.low], this->sites[side.high]);
          if (!circle.exceeds(alpha))
          {
            edges.insert(edges.end(), { std::int64_t(side.low), std::int64_t(side.high) });
            alphas.push_back(circle.leastAlpha());
            this->use(side);
          }
        });
    }
    else
    {
      this->useCells(complex);
    }
    copy(edges, complex.edges);
    copy(alphas, complex.edgeAlphas);

    std::vector<std::int64_t> vertices;
    alphas.clear();
    for (std::size_t v = 0; v < this->sites.size(); ++v)
    {
      const CircleSquare circle(this->sites[v]);
      if (!this->isOut[v] && !circle.exceeds(alpha))
      {
        vertices.push_back(static_cast<std::int64_t>(v));
        alphas.push_back(circle.leastAlpha());
      }
    }
    copy(vertices, complex.vertices);
    copy(alphas, complex.vertexAlphas);
  }

private:
  static constexpr std::size_t CellsPerTask = 1 << 10;

  const PowerSite& corner(std::int64_t k) const
  {
    return this->sites[static_cast<std::size_t>(this->triangulation.connectivity[k])];
  }

  CircleSquare circleOf(std::size_t cell) const
  {
    const std::int64_t k = this->triangulation.cellBegin(static_cast<std::int64_t>(cell));
    switch (this->triangulation.dimension)
    {
      case 0:
        return CircleSquare(this->corner(k));
      case 1:
        return { this->corner(k), this->corner(k + 1) };
      default:
        return { this->corner(k), this->corner(k + 1), this->corner(k + 2) };
    }
  }

  void use(const CellSide& side)
  {
    this->isOut[side.low] = 1;
    this->isOut[side.high] = 1;
  }

  /// Below dimension 2, there are no edges but cells.
  void useCells(const AlphaComplex& complex)
  {
    for (std::size_t cell = 0; cell < complex.cells.size(); ++cell)
    {
      const std::int64_t begin = this->triangulation.cellBegin(static_cast<std::int64_t>(cell));
      const std::int64_t end = this->triangulation.cellBegin(static_cast<std::int64_t>(cell) + 1);
      for (std::int64_t k = begin; k < end; ++k)
      {
        const auto v = static_cast<std::size_t>(this->triangulation.connectivity[k]);
        // The next point of a chain.
        const auto w =
          static_cast<std::size_t>(this->triangulation.connectivity[k + 1 < end ? k + 1 : begin]);
        if (complex.cells[cell] ||
          (this->isWeighted && v != w && isInCircle(this->sites[v], this->sites[w])))
        {
          this->isOut[v] = 1;
        }
      }
    }
  }

  /// offer (side) for each edge that no cell of the complex has, and whose circle has no corner of
  /// its two cells in it.
  template <class Offer>
  void eachEdgeOfCells(const AlphaComplex& complex, const Offer& offer)
  {
    Buffer<std::uint32_t> cellOf;
    Buffer<CellSide> sides = sidesOf(this->triangulation, cellOf);
    StepPoll poll(this->monitor);
    eachEdge(sides,
      [&](const CellSide* begin, const CellSide* end)
      {
        poll.step();
        this->markAttached(*begin);
        bool isLeft = true;
        bool isOpen = true;
        for (const CellSide* side = begin; side != end; ++side)
        {
          isLeft = isLeft && !complex.cells[cellOf[side->place]];
        }
        for (const CellSide* side = begin; isLeft && isOpen && side != end; ++side)
        {
          isOpen = !isInCircle(this->sites[side->low], this->sites[side->high],
            this->corner(this->apexOf(side->place, cellOf[side->place])));
        }
        if (!isLeft)
        {
          this->use(*begin);
        }
        else if (isOpen)
        {
          offer(*begin);
        }
      });
  }

  /// The place of the corner after the side that is at place @p k. All others of the cell are on
  /// the same arc.
  std::int64_t apexOf(std::uint32_t k, std::uint32_t cell) const
  {
    const std::int64_t begin = this->triangulation.cellBegin(cell);
    const std::int64_t end = this->triangulation.cellBegin(std::int64_t(cell) + 1);
    return k + 2 < end ? k + 2 : begin + (k + 2 - end);
  }

  void markAttached(const CellSide& side)
  {
    if (this->isWeighted)
    {
      const PowerSite& a = this->sites[side.low];
      const PowerSite& b = this->sites[side.high];
      if (isInCircle(a, b))
      {
        this->isOut[side.low] = 1;
      }
      if (isInCircle(b, a))
      {
        this->isOut[side.high] = 1;
      }
    }
  }

  template <class T>
  static void copy(const std::vector<T>& from, Buffer<T>& to)
  {
    to.allocate(from.size());
    std::copy(from.begin(), from.end(), to.begin());
  }

  const CellComplex& triangulation;
  const bool isWeighted;
  Monitor& monitor;
  const Buffer<PowerSite> sites;
  std::vector<std::uint8_t> isOut; ///< vertices that cannot be singular
};

}

AlphaComplex alphaComplex(const PointView& points, const WeightView& weights,
  const CellComplex& triangulation, double alpha, bool singular, const Options& options)
{
  if (std::isnan(alpha))
  {
    throw Error(ErrorCode::BadArgument);
  }
  AlphaComplex complex;
  const auto cells = static_cast<std::size_t>(triangulation.cellCount());
  runOver(cells, options,
    [&](Monitor& monitor)
    {
      AlphaRun run(points, weights, triangulation, monitor);
      monitor.stage(0.0, singular ? 0.4 : 1.0, triangulation.cellCount());
      complex.cells.allocate(cells);
      run.eachCell([&](std::size_t cell, const CircleSquare& circle)
        { complex.cells[cell] = circle.exceeds(alpha) ? 0 : 1; });
      complex.cellCount = static_cast<std::int64_t>(
        std::count(complex.cells.begin(), complex.cells.end(), std::uint8_t(1)));
      if (singular)
      {
        monitor.stage(0.4, 1.0, 1);
        run.findSingular(alpha, complex);
      }
    });
  return complex;
}

void cellAlphas(const PointView& points, const WeightView& weights,
  const CellComplex& triangulation, double* alphas, const Options& options)
{
  if (triangulation.cellCount() > 0 && !alphas)
  {
    throw Error(ErrorCode::BadArgument);
  }
  runOver(static_cast<std::size_t>(triangulation.cellCount()), options,
    [&](Monitor& monitor)
    {
      AlphaRun run(points, weights, triangulation, monitor);
      run.eachCell(
        [&](std::size_t cell, const CircleSquare& circle) { alphas[cell] = circle.leastAlpha(); });
    });
}

}
