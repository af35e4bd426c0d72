// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The steps of convexHull(), as a HullRun does them: inspect, span, start, build, finish.
#include <flipflop/ConvexHull.h>

#include "Finish/Canonical.h"
#include "Finish/Redundant.h"
#include "FlipFlop/CpuBuilder.h"
#include "Geometry/HullCones.h"
#include "Geometry/HullLocator.h"
#include "Geometry/HullStart.h"
#include "Points/CornerPoints.h"
#include "Run/HullRun.h"
#include "Run/LowDimensionalHull.h"
#include "Support/EngineCall.h"

#include <utility>
#include <variant>

namespace flipflop
{

Hull convexHull(const PointView& points, const Options& options)
{
  return engineCall(
    [&]
    {
      HullRun run(points, options);
      CpuBuilder<HullGeometry> builder;
      return run.compute(builder);
    });
}

HullRun::HullRun(const PointView& points, const Options& chosen)
  // Most points of most inputs are dismissed at once: a thread serves four times as many as usual.
  : GeometryRun(points, 3, PointSource(points), chosen, 0.25)
{
}

Hull HullRun::compute(PolyhedronBuilder<HullGeometry>& builder)
{
  return this->execute<Hull>([&](Hull& hull) { this->computeSteps(builder, hull); });
}

void HullRun::computeSteps(PolyhedronBuilder<HullGeometry>& builder, Hull& hull)
{
  if (!this->inspect(hull, nullptr, &builder))
  {
    return;
  }
  Samples samples = nestedSamples(this->source.count());
  if (this->geometry.isExactInDouble() && !this->checkFinite && !samples.empty())
  {
    // Grids mostly fill a box.
    addToSamples(samples, cornerPoints(this->source, this->monitor));
  }
  int most = 0; // dimensions: there are none more than the box has
  for (int i = 0; i < 3; ++i)
  {
    most += this->range.high[i] > this->range.low[i] ? 1 : 0;
  }
  const Span span =
    findSpan(this->geometry, this->source, samples, most, this->checkFinite, this->monitor);
  hull.statistics.secondsScan = this->watch.lap();
  if (span.dimension < 3)
  {
    this->finishLower(span, hull);
    return;
  }
  Polyhedron start = startingTetrahedron(this->geometry, this->source, span.ids);

  Tally tally;
  BuildResult built =
    builder.build(this->task(samples, true), std::move(start), tally, hull.statistics);
  this->watch.lap();

  FinishedCells* const finished = std::get_if<FinishedCells>(&built);
  if (!finished)
  {
    this->finish(std::get<Polyhedron>(std::move(built)), std::move(tally), hull);
    return;
  }
  hull.dimension = 3;
  hull.volume = finished->volume;
  hull.area = finished->area;
  this->moveCells(std::move(*finished), hull);
  this->addStatistics(tally, hull.statistics);
}

bool HullRun::inspect(Hull& hull, const double* kernel, PointScanner* scanner)
{
  if (!this->scanPoints(hull.statistics, scanner))
  {
    return false;
  }
  if (kernel)
  {
    this->range.add(kernel);
  }
  this->setArithmetic(chooseArithmetic(this->range));
  this->geometry =
    HullGeometry(this->range, this->arithmetic, this->findLattice(3, HullGeometry::LatticeBits));
  return true;
}

void HullRun::finishLower(const Span& span, Hull& hull)
{
  lowDimensionalHull(this->geometry, this->source, span, this->checkFinite, this->range,
    this->arithmetic.scaleExponent, this->options.facets, this->monitor, hull);
  this->addStatistics(Tally(), hull.statistics);
}

void HullRun::finish(Polyhedron&& polyhedron, Tally&& tally, Hull& hull)
{
  hull.dimension = 3;
  this->monitor.stage(0.9, 1.0, 1, "finishing");
  const bool anyFlat =
    RedundantVertices<HullGeometry>(this->geometry, polyhedron, tally, this->monitor).remove();
  CanonicalForm<Polyhedron> form(polyhedron, anyFlat, tally.duplicates, this->source.count(),
    this->options.facets, this->monitor, hull.pointIds);
  this->monitor.poll();
  form.writeHull(this->range, this->arithmetic.scaleExponent, this->monitor, hull);
  this->addStatistics(tally, hull.statistics);
}

}
