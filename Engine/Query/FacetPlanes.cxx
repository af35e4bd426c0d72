// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/FacetPlane.h"

#include "Predicates/WideIntegers.h"
#include "Query/HullCorners.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"
#include <flipflop/HullQueries.h>

namespace flipflop
{

double FacetPlane::wideNormal(const double* a, const double* b, const double* c, double* normal)
{
  WideInteger exact[3];
  unsigned bits = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int p = (i + 1) % 3;
    const int q = (i + 2) % 3;
    exact[i] =
      wideOffset(b, a, p) * wideOffset(c, a, q) - wideOffset(b, a, q) * wideOffset(c, a, p);
    if (!exact[i].is_zero())
    {
      bits = std::max(bits, static_cast<unsigned>(msb(WideInteger(abs(exact[i])))) + 1);
    }
  }
  constexpr unsigned Most = 1000; // that a double's range holds
  double largest = 0;
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = WideInteger(exact[i] >> (bits > Most ? bits - Most : 0)).convert_to<double>();
    largest = std::max(largest, std::fabs(normal[i]));
  }
  return largest;
}

Buffer<double> facetPlanes(const PointView& points, const Hull& hull, const Options& options)
{
  return engineCall(
    [&]
    {
      const Buffer<double> corners = cornersOf(points, hull);
      Buffer<double> planes;
      if (hull.dimension < 2)
      {
        return planes;
      }
      const auto cells = static_cast<std::size_t>(hull.cellCount());
      runOver(cells, options,
        [&](Monitor& monitor)
        {
          constexpr std::size_t CellsPerTask = 1 << 12;
          planes.allocate(4 * cells);
          eachChunk(cells, CellsPerTask,
            [&](std::size_t begin, std::size_t end, std::size_t)
            {
              for (std::size_t cell = begin; cell < end; ++cell)
              {
                const std::int64_t* const v =
                  hull.connectivity.data() + hull.cellBegin(static_cast<std::int64_t>(cell));
                const FacetPlane plane(
                  corners.data() + 3 * v[0], corners.data() + 3 * v[1], corners.data() + 3 * v[2]);
                std::copy(plane.normal, plane.normal + 3, planes.data() + 4 * cell);
                planes[4 * cell + 3] = plane.offset;
              }
              monitor.advance(static_cast<std::int64_t>(end - begin));
            });
        });
      return planes;
    });
}

}
