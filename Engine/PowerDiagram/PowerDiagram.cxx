// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/PowerDiagram.h>

#include "PowerDiagram/CellRepair.h"
#include "PowerDiagram/DomainCorners.h"
#include "PowerDiagram/PowerCells.h"
#include "PowerDiagram/TriangulationInput.h"
#include "Support/BufferCopy.h"
#include "Support/EngineCall.h"
#include "Support/Monitor.h"
#include "Support/Threads.h"

#include <cstdint>
#include <vector>

namespace flipflop
{
namespace
{

/// @param wanted by site: is its cell wanted? null: all are
/// @return false: some are wanted, and one of these is not convex
bool makeCells(const PointView& points, const WeightView& weights, const CellComplex& complex,
  const std::uint8_t* wanted, const ConvexDomain& domain, const Options& options,
  PowerDiagram& result)
{
  const std::vector<double> polygon = domainCorners(domain);
  Monitor monitor(options);
  monitor.stage(0.0, 0.8, complex.cellCount() + static_cast<std::int64_t>(complex.pointIds.size()),
    "making cells");
  bool isMade = true;
  ArenaLoan arena(threadCount(options.threads, static_cast<std::int64_t>(complex.pointIds.size())));
  arena.execute(
    [&]
    {
      const Buffer<PowerSite> sites = loadSites(points, weights, complex);
      requireCells(complex);
      RoundedCells cells =
        roundedCells(complex, wanted, sites, polygon, domain.corners == 0, monitor);
      monitor.stage(0.9, 1.0, 1, "finishing");
      isMade = !wanted || areConvex(cells, polygon, monitor);
      if (!wanted)
      {
        repairCells(cells, polygon, monitor);
      }
      if (isMade)
      {
        copyTo(cells.positions, result.corners);
        copyTo(cells.corners, result.connectivity);
        copyTo(cells.ends, result.offsets);
        copyTo(cells.ids, result.siteIds);
        monitor.stage(1.0, 1.0, 1);
      }
    });
  return isMade;
}

}

PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const double* box, const Options& options)
{
  return engineCall(
    [&] { return powerDiagram(points, weights, triangulation, ConvexDomain(box), options); });
}

PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const ConvexDomain& domain, const Options& options)
{
  return engineCall(
    [&]
    {
      PowerDiagram result;
      makeCells(points, weights, triangulation, nullptr, domain, options, result);
      return result;
    });
}

bool powerCells(const PointView& points, const WeightView& weights, const CellComplex& facets,
  const std::uint8_t* wanted, const double* box, PowerDiagram& diagram, const Options& options)
{
  return engineCall(
    [&]
    {
      diagram = PowerDiagram();
      if (facets.pointIds.empty())
      {
        return true;
      }
      if (!wanted)
      {
        throw badArgument("wanted must have one flag for each of the facets' points");
      }
      return makeCells(points, weights, facets, wanted, ConvexDomain(box), options, diagram);
    });
}

void facetCenters(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, double* centers, const Options& options)
{
  engineCall(
    [&]
    {
      if (triangulation.cellCount() > 0 && (triangulation.dimension != 2 || !centers))
      {
        throw badArgument(
          "the cells must be triangles or polygons, with an array for their centers");
      }
      Monitor monitor(options);
      monitor.stage(0.0, 1.0, triangulation.cellCount(), "making cells");
      ArenaLoan arena(threadCount(options.threads, triangulation.cellCount()));
      arena.execute(
        [&]
        {
          const Buffer<PowerSite> sites = loadSites(points, weights, triangulation);
          requireCells(triangulation);
          writeCenters(triangulation, sites, centers, monitor);
        });
      monitor.stage(1.0, 1.0, 1);
    });
}

}
