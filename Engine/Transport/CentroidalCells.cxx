// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/CentroidalCells.h>

#include "Support/BufferCopy.h"
#include "Support/EngineCall.h"
#include "Support/ProgressOfParts.h"
#include "Transport/CellMoments.h"
#include "Transport/Iterations.h"
#include "Transport/SiteArrays.h"
#include <flipflop/Measures.h>
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace flipflop
{

namespace
{

class LloydRun
{
public:
  LloydRun(const PointView& points, const WeightView& weights, const ConvexDomain& given,
    std::int64_t mostIterations, double greatestMove, const Options& options)
    : sites(points, weights)
    , domain(given)
    , measured(given)
    , most(mostIterations)
    , tolerance(greatestMove)
    , progress(options)
  {
    requireLimits(this->most, this->tolerance);
  }

  CentroidalCells run()
  {
    this->progress.name("moving sites");
    this->result.converged = this->sites.positions.empty();
    while (!this->result.converged && this->result.iterations < this->most)
    {
      this->move();
    }
    this->progress.name("making cells");
    this->finish();
    return std::move(this->result);
  }

private:
  /// The share of the whole that is done after some iterations; the cells count as one more.
  double share(std::int64_t iterations) const
  {
    return static_cast<double>(iterations) / (static_cast<double>(this->most) + 1);
  }

  Triangulation triangulated(double next, FacetMode facets)
  {
    Options options = this->progress.options(next);
    options.facets = facets;
    Triangulation found =
      regularTriangulation(this->sites.points(), weightsOf(this->sites.numbers), options);
    this->result.statistics += found.statistics;
    return found;
  }

  void move()
  {
    const double next = this->share(this->result.iterations + 1);
    const Triangulation triangulation = this->triangulated(next, FacetMode::Triangles);
    measureCells(this->sites.positions, this->weights(), triangulation, this->measured.polygon,
      this->moments, this->progress.options(next));
    std::vector<double>& positions = this->sites.positions;
    double far = 0;
    for (std::size_t i = 0; i < positions.size(); i += 2)
    {
      far = std::max(far, distanceBetween(&positions[i], &this->moments.centroids[i]));
    }
    positions.swap(this->moments.centroids);
    this->result.lastMove = far;
    this->result.converged = far <= this->tolerance;
    ++this->result.iterations;
  }

  void finish()
  {
    const Triangulation triangulation = this->triangulated(1, FacetMode::Polygons);
    this->result.cells = powerDiagram(this->sites.points(), weightsOf(this->sites.numbers),
      triangulation, this->domain, this->progress.options(1));
    const PowerDiagram& cells = this->result.cells;
    const std::size_t count = cells.siteIds.size();
    std::vector<double> areas(count);
    std::vector<double> centroids(2 * count);
    cellMeasures(cells, areas.data(), centroids.data(), this->progress.options(1));

    this->result.sites = bufferOf(this->sites.positions);
    this->result.centroids = bufferOf(this->sites.positions);
    this->result.areas = bufferOf(std::vector<double>(this->sites.positions.size() / 2, 0.0));
    for (std::size_t c = 0; c < count; ++c)
    {
      const auto site = static_cast<std::size_t>(cells.siteIds[c]);
      this->result.areas[site] = areas[c];
      std::copy_n(&centroids[2 * c], 2, &this->result.centroids[2 * site]);
    }
    this->result.withoutCell = static_cast<std::int64_t>(this->result.areas.size() - count);
  }

  const double* weights() const
  {
    return this->sites.numbers.empty() ? nullptr : this->sites.numbers.data();
  }

  SiteArrays sites;
  const ConvexDomain domain;
  const MeasuredDomain measured;
  const std::int64_t most;
  const double tolerance;
  ProgressOfParts progress;
  CellMoments moments;
  CentroidalCells result;
};

}

CentroidalCells centroidalCells(const PointView& points, const WeightView& weights,
  const ConvexDomain& domain, std::int64_t iterations, double tolerance, const Options& options)
{
  return engineCall(
    [&]
    {
      return withSeconds(
        [&] { return LloydRun(points, weights, domain, iterations, tolerance, options).run(); });
    });
}

}
