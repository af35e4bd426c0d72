// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A run of the Delaunay triangulation, into whose mesh the constraints go before it is written.
#include <flipflop/ConstrainedTriangulation.h>

#include "Constraints/ChainConstraints.h"
#include "Constraints/EdgeInsertion.h"
#include "Constraints/VertexAt.h"
#include "FlipFlop/CpuBuilder.h"
#include "Points/ConstraintInput.h"
#include "Run/TriangulationRun.h"
#include "Support/EngineCall.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

namespace
{

class ConstrainedRun : public TriangulationRun<false>
{
public:
  ConstrainedRun(const PointView& points, const ConstraintView& given, const Options& options)
    : TriangulationRun<false>(points, WeightView(), options)
    , constraints(given)
  {
    requireValid(given, points.count);
  }

  void triangulateConstrained(ConstrainedTriangulation& result)
  {
    CpuBuilder<Geometry> builder;
    this->computeSteps(builder, result);
    result.sides = this->constraints.sides;
    if (result.dimension < 2)
    {
      requireFinite(this->constraints, this->source, this->checkFinite);
      fixChainEdges(this->source, this->constraints, this->monitor, result);
    }
    else
    {
      writeFixedEdges(this->edges, result);
    }
  }

private:
  bool changesTriangulation() const override { return this->constraints.count > 0; }

  bool beforeCanonicalForm(Polyhedron& polyhedron, Tally& tally, bool anyFlat) override
  {
    constexpr std::int64_t ConstraintsPerReport = 1 << 10;
    this->monitor.stage(0.9, 0.98, this->constraints.count, "inserting constraints");
    requireFinite(this->constraints, this->source, this->checkFinite);
    const Geometry local = this->geometry;
    const VertexAt vertexAt(this->source, polyhedron, this->constraints, this->monitor);
    EdgeInsertion insertion(local, polyhedron, this->monitor);
    for (std::int64_t i = 0; i < this->constraints.count; ++i)
    {
      const std::int64_t* const ends = this->constraints.ends + 2 * i;
      insertion.insert(vertexAt(ends[0]), vertexAt(ends[1]), static_cast<std::uint32_t>(i),
        i >= this->constraints.count - this->constraints.sides);
      if ((i + 1) % ConstraintsPerReport == 0)
      {
        this->monitor.advance(ConstraintsPerReport);
      }
    }
    this->edges = std::move(insertion.fixedEdges());
    tally.statistics.flips22 += insertion.flipCount();
    tally.statistics.flipsV += insertion.flipCount();
    tally.statistics.edgeChecks += insertion.checkCount();
    const bool flat = insertion.markFlatEdges();
    tally.addPredicates(local, this->geometry);
    this->monitor.stage(0.98, 1.0, 1, "finishing");
    return anyFlat || flat;
  }

  void beforeCells(const VertexRanks& rank) override
  {
    for (FixedEdge& edge : this->edges)
    {
      edge = FixedEdge(rank[edge.low], rank[edge.high], edge.constraint, edge.sides);
    }
  }

  const ConstraintView constraints;
  std::vector<FixedEdge> edges; ///< by vertices of the mesh, and then by the result's points
};

}

ConstrainedTriangulation constrainedTriangulation(
  const PointView& points, const ConstraintView& constraints, const Options& options)
{
  return engineCall(
    [&]
    {
      ConstrainedRun run(points, constraints, options);
      return run.execute<ConstrainedTriangulation>(
        [&run](ConstrainedTriangulation& result) { run.triangulateConstrained(result); });
    });
}

}
