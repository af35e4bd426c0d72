// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/PartMerge.h"

#include <flipflop/Error.h>

#include <algorithm>
#include <utility>

namespace flipflop
{

template <class Geometry>
Part PartMerge<Geometry>::merge(const Part& first, const Part& second)
{
  if constexpr (!Geometry::IsPlanar)
  {
    this->findTangents(first, second);
    return this->join(first, second);
  }
  const auto coordinate = [this](const Part& part, int side)
  { return this->mesh.vertices[part.vertex[side]].x[side / 2]; };
  const Part* lower = &first; // the left one or the lower one
  const Part* upper = &second;
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
  this->findTangents(*lower, *upper, axis);
  return this->join(*lower, *upper);
}

template <class Geometry>
void PartMerge<Geometry>::addTo(Tally& tally) const
{
  tally.ties += this->ties;
  tally.duplicates.insert(tally.duplicates.end(), this->duplicates.begin(), this->duplicates.end());
  tally.statistics.flips22 += this->flips;
  tally.statistics.flips31 += this->hidden;
  tally.statistics.flipsV += this->flips + this->hidden;
  tally.statistics.edgeChecks += this->checks;
  tally.statistics.moves += this->walked;
}

/// In the plane, from the vertices that face each other: count the edges up to the upper common
/// tangent, then go down to the lower one, and count these, too.
template <class Geometry>
void PartMerge<Geometry>::findTangents(const Part& lower, const Part& upper, int axis)
{
  const int most = axis == 0 ? MostX : MostY;
  const int least = axis == 0 ? LeastX : LeastY;
  this->left = this->shoreOf(true, lower.vertex[most], lower.spoke[most]);
  this->right = this->shoreOf(false, upper.vertex[least], upper.spoke[least]);
  Shore l = this->left;
  Shore r = this->right;
  while (this->follow(l, true, l, r) || this->follow(r, true, l, r))
  {
  }
  while (this->follow(this->left, false, this->left, this->right) ||
    this->follow(this->right, false, this->left, this->right))
  {
  }
  this->left.edges += l.edges;
  this->right.edges += r.edges;
}

/// Follow a shore by one edge, up or down, if that leads above or below the line from l to r.
template <class Geometry>
bool PartMerge<Geometry>::follow(Shore& shore, bool up, const Shore& l, const Shore& r)
{
  if (shore.spoke == NoIndex)
  {
    return false;
  }
  const std::uint32_t spoke = up ? shore.spoke : this->backward(shore, shore.spoke);
  const std::uint32_t vertex = up ? this->upper(shore, spoke) : this->lower(shore, spoke);
  const int sign = this->orient(l.vertex, r.vertex, vertex);
  if (up ? sign <= 0 : sign >= 0)
  {
    return false;
  }
  shore.spoke = up ? this->onward(shore, spoke) : spoke;
  shore.vertex = vertex;
  ++shore.edges;
  return true;
}

/// In space, from any vertices: find both common tangents, and count the edges between them. A part
/// of more than a point has some, and all of them where both tangents are at one vertex.
template <class Geometry>
void PartMerge<Geometry>::findTangents(const Part& first, const Part& second)
{
  this->left = this->shoreOf(true, first.vertex[0], first.spoke[0]);
  this->right = this->shoreOf(false, second.vertex[0], second.spoke[0]);
  this->turn(this->left, this->right, false);
  Shore l = this->left;
  Shore r = this->right;
  this->turn(l, r, true);
  for (const auto& [shore, end] :
    { std::pair{ &this->left, l.vertex }, { &this->right, r.vertex } })
  {
    shore->edges = 0;
    std::uint32_t vertex = NoIndex;
    for (std::uint32_t s = shore->spoke; s != NoIndex && vertex != end; s = this->onward(*shore, s))
    {
      vertex = this->upper(*shore, s);
      ++shore->edges;
    }
  }
}

/// Turn the line from l to r to the upper or the lower common tangent: by turns to that of each
/// part through the other's vertex. Seen from there, the way around a part rises on one side and
/// falls on the other.
template <class Geometry>
void PartMerge<Geometry>::turn(Shore& l, Shore& r, bool up)
{
  const int side = up ? 1 : -1;
  const auto step = [&](Shore& shore)
  {
    if (shore.spoke == NoIndex)
    {
      return false;
    }
    const std::uint32_t back = this->backward(shore, shore.spoke);
    const std::uint32_t above = this->upper(shore, shore.spoke);
    const std::uint32_t beneath = this->lower(shore, back);
    const bool first = this->orient(l.vertex, r.vertex, up ? above : beneath) == side;
    if (!first && this->orient(l.vertex, r.vertex, up ? beneath : above) != side)
    {
      return false;
    }
    const bool goesUp = first == up;
    shore.vertex = goesUp ? above : beneath;
    shore.spoke = goesUp ? this->onward(shore, shore.spoke) : back;
    return true;
  };
  while (step(l) || step(r))
  {
  }
}

/// Cut the borders open where the seam begins. It may take all edges of a part, and comes back to
/// where it began then.
/// @param bottom a free triangle: it closes the border there
template <class Geometry>
void PartMerge<Geometry>::cutBorders(std::uint32_t bottom)
{
  this->mesh.setTriangle(bottom, this->right.vertex, this->left.vertex, VirtualSlot);
  for (const Shore* shore : { &this->left, &this->right })
  {
    if (shore->spoke != NoIndex)
    {
      this->mesh.link(
        bottomSide(*shore, bottom), upperSide(*shore, this->backward(*shore, shore->spoke)));
    }
  }
  this->base = halfEdge(bottom, 0);
  this->below = NoIndex;
}

/// From the lower tangent up: the seam, and the border around both parts.
template <class Geometry>
Part PartMerge<Geometry>::join(const Part& lower, const Part& upper)
{
  const std::uint32_t bottom = lower.firstFree;
  const std::uint32_t top = bottom + 1;
  const std::uint32_t lowest[2] = { this->left.vertex, this->right.vertex };
  this->cutBorders(bottom);
  this->rise();

  this->mesh.setTriangle(top, this->left.vertex, this->right.vertex, VirtualSlot);
  this->mesh.link(this->base, halfEdge(top, 0));
  for (const Shore* shore : { &this->left, &this->right })
  {
    const bool isSingle = (shore->isLeft ? lower : upper).isSingle();
    const bool isConsumed =
      isSingle || ((Hides || shore->reached > 0) && shore->vertex == lowest[shore->isLeft ? 0 : 1]);
    this->mesh.link(halfEdge(top, shore->isLeft ? 2 : 1),
      isConsumed ? bottomSide(*shore, bottom) : lowerSide(*shore, shore->spoke));
  }

  Part whole;
  whole.firstFree = upper.firstFree;
  if constexpr (!Geometry::IsPlanar)
  {
    std::fill_n(whole.vertex, 4, this->left.vertex);
    std::fill_n(whole.spoke, 4, halfEdge(top, 2));
    return whole;
  }
  for (int side = 0; side < 4; ++side)
  {
    const auto* const v = this->mesh.vertices;
    const Part& from =
      isFarther<Geometry>(side, v[lower.vertex[side]], v[upper.vertex[side]]) ? lower : upper;
    const std::uint32_t vertex = from.vertex[side];
    whole.vertex[side] = vertex;
    // Two border edges are new.
    whole.spoke[side] = vertex == lowest[1] ? halfEdge(bottom, 2)
      : vertex == this->left.vertex         ? halfEdge(top, 2)
                                            : from.spoke[side];
  }
  return whole;
}

template <class Geometry>
void PartMerge<Geometry>::rise()
{
  while (this->left.edges > 0 || this->right.edges > 0)
  {
    const Candidate a = this->candidate(this->left);
    const Candidate c = this->candidate(this->right);
    if (!a.isAbove && !c.isAbove)
    {
      break; // hidden vertices were left
    }
    const bool goesLeft = a.isAbove && (!c.isAbove || this->inCircle(a, c.vertex) <= 0);
    goesLeft ? this->reach(this->left, a) : this->reach(this->right, c);
  }
  ensure(this->left.edges == 0 && this->right.edges == 0);
}

/// The next corner on a shore, after the edges that lose are flipped out of the way.
template <class Geometry>
typename PartMerge<Geometry>::Candidate PartMerge<Geometry>::candidate(Shore& shore)
{
  Candidate found{ &shore };
  while (shore.edges > 0)
  {
    found.vertex = this->upper(shore, shore.spoke);
    found.isAbove = this->orient(this->left.vertex, this->right.vertex, found.vertex) > 0;
    if (!found.isAbove && !(Hides && this->isPassed(shore, found.vertex)))
    {
      return found;
    }
    const std::uint32_t inner = this->mesh.twin(nextHalfEdge(shore.spoke));
    const std::uint32_t apex = this->mesh.origin(previousHalfEdge(inner));
    if (apex == VirtualSlot)
    {
      if (!Hides || (found.isAbove && !this->losesBeyond(shore, inner, found)))
      {
        return found;
      }
      this->hideBeyond(shore, inner);
      continue;
    }
    const int sign = found.isAbove ? this->inCircle(found, apex) : 1;
    if (sign <= 0)
    {
      found.isFlat = sign == 0;
      return found;
    }
    this->uncover(shore, inner);
  }
  return { &shore };
}

/// Is a vertex, not above the seam's last edge, beneath the triangle that is beneath that edge, or
/// behind its other edge? The seam has passed it then. Else the other side may rise to it yet.
template <class Geometry>
bool PartMerge<Geometry>::isPassed(const Shore& shore, std::uint32_t vertex)
{
  return this->below != NoIndex && vertex != this->below &&
    this->orient(shore.vertex, this->below, vertex) == (shore.isLeft ? 1 : -1);
}

/// The border passes both sides of the next edge, whose far end is above the seam's last edge. Does
/// it lose to the next neighbour of the near end, where the border comes back to that? The way
/// there is long on a curve, whose edges nearly all hang on one another: it is walked last.
/// @param inner the edge's half-edge on the way back
template <class Geometry>
bool PartMerge<Geometry>::losesBeyond(
  const Shore& shore, std::uint32_t inner, const Candidate& found)
{
  const std::uint32_t next = this->upper(shore, this->onward(shore, previousHalfEdge(inner)));
  return next != (shore.isLeft ? this->right : this->left).vertex &&
    this->orient(this->left.vertex, this->right.vertex, next) > 0 &&
    this->inCircle(found, next) > 0 && shore.edges > this->edgesUntil(shore, inner);
}

/// How many edges there are from the next one to the one of @p inner, both counted.
template <class Geometry>
std::uint32_t PartMerge<Geometry>::edgesUntil(const Shore& shore, std::uint32_t inner)
{
  std::uint32_t edges = 1;
  for (std::uint32_t s = shore.spoke; edges <= shore.edges && triangleOf(s) != triangleOf(inner);
       ++edges)
  {
    s = this->onward(shore, s);
  }
  this->walked += edges;
  return edges;
}

/// The border passes both sides of the next edge, which does not stay: remove it, and all that only
/// it connects with its side. These vertices are hidden.
/// @param inner the edge's half-edge on the way back
template <class Geometry>
void PartMerge<Geometry>::hideBeyond(Shore& shore, std::uint32_t inner)
{
  const std::uint32_t next = this->onward(shore, previousHalfEdge(inner));
  const std::uint32_t edges = this->edgesUntil(shore, inner);
  ensure(edges <= shore.edges);
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
    if (v != VirtualSlot && (this->mesh.vertices[v].flags & VertexAlive))
    {
      ensure(v != this->left.vertex && v != this->right.vertex);
      this->mesh.vertices[v].flags = 0;
      ++this->hidden;
    }
  };
  const std::uint32_t first = this->upper(shore, shore.spoke);
  this->noteIfDuplicates(first, shore.vertex);
  hide(first);
  remove(triangleOf(this->mesh.twin(upperSide(shore, shore.spoke))));
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
  shore.spoke = next;
  shore.edges -= edges;
}

