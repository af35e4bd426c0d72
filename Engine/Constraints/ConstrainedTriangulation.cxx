// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A run of the Delaunay triangulation, into whose mesh the constraints go before it is written.
#include <flipflop/ConstrainedTriangulation.h>

#include "Constraints/ChainConstraints.h"
#include "Constraints/EdgeInsertion.h"
#include "Constraints/EdgeRecords.h"
#include "Constraints/PolyhedronSurface.h"
#include "Constraints/VertexAt.h"
#include "FlipFlop/CpuBuilder.h"
#include "Points/ConstraintInput.h"
#include "Run/TriangulationRun.h"
#include "Support/EngineCall.h"

#include <cstdint>
#include <utility>
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
  /// @throw Error ConstraintsCross
  static void insertConstraint(EdgeInsertion<PolyhedronSurface>& insertion,
    PolyhedronSurface& surface, std::uint32_t u, std::uint32_t v, std::uint32_t constraint,
    bool isSide, EdgeRecords& records)
  {
    // It begins where there are fewer triangles to examine: many constraints may end at one point.
    const bool isTurned = u != v && insertion.hasSmallerStar(v, u);
    if (isTurned)
    {
      std::swap(u, v);
    }
    SidesAlong sides;
    if (isSide)
    {
      sides.balance = isTurned ? -1 : 1;
      sides.first[isTurned] = constraint;
    }
    records.begin(u, v, constraint, sides);
    std::vector<FixedEdge> crossed;
    bool isKnown = false;
    const bool isFree = insertion.insert(
      u, v, [&] { return isKnown = records.isAgain(); },
      [&](std::uint32_t from, std::uint32_t to) { records.add(from, to); },
      [&](std::uint32_t h)
      {
        const Mesh& mesh = surface.mesh();
        crossed.emplace_back(mesh.origin(h), mesh.origin(mesh.twin(h)), 0);
      });
    if (!isFree)
    {
      throw Error(ErrorCode::ConstraintsCross, constraint, records.firstAlong(crossed));
    }
    if (!isKnown)
    {
      records.finish();
    }
  }

  bool changesTriangulation() const override { return this->constraints.count > 0; }

  bool beforeCanonicalForm(Polyhedron& polyhedron, Tally& tally, bool anyFlat) override
  {
    constexpr std::int64_t ConstraintsPerReport = 1 << 10;
    this->monitor.stage(0.9, 0.98, this->constraints.count, "inserting constraints");
    requireFinite(this->constraints, this->source, this->checkFinite);
    const Geometry local = this->geometry;
    const VertexAt vertexAt(this->source, polyhedron, this->constraints, this->monitor);
    PolyhedronSurface surface(local, polyhedron, this->monitor);
    EdgeInsertion<PolyhedronSurface> insertion(surface, this->monitor);
    EdgeRecords records;
    for (std::int64_t i = 0; i < this->constraints.count; ++i)
    {
      const std::int64_t* const ends = this->constraints.ends + 2 * i;
      insertConstraint(insertion, surface, vertexAt(ends[0]), vertexAt(ends[1]),
        static_cast<std::uint32_t>(i), i >= this->constraints.count - this->constraints.sides,
        records);
      if ((i + 1) % ConstraintsPerReport == 0)
      {
        this->monitor.advance(ConstraintsPerReport);
      }
    }
    this->edges = std::move(records.all());
    tally.statistics.flips22 += insertion.flipCount();
    tally.statistics.flipsV += insertion.flipCount();
    tally.statistics.edgeChecks += insertion.checkCount();
    const bool flat = surface.markFlatEdges(this->monitor);
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
