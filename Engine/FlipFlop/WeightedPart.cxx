// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/WeightedPart.h"

#include "FlipFlop/Insertion.h"
#include "FlipFlop/PartMerge.h"
#include "Geometry/LiftedStart.h"

#include <algorithm>
#include <utility>

namespace flipflop
{

PlanePart WeightedPart::build(Tally& tally)
{
  const Geometry before = this->geometry;
  const PlanePart part = startPart(this->mesh, this->begin, this->end, this->geometry)
    ? this->insertAll(tally)
    : this->mergeAlongLine(tally);
  tally.addPredicates(this->geometry, before);
  return part;
}

PlanePart WeightedPart::insertAll(Tally& tally)
{
  setKernelInside(this->geometry, this->mesh.vertices + this->begin);
  const auto notShared = [](std::uint32_t) { return false; };
  Flipper<Geometry, decltype(notShared)> flipper(
    this->geometry, this->mesh, notShared, this->vBiased, this->monitor);
  const std::uint32_t first = firstTriangleOf(this->begin);
  Insertion<Geometry, decltype(notShared)> insertion(
    this->geometry, this->mesh, flipper, first, first + 4, 2 * (this->end - this->begin));
  for (std::uint32_t v = this->begin + 3; v < this->end; ++v)
  {
    ensure(insertion.insert(v));
  }
  flipper.addTo(tally);
  insertion.addTo(tally);
  tally.statistics.insertions += 3;
  PlanePart part;
  part.firstFree = insertion.firstFree();
  findFarthest<true>(this->mesh, anySpoke(this->mesh, first), part);
  return part;
}

PlanePart WeightedPart::mergeAlongLine(Tally& tally)
{
  Vertex* const v = this->mesh.vertices;
  std::sort(v + this->begin, v + this->end,
    [](const Vertex& p, const Vertex& q)
    {
      return p.x[0] != q.x[0] ? p.x[0] < q.x[0]
        : p.x[1] != q.x[1]    ? p.x[1] < q.x[1]
        : p.x[2] != q.x[2]    ? p.x[2] > q.x[2]
                              : p.id < q.id;
    });
  // At one position, all but one are hidden.
  std::uint32_t stays = this->begin;
  for (std::uint32_t i = this->begin + 1; i < this->end; ++i)
  {
    if (!Geometry::samePlanePosition(v[stays], v[i]))
    {
      std::swap(v[++stays], v[i]);
    }
  }
  tally.statistics.insertions += stays + 1 - this->begin;
  return this->mergeRange(this->begin, stays + 1, tally);
}

PlanePart WeightedPart::mergeRange(std::uint32_t from, std::uint32_t to, Tally& tally) const
{
  if (to - from == 1)
  {
    this->mesh.vertices[from].flags = VertexAlive;
    PlanePart part;
    std::fill_n(part.vertex, 4, from);
    part.firstFree = firstTriangleOf(from);
    return part;
  }
  const std::uint32_t middle = from + (to - from) / 2;
  const PlanePart left = this->mergeRange(from, middle, tally);
  const PlanePart right = this->mergeRange(middle, to, tally);
  PartMerge<true> merge(this->geometry, this->mesh);
  const PlanePart whole = merge.merge(left, right);
  merge.addTo(tally);
  return whole;
}

}
