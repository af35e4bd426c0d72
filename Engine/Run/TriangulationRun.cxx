// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/TriangulationRun.h"

#include "Points/PointSubset.h"
#include "Run/Chain.h"
#include "Support/Parallel.h"

#include <cstdint>

namespace flipflop
{

template <bool Weighted>
TriangulationRun<Weighted>::TriangulationRun(
  const PointView& points, const WeightView& weights, const Options& options)
  : GeometryRun<Geometry>(points, 2, PointSource(points, weights), options)
{
  requireValid(weights, points.count);
}

template <bool Weighted>
bool TriangulationRun<Weighted>::inspect(Statistics& statistics, PointScanner* scanner)
{
  if (!this->look(statistics, scanner))
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
Span TriangulationRun<Weighted>::spanOf(const std::uint32_t* ids, std::uint32_t count)
{
  // In space, with zero for the third coordinate.
  CoordinateRange flatRange = this->range;
  flatRange.low[2] = flatRange.high[2] = 0;
  const HullGeometry flat(flatRange, this->arithmetic);
  return findSpan(flat, this->source.flattened(), ids, count, 2, this->checkFinite, this->monitor);
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
        (span.dimension == 0 ? !Geometry::samePlace(corner[0], p)
                             : local.orient(corner[0], corner[1], p) != 0)))
    {
      corner[++span.dimension] = p;
      span.ids[span.dimension] = id;
    }
  }
  return span;
}

template <bool Weighted>
void TriangulationRun<Weighted>::triangulate(
  PolyhedronBuilder<Geometry>& engine, Triangulation& result)
{
  if (!this->inspect(result.statistics, &engine))
  {
    return;
  }
  const auto chain = [&](const Span&)
  {
    chainOfPoints(this->geometry, this->source, this->checkFinite, this->monitor, result);
    this->listHidden(result);
  };
  FinishedCells finished;
  this->build(
    engine, result, 2, finished,
    [&](const std::uint32_t* ids, std::uint32_t count)
    { return engine.startsFromPoints() ? this->firstSpan() : this->spanOf(ids, count); },
    chain,
    [&](auto& form)
    {
      this->listHidden(result);
      this->monitor.poll();
      this->describe(form.ranks());
      form.writeCells(this->monitor, result);
    },
    [&] { this->listHidden(result); });
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
  numberFound(
    this->source.count(), PointsPerTask,
    [&](std::size_t begin, std::size_t end, const auto& tell)
    {
      this->monitor.poll();
      PointSubset::eachLeft(
        static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
        [](std::uint32_t id) { return id; }, visible.begin(), visible.end(),
        this->checkFinite ? &this->source : nullptr, tell);
    },
    [&](std::size_t hidden) { result.hiddenIds.allocate(hidden); },
    [&](std::size_t at, std::uint32_t id) { result.hiddenIds[at] = id; });
}

template class TriangulationRun<false>;
template class TriangulationRun<true>;

}
