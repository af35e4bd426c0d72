// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The squares of lengths are compared: in double, and near a tie exactly.
#include <flipflop/EdgeLengths.h>

#include "PowerDiagram/TriangulationInput.h"
#include "Predicates/ErrorBounds.h"
#include "Predicates/WideSigns.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flipflop
{

namespace
{

class LengthLimit
{
public:
  explicit LengthLimit(double limit)
    : limit(limit)
    , square(limit * limit)
  {
  }

  /// Is the edge from p to q, of which x and y count, longer than the limit?
  bool isExceeded(const double* p, const double* q) const
  {
    if (std::isinf(this->limit))
    {
      return false;
    }
    const double x = p[0] - q[0];
    const double y = p[1] - q[1];
    const double found = x * x + y * y;
    if (isNormal(found) && isNormal(this->square))
    {
      if (found > this->square * (1 + LengthError))
      {
        return true;
      }
      if (found < this->square * (1 - LengthError))
      {
        return false;
      }
    }
    const double a[3] = { p[0], p[1], 0 };
    const double b[3] = { q[0], q[1], 0 };
    const double c[3] = { this->limit, 0, 0 };
    const double d[3] = { 0, 0, 0 };
    const bool narrow =
      isNarrow(p[0]) && isNarrow(p[1]) && isNarrow(q[0]) && isNarrow(q[1]) && isNarrow(this->limit);
    return inArithmetic<ExpansionSigns, WideSigns>(
             !narrow, [&](auto signs) { return signs.compareDistances(a, b, c, d); }) > 0;
  }

private:
  /// Neither overflown nor of lost bits.
  static bool isNormal(double square) { return square > SquareFloor && square < SquareCeiling; }

  /// Of what expansions carry: squares of the last bits are doubles.
  static bool isNarrow(double x)
  {
    return x == 0 || (std::fabs(x) > 1e-120 && std::fabs(x) < 1e145);
  }

  double limit;
  double square;
};

}

std::int64_t cellsWithinEdgeLength(const PointView& points, const CellComplex& triangulation,
  double limit, std::uint8_t* within, const Options& options)
{
  return engineCall(
    [&]
    {
      // A NaN is not 0 or more.
      if (!(limit >= 0))
      {
        throw badArgument("the limit of edge lengths must be 0 or more");
      }
      if (triangulation.cellCount() > 0 && !within)
      {
        throw badArgument("within must have room for one byte a cell: a null pointer was given");
      }
      std::int64_t count = 0;
      const auto cells = static_cast<std::size_t>(triangulation.cellCount());
      runOver(cells, options,
        [&](Monitor& monitor)
        {
          const Buffer<PowerSite> sites = loadSites(points, WeightView(), triangulation);
          requireCells(triangulation);
          const LengthLimit length(limit);
          eachChunk(cells, FacetsPerTask,
            [&](std::size_t begin, std::size_t end, std::size_t)
            {
              for (std::size_t cell = begin; cell < end; ++cell)
              {
                const std::int64_t first = triangulation.cellBegin(static_cast<std::int64_t>(cell));
                const std::int64_t next =
                  triangulation.cellBegin(static_cast<std::int64_t>(cell) + 1);
                const auto siteAt = [&](std::int64_t i)
                { return sites[triangulation.connectivity[i]].x; };
                bool isWithin = true;
                for (std::int64_t i = first; i < next && isWithin; ++i)
                {
                  isWithin = !length.isExceeded(siteAt(i), siteAt(i + 1 < next ? i + 1 : first));
                }
                within[cell] = isWithin ? 1 : 0;
              }
              monitor.advance(static_cast<std::int64_t>(end - begin));
            });
          count = static_cast<std::int64_t>(std::count(within, within + cells, std::uint8_t(1)));
        });
      return count;
    });
}

void keepCells(CellComplex& complex, const std::uint8_t* kept)
{
  engineCall(
    [&]
    {
      const std::int64_t cells = complex.cellCount();
      std::int64_t* const corners = complex.connectivity.data();
      std::size_t size = 0;
      std::size_t keptCount = 0;
      // Cells move towards the front, so none is overwritten before it has moved.
      for (std::int64_t cell = 0; cell < cells; ++cell)
      {
        const std::int64_t begin = complex.cellBegin(cell);
        const std::int64_t end = complex.cellBegin(cell + 1);
        if (!kept[cell])
        {
          continue;
        }
        std::copy(corners + begin, corners + end, corners + size);
        if (!complex.cellSize)
        {
          complex.offsets[keptCount] = static_cast<std::int64_t>(size);
        }
        size += static_cast<std::size_t>(end - begin);
        ++keptCount;
      }
      complex.connectivity.truncate(size);
      if (!complex.cellSize && !complex.offsets.empty())
      {
        complex.offsets[keptCount] = static_cast<std::int64_t>(size);
        complex.offsets.truncate(keptCount + 1);
      }
    });
}

}
