// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartMerge.h"

#include <flipflop/Error.h>

namespace flipflop
{

template <bool Weighted>
PlanePart PartMerge<Weighted>::merge(const PlanePart& first, const PlanePart& second)
{
  const auto coordinate = [this](const PlanePart& part, int side)
  { return this->mesh.vertices[part.vertex[side]].x[side / 2]; };
  const PlanePart* lower = &first; // the left one or the lower one
  const PlanePart* upper = &second;
  int axis = 0;
  for (; axis < 2; ++axis)
  {
    const int least = axis == 0 ? LeastX : LeastY;
    const int most = axis == 0 ? MostX : MostY;
    if (coordinate(first, most) < coordinate(second, least))
    {
      break;
    }
    if (coordinate(second, most) < coordinate(first, least))
    {
      std::swap(lower, upper);
      break;
    }
  }
  ensure(axis < 2);

  this->left = { NoIndex, lower->spoke[axis == 0 ? MostX : MostY], 0, 0 };
  this->right = { NoIndex, upper->spoke[axis == 0 ? LeastX : LeastY], 0, 0 };
  this->left.vertex = lower->vertex[axis == 0 ? MostX : MostY];
  this->right.vertex = upper->vertex[axis == 0 ? LeastX : LeastY];
  this->countEdgesAbove();
  this->findLowerTangent();
  return this->join(*lower, *upper);
}

template <bool Weighted>
void PartMerge<Weighted>::addTo(Tally& tally) const
{
  tally.ties += this->ties;
  tally.statistics.flips22 += this->flips;
  tally.statistics.flipsV += this->flips;
  tally.statistics.edgeChecks += this->checks;
}

/// Count the border edges from the facing extremes up to the upper common tangent.
template <bool Weighted>
void PartMerge<Weighted>::countEdgesAbove()
{
  Shore l = this->left;
  Shore r = this->right;
  while (true)
  {
    if (l.spoke != NoIndex)
    {
      const std::uint32_t spoke = this->ring.previous(l.spoke);
      const std::uint32_t vertex = this->ring.begin(spoke);
      if (this->orient(vertex, l.vertex, r.vertex) > 0)
      {
        l.spoke = spoke;
        l.vertex = vertex;
        ++this->left.edges;
        continue;
      }
    }
    if (r.spoke != NoIndex)
    {
      const std::uint32_t vertex = this->ring.end(r.spoke);
      if (this->orient(r.vertex, vertex, l.vertex) > 0)
      {
        r.spoke = this->ring.next(r.spoke);
        r.vertex = vertex;
        ++this->right.edges;
        continue;
      }
    }
    return;
  }
}

/// Go down from the facing extremes to the lower common tangent, and count the edges, too.
template <bool Weighted>
void PartMerge<Weighted>::findLowerTangent()
{
  Shore& l = this->left;
  Shore& r = this->right;
  while (true)
  {
    if (l.spoke != NoIndex)
    {
      const std::uint32_t vertex = this->ring.end(l.spoke);
      if (this->orient(l.vertex, vertex, r.vertex) > 0)
      {
        l.spoke = this->ring.next(l.spoke);
        l.vertex = vertex;
        ++l.edges;
        continue;
      }
    }
    if (r.spoke != NoIndex)
    {
      const std::uint32_t spoke = this->ring.previous(r.spoke);
      const std::uint32_t vertex = this->ring.begin(spoke);
      if (this->orient(vertex, r.vertex, l.vertex) > 0)
      {
        r.spoke = spoke;
        r.vertex = vertex;
        ++r.edges;
        continue;
      }
    }
    return;
  }
}

/// From the lower tangent up: the seam, and the border around both parts.
template <bool Weighted>
PlanePart PartMerge<Weighted>::join(const PlanePart& lower, const PlanePart& upper)
{
  const std::uint32_t bottom = lower.firstFree;
  const std::uint32_t top = bottom + 1;
  const std::uint32_t lowest[2] = { this->left.vertex, this->right.vertex };
  // The border is cut open at the tangent before the seam begins. The seam may take all edges of a
  // part, and comes back to where it began then.
  this->mesh.setTriangle(bottom, this->right.vertex, this->left.vertex, PlaneVirtual);
  if (this->left.spoke != NoIndex)
  {
    const std::uint32_t spoke = this->ring.previous(this->left.spoke);
    this->mesh.link(halfEdge(bottom, 1), this->left.spoke);
    this->left.spoke = spoke;
  }
  if (this->right.spoke != NoIndex)
  {
    const std::uint32_t spoke = this->ring.previous(this->right.spoke);
    this->mesh.link(halfEdge(bottom, 2), previousHalfEdge(spoke));
  }
  this->base = halfEdge(bottom, 0);
  this->below = NoIndex;
  this->rise();

  this->mesh.setTriangle(top, this->left.vertex, this->right.vertex, PlaneVirtual);
  this->mesh.link(this->base, halfEdge(top, 0));
  const auto isConsumed = [&](const PlanePart& part, const Shore& shore, std::uint32_t from)
  { return part.isSingle() || (shore.reached > 0 && shore.vertex == from); };
  this->mesh.link(halfEdge(top, 2),
    isConsumed(lower, this->left, lowest[0]) ? halfEdge(bottom, 1)
                                             : previousHalfEdge(this->left.spoke));
  this->mesh.link(halfEdge(top, 1),
    isConsumed(upper, this->right, lowest[1]) ? halfEdge(bottom, 2) : this->right.spoke);

  PlanePart whole;
  whole.firstFree = upper.firstFree;
  for (int side = 0; side < 4; ++side)
  {
    const auto* const v = this->mesh.vertices;
    const PlanePart& from =
      isFarther(side, v[lower.vertex[side]].x, v[upper.vertex[side]].x) ? lower : upper;
    const std::uint32_t vertex = from.vertex[side];
    whole.vertex[side] = vertex;
    // Two border edges are new.
    whole.spoke[side] = vertex == lowest[1] ? halfEdge(bottom, 2)
      : vertex == this->left.vertex         ? halfEdge(top, 2)
                                            : from.spoke[side];
  }
  return whole;
}

template <bool Weighted>
void PartMerge<Weighted>::rise()
{
  while (this->left.edges > 0 || this->right.edges > 0)
  {
    const Candidate a = this->candidate(true);
    const Candidate c = this->candidate(false);
    ensure(a.isAbove || c.isAbove);
    const bool goesLeft = a.isAbove &&
      (!c.isAbove ||
        this->inCircle(this->left.vertex, this->right.vertex, a.vertex, c.vertex) <= 0);
    goesLeft ? this->reachLeft(a) : this->reachRight(c);
  }
}

/// The next corner on one side, after the edges that lose are flipped out of the way.
template <bool Weighted>
typename PartMerge<Weighted>::Candidate PartMerge<Weighted>::candidate(bool isLeft)
{
  const Shore& shore = isLeft ? this->left : this->right;
  Candidate found;
  if (shore.edges == 0)
  {
    return found;
  }
  const std::uint32_t l = this->left.vertex;
  const std::uint32_t r = this->right.vertex;
  found.vertex = isLeft ? this->ring.begin(shore.spoke) : this->ring.end(shore.spoke);
  found.isAbove = this->orient(l, r, found.vertex) > 0;
  while (found.isAbove)
  {
    const std::uint32_t inner = this->mesh.twin(nextHalfEdge(shore.spoke));
    const std::uint32_t apex = this->mesh.origin(previousHalfEdge(inner));
    if (apex == PlaneVirtual)
    {
      break;
    }
    const int sign = this->inCircle(l, r, found.vertex, apex);
    if (sign <= 0)
    {
      found.isFlat = sign == 0;
      break;
    }
    isLeft ? this->uncoverLeft(inner, found.vertex, apex)
           : this->uncoverRight(inner, found.vertex, apex);
    found.vertex = apex;
  }
  return found;
}

/// Flip the border edge's triangle, of the half-edge @p inner from l to a and its apex d, with the
/// virtual triangle: ad and dl are border edges then, and dl the next.
template <bool Weighted>
void PartMerge<Weighted>::uncoverLeft(std::uint32_t inner, std::uint32_t a, std::uint32_t d)
{
  const std::uint32_t spoke = this->left.spoke;
  const std::uint32_t t = triangleOf(inner);
  const std::uint32_t da = this->mesh.twin(nextHalfEdge(inner));
  const std::uint32_t ld = this->mesh.twin(previousHalfEdge(inner));
  const std::uint32_t back = this->mesh.twin(spoke);
  this->mesh.triangles[triangleOf(spoke)].v[nextCorner(cornerOf(spoke))] = d;
  this->mesh.link(nextHalfEdge(spoke), ld);
  this->mesh.setTriangle(t, a, d, PlaneVirtual);
  this->mesh.link(halfEdge(t, 0), da);
  this->mesh.link(halfEdge(t, 1), spoke);
  this->mesh.link(halfEdge(t, 2), back);
  ++this->left.edges;
  ++this->flips;
}

/// The same on the right, of the half-edge from c to r: rd and dc are border edges then, and rd the
/// next.
template <bool Weighted>
void PartMerge<Weighted>::uncoverRight(std::uint32_t inner, std::uint32_t c, std::uint32_t d)
{
  const std::uint32_t spoke = this->right.spoke;
  const std::uint32_t t = triangleOf(inner);
  const std::uint32_t dr = this->mesh.twin(nextHalfEdge(inner));
  const std::uint32_t cd = this->mesh.twin(previousHalfEdge(inner));
  const std::uint32_t onward = this->mesh.twin(previousHalfEdge(spoke));
  this->mesh.triangles[triangleOf(spoke)].v[previousCorner(cornerOf(spoke))] = d;
  this->mesh.link(nextHalfEdge(spoke), dr);
  this->mesh.setTriangle(t, d, c, PlaneVirtual);
  this->mesh.link(halfEdge(t, 0), cd);
  this->mesh.link(halfEdge(t, 1), onward);
  this->mesh.link(halfEdge(t, 2), previousHalfEdge(spoke));
  ++this->right.edges;
  ++this->flips;
}

/// The virtual triangle of the next border edge on the left becomes the seam's triangle.
template <bool Weighted>
void PartMerge<Weighted>::reachLeft(const Candidate& next)
{
  const std::uint32_t spoke = this->left.spoke;
  const std::uint32_t onward = this->ring.previous(spoke);
  this->mesh.triangles[triangleOf(spoke)].v[cornerOf(spoke)] = this->right.vertex;
  this->closeTriangle(previousHalfEdge(spoke), nextHalfEdge(spoke), next);
  this->base = spoke;
  this->below = std::exchange(this->left.vertex, next.vertex);
  this->left.spoke = onward;
  this->left.advance();
}

template <bool Weighted>
void PartMerge<Weighted>::reachRight(const Candidate& next)
{
  const std::uint32_t spoke = this->right.spoke;
  const std::uint32_t onward = this->ring.next(spoke);
  this->mesh.triangles[triangleOf(spoke)].v[cornerOf(spoke)] = this->left.vertex;
  this->closeTriangle(spoke, nextHalfEdge(spoke), next);
  this->base = previousHalfEdge(spoke);
  this->below = std::exchange(this->right.vertex, next.vertex);
  this->right.spoke = onward;
  this->right.advance();
}

/// Link the seam's new triangle to the one beneath, and mark its flat edges (PlanePolyhedron.h).
/// @param onBase, outer its half-edges on the seam's last edge, and on the part's border
template <bool Weighted>
void PartMerge<Weighted>::closeTriangle(
  std::uint32_t onBase, std::uint32_t outer, const Candidate& next)
{
  this->mesh.setMarks(triangleOf(onBase), 0);
  this->mesh.link(onBase, this->base);
  if (next.isFlat)
  {
    this->mesh.markTied(outer);
  }
  if (this->below != NoIndex &&
    this->inCircle(this->left.vertex, this->right.vertex, next.vertex, this->below) == 0)
  {
    this->mesh.markTied(onBase);
  }
}

template class PartMerge<false>;

}
