// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Edit/EditableMesh.h"

#include "Surface/Topology.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipflop
{

template <bool Weighted>
EditableMesh<Weighted>::EditableMesh(const Geometry& signs)
  : geometry(signs)
{
  this->addSlot(virtualVertex());
}

template <bool Weighted>
EditableMesh<Weighted>::EditableMesh(const Geometry& signs, EditableMesh<false>&& other)
  : geometry(signs)
  , vertices(std::move(other.vertices))
  , triangles(std::move(other.triangles))
  , at(std::move(other.at))
  , hanging(std::move(other.hanging))
  , visible(other.visible)
  , live(other.live)
  , firstFree(other.firstFree)
  , last(other.last)
  , sideFrom(std::move(other.sideFrom))
{
  this->commit();
}

template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::addSlot(const Vertex& point)
{
  const std::size_t slot = this->vertices.size();
  if (slot >= MostSlots)
  {
    throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(slot));
  }
  this->sideFrom.resize(slot + 1);
  this->at.append(NoIndex);
  this->vertices.append(point);
  return static_cast<std::uint32_t>(slot);
}

template <bool Weighted>
void EditableMesh<Weighted>::commit() noexcept
{
  this->vertices.commit();
  this->triangles.commit();
  this->at.commit();
  this->hanging.commit();
  this->committedCounts = { this->visible, this->live, this->firstFree, this->last };
}

template <bool Weighted>
void EditableMesh<Weighted>::rollback() noexcept
{
  const auto keep = [](auto&) {};
  for (const std::uint32_t t : this->cavity)
  {
    if (t < this->triangles.size())
    {
      this->triangles.again(t).flags &= ~TriangleInCavity;
    }
  }
  this->vertices.rollback(keep);
  this->triangles.rollback([](Triangle& triangle) { triangle.flags &= ~TriangleInCavity; });
  this->at.rollback(keep);
  this->hanging.rollback(keep);
  this->visible = this->committedCounts.visible;
  this->live = this->committedCounts.live;
  this->firstFree = this->committedCounts.firstFree;
  this->last = this->committedCounts.last;
}

template <bool Weighted>
void EditableMesh<Weighted>::setTriangle(
  std::uint32_t t, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  this->triangles.edit(t) = { { a, b, c }, 0, { NoIndex, NoIndex, NoIndex }, 0 };
}

template <bool Weighted>
void EditableMesh<Weighted>::linkTwins(std::uint32_t h, std::uint32_t other)
{
  this->triangles.edit(triangleOf(h)).twin[cornerOf(h)] = other;
  this->triangles.edit(triangleOf(other)).twin[cornerOf(other)] = h;
}

/// A triangle that is to be set.
template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::newTriangle()
{
  ++this->live;
  if (this->firstFree != NoIndex)
  {
    const std::uint32_t t = this->firstFree;
    this->firstFree = this->triangles[t].twin[0];
    return t;
  }
  const std::size_t t = this->triangles.size();
  if (t >= NoIndex / 4)
  {
    throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(t));
  }
  this->triangles.append(Triangle());
  return static_cast<std::uint32_t>(t);
}

template <bool Weighted>
void EditableMesh<Weighted>::freeTriangle(std::uint32_t t)
{
  Triangle& triangle = this->triangles.edit(t);
  triangle.flags = TriangleDead;
  triangle.flatEdges = NoSlot;
  triangle.twin[0] = std::exchange(this->firstFree, t);
  --this->live;
}

template <bool Weighted>
void EditableMesh<Weighted>::setVisible(std::uint32_t slot)
{
  this->vertices.edit(slot).flags = VertexAlive;
  ++this->visible;
}

template <bool Weighted>
void EditableMesh<Weighted>::start(const std::uint32_t (&corner)[3])
{
  std::uint32_t v[3] = { corner[0], corner[1], corner[2] };
  if (this->geometry.orient(this->vertices[v[0]], this->vertices[v[1]], this->vertices[v[2]]) < 0)
  {
    std::swap(v[1], v[2]);
  }
  this->adopt({ v[0], v[1], v[2] });
}

