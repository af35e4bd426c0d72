// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HullRun.h"

#include "Builder.h"
#include "Canonical.h"
#include "HullCones.h"
#include "HullLocator.h"
#include "HullStart.h"
#include "Planar.h"
#include "Redundant.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

namespace
{

void include(const double* x, CoordinateRange& range)
{
  for (int i = 0; i < 3; ++i)
  {
    const double magnitude = std::fabs(x[i]);
    range.low[i] = std::min(range.low[i], x[i]);
    range.high[i] = std::max(range.high[i], x[i]);
    range.smallest[i] = magnitude > 0 ? std::min(range.smallest[i], magnitude) : range.smallest[i];
  }
}

}

bool HullRun::inspect(Hull& hull, const double* kernel)
{
  if (!this->look(hull.statistics))
  {
    return false;
  }
  if (kernel)
  {
    include(kernel, this->range);
  }
  this->setArithmetic(chooseArithmetic(this->range));
  // Differences below 2^16 units make products of three sums of six below 2^53.
  const double unit = this->latticeUnit(3, 16);
  const double units[3] = { unit, unit, unit };
  const bool onLattice = unit > 0 && isOnLattice(this->source, units, this->checkFinite);
  this->geometry = HullGeometry(this->range, this->arithmetic, onLattice);
  return true;
}

void HullRun::hullOfPoints(Hull& hull)
{
  Stopwatch watch;
  if (!this->inspect(hull))
  {
    return;
  }
  using HullBuilder = Builder<HullGeometry>;
  const std::uint32_t count = this->source.count();
  const auto samples = HullBuilder::nestedSamples(count);
  const Span span = samples.empty()
    ? findSpan(this->geometry, this->source, nullptr, count, 3, this->checkFinite, this->monitor)
    : findSpan(this->geometry, this->source, samples.back().data(),
        static_cast<std::uint32_t>(samples.back().size()), 3, this->checkFinite, this->monitor);
  hull.statistics.secondsScan = watch.lap();
  if (span.dimension < 3)
  {
    lowDimensionalHull(this->geometry, this->source, span, this->checkFinite, this->range,
      this->arithmetic.scaleExponent, this->options.facets, this->monitor, hull);
    hull.statistics.exactCalls = this->geometry.predicateCounts().exact;
    hull.statistics.secondsFinish = watch.lap();
    return;
  }

  Tally tally;
  Polyhedron start = startingTetrahedron(this->geometry, this->source, span.ids);
  HullBuilder builder(
    this->geometry, this->source, this->checkFinite, this->options, this->threads, this->monitor);
  Polyhedron polyhedron = builder.build(samples, std::move(start), tally);
  hull.statistics.secondsLocate = builder.secondsLocate;
  this->finish(std::move(polyhedron), std::move(tally), hull);
}

void HullRun::finish(Polyhedron&& polyhedron, Tally&& tally, Hull& hull)
{
  Stopwatch watch;
  this->monitor.stage(0.9, 1.0, 1);
  const bool anyFlat =
    RedundantVertices<HullGeometry>(this->geometry, polyhedron, tally, this->monitor).remove();
  CanonicalForm form(polyhedron, anyFlat, tally.duplicates, this->source.count(),
    this->options.facets, hull.pointIds);
  this->monitor.poll();
  hull.dimension = 3;
  form.writeMeasure(this->range, this->arithmetic.scaleExponent, hull);
  this->monitor.poll();
  form.writeCells(this->monitor, hull);
  this->report(tally, hull.statistics);
  hull.statistics.exactCalls += this->geometry.predicateCounts().exact;
  hull.statistics.secondsFinish = watch.lap();
}

}
