// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constraints/EdgeInsertion.h"

#include <algorithm>
#include <utility>

namespace flipflop
{

EdgeInsertion::EdgeInsertion(const Geometry& signs, Polyhedron& surface, Monitor& monitor)
  : geometry(signs)
  , mesh(surface.mesh())
  , poll(monitor)
  , leaving(surface.vertexCount())
  , cavity(signs, this->mesh, this->leaving, this->poll)
{
  surface.eachTriangle(
    [&](std::uint32_t t, std::size_t)
    {
      if ((t & 0xFFF) == 0)
      {
        monitor.poll();
      }
      setLeaving(this->leaving, this->mesh, t);
    });
}

void EdgeInsertion::insert(std::uint32_t u, std::uint32_t v, std::uint32_t constraint, bool isSide)
{
  // Of all that it crosses, the first constraint is reported; nothing more is changed until then.
  std::uint32_t crossed = NoIndex;
  const auto meet = [&](std::uint32_t h)
  {
    if (crossed == NoIndex)
    {
      joinRecords(this->fixed);
    }
    crossed = std::min(crossed, this->firstAlong(h));
  };
  // It begins where there are fewer triangles to examine: many constraints may end at one point.
  const bool isTurned = u != v && this->hasSmallerStar(v, u);
  if (isTurned)
  {
    std::swap(u, v);
  }
  SidesAlong sides;
  if (isSide)
  {
    sides.balance = isTurned ? -1 : 1;
    sides.first[isTurned] = constraint;
  }
  const Chain chain = { u, this->fixed.size(), 0, SidesAlong() };
  while (u != v)
  {
    const Exit exit = this->exitOf(u, v);
    std::uint32_t edge = exit.along;
    std::uint32_t end = exit.end;
    if (u == chain.from && edge != NoIndex && end != v && this->mesh.isFixed(edge) &&
      this->isAgain(u, v, sides))
    {
      return;
    }
    if (edge == NoIndex)
    {
      end = this->cavity.open(u, v, exit.across, meet);
      if (crossed == NoIndex)
      {
        edge = this->cavity.close(u, end);
        this->fix(edge);
        this->makeDelaunay();
      }
    }
    else if (crossed == NoIndex)
    {
      this->fix(edge);
    }
    if (crossed == NoIndex)
    {
      this->fixed.emplace_back(u, end, constraint, sides);
    }
    u = end;
  }
  if (crossed != NoIndex)
  {
    throw Error(ErrorCode::ConstraintsCross, constraint, crossed);
  }
  const std::size_t count = this->fixed.size() - chain.begin;
  if (count > 1)
  {
    Chain& known = this->chains.emplace(keyOf(chain.from, v), chain).first->second;
    known.count = count;
  }
}

/// Was a constraint between these two vertices inserted, in several edges? They are not walked
/// again; it gets the sides.
bool EdgeInsertion::isAgain(std::uint32_t u, std::uint32_t v, const SidesAlong& sides)
{
  const auto found = this->chains.find(keyOf(u, v));
  if (found == this->chains.end())
  {
    return false;
  }
  found->second.again.add(found->second.from == u ? sides : sides.reversed());
  return true;
}

std::vector<FixedEdge>& EdgeInsertion::fixedEdges()
{
  for (auto& entry : this->chains)
  {
    Chain& chain = entry.second;
    std::uint32_t at = chain.from;
    for (std::size_t i = chain.begin; i < chain.begin + chain.count; ++i)
    {
      FixedEdge& edge = this->fixed[i];
      const bool isAlong = edge.low == at;
      edge.sides.add(isAlong ? chain.again : chain.again.reversed());
      at = isAlong ? edge.high : edge.low;
    }
  }
  this->chains.clear();
  return this->fixed;
}

/// Have fewer triangles the corner v than u? It takes as many steps as the fewer are.
bool EdgeInsertion::hasSmallerStar(std::uint32_t v, std::uint32_t u)
{
  const std::uint32_t first[2] = { this->leaving[u].load(std::memory_order_relaxed),
    this->leaving[v].load(std::memory_order_relaxed) };
  std::uint32_t h[2] = { first[0], first[1] };
  do
  {
    this->poll.step();
    for (std::uint32_t& spoke : h)
    {
      spoke = this->mesh.twin(previousHalfEdge(spoke));
    }
  } while (h[0] != first[0] && h[1] != first[1]);
  return h[0] != first[0];
}

/// Around u, the edge along the line to v, or the triangle that the line leaves through.
EdgeInsertion::Exit EdgeInsertion::exitOf(std::uint32_t u, std::uint32_t v)
{
  const Vertex& from = this->vertex(u);
  const Vertex& to = this->vertex(v);
  const int axis = from.x[0] != to.x[0] ? 0 : 1;
  const bool ascends = from.x[axis] < to.x[axis];
  const auto isAhead = [&](const Vertex& p)
  { return ascends ? p.x[axis] > from.x[axis] : p.x[axis] < from.x[axis]; };
  const auto sideOf = [&](const Vertex& p)
  { return Geometry::isVirtual(p) ? 0 : this->geometry.orient(from, to, p); };

  const std::uint32_t first = this->leaving[u].load(std::memory_order_relaxed);
  std::uint32_t h = first;
  int side = sideOf(this->vertex(this->mesh.origin(nextHalfEdge(h))));
  do
  {
    this->poll.step();
    const std::uint32_t last = previousHalfEdge(h);
    const std::uint32_t p = this->mesh.origin(nextHalfEdge(h));
    const std::uint32_t q = this->mesh.origin(last);
    const Vertex& right = this->vertex(p);
    const Vertex& left = this->vertex(q);
    const int nextSide = sideOf(left);
    if (side <= 0 && nextSide >= 0 && !Geometry::isVirtual(right, left))
    {
      const bool alongRight = side == 0 && isAhead(right);
      const bool alongLeft = nextSide == 0 && isAhead(left);
      const bool between = side < 0 && nextSide > 0;
      // A triangle without area, at the border, has no edges of its own.
      if ((alongRight || alongLeft || between) && this->geometry.orient(from, right, left) > 0)
      {
        return between ? Exit{ NoIndex, NoIndex, nextHalfEdge(h) }
          : alongRight ? Exit{ h, p, NoIndex }
                       : Exit{ last, q, NoIndex };
      }
    }
    side = nextSide;
    h = this->mesh.twin(last);
  } while (h != first);
  throw Error(ErrorCode::Internal); // the triangulation is convex
}

void EdgeInsertion::fix(std::uint32_t h)
{
  const std::uint32_t twin = this->mesh.twin(h);
  for (const std::uint32_t side : { h, twin })
  {
    this->mesh.triangles[triangleOf(side)].flags |= EdgeFixed << cornerOf(side);
  }
  this->mesh.setFlat(h, false);
  // The next constraint often goes on here.
  this->leaving[this->mesh.origin(h)].store(h, std::memory_order_relaxed);
  this->leaving[this->mesh.origin(twin)].store(twin, std::memory_order_relaxed);
}

/// Flip in the cavity. Its sides, though tested, stay.
void EdgeInsertion::makeDelaunay()
{
  const std::vector<std::uint32_t>& triangles = this->cavity.triangles();
  this->changed.insert(this->changed.end(), triangles.begin(), triangles.end());
  this->waiting = this->cavity.innerEdges();
  while (!this->waiting.empty())
  {
    this->poll.step();
    const std::uint32_t h = this->waiting.back();
    this->waiting.pop_back();
    if (this->mesh.isFixed(h))
    {
      continue;
    }
    ++this->checks;
    const Triangle& triangle = this->mesh.triangles[triangleOf(h)];
    const std::uint32_t apex = this->mesh.origin(previousHalfEdge(this->mesh.twin(h)));
    if (this->geometry.above(this->vertex(triangle.v[0]), this->vertex(triangle.v[1]),
          this->vertex(triangle.v[2]), this->vertex(apex)) <= 0)
    {
      continue;
    }
    const FlipPlan plan = planFlip22(this->mesh, h);
    flip(this->mesh, plan);
    ++this->flips;
    setLeaving(this->leaving, this->mesh, plan.triangle[0]);
    setLeaving(this->leaving, this->mesh, plan.triangle[1]);
    this->waiting.insert(this->waiting.end(), plan.to, plan.to + plan.outerCount);
  }
}

bool EdgeInsertion::isCocircular(std::uint32_t h) const
{
  const Triangle& triangle = this->mesh.triangles[triangleOf(h)];
  const std::uint32_t apex = this->mesh.origin(previousHalfEdge(this->mesh.twin(h)));
  return !this->mesh.isFixed(h) &&
    this->geometry.above(this->vertex(triangle.v[0]), this->vertex(triangle.v[1]),
      this->vertex(triangle.v[2]), this->vertex(apex)) == 0;
}

bool EdgeInsertion::markFlatEdges()
{
  std::sort(this->changed.begin(), this->changed.end());
  this->changed.erase(std::unique(this->changed.begin(), this->changed.end()), this->changed.end());
  bool any = false;
  for (const std::uint32_t t : this->changed)
  {
    this->poll.step();
    for (int e = 0; e < 3; ++e)
    {
      const bool flat = this->isCocircular(halfEdge(t, e));
      this->mesh.setFlat(halfEdge(t, e), flat);
      any = any || flat;
    }
  }
  return any;
}

std::uint32_t EdgeInsertion::firstAlong(std::uint32_t h) const
{
  const FixedEdge wanted(this->mesh.origin(h), this->mesh.origin(this->mesh.twin(h)), 0);
  const auto found =
    std::lower_bound(this->fixed.begin(), this->fixed.end(), wanted, FixedEdge::isBefore);
  return found->constraint;
}

}