template <bool Weighted>
void EditableMesh<Weighted>::adopt(const std::vector<std::uint32_t>& corners)
{
  ensure(this->live == 0);
  const std::size_t count = corners.size() / 3;
  for (std::size_t t = 0; t < count; ++t)
  {
    this->triangles.append(
      { { corners[3 * t], corners[3 * t + 1], corners[3 * t + 2] }, 0, { 0, 0, 0 }, NoSlot });
  }
  linkTriangles(&this->triangles.again(0), static_cast<std::uint32_t>(count), this->slotCount());
  this->live = static_cast<std::uint32_t>(count);

  // The border, by the vertex where each of its edges ends.
  for (std::uint32_t h = 0; h < halfEdge(static_cast<std::uint32_t>(count), 0);
       h = h + 1 + (h % 4) / 2)
  {
    const std::uint32_t from = this->origin(h);
    this->at.edit(from) = h;
    if (!this->isVisible(from))
    {
      this->setVisible(from);
    }
    if (this->twin(h) == NoIndex)
    {
      const std::uint32_t to = this->origin(nextHalfEdge(h));
      const std::uint32_t t = this->newTriangle();
      this->setTriangle(t, to, from, 0);
      this->linkTwins(halfEdge(t, 0), h);
      this->sideFrom[to] = t;
      this->at.edit(0) = halfEdge(t, 2);
    }
  }
  for (auto t = static_cast<std::uint32_t>(count); t < this->triangles.size(); ++t)
  {
    // The triangle from the vertex where this one's edge ends.
    const std::uint32_t next = this->sideFrom[this->origin(halfEdge(t, 1))];
    this->linkTwins(halfEdge(t, 1), halfEdge(next, 2));
  }
  this->last = 0;
}

template <bool Weighted>
void EditableMesh<Weighted>::fix(const std::vector<std::uint64_t>& edges)
{
  for (std::uint32_t t = 0; !edges.empty() && t < this->triangleCount(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t* const v = this->triangles[t].v;
      if (std::binary_search(edges.begin(), edges.end(), edgeKey(v[e], v[nextCorner(e)])))
      {
        this->triangles.edit(t).flags |= EdgeFixed << e;
      }
    }
  }
}

template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::visibleAt(std::uint32_t slot)
{
  if (this->isVisible(slot))
  {
    return slot;
  }
  const Vertex& p = this->vertices[slot];
  for (const std::uint32_t corner : this->triangles[this->locate(p)].v)
  {
    if (corner != 0 && Geometry::samePlanePosition(this->vertices[corner], p))
    {
      return corner;
    }
  }
  throw Error(ErrorCode::Internal); // without weights, what is hidden is a duplicate
}

template <bool Weighted>
std::vector<std::uint32_t> EditableMesh<Weighted>::visibleOfAll() const
{
  std::vector<std::uint32_t> result(this->slotCount());
  for (std::uint32_t slot = 1; slot < this->slotCount(); ++slot)
  {
    if (this->isVisible(slot))
    {
      this->eachAt(slot, [&](std::uint32_t other) { result[other] = slot; });
    }
  }
  return result;
}

/// The end of the fixed edge at @p u along the line to @p v.
template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::fixedTowards(std::uint32_t u, std::uint32_t v) const
{
  const Vertex& from = this->vertices[u];
  const Vertex& to = this->vertices[v];
  const int axis = from.x[0] != to.x[0] ? 0 : 1;
  const std::uint32_t first = this->at[u];
  std::uint32_t h = first;
  do
  {
    const std::uint32_t end = this->origin(nextHalfEdge(h));
    const Vertex& p = this->vertices[end];
    if (this->isFixed(h) && (p.x[axis] > from.x[axis]) == (to.x[axis] > from.x[axis]) &&
      this->geometry.orient(from, to, p) == 0)
    {
      return end;
    }
    h = this->twin(previousHalfEdge(h));
  } while (h != first);
  throw Error(ErrorCode::Internal); // no constraint is here
}

/// Of a virtual triangle its neighbour.
template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::inner(std::uint32_t t) const
{
  const std::uint32_t* const v = this->triangles[t].v;
  const int apex = v[0] == 0 ? 0 : v[1] == 0 ? 1 : v[2] == 0 ? 2 : -1;
  return apex < 0 ? t : triangleOf(this->triangles[t].twin[nextCorner(apex)]);
}

/// A visibility walk.
/// @return NoIndex: it would take more steps
template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::walk(
  const Vertex& p, std::uint32_t from, std::uint32_t mostSteps)
{
  std::uint32_t t = this->inner(from);
  std::uint32_t entered = NoIndex; // the half-edge that it came through
  for (std::uint32_t step = 0; step < mostSteps; ++step)
  {
    const std::uint32_t left = this->exitTowards(p, t, entered);
    if (left == NoIndex)
    {
      return t;
    }
    entered = this->twin(left);
    t = triangleOf(entered);
    if (this->isVirtual(t))
    {
      return t;
    }
  }
  return NoIndex;
}

template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::locate(const Vertex& point, std::uint32_t fewSteps)
{
  constexpr std::uint32_t FewPoints = 64;
  std::uint32_t t = this->walk(point, this->last, this->visible < FewPoints ? NoIndex : fewSteps);
  if (t == NoIndex)
  {
    if (this->visible / 2 >= this->hintsOf)
    {
      this->buildHints();
    }
    const std::uint32_t near =
      this->hints.valueAt(this->hints.cellOf(point.x[0], point.x[1]), point.x[0], point.x[1]);
    const std::uint32_t from =
      near < this->slotCount() && this->isVisible(near) ? triangleOf(this->at[near]) : this->last;
    t = this->walk(point, from, NoIndex);
  }
  this->last = t;
  return t;
}

