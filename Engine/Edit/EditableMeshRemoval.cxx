// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The removal of a vertex: the triangles around it become those of its link.
///
/// All corners of the link stay visible without it, and triangles elsewhere stay as they are. So
/// the hole is filled by the triangles of the link's own triangulation that are inside it. No edge
/// at the vertex is fixed, so it sees all corners: none is above a triangle of its star, and each
/// side of the link, fixed or not, is an edge of that triangulation. A
/// triangle of three neighbours in the link is one of them (an ear) if no other corner is above it
/// (O. Devillers, "On deletion in Delaunay triangulations", 2002).
#include "Edit/EditableMesh.h"

#include <algorithm>
#include <utility>

namespace flipflop
{

template <bool Weighted>
bool EditableMesh<Weighted>::remove(std::uint32_t slot)
{
  if (this->isVisible(slot))
  {
    return this->removeVisible(slot);
  }
  this->removeHidden(slot);
  return true;
}

template <bool Weighted>
bool EditableMesh<Weighted>::removeVisible(std::uint32_t slot)
{
  constexpr std::size_t MostByEars = 16;
  this->openStar(slot);
  const std::size_t count = this->sides.size();
  const bool isOnLine = this->isLinkOnLine();
  if (isOnLine && this->live == 2 * count - 2)
  {
    return false;
  }
  std::vector<std::uint32_t> again;
  std::swap(again, this->waiting);
  const std::uint32_t best = this->takeBestAt(slot);
  if (best != NoSlot)
  {
    again.push_back(best);
  }
  this->vertices.edit(slot).flags = 0;
  this->at.edit(slot) = NoIndex;
  --this->visible;

  this->used = 0;
  if (isOnLine)
  {
    this->fillAlongLine();
  }
  else if (count <= MostByEars)
  {
    this->fillByEars();
  }
  else
  {
    this->fillByTriangulation();
  }
  ensure(this->used + 2 == count);
  for (const std::uint32_t t : this->fresh)
  {
    for (int e = 0; e < 3; ++e)
    {
      this->at.edit(this->triangles[t].v[e]) = halfEdge(t, e);
    }
  }
  this->freeTriangle(this->cavity[count - 2]);
  this->freeTriangle(this->cavity[count - 1]);
  this->last = this->fresh[0];

  for (const std::uint32_t hidden : again)
  {
    // From where the star was.
    this->last = this->walk(this->vertices[hidden], this->last, NoIndex);
    this->insertIn(hidden, this->last);
  }
  std::swap(again, this->waiting);
  this->waiting.clear();
  return true;
}

/// The triangles around a vertex are the cavity, the edges around them its sides.
template <bool Weighted>
void EditableMesh<Weighted>::openStar(std::uint32_t slot)
{
  this->cavity.clear();
  this->sides.clear();
  this->waiting.clear();
  this->fresh.clear();
  const std::uint32_t first = this->at[slot];
  std::uint32_t spoke = first;
  do
  {
    const std::uint32_t t = triangleOf(spoke);
    const std::uint32_t h = nextHalfEdge(spoke);
    this->cavity.push_back(t);
    this->sides.push_back(
      { this->origin(h), this->origin(nextHalfEdge(h)), this->twin(h), this->isFixed(h) });
    for (std::uint32_t hidden = this->firstHidden(t); hidden != NoSlot;
         hidden = this->hanging[hidden].next)
    {
      this->waiting.push_back(hidden);
    }
    spoke = this->twin(previousHalfEdge(spoke));
  } while (spoke != first);
}

/// Is the vertex on the border, and the rest of the link on one line?
template <bool Weighted>
bool EditableMesh<Weighted>::isLinkOnLine() const
{
  const auto atInfinity = std::find_if(
    this->sides.begin(), this->sides.end(), [](const Side& side) { return side.from == 0; });
  if (atInfinity == this->sides.end())
  {
    return false;
  }
  const Vertex* base[2] = { nullptr, nullptr };
  for (const Side& side : this->sides)
  {
    const Vertex& v = this->vertices[side.from];
    if (side.from == 0)
    {
      continue;
    }
    if (base[1])
    {
      if (this->geometry.orient(*base[0], *base[1], v) != 0)
      {
        return false;
      }
    }
    else
    {
      base[base[0] ? 1 : 0] = &v;
    }
  }
  return true;
}

/// One of the star's triangles, to be used again.
template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::nextOfStar()
{
  const std::uint32_t t = this->cavity[this->used++];
  this->setTriangle(t, 0, 0, 0);
  this->fresh.push_back(t);
  return t;
}

/// Make @p h the side of a hole.
template <bool Weighted>
void EditableMesh<Weighted>::attach(std::uint32_t h, const Side& side)
{
  Triangle& triangle = this->triangles.edit(triangleOf(h));
  triangle.v[cornerOf(h)] = side.from;
  triangle.flags |= side.isFixed ? EdgeFixed << cornerOf(h) : 0u;
  this->linkTwins(h, side.outer);
}

/// Of the corners of side @p i and side @p j, the next: do they form an ear?
/// @param next of each side the one after it, in what is left of the hole
template <bool Weighted>
bool EditableMesh<Weighted>::isEar(
  std::size_t i, std::size_t j, const std::vector<std::size_t>& next) const
{
  const Vertex& a = this->vertices[this->sides[i].from];
  const Vertex& b = this->vertices[this->sides[j].from];
  const Vertex& c = this->vertices[this->sides[j].to];
  if (!Geometry::isVirtual(a, b, c) && this->geometry.orient(a, b, c) <= 0)
  {
    return false;
  }
  for (std::size_t k = next[next[j]]; k != i; k = next[k])
  {
    const Vertex& p = this->vertices[this->sides[k].from];
    if (!Geometry::isVirtual(p) && this->geometry.isAbove(a, b, c, p))
    {
      return false;
    }
  }
  return true;
}

template <bool Weighted>
void EditableMesh<Weighted>::fillByEars()
{
  const std::size_t count = this->sides.size();
  std::vector<std::size_t> next(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    next[i] = i + 1 < count ? i + 1 : 0;
  }
  std::size_t i = 0;
  std::size_t tried = 0;
  for (std::size_t remaining = count; remaining > 3;)
  {
    const std::size_t j = next[i];
    if (!this->isEar(i, j, next))
    {
      ensure(++tried < remaining);
      i = j;
      continue;
    }
    tried = 0;
    const std::uint32_t t = this->nextOfStar();
    this->attach(halfEdge(t, 0), this->sides[i]);
    this->attach(halfEdge(t, 1), this->sides[j]);
    this->triangles.again(t).v[2] = this->sides[j].to;
    this->sides[i] = { this->sides[i].from, this->sides[j].to, halfEdge(t, 2), false };
    next[i] = next[j];
    --remaining;
  }
  const std::uint32_t t = this->nextOfStar();
  this->attach(halfEdge(t, 0), this->sides[i]);
  this->attach(halfEdge(t, 1), this->sides[next[i]]);
  this->attach(halfEdge(t, 2), this->sides[next[next[i]]]);
}

/// The corners are on one line, which is the border now.
template <bool Weighted>
void EditableMesh<Weighted>::fillAlongLine()
{
  const auto atInfinity = std::find_if(
    this->sides.begin(), this->sides.end(), [](const Side& side) { return side.from == 0; });
  std::rotate(this->sides.begin(), atInfinity, this->sides.end());
  // First the side that leaves the virtual vertex, last that which comes back.
  Side open = this->sides.front();
  for (std::size_t i = 1; i + 1 < this->sides.size(); ++i)
  {
    const std::uint32_t t = this->nextOfStar();
    this->attach(halfEdge(t, 0), open);
    this->attach(halfEdge(t, 1), this->sides[i]);
    this->triangles.again(t).v[2] = this->sides[i].to;
    open = { 0, this->sides[i].to, halfEdge(t, 2), false };
    if (i + 2 == this->sides.size())
    {
      this->attach(halfEdge(t, 2), this->sides.back());
    }
  }
}

/// Triangulate the link alone, and copy what is inside its sides.
template <bool Weighted>
void EditableMesh<Weighted>::fillByTriangulation()
{
  const std::size_t count = this->sides.size();
  EditableMesh alone(this->geometry.unraised());
  std::vector<std::uint32_t> sideAt(1, NoIndex); // by slot there: the side that leaves it
  std::uint32_t start[3] = { 0, 0, 0 };
  int chosen = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (this->sides[i].from == 0)
    {
      sideAt[0] = static_cast<std::uint32_t>(i);
      continue;
    }
    Vertex corner = this->vertices[this->sides[i].from];
    corner.flags = 0;
    const std::uint32_t slot = alone.addSlot(corner);
    sideAt.push_back(static_cast<std::uint32_t>(i));
    if (chosen < 2 ||
      (chosen == 2 &&
        this->geometry.orient(alone.vertices[start[0]], alone.vertices[start[1]], corner) != 0))
    {
      start[chosen++] = slot;
    }
  }
  alone.start(start);
  // In an order without order: neighbours in a link, one after another, may replace all each time.
  const std::uint32_t corners = alone.slotCount() - 1;
  std::vector<std::uint32_t> order(corners);
  std::uint32_t random = 1;
  for (std::uint32_t i = 0; i < corners; ++i)
  {
    random = random * 1664525u + 1013904223u;
    const auto j = static_cast<std::uint32_t>((std::uint64_t(random) * (i + 1)) >> 32);
    order[i] = order[j];
    order[j] = i + 1;
  }
  for (const std::uint32_t slot : order)
  {
    ensure(alone.isVisible(slot) || alone.insert(slot));
  }

