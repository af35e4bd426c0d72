// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One run of the engine from the caller's weighted points to the canonical regular triangulation.
#ifndef flipflop_TriangulationRun_h
#define flipflop_TriangulationRun_h

#include "Builder.h"
#include "Canonical.h"
#include "Chain.h"
#include "LiftedLocator.h"
#include "LiftedStart.h"
#include "Redundant.h"
#include "Run.h"
#include "Triangulation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Weighted false: there are no weights
template <bool Weighted>
class TriangulationRun : public Run
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  /// @throw Error BadArgument, WeightCount, TooManyPoints
  TriangulationRun(const PointView& points, const WeightView& weights, const Options& options)
    : Run(points, 2, PointSource(points, weights), options)
  {
    requireValid(weights, points.count);
  }

  /// Look at all points, and choose the arithmetic. False: there is no finite point.
  /// @throw Error NonFinite
  bool inspect(Statistics& statistics)
  {
    if (!this->look(statistics))
    {
      return false;
    }
    this->setArithmetic(chooseLiftedArithmetic(this->range));
    // Differences below 2^12 units, and weights' below 2^25 of their squares, make the
    // determinant's six products of four sum to less than 2^53.
    const double unit = this->latticeUnit(2, 12);
    const double units[3] = { unit, unit, unit * unit };
    const bool onLattice = unit > 0 &&
      this->range.high[2] - this->range.low[2] < 0x1p25 * units[2] &&
      isOnLattice(this->source, units, this->checkFinite);
    this->geometry = Geometry(this->range, this->arithmetic, onLattice);
    return true;
  }

  /// Three points that are not collinear, or fewer that span the others' positions.
  /// @param ids, count a sample to choose from first; null: all
  Span spanOf(const std::uint32_t* ids, std::uint32_t count)
  {
    // In space, with zero for the third coordinate.
    CoordinateRange flatRange = this->range;
    flatRange.low[2] = flatRange.high[2] = 0;
    const HullGeometry flat(flatRange, this->arithmetic, false);
    return findSpan(
      flat, this->source.flattened(), ids, count, 2, this->checkFinite, this->monitor);
  }

  /// The regular triangulation of all points.
  void triangulate(Triangulation& result)
  {
    Stopwatch watch;
    if (!this->inspect(result.statistics))
    {
      return;
    }
    using LiftedBuilder = Builder<Geometry>;
    const std::uint32_t count = this->source.count();
    const auto samples = LiftedBuilder::nestedSamples(count);
    const Span span = samples.empty()
      ? this->spanOf(nullptr, count)
      : this->spanOf(samples.back().data(), static_cast<std::uint32_t>(samples.back().size()));
    result.statistics.secondsScan = watch.lap();
    if (span.dimension < 2)
    {
      chainOfPoints(this->geometry, this->source, this->checkFinite, this->monitor, result);
      this->listHidden(result);
      result.statistics.exactCalls = this->geometry.predicateCounts().exact;
      result.statistics.secondsFinish = watch.lap();
      return;
    }

    Tally tally;
    Polyhedron start = startingTetrahedron(this->geometry, this->source, span.ids);
    LiftedBuilder builder(
      this->geometry, this->source, this->checkFinite, this->options, this->threads, this->monitor);
    Polyhedron polyhedron = builder.build(samples, std::move(start), tally);
    result.statistics.secondsLocate = builder.secondsLocate;

    watch.lap();
    this->monitor.stage(0.9, 1.0, 1);
    const bool anyFlat =
      RedundantVertices<Geometry>(this->geometry, polyhedron, tally, this->monitor).remove();
    CanonicalForm form(
      polyhedron, anyFlat, tally.duplicates, count, this->options.facets, result.pointIds);
    this->monitor.poll();
    result.dimension = 2;
    form.writeCells(this->monitor, result);
    this->monitor.poll();
    this->listHidden(result);
    this->report(tally, result.statistics);
    result.statistics.exactCalls += this->geometry.predicateCounts().exact;
    result.statistics.secondsFinish = watch.lap();
  }

  Geometry geometry;

private:
  /// All finite points that do not appear.
  void listHidden(Triangulation& result) const
  {
    const Buffer<std::int64_t>& visible = result.pointIds;
    const auto hidden = static_cast<std::int64_t>(this->source.count()) -
      result.statistics.nonFinite - static_cast<std::int64_t>(visible.size());
    result.hiddenIds.allocate(static_cast<std::size_t>(hidden));
    if (hidden == 0)
    {
      return;
    }
    std::int64_t* out = result.hiddenIds.data();
    const std::int64_t* next = visible.begin();
    for (std::uint32_t id = 0; id < this->source.count(); ++id)
    {
      if (next != visible.end() && *next == id)
      {
        ++next;
        continue;
      }
      double x[3];
      if (this->checkFinite)
      {
        this->source.load(id, x);
      }
      if (!this->checkFinite || isFinite(x))
      {
        *out++ = id;
      }
    }
  }
};

}

#endif