template <bool Weighted>
bool EditableMesh<Weighted>::firstHolding(const Vertex& point, std::uint32_t* slots)
{
  const std::uint32_t t = this->locate(point);
  if (this->isVirtual(t))
  {
    return false;
  }
  const auto isAlong = [&](std::uint32_t h)
  {
    return this->geometry.orient(this->vertices[this->origin(h)],
             this->vertices[this->origin(nextHalfEdge(h))], point) == 0;
  };
  const auto idOf = [this](std::uint32_t slot) { return this->vertices[slot].id; };
  bool any = false;
  const auto consider = [&](std::uint32_t triangle)
  {
    if (this->isVirtual(triangle))
    {
      return;
    }
    std::uint32_t v[3];
    std::copy_n(this->triangles[triangle].v, 3, v);
    while (idOf(v[0]) > idOf(v[1]) || idOf(v[0]) > idOf(v[2]))
    {
      std::rotate(v, v + 1, v + 3);
    }
    const auto isBefore = [&](std::uint32_t a, std::uint32_t b) { return idOf(a) < idOf(b); };
    if (!any || std::lexicographical_compare(v, v + 3, slots, slots + 3, isBefore))
    {
      std::copy_n(v, 3, slots);
      any = true;
    }
  };
  consider(t);
  for (int e = 0; e < 3; ++e)
  {
    const std::uint32_t h = halfEdge(t, e);
    if (!isAlong(h))
    {
      continue;
    }
    consider(triangleOf(this->twin(h)));
    if (isAlong(previousHalfEdge(h)))
    {
      // At its origin.
      std::uint32_t spoke = h;
      do
      {
        consider(triangleOf(spoke));
        spoke = this->twin(previousHalfEdge(spoke));
      } while (spoke != h);
    }
  }
  return true;
}

/// From some of the points: of each cell, one near its middle.
template <bool Weighted>
void EditableMesh<Weighted>::buildHints()
{
  constexpr std::uint32_t OneOf = 4; // by two bits of a hash
  std::vector<ValuedPosition> positions;
  positions.reserve(this->visible / OneOf);
  for (std::uint32_t slot = 1; slot < this->slotCount(); ++slot)
  {
    if (this->isVisible(slot) && (positions.empty() || (slot * 2654435769u) >> 30 == 0))
    {
      const Vertex& v = this->vertices[slot];
      positions.push_back({ { v.x[0], v.x[1] }, slot });
    }
  }
  double low[2] = { HUGE_VAL, HUGE_VAL };
  double high[2] = { -HUGE_VAL, -HUGE_VAL };
  for (const ValuedPosition& position : positions)
  {
    for (int i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], position.x[i]);
      high[i] = std::max(high[i], position.x[i]);
    }
  }
  const double far =
    4 * std::sqrt((high[0] - low[0]) * (high[1] - low[1]) / static_cast<double>(positions.size()));
  // A cell without a point has another's, which may be far: in a grid, rows of cells are empty.
  const auto nearMiddle = [&](double x, double y, std::uint32_t slot)
  {
    constexpr std::uint32_t MostSteps = 1 << 12; // signs may be wrong here, and lead nowhere
    const Vertex& v = this->vertices[slot];
    if (std::fabs(v.x[0] - x) + std::fabs(v.x[1] - y) < far)
    {
      return slot;
    }
    const Vertex middle = { { x, y, 0.0 }, NoIndex, 0 };
    const std::uint32_t t = this->walk(middle, triangleOf(this->at[slot]), MostSteps);
    const std::uint32_t* const corner = this->triangles[t == NoIndex ? 0 : t].v;
    return t == NoIndex ? slot : corner[0] != 0 ? corner[0] : corner[1];
  };
  this->hints.build(std::move(positions), nearMiddle, [] {});
  this->hintsOf = this->visible;
}

template <bool Weighted>
bool EditableMesh<Weighted>::insertIn(std::uint32_t slot, std::uint32_t t)
{
  const Vertex p = this->vertices[slot];
  if (!this->isAbove(t, p))
  {
    this->hide(slot, t);
    return false;
  }
  this->openCavity(p, t);
  this->orderSides();
  this->takeHidden();
  this->fillCavity(slot);
  this->settle(this->fresh[0]);
  return true;
}

template <bool Weighted>
void EditableMesh<Weighted>::addToCavity(std::uint32_t t)
{
  this->cavity.push_back(t);
  this->triangles.again(t).flags |= TriangleInCavity;
}

