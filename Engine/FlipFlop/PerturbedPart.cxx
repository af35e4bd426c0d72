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

/// Bring the first of each run of sorted vertices that are the same to the front.
/// @return where the others begin
template <class Same>
Vertex* keepFirsts(Vertex* first, Vertex* last, const Same& same)
{
  Vertex* kept = first;
  for (Vertex* v = first + 1; v < last; ++v)
  {
    if (!same(*kept, *v))
    {
      std::swap(*++kept, *v);
    }
  }
  return kept + 1;
}

/// Sort points on one line along it. At one position, all but one are hidden.
/// @return where the hidden ones begin
Vertex* sortCollinear(const LiftedGeometry<true>&, Vertex* first, Vertex* last)
{
  std::sort(first, last,
    [](const Vertex& p, const Vertex& q)
    {
      return p.x[0] != q.x[0] ? p.x[0] < q.x[0]
        : p.x[1] != q.x[1]    ? p.x[1] < q.x[1]
        : p.x[2] != q.x[2]    ? p.x[2] > q.x[2]
                              : p.id < q.id;
    });
  return keepFirsts(first, last, LiftedGeometry<true>::samePlanePosition);
}

/// Sort directions on one plane around the kernel point. Of several points in one direction, all
/// but the farthest are hidden.
Vertex* sortCollinear(const HullGeometry& geometry, Vertex* first, Vertex* last)
{
  const Vertex kernel = kernelVertex(geometry);
  const auto same = [&](const Vertex& p, const Vertex& q) { return geometry.sameDirection(p, q); };
  const Vertex* const other =
    std::find_if(first, last, [&](const Vertex& v) { return !same(*first, v); });
  int axis = 0; // one along which their plane is not seen edge on
  while (axis < 2 && other != last && geometry.turn(*first, *other, axis) == 0)
  {
    ++axis;
  }
  std::sort(first, last,
    [&](const Vertex& p, const Vertex& q)
    {
      const int turn = geometry.turn(p, q, axis);
      return turn != 0 ? turn > 0 : !samePosition(p, q) ? isWithin(kernel, p, q, 3) : p.id < q.id;
    });
  return keepFirsts(first, last, same);
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

/// Points on one line, or in space on one plane through the kernel point.
template <class Geometry>
Part PerturbedPart<Geometry>::merge(const Geometry& local, Tally& tally)
{
  Vertex* const first = this->mesh.vertices + this->begin;
  Vertex* const last = this->mesh.vertices + this->end;
  const std::uint32_t end =
    this->begin + static_cast<std::uint32_t>(sortCollinear(local, first, last) - first);
  tally.statistics.insertions += end - this->begin;
  return this->mergeRange(this->begin, end, local, tally);
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