  // A half-edge of the link's own triangulation is a side if it runs to the next corner.
  const auto sideOf = [&](std::uint32_t h)
  {
    const std::uint32_t i = sideAt[alone.origin(h)];
    const std::uint32_t end = sideAt[alone.origin(nextHalfEdge(h))];
    return i != NoIndex && end == (i + 1 < count ? i + 1 : 0) ? i : NoIndex;
  };
  std::vector<std::uint32_t> copy(alone.triangleCount(), NoIndex);
  std::vector<std::uint32_t> inside;
  const auto enter = [&](std::uint32_t t)
  {
    if (copy[t] == NoIndex)
    {
      copy[t] = this->nextOfStar();
      inside.push_back(t);
    }
  };
  for (std::uint32_t t = 0; t < alone.triangleCount(); ++t)
  {
    for (int e = 0; e < 3 && !alone.isDead(t); ++e)
    {
      if (sideOf(halfEdge(t, e)) != NoIndex)
      {
        enter(t);
      }
    }
  }
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t h = halfEdge(inside[i], e);
      if (sideOf(h) == NoIndex)
      {
        enter(triangleOf(alone.twin(h)));
      }
    }
  }
  for (const std::uint32_t t : inside)
  {
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t h = halfEdge(t, e);
      const std::uint32_t side = sideOf(h);
      const std::uint32_t own = halfEdge(copy[t], e);
      if (side != NoIndex)
      {
        this->attach(own, this->sides[side]);
        continue;
      }
      const std::uint32_t other = alone.twin(h);
      this->attach(own,
        { this->sides[sideAt[alone.origin(h)]].from, 0,
          halfEdge(copy[triangleOf(other)], cornerOf(other)), false });
    }
  }
}

template bool EditableMesh<false>::remove(std::uint32_t);
template bool EditableMesh<true>::remove(std::uint32_t);

}
