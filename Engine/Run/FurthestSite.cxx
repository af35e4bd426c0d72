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

/// Directions from the kernel point, in the axes of a triangle around it: neighbours along a hull
/// are near each other in these, however thin it is.
OctahedralMap directionsOf(const LiftedGeometry<false>& geometry, const Vertex* triangle)
{
  const double kernel[3] = { geometry.kernel()[0], geometry.kernel()[1], 0 };
  double unit[3] = { 0, 0, 1 };
  for (int i = 0; i < 6; ++i)
  {
    unit[i % 2] = std::max(unit[i % 2], std::fabs(triangle[i / 2].x[i % 2] - kernel[i % 2]));
  }
  const bool isInRange =
    std::min(unit[0], unit[1]) > 0x1p-500 && std::max(unit[0], unit[1]) < 0x1p500;
  return octahedralMapOf(kernel, isInRange ? unit : nullptr, triangle, 3);
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
    const OctahedralMap map = directionsOf(this->geometry, start.vertices.data());
    FurthestGeometry turned(this->geometry);
    const BuildTask<FurthestGeometry> task{ turned, this->source, this->range, this->checkFinite,
      this->options, this->threads, this->monitor, {} };
    const std::vector<std::uint32_t> corners = start.pointIds();
    PointSubset subset;
    subset.count = this->source.count();
    subset.checkFinite = this->checkFinite;
    subset.exclude(corners);
    Tally tally;
    Polyhedron polyhedron =
      insertAlongCurve(task, std::move(start), subset, map, 0.1, 0.9, tally, result.statistics);
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
