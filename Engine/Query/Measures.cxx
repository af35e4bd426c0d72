// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A cell is the fan from its first corner: its area is their sum, its centroid their mean, taken
/// relative to that corner.
#include <flipflop/Measures.h>

#include "PowerDiagram/TriangulationInput.h"
#include "Query/PlaneValues.h"
#include "Support/EngineCall.h"
#include "Support/Monitor.h"
#include "Support/Threads.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace flipflop
{

namespace
{

/// @param corner const double* (i): the position of corner i
template <class Corner>
void measure(std::int64_t count, const Corner& corner, double* area, double* centroid)
{
  withValues(
    [&](auto& values)
    {
      using Number = typename std::decay_t<decltype(values)>::Number;
      const double* const a = corner(0);
      Number twice = values.number(0.0);
      Number moment[2] = { twice, twice };
      for (std::int64_t i = 1; i + 1 < count; ++i)
      {
        const double* const b = corner(i);
        const double* const c = corner(i + 1);
        const Number part = values.area(a, b, c);
        twice = twice + part;
        for (int k = 0; k < 2; ++k)
        {
          moment[k] =
            moment[k] + part * (values.difference(b[k], a[k]) + values.difference(c[k], a[k]));
        }
      }
      if (area)
      {
        *area = toDouble(twice * values.number(0.5));
      }
      for (int k = 0; centroid && k < 2; ++k)
      {
        // Of a segment, or of what has no area, the middle of the ends.
        const Number mean = count > 2 && !values.isZero(twice)
          ? moment[k] / (twice * values.number(3.0))
          : values.difference(corner(count - 1)[k], a[k]) * values.number(0.5);
        centroid[k] = toDouble(values.number(a[k]) + mean);
      }
      return true;
    });
}

/// measure(cell) for all cells, in parallel.
template <class Measure>
void eachCell(std::int64_t cells, Monitor& monitor, const Measure& measure)
{
  monitor.stage(0.1, 1.0, cells, "measuring");
  eachChunk(static_cast<std::size_t>(cells), FacetsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t cell = begin; cell < end; ++cell)
      {
        measure(cell);
      }
      monitor.advance(static_cast<std::int64_t>(end - begin));
    });
  monitor.stage(1.0, 1.0, 1);
}

/// body(monitor) on threads.
template <class Body>
void onThreads(const Options& options, std::size_t count, const Body& body)
{
  Monitor monitor(options);
  monitor.stage(0.0, 0.1, 1);
  ArenaLoan arena(threadCount(options.threads, static_cast<std::int64_t>(count)));
  arena.execute([&] { body(monitor); });
}

constexpr const char* NotADiagram = "the diagram must be one that powerDiagram() returned";

double* at(double* array, std::size_t i)
{
  return array ? array + i : nullptr;
}

}

void cellMeasures(const PointView& points, const CellComplex& triangulation, double* areas,
  double* centroids, const Options& options)
{
  engineCall(
    [&]
    {
      onThreads(options, triangulation.connectivity.size(),
        [&](Monitor& monitor)
        {
          const Buffer<PowerSite> sites = loadSites(points, WeightView(), triangulation);
          requireCells(triangulation);
          eachCell(triangulation.cellCount(), monitor,
            [&](std::size_t cell)
            {
              const std::int64_t begin = triangulation.cellBegin(static_cast<std::int64_t>(cell));
              const std::int64_t end = triangulation.cellBegin(static_cast<std::int64_t>(cell) + 1);
              const std::int64_t* const corners = triangulation.connectivity.data() + begin;
              measure(
                end - begin,
                [&](std::int64_t i) { return sites[static_cast<std::size_t>(corners[i])].x; },
                at(areas, cell), at(centroids, 2 * cell));
            });
        });
    });
}

void cellMeasures(
  const PowerDiagram& diagram, double* areas, double* centroids, const Options& options)
{
  engineCall(
    [&]
    {
      onThreads(options, diagram.connectivity.size(),
        [&](Monitor& monitor)
        {
          const std::size_t cells = diagram.siteIds.size();
          const auto size = static_cast<std::int64_t>(diagram.connectivity.size());
          const auto corners = static_cast<std::int64_t>(diagram.corners.size() / 2);
          if (diagram.offsets.size() != (cells ? cells + 1 : diagram.offsets.size()) ||
            (cells && (diagram.offsets[0] != 0 || diagram.offsets[cells] != size)))
          {
            throw badArgument(NotADiagram);
          }
          eachCheckedChunk(cells, FacetsPerTask,
            [&](std::size_t begin, std::size_t end, std::size_t)
            {
              for (std::size_t c = begin; c < end; ++c)
              {
                const std::int64_t first = diagram.offsets[c];
                const std::int64_t next = diagram.offsets[c + 1];
                if (first < 0 || next <= first || next > size)
                {
                  throw badArgument(NotADiagram, diagram.siteIds[c]);
                }
                for (std::int64_t i = first; i < next; ++i)
                {
                  const std::int64_t corner = diagram.connectivity[static_cast<std::size_t>(i)];
                  if (corner < 0 || corner >= corners ||
                    !std::isfinite(diagram.corners[static_cast<std::size_t>(2 * corner)]) ||
                    !std::isfinite(diagram.corners[static_cast<std::size_t>(2 * corner) + 1]))
                  {
                    throw badArgument(NotADiagram, diagram.siteIds[c]);
                  }
                }
              }
            });
          eachCell(static_cast<std::int64_t>(cells), monitor,
            [&](std::size_t cell)
            {
              const std::int64_t* const ring = diagram.connectivity.data() + diagram.offsets[cell];
              measure(
                diagram.offsets[cell + 1] - diagram.offsets[cell],
                [&](std::int64_t i) { return diagram.corners.data() + 2 * ring[i]; },
                at(areas, cell), at(centroids, 2 * cell));
            });
        });
    });
}

}
