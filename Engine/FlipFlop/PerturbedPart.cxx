// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PerturbedPart.h"

#include "FlipFlop/Insertion.h"
#include "FlipFlop/PartMerge.h"
#include "Geometry/HullStart.h"
#include "Geometry/LiftedStart.h"

#include <algorithm>
#include <utility>

namespace flipflop
{

namespace
{

/// The geometry of a part, with a kernel point inside its first triangle's tetrahedron.
LiftedGeometry<true> geometryInside(const LiftedGeometry<true>& geometry, const Vertex* corner)
{
  LiftedGeometry<true> result = geometry;
  setKernelInside(result, corner);
  return result;
}

HullGeometry geometryInside(const HullGeometry& geometry, const Vertex* corner)
{
  HullGeometry result = geometry.withPoint(geometry.kernel());
  const Vertex corners[4] = { corner[0], corner[1], corner[2], kernelVertex(geometry) };
  setKernelInside(result, makeTetrahedron(corners));
  return result;
}

}

template <class Geometry>
Part PerturbedPart<Geometry>::build(Tally& tally)
{
  const Geometry local = this->geometry; // counts its own exact signs
  const Part part = startPart(this->mesh, this->begin, this->end, local)
    ? this->insertAll(tally)
    : this->merge(local, tally);
  tally.addPredicates(local, this->geometry);
  return part;
}

template <class Geometry>
Part PerturbedPart<Geometry>::insertAll(Tally& tally)
{
  const Geometry inside = geometryInside(this->geometry, this->mesh.vertices + this->begin);
  const Geometry before = inside;
  Flipper<Geometry, NoneShared> flipper(
    inside, this->mesh, NoneShared(), this->vBiased, this->monitor);
  const std::uint32_t first = firstTriangleOf(this->begin);
  Insertion<Geometry> insertion(
    inside, this->mesh, flipper, first, first + 4, 2 * (this->end - this->begin));
  for (std::uint32_t v = this->begin + 3; v < this->end; ++v)
  {
    ensure(insertion.insert(v));
  }
  flipper.addTo(tally);
  insertion.addTo(tally);
  tally.addPredicates(inside, before);
  tally.statistics.insertions += 3;
  Part part;
  part.firstFree = insertion.firstFree();
  setBorder<Geometry>(this->mesh, anySpoke(this->mesh, first), part);
  return part;
}

/// Points on one line, or on a plane through the kernel point.
template <class Geometry>
Part PerturbedPart<Geometry>::merge(const Geometry& local, Tally& tally)
{
  Vertex* const v = this->mesh.vertices;
  std::uint32_t stays = this->begin;
  if constexpr (Geometry::IsPlanar)
  {
    std::sort(v + this->begin, v + this->end,
      [](const Vertex& p, const Vertex& q)
      {
        return p.x[0] != q.x[0] ? p.x[0] < q.x[0]
          : p.x[1] != q.x[1]    ? p.x[1] < q.x[1]
          : p.x[2] != q.x[2]    ? p.x[2] > q.x[2]
                                : p.id < q.id;
      });
    // At one position, all but one are hidden.
    for (std::uint32_t i = this->begin + 1; i < this->end; ++i)
    {
      if (!Geometry::samePlanePosition(v[stays], v[i]))
      {
        std::swap(v[++stays], v[i]);
      }
    }
  }
  else
  {
    std::uint32_t second = this->begin + 1;
    while (second < this->end && local.sameDirection(v[this->begin], v[second]))
    {
      ++second;
    }
    if (second < this->end)
    {
      std::swap(v[++stays], v[second]);
    }
    this->end = stays + 1;
  }
  tally.statistics.insertions += stays + 1 - this->begin;
  return this->mergeRange(this->begin, stays + 1, local, tally);
}

template <class Geometry>
Part PerturbedPart<Geometry>::mergeRange(
  std::uint32_t from, std::uint32_t to, const Geometry& local, Tally& tally) const
{
  if (to - from == 1)
  {
    this->mesh.vertices[from].flags = VertexAlive;
    Part part;
    std::fill_n(part.vertex, 4, from);
    part.firstFree = firstTriangleOf(from);
    return part;
  }
  const std::uint32_t middle = from + (to - from) / 2;
  const Part left = this->mergeRange(from, middle, local, tally);
  const Part right = this->mergeRange(middle, to, local, tally);
  PartMerge<Geometry> merge(local, this->mesh);
  const Part whole = merge.merge(left, right);
  merge.addTo(tally);
  return whole;
}

template class PerturbedPart<LiftedGeometry<true>>;
template class PerturbedPart<HullGeometry>;

}