/// The triangles from @p t on that @p p is above, and the edges around them.
template <bool Weighted>
void EditableMesh<Weighted>::openCavity(const Vertex& p, std::uint32_t t)
{
  this->cavity.clear();
  this->found.clear();
  this->split = NoIndex;
  this->addToCavity(t);
  for (int e = 0; !Weighted && e < 3; ++e)
  {
    const std::uint32_t h = halfEdge(t, e);
    if (this->isFixed(h) &&
      this->geometry.orient(
        this->vertices[this->origin(h)], this->vertices[this->origin(nextHalfEdge(h))], p) == 0)
    {
      this->split = h;
      this->addToCavity(triangleOf(this->twin(h)));
      break;
    }
  }
  for (std::size_t i = 0; i < this->cavity.size(); ++i)
  {
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t h = halfEdge(this->cavity[i], e);
      const std::uint32_t twin = this->twin(h);
      const std::uint32_t other = triangleOf(twin);
      const bool isSplit = this->split != NoIndex && (h == this->split || twin == this->split);
      const bool isFixed = !isSplit && !Weighted && this->isFixed(h);
      if (!isFixed && (this->triangles[other].flags & TriangleInCavity))
      {
        continue;
      }
      ++this->checks;
      if (!isFixed && this->isAbove(other, p))
      {
        this->addToCavity(other);
        continue;
      }
      this->found.push_back({ this->origin(h), this->origin(nextHalfEdge(h)), twin, isFixed });
    }
  }
}

template <bool Weighted>
void EditableMesh<Weighted>::orderSides()
{
  const std::size_t count = this->found.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    this->sideFrom[this->found[i].from] = static_cast<std::uint32_t>(i);
  }
  this->sides.clear();
  std::uint32_t next = 0;
  do
  {
    this->sides.push_back(this->found[next]);
    next = this->sideFrom[this->found[next].to];
    ensure(next < count && this->sides.size() <= count);
  } while (next != 0);
  ensure(this->sides.size() == count);
}

/// What was hidden in the cavity's triangles, and vertices in its inside, will be hidden elsewhere.
template <bool Weighted>
void EditableMesh<Weighted>::takeHidden()
{
  this->waiting.clear();
  const std::size_t count = this->found.size();
  const bool anyInside = count < this->cavity.size() + 2;
  if (!Weighted && !anyInside)
  {
    return;
  }
  for (const std::uint32_t t : this->cavity)
  {
    for (std::uint32_t slot = this->firstHidden(t); slot != NoSlot; slot = this->hanging[slot].next)
    {
      this->waiting.push_back(slot);
    }
    for (int e = 0; anyInside && e < 3; ++e)
    {
      const std::uint32_t v = this->triangles[t].v[e];
      const std::uint32_t side = this->sideFrom[v];
      if ((side >= count || this->found[side].from != v) && this->isVisible(v))
      {
        this->vertices.edit(v).flags = 0;
        --this->visible;
        this->waiting.push_back(v);
      }
    }
  }
}

template <bool Weighted>
void EditableMesh<Weighted>::fillCavity(std::uint32_t slot)
{
  const std::size_t count = this->sides.size();
  const bool divides = this->split != NoIndex;
  this->divided[0] = divides ? this->origin(this->split) : 0;
  this->divided[1] = divides ? this->origin(nextHalfEdge(this->split)) : 0;
  const auto spoke = [&](std::uint32_t end, int e)
  { return divides && (end == this->divided[0] || end == this->divided[1]) ? EdgeFixed << e : 0u; };
  this->fresh.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    this->fresh.push_back(i < this->cavity.size() ? this->cavity[i] : this->newTriangle());
  }
  for (std::size_t i = count; i < this->cavity.size(); ++i)
  {
    this->freeTriangle(this->cavity[i]);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Side& side = this->sides[i];
    const std::uint32_t t = this->fresh[i];
    this->triangles.edit(t) = { { side.from, side.to, slot },
      (side.isFixed ? EdgeFixed : 0u) | spoke(side.to, 1) | spoke(side.from, 2),
      { side.outer, halfEdge(this->fresh[i + 1 < count ? i + 1 : 0], 2),
        halfEdge(this->fresh[i > 0 ? i - 1 : count - 1], 1) },
      NoSlot };
    this->triangles.edit(triangleOf(side.outer)).twin[cornerOf(side.outer)] = halfEdge(t, 0);
    this->at.edit(side.from) = halfEdge(t, 0);
  }
  this->at.edit(slot) = halfEdge(this->fresh[0], 2);
  this->setVisible(slot);
  this->last = this->fresh[0];
}

template <bool Weighted>
void EditableMesh<Weighted>::settle(std::uint32_t t)
{
  for (const std::uint32_t slot : this->waiting)
  {
    t = this->walk(this->vertices[slot], t, NoIndex);
    this->hide(slot, t);
  }
  this->waiting.clear();
}

template class EditableMesh<false>;
template class EditableMesh<true>;

}
