// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where hidden points hang: in a triangle, or at a point of their position.
#include "Edit/EditableMesh.h"

#include <utility>

namespace flipflop
{

template <bool Weighted>
HangingPoints& EditableMesh<Weighted>::editHanging(std::uint32_t slot)
{
  while (this->hanging.size() <= slot)
  {
    this->hanging.append(HangingPoints{});
  }
  return this->hanging.edit(slot);
}

/// Of a point that is beneath triangle @p t, which holds it.
template <bool Weighted>
void EditableMesh<Weighted>::hide(std::uint32_t slot, std::uint32_t t)
{
  for (const std::uint32_t corner : this->triangles[t].v)
  {
    if (corner != 0 && Geometry::samePlanePosition(this->vertices[corner], this->vertices[slot]))
    {
      this->hangAt(slot, corner);
      return;
    }
  }
  this->hangIn(slot, t);
}

template <bool Weighted>
void EditableMesh<Weighted>::hangIn(std::uint32_t slot, std::uint32_t t)
{
  const std::uint32_t next = this->firstHidden(t);
  HangingPoints& own = this->editHanging(slot);
  own.next = next;
  own.previous = NoSlot;
  if (next != NoSlot)
  {
    this->editHanging(next).previous = slot;
  }
  this->triangles.edit(t).flatEdges = slot;
  this->at.edit(slot) = t;
  this->vertices.edit(slot).flags = HiddenInTriangle;
}

/// Hang a point, and what hangs at it, at another of its position. Without weights, the list stays
/// in the order of ids: its first is the next to be visible. With weights, that is searched for.
template <bool Weighted>
void EditableMesh<Weighted>::hangAt(std::uint32_t slot, std::uint32_t point)
{
  const HangingPoints own = this->hangingOf(slot);
  const HangingPoints host = this->hangingOf(point);
  std::uint32_t before = host.last;
  while (!Weighted && before != NoSlot && this->vertices[before].id > this->vertices[slot].id)
  {
    before = this->hanging[before].previous;
  }
  const std::uint32_t after = before == NoSlot ? host.first : this->hanging[before].next;
  const std::uint32_t end = own.first == NoSlot ? slot : own.last;
  this->editHanging(slot) = { own.first, before, NoSlot, NoSlot };
  if (own.first != NoSlot)
  {
    this->editHanging(own.first).previous = slot;
  }
  this->editHanging(end).next = after;
  if (before != NoSlot)
  {
    this->editHanging(before).next = slot;
  }
  else
  {
    this->editHanging(point).first = slot;
  }
  if (after != NoSlot)
  {
    this->editHanging(after).previous = end;
  }
  else
  {
    this->editHanging(point).last = end;
  }
  // The first and the last of a list know where it is.
  this->at.edit(this->hanging[point].first) = point;
  this->at.edit(this->hanging[point].last) = point;
  this->vertices.edit(slot).flags = HiddenAtPoint;
}

/// Take a hidden point out of the list that it is in.
template <bool Weighted>
void EditableMesh<Weighted>::unlinkHidden(std::uint32_t slot)
{
  const HangingPoints own = this->hanging[slot];
  const std::uint32_t where = this->at[slot];
  const bool isAtPoint = (this->vertices[slot].flags & HiddenAtPoint) != 0;
  if (own.previous != NoSlot)
  {
    this->editHanging(own.previous).next = own.next;
  }
  else if (isAtPoint)
  {
    this->editHanging(where).first = own.next;
  }
  else
  {
    this->triangles.edit(where).flatEdges = own.next;
  }
  if (own.next != NoSlot)
  {
    this->editHanging(own.next).previous = own.previous;
  }
  else if (isAtPoint)
  {
    this->editHanging(where).last = own.previous;
  }
  if (isAtPoint && own.previous == NoSlot && own.next != NoSlot)
  {
    this->at.edit(own.next) = where;
  }
  if (isAtPoint && own.next == NoSlot && own.previous != NoSlot)
  {
    this->at.edit(own.previous) = where;
  }
  HangingPoints& changed = this->editHanging(slot);
  changed.next = changed.previous = NoSlot;
  this->at.edit(slot) = NoIndex;
  this->vertices.edit(slot).flags = 0;
}

/// Of the points that hang at one, take out the highest. The others hang at it then.
/// @return NoSlot: there is none
template <bool Weighted>
std::uint32_t EditableMesh<Weighted>::takeBestAt(std::uint32_t point)
{
  std::uint32_t best = this->hangingOf(point).first;
  for (std::uint32_t slot = best; Weighted && slot != NoSlot; slot = this->hanging[slot].next)
  {
    const Vertex& v = this->vertices[slot];
    const Vertex& b = this->vertices[best];
    best = v.x[2] > b.x[2] || (v.x[2] == b.x[2] && v.id < b.id) ? slot : best;
  }
  if (best == NoSlot)
  {
    return NoSlot;
  }
  this->unlinkHidden(best);
  const HangingPoints host = this->hanging[point];
  HangingPoints& own = this->editHanging(best);
  own.first = host.first;
  own.last = host.last;
  HangingPoints& changed = this->editHanging(point);
  changed.first = changed.last = NoSlot;
  if (host.first != NoSlot)
  {
    this->at.edit(host.first) = best;
    this->at.edit(host.last) = best;
  }
  return best;
}

template <bool Weighted>
void EditableMesh<Weighted>::removeHidden(std::uint32_t slot)
{
  const std::uint32_t t = this->at[slot]; // of one in a triangle
  const std::uint32_t best = this->takeBestAt(slot);
  this->unlinkHidden(slot);
  if (best != NoSlot)
  {
    this->hide(best, t);
  }
}

template void EditableMesh<false>::hide(std::uint32_t, std::uint32_t);
template void EditableMesh<false>::removeHidden(std::uint32_t);
template std::uint32_t EditableMesh<false>::takeBestAt(std::uint32_t);
template void EditableMesh<true>::hide(std::uint32_t, std::uint32_t);
template void EditableMesh<true>::removeHidden(std::uint32_t);
template std::uint32_t EditableMesh<true>::takeBestAt(std::uint32_t);

}
