// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HullRun.h"

#include "Builder.h"
#include "Canonical.h"
#include "HullCones.h"
#include "HullLocator.h"
#include "Planar.h"
#include "Redundant.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace flipflop
{

namespace
{

/// The tetrahedron of four independent points, and a kernel point inside it.
Polyhedron startingTetrahedron(HullGeometry& geometry, const PointSource& source, const Span& span)
{
  Vertex corner[4];
  for (int i = 0; i < 4; ++i)
  {
    corner[i] = source.vertex(span.ids[i]);
    corner[i].flags = VertexAlive;
  }
  if (geometry.above(corner[0], corner[1], corner[2], corner[3]) > 0)
  {
    std::swap(corner[1], corner[2]);
  }

  Polyhedron result(4, 4);
  std::copy(corner, corner + 4, result.vertices.begin());
  // Corner 3 is beneath the triangle 0, 1, 2.
  static constexpr std::uint32_t corners[4][3] = { { 0, 1, 2 }, { 0, 3, 1 }, { 1, 3, 2 },
    { 2, 3, 0 } };
  for (std::uint32_t t = 0; t < 4; ++t)
  {
    std::copy(corners[t], corners[t] + 3, result.triangles[t].v);
    result.triangles[t].flags = 0;
    result.triangles[t].index = 0;
  }
  const Mesh mesh = result.mesh();
  for (std::uint32_t h = 0; h < 16; ++h)
  {
    for (std::uint32_t other = 0; other < 16 && cornerOf(h) < 3; ++other)
    {
      if (cornerOf(other) < 3 && mesh.origin(h) == mesh.origin(nextHalfEdge(other)) &&
        mesh.origin(other) == mesh.origin(nextHalfEdge(h)))
      {
        mesh.triangles[triangleOf(h)].twin[cornerOf(h)] = other;
      }
    }
  }

  // Unequal weights keep the kernel off the planes of a grid.
  static constexpr double weight[4] = { 0.2718281828, 0.2414213562, 0.2236067977, 0.2631436633 };
  double s[3] = { 0, 0, 0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      s[i] += weight[k] * corner[k].x[i];
    }
  }
  geometry.setKernel(s);
  bool inside = true;
  for (const Triangle& t : result.triangles)
  {
    inside = inside &&
      geometry.beneathKernel(
        result.vertices[t.v[0]], result.vertices[t.v[1]], result.vertices[t.v[2]]) > 0;
  }
  if (!inside)
  {
    geometry.setSymbolicKernel(corner);
  }
  return result;
}

void include(const double* x, CoordinateRange& range)
{
  for (int i = 0; i < 3; ++i)
  {
    const double magnitude = std::fabs(x[i]);
    range.low[i] = std::min(range.low[i], x[i]);
    range.high[i] = std::max(range.high[i], x[i]);
    range.largest = std::max(range.largest, magnitude);
    range.smallest = magnitude > 0 ? std::min(range.smallest, magnitude) : range.smallest;
  }
}

}

int threadCount(int asked)
{
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

HullRun::HullRun(const PointView& view, const Options& chosen)
  : points(view)
  , options(chosen)
  , threads(threadCount(chosen.threads))
  , monitor(chosen)
  , source(view)
{
  if (view.count < 0 || (view.count > 0 && (!view.data || view.stride < 3)))
  {
    throw Error(ErrorCode::BadArgument);
  }
  if (view.count > static_cast<std::int64_t>(NoIndex) - 1)
  {
    throw Error(ErrorCode::TooManyPoints, -1, view.count);
  }
}

bool HullRun::inspect(Hull& hull, const double* kernel)
{
  Statistics& statistics = hull.statistics;
  statistics.points = this->points.count;
  statistics.threads = this->threads;
  this->monitor.stage(0.0, 0.1, this->points.count);
  const ScanResult found = scan(this->source, this->threads, this->monitor);
  statistics.nonFinite = found.nonFinite;
  if (found.nonFinite && this->options.nonFinite == NonFinitePolicy::Error)
  {
    throw Error(ErrorCode::NonFinite, found.firstNonFinite, found.nonFinite);
  }
  this->checkFinite = found.nonFinite != 0;
  if (found.firstFinite < 0)
  {
    return false;
  }

  this->range = found.range;
  if (kernel)
  {
    include(kernel, this->range);
  }
  this->arithmetic = chooseArithmetic(this->range);
  this->source.setArithmetic(this->arithmetic);
  const int exponent = this->arithmetic.scaleExponent;
  for (int i = 0; i < 3; ++i)
  {
    this->range.low[i] = std::ldexp(this->range.low[i], exponent);
    this->range.high[i] = std::ldexp(this->range.high[i], exponent);
  }
  const bool onLattice =
    !this->arithmetic.wide && isOnLattice(this->source, this->range, this->checkFinite);
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
    ? findSpan(this->geometry, this->source, nullptr, count, this->checkFinite, this->monitor)
    : findSpan(this->geometry, this->source, samples.back().data(),
        static_cast<std::uint32_t>(samples.back().size()), this->checkFinite, this->monitor);
  hull.statistics.secondsScan = watch.lap();
  if (span.dimension < 3)
  {
    lowDimensionalHull(this->geometry, this->source, span, this->checkFinite, this->range,
      this->arithmetic.scaleExponent, this->options.facets, this->monitor, hull);
    hull.statistics.exactCalls = this->geometry.exactCallCount();
    hull.statistics.secondsFinish = watch.lap();
    return;
  }

  Tally tally;
  Polyhedron start = startingTetrahedron(this->geometry, this->source, span);
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
  RedundantVertices<HullGeometry> redundant(this->geometry, polyhedron, tally, this->monitor);
  const bool anyFlat = redundant.remove();
  writeCanonical(polyhedron, anyFlat, tally.duplicates, this->source.count(), this->range,
    this->arithmetic.scaleExponent, this->options.facets, this->monitor, hull);

  Statistics& statistics = hull.statistics;
  const Statistics& work = tally.statistics;
  statistics.culled = work.culled;
  statistics.insertions = work.insertions;
  statistics.flips22 = work.flips22;
  statistics.flips31 = work.flips31;
  statistics.flipsV = work.flipsV;
  statistics.flipsD = work.flipsD;
  statistics.labelled = work.labelled;
  statistics.edgeChecks = work.edgeChecks;
  statistics.exactCalls = work.exactCalls + this->geometry.exactCallCount();
  statistics.secondsGrow = work.secondsGrow;
  statistics.secondsFlip = work.secondsFlip;
  statistics.secondsFinish = watch.lap();
}

}
