// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the runs of hulls and of triangulations share. Their steps are in ConvexHull.cxx and
/// RegularTriangulation.cxx: inspect, span, start, build, finish.
#ifndef flipflop_GeometryRun_h
#define flipflop_GeometryRun_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Run/Run.h"
#include <flipflop/CellComplex.h>

#include <utility>

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (GeometryConcept.h)
template <class Geometry>
class GeometryRun : public Run
{
public:
  using Run::Run;

  Geometry geometry;

protected:
  /// What a builder starts from.
  /// @param measured volume and area are wanted
  BuildTask<Geometry> task(const Samples& samples, bool measured = false)
  {
    return { this->geometry, this->source, this->range, this->checkFinite, this->options,
      this->threads, this->monitor, samples, measured, this->arithmetic.scaleExponent };
  }

  /// Store the points and cells that the builder has finished.
  void moveCells(FinishedCells&& finished, CellComplex& result) const
  {
    result.pointIds = std::move(finished.pointIds);
    result.connectivity = std::move(finished.connectivity);
    result.cellSize = 3;
  }

  void addStatistics(const Tally& tally, Statistics& statistics)
  {
    statistics += tally.statistics;
    statistics.exactCalls += this->geometry.predicateCounts().exact;
    statistics.secondsFinish += this->watch.lap();
  }
};

}

#endif