/// Flip the next border edge, from l to a on the left, of the triangle with the apex d, with its
/// virtual triangle: ld and da are border edges then, and ld the next.
/// @param inner the edge's half-edge in the triangle
template <class Geometry>
void PartMerge<Geometry>::uncover(Shore& shore, std::uint32_t inner)
{
  const std::uint32_t spoke = shore.spoke;
  const std::uint32_t t = triangleOf(inner);
  const std::uint32_t a = this->upper(shore, spoke);
  const std::uint32_t d = this->mesh.origin(previousHalfEdge(inner));
  this->noteIfDuplicates(shore.vertex, a);
  const std::uint32_t before = this->mesh.twin(previousHalfEdge(inner));
  const std::uint32_t behind = this->mesh.twin(nextHalfEdge(inner));
  const std::uint32_t side = upperSide(shore, spoke);
  const std::uint32_t beyond = this->mesh.twin(side);
  const int corner = cornerOf(spoke);
  const int upperCorner = shore.isLeft ? nextCorner(corner) : previousCorner(corner);
  this->mesh.triangles[triangleOf(spoke)].v[upperCorner] = d;
  this->mesh.link(nextHalfEdge(spoke), shore.isLeft ? before : behind);
  this->mesh.setTriangle(t, shore.isLeft ? a : d, shore.isLeft ? d : a, VirtualSlot);
  this->mesh.link(halfEdge(t, 0), shore.isLeft ? behind : before);
  this->mesh.link(halfEdge(t, shore.isLeft ? 1 : 2), side);
  this->mesh.link(halfEdge(t, shore.isLeft ? 2 : 1), beyond);
  ++shore.edges;
  ++this->flips;
}

