// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/FurthestSite.h>

#include "Finish/Redundant.h"
#include "FlipFlop/CurveInsertion.h"
#include "Geometry/FurthestGeometry.h"
#include "Geometry/GeometryConcept.h"
#include "Geometry/LiftedStart.h"
#include "Run/TriangulationRun.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

static_assert(hasSigns<FurthestGeometry>());

/// Directions from the kernel point, in which a triangle around it is spread: neighbours along a
/// hull are near each other in these, however thin it is.
OctahedralMap directionsOf(
  const LiftedGeometry<false>& geometry, const std::vector<Vertex>& triangle)
{
  double unit[2] = { 0, 0 };
  for (int i = 0; i < 2; ++i)
  {
    for (const Vertex& v : triangle)
    {
      unit[i] = std::max(unit[i], std::fabs(v.x[i] - geometry.kernel()[i]));
    }
  }
  const bool isInRange =
    std::min(unit[0], unit[1]) > 0x1p-500 && std::max(unit[0], unit[1]) < 0x1p500;
  double moment[3] = { 0, 0, 0 }; // of xx, xy, yy, in these units
  for (const Vertex& v : triangle)
  {
    const double x = isInRange ? (v.x[0] - geometry.kernel()[0]) / unit[0] : 0;
    const double y = isInRange ? (v.x[1] - geometry.kernel()[1]) / unit[1] : 0;
    moment[0] += x * x;
    moment[1] += x * y;
    moment[2] += y * y;
  }
  // The inverse of their Cholesky factor, as octahedralMapOf has it.
  double basis[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const double rest = moment[2] - moment[1] * moment[1] / moment[0];
  if (isInRange && rest > 0)
  {
    const double second = 1 / std::sqrt(rest);
    basis[0][0] = 1 / (std::sqrt(moment[0]) * unit[0]);
    basis[1][0] = -second * moment[1] / moment[0] / unit[0];
    basis[1][1] = second / unit[1];
  }
  const double kernel[3] = { geometry.kernel()[0], geometry.kernel()[1], 0 };
  return OctahedralMap(kernel, basis);
}

class FurthestSiteRun : public TriangulationRun<false>
{
public:
  using TriangulationRun::TriangulationRun;

  Triangulation compute()
  {
    return this->execute<Triangulation>([&](Triangulation& result) { this->steps(result); });
  }

private:
  void steps(Triangulation& result)
  {
    if (!this->inspect(result.statistics))
    {
      return;
    }
    const Span span = this->spanOf(nestedSamples(this->source.count()));
    result.statistics.secondsScan = this->watch.lap();
    if (span.dimension < 2)
    {
      this->writeEnds(result);
      return;
    }
    Polyhedron start = startingTetrahedron(this->geometry, this->source, span.ids);
    const std::vector<Vertex> startCorners(start.vertices.begin(), start.vertices.begin() + 3);
    FurthestGeometry turned(this->geometry);
    const BuildTask<FurthestGeometry> task{ turned, this->source, this->range, this->checkFinite,
      this->options, this->threads, this->monitor, {} };
    const std::vector<std::uint32_t> corners = start.pointIds();
    PointSubset subset;
    subset.count = this->source.count();
    subset.checkFinite = this->checkFinite;
    subset.exclude(corners);
    Tally tally;
    Polyhedron polyhedron = insertAlongCurve(task, std::move(start), subset,
      directionsOf(this->geometry, startCorners), 0.1, 0.9, tally, result.statistics);
    this->watch.lap();
    result.dimension = 2;
    this->monitor.stage(0.9, 1.0, 1, "finishing");
    const bool anyFlat =
      RedundantVertices<FurthestGeometry>(turned, polyhedron, tally, this->monitor).remove();
    this->write(polyhedron, anyFlat, tally, result);
  }

  /// Of points on a line: the two at the ends, of those there the lowest ids.
  void writeEnds(Triangulation& result)
  {
    Vertex ends[2];
    bool isFirst = true;
    eachFinite(this->source, this->checkFinite, this->monitor,
      [&](const Vertex& v)
      {
        const auto isBefore = [](const Vertex& a, const Vertex& b)
        { return a.x[0] != b.x[0] ? a.x[0] < b.x[0] : a.x[1] < b.x[1]; };
        ends[0] = isFirst || isBefore(v, ends[0]) ? v : ends[0];
        ends[1] = isFirst || isBefore(ends[1], v) ? v : ends[1];
        isFirst = false;
      });
    result.dimension = ends[0].id == ends[1].id ? 0 : 1;
    result.cellSize = result.dimension + 1;
    result.pointIds.allocate(static_cast<std::size_t>(result.cellSize));
    result.connectivity.allocate(static_cast<std::size_t>(result.cellSize));
    for (std::int64_t i = 0; i < result.cellSize; ++i)
    {
      result.pointIds[static_cast<std::size_t>(i)] = ends[i].id;
      result.connectivity[static_cast<std::size_t>(i)] = i;
    }
    std::sort(result.pointIds.begin(), result.pointIds.end());
    this->listHidden(result);
    this->addStatistics(Tally(), result.statistics);
  }
};

}

Triangulation furthestSiteTriangulation(const PointView& points, const Options& options)
{
  return engineCall([&] { return FurthestSiteRun(points, WeightView(), options).compute(); });
}

}
