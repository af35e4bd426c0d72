// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/HullRun.h"

#include "Run/Planar.h"

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

bool HullRun::inspect(Hull& hull, const double* kernel, PointScanner* scanner)
{
  if (!this->look(hull.statistics, scanner))
  {
    return false;
  }
  if (kernel)
  {
    include(kernel, this->range);
  }
  this->setArithmetic(chooseArithmetic(this->range));
  this->geometry =
    HullGeometry(this->range, this->arithmetic, this->findLattice(3, HullGeometry::LatticeBits));
  return true;
}

void HullRun::hullOfPoints(PolyhedronBuilder<HullGeometry>& engine, Hull& hull)
{
  if (!this->inspect(hull, nullptr, &engine))
  {
    return;
  }
  const auto spanOf = [this](const std::uint32_t* ids, std::uint32_t count) {
    return findSpan(this->geometry, this->source, ids, count, 3, this->checkFinite, this->monitor);
  };
  const auto lowerHull = [&](const Span& span)
  {
    lowDimensionalHull(this->geometry, this->source, span, this->checkFinite, this->range,
      this->arithmetic.scaleExponent, this->options.facets, this->monitor, hull);
  };
  FinishedCells finished;
  finished.measured = true;
  finished.exponent = this->arithmetic.scaleExponent;
  this->build(
    engine, hull, 3, finished, spanOf, lowerHull,
    [&](CanonicalForm<Polyhedron>& form) { this->write(form, hull); },
    [&]
    {
      hull.volume = finished.volume;
      hull.area = finished.area;
    });
}

void HullRun::finish(Polyhedron&& polyhedron, Tally&& tally, Hull& hull)
{
  hull.dimension = 3;
  GeometryRun::finish(std::move(polyhedron), std::move(tally), hull,
    [&](CanonicalForm<Polyhedron>& form) { this->write(form, hull); });
}

void HullRun::write(CanonicalForm<Polyhedron>& form, Hull& hull)
{
  form.writeHull(this->range, this->arithmetic.scaleExponent, this->monitor, hull);
}

}