/// The virtual triangle of the next border edge becomes the seam's triangle.
template <class Geometry>
void PartMerge<Geometry>::reach(Shore& shore, const Candidate& next)
{
  const std::uint32_t spoke = shore.spoke;
  const std::uint32_t onwardSpoke = this->onward(shore, spoke);
  this->mesh.triangles[triangleOf(spoke)].v[cornerOf(spoke)] =
    (shore.isLeft ? this->right : this->left).vertex;
  this->closeTriangle(lowerSide(shore, spoke), nextHalfEdge(spoke), next);
  this->base = upperSide(shore, spoke);
  this->below = std::exchange(shore.vertex, next.vertex);
  shore.spoke = onwardSpoke;
  --shore.edges;
  ++shore.reached;
}

/// Link the seam's new triangle to the one beneath, and mark its flat edges (PlanePolyhedron.h).
/// @param onBase, outer its half-edges on the seam's last edge, and on the part's border
template <class Geometry>
void PartMerge<Geometry>::closeTriangle(
  std::uint32_t onBase, std::uint32_t outer, const Candidate& next)
{
  this->mesh.setMarks(triangleOf(onBase), 0);
  this->mesh.link(onBase, this->base);
  if (next.isFlat)
  {
    this->mesh.markTied(outer);
  }
  if (this->below != NoIndex && this->exactInCircle(next, this->below) == 0)
  {
    this->mesh.markTied(onBase);
  }
}

template class PartMerge<LiftedGeometry<false>>;
template class PartMerge<LiftedGeometry<true>>;
template class PartMerge<HullGeometry>;

}
