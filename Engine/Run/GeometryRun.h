// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A run over one geometry: from points to the perturbed result, and from there to the true one in
/// its canonical form. Hulls and triangulations do all of this alike.
#ifndef flipflop_GeometryRun_h
#define flipflop_GeometryRun_h

#include "Finish/Canonical.h"
#include "Finish/Redundant.h"
#include "FlipFlop/PolyhedronBuilder.h"
#include "Mesh/Polyhedron.h"
#include "Points/Samples.h"
#include "Run/Run.h"
#include "Run/Span.h"
#include <flipflop/CellComplex.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Model a model of the geometry concept (GeometryConcept.h), for which
///               startingTetrahedron(Model&, const PointSource&, const std::uint32_t*) starts from
///               points that span
template <class Model>
class GeometryRun : public Run
{
public:
  using Run::Run;
  virtual ~GeometryRun() = default;

  Model geometry;

  /// The result of all points, after a look at them.
  /// @param engine       does the work between the start and the finish
  /// @param dimension    of the space: as many and one points span it
  /// @param spanOf       Span (ids, count): points that span what a sample (null: all points) does,
  ///                     or what all do where that is more
  /// @param lowerResult  void (const Span&): fill in the result of points that span less
  /// @param finished     in what units to measure, for an engine that finishes itself
  /// @param write        see finish
  /// @param writeRest    void (): fill in what the result has beside points and cells, which the
  ///                     engine has written
  template <class SpanOf, class LowerResult, class Write, class WriteRest>
  void build(PolyhedronBuilder<Model>& engine, CellComplex& result, int dimension,
    FinishedCells& finished, SpanOf&& spanOf, LowerResult&& lowerResult, Write&& write,
    WriteRest&& writeRest)
  {
    const std::uint32_t count = this->source.count();
    const bool fromPoints = engine.startsFromPoints();
    const auto samples =
      fromPoints ? std::vector<std::vector<std::uint32_t>>() : nestedSamples(count);
    const Span span = samples.empty()
      ? spanOf(nullptr, count)
      : spanOf(samples.back().data(), static_cast<std::uint32_t>(samples.back().size()));
    result.statistics.secondsScan = this->watch.lap();
    if (span.dimension < dimension)
    {
      lowerResult(span);
      result.statistics.exactCalls = this->geometry.predicateCounts().exact;
      result.statistics.secondsFinish = this->watch.lap();
      return;
    }
    Tally tally;
    Polyhedron start =
      fromPoints ? Polyhedron() : startingTetrahedron(this->geometry, this->source, span.ids);
    PlanePolyhedron plane;
    Polyhedron polyhedron =
      engine.build({ this->geometry, this->source, this->range, this->checkFinite, this->options,
                     this->threads, this->monitor, samples, &finished, &plane },
        std::move(start), tally, result.statistics);
    this->watch.lap();
    result.dimension = dimension;
    if constexpr (Model::AllExtreme)
    {
      if (plane.vertexCount() > 0)
      {
        this->finish(std::move(plane), std::move(tally), result, write);
        return;
      }
    }
    if (!finished.written)
    {
      this->finish(std::move(polyhedron), std::move(tally), result, write);
      return;
    }
    result.pointIds = std::move(finished.pointIds);
    result.connectivity = std::move(finished.connectivity);
    result.cellSize = 3;
    writeRest();
    this->addStatistics(tally, result);
    result.statistics.secondsFinish += this->watch.lap();
  }

  /// From a hull of perturbed points to the true one, in canonical form.
  /// @param write void (CanonicalForm&): fill in the result's cells, and what else it has; its
  ///              points are known
  template <class Write>
  void finish(Polyhedron&& polyhedron, Tally&& tally, CellComplex& result, Write&& write)
  {
    this->monitor.stage(0.9, 1.0, 1, "finishing");
    const bool anyFlat =
      RedundantVertices<Model>(this->geometry, polyhedron, tally, this->monitor).remove();
    this->amendAndWrite(polyhedron, anyFlat, tally, result, write);
    result.statistics.secondsFinish = this->watch.lap();
  }

private:
  /// The same from a triangulation of the plane, which is the true one.
  template <class Write>
  void finish(PlanePolyhedron&& plane, Tally&& tally, CellComplex& result, Write&& write)
  {
    this->monitor.stage(0.9, 1.0, 1, "finishing");
    if (this->amends())
    {
      Polyhedron polyhedron = plane.full();
      plane = PlanePolyhedron();
      this->amendAndWrite(polyhedron, tally.ties > 0, tally, result, write);
    }
    else
    {
      this->writeForm(plane, tally.ties > 0, tally, result, write);
    }
    result.statistics.secondsFinish = this->watch.lap();
  }

  template <class Write>
  void amendAndWrite(
    Polyhedron& polyhedron, bool anyFlat, Tally& tally, CellComplex& result, Write&& write)
  {
    if (this->amends())
    {
      anyFlat = this->amend(polyhedron, tally, anyFlat);
    }
    this->writeForm(polyhedron, anyFlat, tally, result, write);
  }

  template <class Surface, class Write>
  void writeForm(
    Surface& surface, bool anyFlat, const Tally& tally, CellComplex& result, Write&& write)
  {
    CanonicalForm<Surface> form(surface, anyFlat, tally.duplicates, this->source.count(),
      this->options.facets, this->monitor, result.pointIds);
    this->monitor.poll();
    write(form);
    this->addStatistics(tally, result);
  }

  /// Does the run change the true result before it is written?
  virtual bool amends() const { return false; }

  /// Change it: what a run may want that is not of its points alone.
  /// @param anyFlat whether there is a flat edge
  /// @return        the same, after the change
  virtual bool amend(Polyhedron&, Tally&, bool anyFlat) { return anyFlat; }

  void addStatistics(const Tally& tally, CellComplex& result) const
  {
    result.statistics += tally.statistics;
    result.statistics.exactCalls += this->geometry.predicateCounts().exact;
  }
};

}

#endif
