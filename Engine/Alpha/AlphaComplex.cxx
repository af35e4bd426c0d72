// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells are classified by their circles alone. Another edge or point is in the complex by its own
/// circle if that holds no neighbour: those of a regular triangulation hold for all points.
#include <flipflop/AlphaComplex.h>

#include "Alpha/CircleSquare.h"
#include "Mesh/VertexStars.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Run/QueryRun.h"
#include "Support/BufferCopy.h"
#include "Support/EngineCall.h"

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
  AlphaRun(const PointView& points, const WeightView& weights, const CellComplex& cells,
    Monitor& monitorToUse)
    : triangulation(cells)
    , isWeighted(weights.data != nullptr)
    , monitor(monitorToUse)
    , sites(loadSites(points, weights, cells))
  {
    requireCells(cells);
  }

  /// use (cell, circle), side by side.
  template <class Use>
  void eachCell(const Use& use)
  {
    eachCheckedChunk(static_cast<std::size_t>(this->triangulation.cellCount()), CellsPerTask,
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
    if (this->triangulation.dimension == 2)
    {
      this->findEdges(alpha, complex);
    }
    else
    {
      this->useCells(complex);
    }
    std::vector<std::int64_t> vertices;
    std::vector<double> alphas;
    for (std::size_t v = 0; v < this->sites.size(); ++v)
    {
      const CircleSquare circle(this->sites[v]);
      if (!this->isOut[v] && !circle.exceeds(alpha))
      {
        vertices.push_back(static_cast<std::int64_t>(v));
        alphas.push_back(circle.leastAlpha());
      }
    }
    copyTo(vertices, complex.vertices);
    copyTo(alphas, complex.vertexAlphas);
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

  /// An edge that no cell of the complex has: its ends and sides, and what is found of it.
  struct Edge
  {
    std::uint32_t corner[2];
    std::uint32_t sides[2]; ///< the second: NoIndex at the border
    bool isSingular = false;
    bool attaches[2] = { false,
      false };        ///< is the other end in the circle of the lower, the higher?
    double alpha = 0; ///< of a singular one
  };

  void findEdges(double alpha, AlphaComplex& complex)
  {
    const VertexStars<CellSides> stars{ CellSides(this->triangulation) };
    std::vector<Edge> edges;
    StepPoll poll(this->monitor);
    stars.eachEdge(
      [&](const LinkedEdge& edge)
      {
        poll.step();
        if (edge.count > 2)
        {
          refuse(this->triangulation.pointIds[edge.low]);
        }
        if (std::any_of(edge.sides, edge.sides + edge.count,
              [&](std::uint32_t side) { return complex.cells[stars.of().cell(side)] != 0; }))
        {
          this->isOut[edge.low] = this->isOut[edge.high] = 1;
        }
        else
        {
          edges.push_back({ { edge.low, edge.high }, { edge.sides[0], edge.other() } });
        }
      });
    this->monitor.stage(0.7, 1.0, static_cast<std::int64_t>(edges.size()));
    eachChunk(edges.size(), CellsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        std::for_each(edges.begin() + begin, edges.begin() + end,
          [&](Edge& edge) { this->classify(edge, alpha, stars); });
        this->monitor.advance(static_cast<std::int64_t>(end - begin));
      });
    std::vector<std::int64_t> ends;
    std::vector<double> alphas;
    for (const Edge& edge : edges)
    {
      for (int i = 0; i < 2; ++i)
      {
        if (edge.isSingular || edge.attaches[i])
        {
          this->isOut[edge.corner[i]] = 1;
        }
      }
      if (edge.isSingular)
      {
        ends.insert(ends.end(), { std::int64_t(edge.corner[0]), std::int64_t(edge.corner[1]) });
        alphas.push_back(edge.alpha);
      }
    }
    copyTo(ends, complex.edges);
    copyTo(alphas, complex.edgeAlphas);
  }

  void classify(Edge& edge, double alpha, const VertexStars<CellSides>& stars) const
  {
    const PowerSite& a = this->sites[edge.corner[0]];
    const PowerSite& b = this->sites[edge.corner[1]];
    if (this->isWeighted)
    {
      edge.attaches[0] = isInCircle(a, b);
      edge.attaches[1] = isInCircle(b, a);
    }
    const CircleSquare circle(a, b);
    edge.isSingular = std::none_of(edge.sides, edge.sides + 2,
                        [&](std::uint32_t side)
                        {
                          // The corner after the side: all others of the cell are on the same arc.
                          return side != NoIndex &&
                            isInCircle(a, b, this->sites[stars.destination(stars.of().next(side))]);
                        }) &&
      !circle.exceeds(alpha);
    if (edge.isSingular)
    {
      edge.alpha = circle.leastAlpha();
    }
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
  return engineCall(
    [&]
    {
      if (std::isnan(alpha))
      {
        throw badArgument("alpha must not be NaN");
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
    });
}

void cellAlphas(const PointView& points, const WeightView& weights,
  const CellComplex& triangulation, double* alphas, const Options& options)
{
  engineCall(
    [&]
    {
      if (triangulation.cellCount() > 0 && !alphas)
      {
        throw badArgument("alphas must have room for one number a cell: a null pointer was given");
      }
      runOver(static_cast<std::size_t>(triangulation.cellCount()), options,
        [&](Monitor& monitor)
        {
          AlphaRun run(points, weights, triangulation, monitor);
          run.eachCell([&](std::size_t cell, const CircleSquare& circle)
            { alphas[cell] = circle.leastAlpha(); });
        });
    });
}

}
