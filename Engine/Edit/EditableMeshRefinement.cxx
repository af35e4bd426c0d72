// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What Delaunay refinement requires of the mesh: insertions that are looked at before they are
/// made, and fixed edges that are bent.
///
/// A point that is to divide a fixed edge is rounded, so it may be beside the edge, and even beyond
/// a thin triangle there. The edge is then an ordinary one, and the point is inserted into the
/// triangle that holds it. On each side of the edge all other edges are locally Delaunay; so along
/// each ray from the point, through the edge or not, the triangles whose circle holds it come
/// first, and the cavity is star-shaped. Where rounding is too coarse for that, nothing is done.
#include "Edit/EditableMesh.h"

#include <algorithm>

namespace flipflop
{

template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::walkWithin(
  const Vertex& p, std::uint32_t t, std::uint32_t& blocked)
{
  blocked = NoIndex;
  std::uint32_t entered = NoIndex;
  for (;;)
  {
    const std::uint32_t left = this->exitTowards(p, t, entered);
    for (int e = 0; left == NoIndex && e < 3; ++e)
    {
      const std::uint32_t h = halfEdge(t, e);
      const bool isOn = this->isFixed(h) &&
        this->geometry.orient(
          this->vertices[this->origin(h)], this->vertices[this->origin(nextHalfEdge(h))], p) == 0;
      blocked = isOn ? h : blocked;
    }
    if (left == NoIndex)
    {
      return t;
    }
    if (this->isFixed(left))
    {
      blocked = left;
      return t;
    }
    entered = this->twin(left);
    t = triangleOf(entered);
    if (this->isVirtual(t))
    {
      return t;
    }
  }
}

template <bool Weighted>
void EditableMesh<Weighted>::closeCavity()
{
  for (const std::uint32_t t : this->cavity)
  {
    this->triangles.again(t).flags &= ~TriangleInCavity;
  }
  this->cavity.clear();
}

template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::insertInCavity(const Vertex& point)
{
  const std::uint32_t slot = this->addSlot(point);
  this->orderSides();
  this->takeHidden();
  this->fillCavity(slot);
  this->settle(this->fresh[0]);
  return slot;
}

template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::halfEdgeTo(std::uint32_t from, std::uint32_t to) const
{
  const std::uint32_t first = this->at[from];
  std::uint32_t h = first;
  do
  {
    if (this->origin(nextHalfEdge(h)) == to)
    {
      return h;
    }
    h = this->twin(previousHalfEdge(h));
  } while (h != first);
  return NoIndex;
}

template <bool Weighted>
void EditableMesh<Weighted>::setFixed(std::uint32_t h, bool isFixed)
{
  for (const std::uint32_t half : { h, this->twin(h) })
  {
    std::uint32_t& flags = this->triangles.edit(triangleOf(half)).flags;
    flags = isFixed ? flags | EdgeFixed << cornerOf(half) : flags & ~(EdgeFixed << cornerOf(half));
  }
}

/// Does a point see all sides of the open cavity?
template <bool Weighted>
bool EditableMesh<Weighted>::isStarShaped(const Vertex& p) const
{
  return std::all_of(this->found.begin(), this->found.end(),
    [&](const Side& side)
    {
      return side.from == 0 || side.to == 0 ||
        this->geometry.orient(this->vertices[side.from], this->vertices[side.to], p) > 0;
    });
}

/// Is an end of a fixed edge a vertex of the open cavity?
template <bool Weighted>
bool EditableMesh<Weighted>::isAtCavity(std::uint32_t end) const
{
  return std::any_of(
    this->found.begin(), this->found.end(), [end](const Side& side) { return side.from == end; });
}

/// Is no vertex of the open cavity between an edge and a point near it, or on the way from the
/// point to its ends?
template <bool Weighted>
bool EditableMesh<Weighted>::isNoneBetween(
  std::uint32_t from, std::uint32_t to, const Vertex& p) const
{
  const Vertex& a = this->vertices[from];
  const Vertex& b = this->vertices[to];
  const int turn = this->geometry.orient(a, b, p);
  return turn == 0 ||
    std::none_of(this->found.begin(), this->found.end(),
      [&](const Side& side)
      {
        const Vertex& v = this->vertices[side.from];
        return side.from != 0 && side.from != from && side.from != to &&
          this->geometry.orient(a, b, v) * turn >= 0 &&
          this->geometry.orient(b, p, v) * turn >= 0 && this->geometry.orient(p, a, v) * turn >= 0;
      });
}

template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::bendFixed(const Vertex& p, std::uint32_t h)
{
  const std::uint32_t from = this->origin(h);
  const std::uint32_t to = this->origin(nextHalfEdge(h));
  const std::uint32_t sides[2] = { triangleOf(h), triangleOf(this->twin(h)) };
  this->setFixed(h, false);
  std::uint32_t blocked = NoIndex;
  const std::uint32_t holding =
    this->walkWithin(p, this->isVirtual(sides[0]) ? sides[1] : sides[0], blocked);
  if (blocked == NoIndex && this->isAbove(holding, p))
  {
    this->openCavity(p, holding);
    const auto isInCavity = [this](std::uint32_t t)
    { return (this->triangles[t].flags & TriangleInCavity) != 0; };
    if ((isInCavity(sides[0]) || isInCavity(sides[1])) && this->isAtCavity(from) &&
      this->isAtCavity(to) && this->isStarShaped(p) && this->isNoneBetween(from, to, p))
    {
      this->split = h; // the edges from the point to its ends become fixed
      return this->insertInCavity(p);
    }
    this->closeCavity();
  }
  this->setFixed(h, true);
  return NoSlot;
}

template std::uint32_t EditableMesh<false>::walkWithin(
  const Vertex&, std::uint32_t, std::uint32_t&);
template void EditableMesh<false>::closeCavity();
template void EditableMesh<false>::setFixed(std::uint32_t, bool);
template std::uint32_t EditableMesh<false>::insertInCavity(const Vertex&);
template std::uint32_t EditableMesh<false>::bendFixed(const Vertex&, std::uint32_t);
template std::uint32_t EditableMesh<false>::halfEdgeTo(std::uint32_t, std::uint32_t) const;

}
