// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulation to be validated among all its points: its corners in their arithmetic, linked
/// and checked as queries would have it.
#ifndef flipflop_GivenTriangulation_h
#define flipflop_GivenTriangulation_h

#include "Mesh/CellStructure.h"
#include "Query/FanMesh.h"
#include "Query/SiteChain.h"
#include "Run/TriangulationRun.h"
#include "Surface/CellMesh.h"
#include "Surface/SurfaceCheck.h"
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>
#include <flipflop/Validate.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

struct GivenTriangulation
{
  using Geometry = LiftedGeometry<true>;

  /// @param pointsRun after it has scanned the points
  GivenTriangulation(TriangulationRun<true>& pointsRun, const Triangulation& triangulation)
    : run(pointsRun)
    , cells(triangulation)
    , corners(cornersIn(pointsRun.source, triangulation))
  {
  }

  /// Of dimension 1 or 2: link the cells, and check them.
  /// @param fixedEdges null: it is regular
  Validation checkMesh(const Buffer<std::int64_t>* fixedEdges)
  {
    const Vertex* const points = this->corners.data();
    Monitor& monitor = this->run.monitor;
    if (this->cells.dimension == 1)
    {
      return this->chain.make(points, this->run.geometry, this->cells, monitor);
    }
    std::vector<std::uint32_t> ids;
    for (const Vertex& corner : this->corners)
    {
      ids.push_back(corner.id);
    }
    if (this->run.spanOf(ids.data(), static_cast<std::uint32_t>(ids.size())).dimension < 2)
    {
      return faultAt(Fault::WrongDimension, -1);
    }
    const Validation linked = this->mesh.link(this->cells, true, monitor);
    SurfaceCheck<Geometry> check(this->cells, this->mesh.triangles, this->mesh.cells.data(), points,
      this->run.geometry, monitor);
    const Validation plane = linked ? check.checkPlane() : linked;
    const Validation edges = plane ? check.checkEdges(CellForm::Canonical, fixedEdges) : plane;
    return edges && !fixedEdges ? check.checkExtreme() : edges;
  }

  TriangulationRun<true>& run;
  const Triangulation& cells;
  std::vector<Vertex> corners; ///< by index
  FanMesh mesh;                ///< of dimension 2
  SiteChain chain;             ///< of dimension 1
};

/// What check (run) finds of a triangulation whose structure is right, among points of which one is
/// finite.
template <class Check>
Validation validateTriangulation(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, int threads, const Check& check)
{
  Options options;
  options.threads = threads;
  options.nonFinite = NonFinitePolicy::Ignore;
  TriangulationRun<true> run(points, weights, options);
  Validation result = checkTriangulationStructure(points.count, triangulation);
  if (!result)
  {
    return result;
  }
  run.execute<Triangulation>(
    [&](Triangulation& scratch)
    {
      const bool isAny = run.inspect(scratch.statistics);
      const bool isMeant = triangulation.dimension >= 0;
      result = isAny != isMeant           ? faultAt(Fault::WrongDimension, -1)
        : isAny                           ? check(run)
        : triangulation.hiddenIds.empty() ? Validation()
                                          : faultAt(Fault::Structure, -1);
    });
  return result;
}

}

#endif
