// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The steps of regularTriangulation(), as a TriangulationRun does them: inspect, span, start,
/// build, finish.
#include <flipflop/RegularTriangulation.h>

#include "Finish/Canonical.h"
#include "Finish/Redundant.h"
#include "FlipFlop/CpuBuilder.h"
#include "Geometry/LiftedStart.h"
#include "Points/PointSubset.h"
#include "Run/Chain.h"
#include "Run/TriangulationRun.h"
#include "Support/EngineCall.h"
#include "Support/Parallel.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

namespace flipflop
{

Triangulation regularTriangulation(
  const PointView& points, const WeightView& weights, const Options& options)
{
  return engineCall(
    [&]
    {
      return withOrWithoutWeights(points, weights,
        [&](auto weighted, const WeightView& thatMatter)
        {
          TriangulationRun<weighted> run(points, thatMatter, options);
          CpuBuilder<LiftedGeometry<weighted>> builder;
          return run.compute(builder);
        });
    });
}

namespace
{

template <class T>
bool anyDiffers(const WeightView& weights)
{
  const T* const w = static_cast<const T*>(weights.data);
  std::int64_t i = 0;
  while (i < weights.count && std::isfinite(w[i * weights.stride]) && w[i * weights.stride] == w[0])
  {
    ++i;
  }
  return i < weights.count;
}

}

bool matter(const WeightView& weights, std::int64_t pointCount)
{
  if (!weights.data && weights.count == 0)
  {
    return false;
  }
  const bool valid =
    weights.data && weights.stride > 0 && weights.count == pointCount && pointCount < NoIndex;
  return !valid ||
    (weights.type == ScalarType::Float32 ? anyDiffers<float>(weights)
                                         : anyDiffers<double>(weights));
}

template <bool Weighted>
TriangulationRun<Weighted>::TriangulationRun(
  const PointView& points, const WeightView& weights, const Options& options)
  : GeometryRun<Geometry>(points, 2, PointSource(points, weights), options)
{
  requireValid(weights, points.count);
}

template <bool Weighted>
Triangulation TriangulationRun<Weighted>::compute(PolyhedronBuilder<Geometry>& builder)
{
  return this->template execute<Triangulation>(
    [&](Triangulation& result) { this->computeSteps(builder, result); });
}

template <bool Weighted>
void TriangulationRun<Weighted>::computeSteps(
  PolyhedronBuilder<Geometry>& builder, Triangulation& result)
{
  if (!this->inspect(result.statistics, &builder))
  {
    return;
  }
  const bool fromPoints = builder.startsFromPoints();
  const Samples samples = fromPoints ? Samples() : nestedSamples(this->source.count());
  const Span span = fromPoints ? this->firstSpan() : this->spanOf(samples);
  result.statistics.secondsScan = this->watch.lap();
  if (span.dimension < 2)
  {
    this->finishLower(result);
    return;
  }
  Polyhedron start =
    fromPoints ? Polyhedron() : startingTetrahedron(this->geometry, this->source, span.ids);

  Tally tally;
  BuildResult built =
    builder.build(this->task(samples), std::move(start), tally, result.statistics);
  this->watch.lap();

  result.dimension = 2;
  std::visit([&](auto& made) { this->finish(std::move(made), tally, result); }, built);
}

template <bool Weighted>
bool TriangulationRun<Weighted>::inspect(Statistics& statistics, PointScanner* scanner)
{
  if (!this->scanPoints(statistics, scanner))
  {
    return false;
  }
  this->setArithmetic(chooseLiftedArithmetic(this->range));
  Lattice lattice = this->findLattice(2, Geometry::LatticeBits);
  lattice.everywhere = lattice.everywhere &&
    this->range.high[2] - this->range.low[2] < Geometry::latticeWeights(lattice.unit);
  this->geometry = Geometry(this->range, this->arithmetic, lattice);
  return true;
}

template <bool Weighted>
Span TriangulationRun<Weighted>::firstSpan()
{
  const Geometry local = this->geometry;
  Span span;
  Vertex corner[3];
  for (std::uint32_t id = 0; id < this->source.count() && span.dimension < 2; ++id)
  {
    if ((id & 0xFFFF) == 0)
    {
      this->monitor.poll();
    }
    const Vertex p = this->source.vertex(id);
    if ((!this->checkFinite || isFinite(p.x)) &&
      (span.dimension < 0 ||
        (span.dimension == 0 ? !Geometry::samePlanePosition(corner[0], p)
                             : local.orient(corner[0], corner[1], p) != 0)))
    {
      corner[++span.dimension] = p;
      span.ids[span.dimension] = id;
    }
  }
  return span;
}

template <bool Weighted>
void TriangulationRun<Weighted>::finishLower(Triangulation& result)
{
  chainOfPoints(this->geometry, this->source, this->checkFinite, this->monitor, result);
  this->listHidden(result);
  this->addStatistics(Tally(), result.statistics);
}

template <bool Weighted>
void TriangulationRun<Weighted>::finish(
  Polyhedron&& polyhedron, Tally& tally, Triangulation& result)
{
  this->monitor.stage(0.9, 1.0, 1, "finishing");
  const bool anyFlat =
    RedundantVertices<Geometry>(this->geometry, polyhedron, tally, this->monitor).remove();
  this->write(polyhedron, this->beforeCanonicalForm(polyhedron, tally, anyFlat), tally, result);
}

template <bool Weighted>
void TriangulationRun<Weighted>::finish(
  PlanePolyhedron&& plane, Tally& tally, Triangulation& result)
{
  this->monitor.stage(0.9, 1.0, 1, "finishing");
  const bool anyFlat = tally.ties > 0;
  if (!this->changesTriangulation())
  {
    this->write(plane, anyFlat, tally, result);
    return;
  }
  Polyhedron polyhedron = plane.full();
  plane = PlanePolyhedron();
  this->write(polyhedron, this->beforeCanonicalForm(polyhedron, tally, anyFlat), tally, result);
}

template <bool Weighted>
void TriangulationRun<Weighted>::finish(FinishedCells&& cells, Tally& tally, Triangulation& result)
{
  this->moveCells(std::move(cells), result);
  this->listHidden(result);
  this->addStatistics(tally, result.statistics);
}

template <bool Weighted>
template <class Surface>
void TriangulationRun<Weighted>::write(
  Surface& surface, bool anyFlat, const Tally& tally, Triangulation& result)
{
  CanonicalForm<Surface> form(surface, anyFlat, tally.duplicates, this->source.count(),
    this->options.facets, this->monitor, result.pointIds);
  this->monitor.poll();
  this->listHidden(result);
  this->monitor.poll();
  this->beforeCells(form.ranks());
  form.writeCells(this->monitor, result);
  this->addStatistics(tally, result.statistics);
}

template <bool Weighted>
void TriangulationRun<Weighted>::listHidden(Triangulation& result)
{
  const Buffer<std::int64_t>& visible = result.pointIds;
  const std::int64_t seen = result.statistics.nonFinite + static_cast<std::int64_t>(visible.size());
  if (seen == static_cast<std::int64_t>(this->source.count()))
  {
    result.hiddenIds.allocate(0);
    return;
  }
  constexpr std::size_t PointsPerTask = 1 << 14;
  parallelCompact(
    this->source.count(), PointsPerTask,
    [&](std::size_t begin, std::size_t end, const auto& emit)
    {
      this->monitor.poll();
      PointSubset::eachRemaining(
        static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
        [](std::uint32_t id) { return id; }, visible.begin(), visible.end(),
        this->checkFinite ? &this->source : nullptr, emit);
    },
    [&](std::size_t hidden) { result.hiddenIds.allocate(hidden); },
    [&](std::size_t at, std::uint32_t id) { result.hiddenIds[at] = id; });
}

template class TriangulationRun<false>;
template class TriangulationRun<true>;
template void TriangulationRun<false>::write(Polyhedron&, bool, const Tally&, Triangulation&);

}
