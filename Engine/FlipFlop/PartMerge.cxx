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
  tally.duplicates.insert(tally.duplicates.end(), this->duplicates.begin(), this->duplicates.end());
  tally.statistics.flips22 += this->flips;
  tally.statistics.flips31 += this->hidden;
  tally.statistics.flipsV += this->flips + this->hidden;
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
  { return part.isSingle() || ((Weighted || shore.reached > 0) && shore.vertex == from); };
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
      isFarther<Weighted>(side, v[lower.vertex[side]], v[upper.vertex[side]]) ? lower : upper;
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
    if (!a.isAbove && !c.isAbove)
    {
      break; // hidden vertices were left
    }
    const bool goesLeft =
      a.isAbove && (!c.isAbove || this->inCircle(true, a.vertex, c.vertex) <= 0);
    goesLeft ? this->reachLeft(a) : this->reachRight(c);
  }
  ensure(this->left.edges == 0 && this->right.edges == 0);
}

/// The next corner on one side, after the edges that lose are flipped out of the way.
template <bool Weighted>
typename PartMerge<Weighted>::Candidate PartMerge<Weighted>::candidate(bool isLeft)
{
  const Shore& shore = isLeft ? this->left : this->right;
  while (shore.edges > 0)
  {
    Candidate found;
    found.isLeft = isLeft;
    found.vertex = isLeft ? this->ring.begin(shore.spoke) : this->ring.end(shore.spoke);
    found.isAbove = this->orient(this->left.vertex, this->right.vertex, found.vertex) > 0;
    if (!found.isAbove && !(Weighted && this->isPassed(isLeft, found.vertex)))
    {
      return found;
    }
    const std::uint32_t inner = this->mesh.twin(nextHalfEdge(shore.spoke));
    const std::uint32_t apex = this->mesh.origin(previousHalfEdge(inner));
    if (apex == PlaneVirtual)
    {
      if (found.isAbove)
      {
        return found;
      }
      this->hideBeyond(isLeft, inner);
      continue;
    }
    const int sign = found.isAbove ? this->inCircle(isLeft, found.vertex, apex) : 1;
    if (sign <= 0)
    {
      found.isFlat = sign == 0;
      return found;
    }
    isLeft ? this->uncoverLeft(inner, found.vertex, apex)
           : this->uncoverRight(inner, found.vertex, apex);
  }
  return Candidate();
}

/// Is a vertex, not above the seam's last edge, beneath the triangle that is beneath that edge, or
/// behind its other edge? The seam has passed it then. Else the other side may rise to it yet.
template <bool Weighted>
bool PartMerge<Weighted>::isPassed(bool isLeft, std::uint32_t vertex)
{
  if (this->below == NoIndex || vertex == this->below)
  {
    return false;
  }
  return isLeft ? this->orient(this->left.vertex, this->below, vertex) > 0
                : this->orient(this->right.vertex, this->below, vertex) < 0;
}

/// The border passes both sides of the next edge, which does not stay: remove it, and all that only
/// it connects with its side. These vertices are hidden.
/// @param inner the edge's half-edge on the way back
template <bool Weighted>
void PartMerge<Weighted>::hideBeyond(bool isLeft, std::uint32_t inner)
{
  Shore& shore = isLeft ? this->left : this->right;
  const std::uint32_t back = previousHalfEdge(inner);
  const std::uint32_t onward = isLeft ? this->ring.previous(back) : this->ring.next(back);
  std::uint32_t edges = 1;
  for (std::uint32_t s = shore.spoke; triangleOf(s) != triangleOf(inner); ++edges)
  {
    ensure(edges < shore.edges);
    s = isLeft ? this->ring.previous(s) : this->ring.next(s);
  }
  this->mesh.removeTriangle(triangleOf(shore.spoke));
  this->mesh.removeTriangle(triangleOf(inner));
  const auto remove = [&](std::uint32_t t)
  {
    if (!this->mesh.isDead(t))
    {
      this->mesh.removeTriangle(t);
      this->hiding.push_back(t);
    }
  };
  const auto hide = [&](std::uint32_t v)
  {
    if (v != PlaneVirtual && (this->mesh.vertices[v].flags & VertexAlive))
    {
      ensure(v != this->left.vertex && v != this->right.vertex);
      this->mesh.vertices[v].flags = 0;
      ++this->hidden;
    }
  };
  const std::uint32_t first = isLeft ? this->ring.begin(shore.spoke) : this->ring.end(shore.spoke);
  this->noteIfDuplicates(first, shore.vertex);
  hide(first);
  remove(triangleOf(this->mesh.twin(isLeft ? shore.spoke : previousHalfEdge(shore.spoke))));
  while (!this->hiding.empty())
  {
    const std::uint32_t t = this->hiding.back();
    this->hiding.pop_back();
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t v = this->mesh.triangles[t].v[e];
      this->noteIfDuplicates(v, this->mesh.triangles[t].v[nextCorner(e)]);
      hide(v);
      remove(triangleOf(this->mesh.triangles[t].twin[e]));
    }
  }
  shore.spoke = onward;
  shore.edges -= edges;
}

/// Flip the border edge's triangle, of the half-edge @p inner from l to a and its apex d, with the
/// virtual triangle: ad and dl are border edges then, and dl the next.
template <bool Weighted>
void PartMerge<Weighted>::uncoverLeft(std::uint32_t inner, std::uint32_t a, std::uint32_t d)
{
  const std::uint32_t spoke = this->left.spoke;
  this->noteIfDuplicates(this->left.vertex, a);
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
  this->noteIfDuplicates(this->right.vertex, c);
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
  if (this->below != NoIndex && this->exactInCircle(next.isLeft, next.vertex, this->below) == 0)
  {
    this->mesh.markTied(onBase);
  }
}

template class PartMerge<false>;
template class PartMerge<true>;

}
