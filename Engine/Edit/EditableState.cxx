// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Edit/EditableState.h"

#include "Edit/SlotOrder.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

namespace
{

/// @throw Error BadArgument
void requireEither(bool holds)
{
  if (!holds)
  {
    throw badArgument("a triangulation has constraints or weights other than 0, not both");
  }
}

}

std::int64_t EditableState::idCount() const
{
  return this->inMesh([](const auto& m) { return std::int64_t(m.slotCount()) - 1; });
}

bool EditableState::contains(std::int64_t id) const
{
  return id >= 0 && id < this->idCount() && this->vertex(slotOf(id)).flags != 0;
}

bool EditableState::hasTriangles() const
{
  return this->inMesh([](const auto& m) { return m.hasTriangles(); });
}

const Vertex& EditableState::vertex(std::uint32_t slot) const
{
  return this->inMesh([slot](const auto& m) -> const Vertex& { return m.vertex(slot); });
}

void EditableState::setPoint(std::uint32_t slot, const Vertex& point)
{
  this->inMesh([&](auto& m) { m.setPoint(slot, point); });
}

void EditableState::load(std::uint32_t slot, double* x) const
{
  for (int i = 0; i < 3; ++i)
  {
    x[i] = std::ldexp(this->vertex(slot).x[i], -this->known.frame.scaleExponent(i));
  }
}

Vertex EditableState::scaled(const double* x, std::uint32_t slot) const
{
  Vertex v{ {}, slot - 1, 0 };
  for (int i = 0; i < 3; ++i)
  {
    v.x[i] = std::ldexp(x[i], this->known.frame.scaleExponent(i));
  }
  return v;
}

void EditableState::setGeometry() noexcept
{
  if (auto* const without = std::get_if<EditableMesh<false>>(&this->now.mesh))
  {
    without->setGeometry(this->known.frame.geometry<false>());
  }
  else
  {
    std::get<EditableMesh<true>>(this->now.mesh).setGeometry(this->known.frame.geometry<true>());
  }
}

/// Scale all points for a frame that holds them, and choose the signs.
void EditableState::setFrame(const PointFrame& next)
{
  int change[3];
  for (int i = 0; i < 3; ++i)
  {
    change[i] = next.scaleExponent(i) - this->known.frame.scaleExponent(i);
  }
  this->known.frame = next;
  for (std::uint32_t slot = 1; change[0] != 0 && slot <= this->idCount(); ++slot)
  {
    Vertex v = this->vertex(slot);
    for (int i = 0; i < 3; ++i)
    {
      v.x[i] = std::ldexp(v.x[i], change[i]);
    }
    this->setPoint(slot, v);
  }
  if (next.anyWeight() && std::holds_alternative<EditableMesh<false>>(this->now.mesh))
  {
    requireEither(this->list.count() == 0);
    EditableMesh<false>& without = std::get<EditableMesh<false>>(this->now.mesh);
    AnyMesh weighted = EditableMesh<true>(next.geometry<true>(), EditableMesh<false>(without));
    this->before = std::move(this->now);
    this->now = { std::move(weighted), EdgeCounts() };
    return;
  }
  this->setGeometry();
}

/// Before points are scaled.
void EditableState::admit(const PointSource& points)
{
  PointFrame next = this->known.frame;
  for (std::uint32_t i = 0; i < points.count(); ++i)
  {
    double x[3];
    points.load(i, x);
    if (isFinite(x))
    {
      next.add(x);
    }
  }
  if (!next.isSame(this->known.frame))
  {
    this->setFrame(next);
  }
}

void EditableState::commit() noexcept
{
  this->before.reset();
  this->inMesh([](auto& m) { m.commit(); });
  this->now.counts.commit();
  this->list.commit();
  this->committed = this->known;
}

void EditableState::rollback() noexcept
{
  if (this->before)
  {
    this->now = std::move(*this->before);
    this->before.reset();
  }
  this->inMesh([](auto& m) { m.rollback(); });
  this->now.counts.rollback();
  this->list.rollback();
  this->known = this->committed;
  this->setGeometry();
}

EditableState::Edit EditableState::beginEdit(Monitor& monitor, ProgressOfParts& parts)
{
  Edit edit{ monitor, parts, std::nullopt, false };
  this->known.divided = 0;
  if (this->list.count() > 0)
  {
    edit.constrained.emplace(
      std::get<EditableMesh<false>>(this->now.mesh), this->list, this->now.counts, monitor);
  }
  return edit;
}

/// @param slots of the edit
void EditableState::countDivided(const std::vector<std::uint32_t>& slots, Monitor& monitor)
{
  if (this->list.count() == 0 || !this->hasTriangles())
  {
    return;
  }
  const ConstrainedEdits edits(
    std::get<EditableMesh<false>>(this->now.mesh), this->list, this->now.counts, monitor);
  this->known.divided = std::count_if(
    slots.begin(), slots.end(), [&](std::uint32_t slot) { return edits.divides(slot); });
}

/// Do so many edits take longer one by one than a triangulation of all?
bool EditableState::paysToRemake(std::size_t edits) const
{
  constexpr std::size_t Few = 64;
  return edits > Few && 2 * edits >= static_cast<std::size_t>(this->known.present);
}

void EditableState::insert(const PointSource& points, Monitor& monitor, ProgressOfParts& parts)
{
  this->admit(points);
  std::vector<std::uint32_t> slots;
  slots.reserve(points.count());
  for (std::uint32_t i = 0; i < points.count(); ++i)
  {
    double x[3];
    points.load(i, x);
    const std::uint32_t slot =
      this->inMesh([&](auto& m) { return m.addSlot(this->scaled(x, m.slotCount())); });
    if (isFinite(x))
    {
      slots.push_back(slot);
    }
  }
  this->known.present += static_cast<std::int64_t>(slots.size());
  Edit edit = this->beginEdit(monitor, parts);
  if (this->paysToRemake(slots.size()))
  {
    for (const std::uint32_t slot : slots)
    {
      this->inMesh([slot](auto& m) { m.wait(slot); });
    }
    this->triangulate(edit);
  }
  else
  {
    if (slots.size() > 1)
    {
      this->sortSlots(slots, edit);
    }
    StepPoll poll(monitor);
    for (const std::uint32_t slot : slots)
    {
      poll.step();
      this->insertSlot(slot, edit);
    }
  }
  this->countDivided(slots, monitor);
}

void EditableState::sortSlots(std::vector<std::uint32_t>& slots, Edit& edit) const
{
  sortAlongCurve(
    slots, [this](std::uint32_t slot) { return this->vertex(slot); }, edit.monitor);
  edit.isAlongCurve = true;
}

void EditableState::insertSlot(std::uint32_t slot, Edit& edit)
{
  if (this->hasTriangles())
  {
    if (edit.constrained)
    {
      edit.constrained->insertPoint(slot);
      return;
    }
    this->inMesh([&](auto& m) { edit.isAlongCurve ? m.insertNext(slot) : m.insert(slot); });
    return;
  }
  this->inMesh([slot](auto& m) { m.wait(slot); });
  const std::uint32_t* const span = this->known.span;
  const bool isOffLine = span[1] != 0 &&
    this->inMesh([&](const auto& m)
      { return m.orient(m.vertex(span[0]), m.vertex(span[1]), m.vertex(slot)) != 0; });
  if (isOffLine)
  {
    this->triangulate(edit);
    return;
  }
  this->addToSpan(slot);
}

void EditableState::addToSpan(std::uint32_t slot)
{
  std::uint32_t* const span = this->known.span;
  if (span[0] == 0)
  {
    span[0] = slot;
  }
  else if (span[1] == 0 &&
    !LiftedGeometry<true>::samePlanePosition(this->vertex(span[0]), this->vertex(slot)))
  {
    span[1] = slot;
  }
}

void EditableState::remove(
  const std::vector<std::uint32_t>& slots, Monitor& monitor, ProgressOfParts& parts)
{
  for (std::size_t i = 0; i < slots.size(); ++i)
  {
    if (this->list.anyAt(slots[i]))
    {
      throw badArgument("a point can be removed only once no constraint ends there",
        static_cast<std::int64_t>(i), std::int64_t(slots[i]) - 1);
    }
  }
  Edit edit = this->beginEdit(monitor, parts);
  this->known.present -= static_cast<std::int64_t>(slots.size());
  const bool hasTriangles = this->hasTriangles();
  bool remakes = hasTriangles && this->paysToRemake(slots.size());
  std::vector<std::uint32_t> order = slots;
  if (order.size() > 1 && !remakes)
  {
    this->sortSlots(order, edit);
  }
  StepPoll poll(monitor);
  for (const std::uint32_t slot : order)
  {
    poll.step();
    if (!hasTriangles || remakes || !this->removeFromTriangles(slot, edit))
    {
      remakes = hasTriangles;
      this->inMesh([slot](auto& m) { m.forget(slot); });
    }
  }
  if (remakes)
  {
    this->triangulate(edit);
  }
}

/// @return false: the triangles are to be made again
bool EditableState::removeFromTriangles(std::uint32_t slot, Edit& edit)
{
  return edit.constrained ? edit.constrained->removePoint(slot)
                          : this->inMesh([slot](auto& m) { return m.remove(slot); });
}

void EditableState::move(const std::vector<std::uint32_t>& slots, const PointSource& points,
  bool keepWeights, Monitor& monitor, ProgressOfParts& parts)
{
  std::vector<double> given(3 * slots.size());
  PointFrame next = this->known.frame;
  for (std::uint32_t i = 0; i < slots.size(); ++i)
  {
    double* const x = &given[3 * std::size_t(i)];
    double old[3];
    this->load(slots[i], old);
    points.load(i, x);
    x[2] = keepWeights ? old[2] : x[2];
    next.add(x);
  }
  if (!next.isSame(this->known.frame))
  {
    this->setFrame(next);
  }
  Edit edit = this->beginEdit(monitor, parts);
  bool remakes = !this->hasTriangles() || this->paysToRemake(slots.size());
  // Constraints go with the points. Only where they are in the end they must not cross.
  std::vector<std::uint32_t> carried;
  if (edit.constrained && !remakes)
  {
    for (const std::uint32_t slot : slots)
    {
      const std::vector<std::uint32_t> here = this->list.at(slot);
      carried.insert(carried.end(), here.begin(), here.end());
    }
    std::sort(carried.begin(), carried.end());
    carried.erase(std::unique(carried.begin(), carried.end()), carried.end());
    for (const std::uint32_t number : carried)
    {
      edit.constrained->release(number);
    }
  }
  StepPoll poll(monitor);
  for (std::size_t i = 0; i < slots.size(); ++i)
  {
    poll.step();
    const std::uint32_t slot = slots[i];
    remakes = remakes || !this->removeFromTriangles(slot, edit);
    this->setPoint(slot, this->scaled(&given[3 * i], slot));
    if (remakes)
    {
      this->inMesh([slot](auto& m) { m.wait(slot); });
    }
    else
    {
      this->insertSlot(slot, edit);
    }
  }
  if (remakes)
  {
    this->triangulate(edit);
  }
  else
  {
    for (const std::uint32_t number : carried)
    {
      edit.constrained->insert(number);
    }
  }
  this->countDivided(slots, monitor);
}

void EditableState::insertConstraints(const std::vector<std::uint32_t>& ends, Monitor& monitor)
{
  auto* const mesh = std::get_if<EditableMesh<false>>(&this->now.mesh);
  requireEither(mesh || ends.empty());
  this->known.divided = 0;
  if (ends.empty())
  {
    return;
  }
  ConstrainedEdits edits(*mesh, this->list, this->now.counts, monitor);
  StepPoll poll(monitor);
  for (std::size_t i = 0; i < ends.size(); i += 2)
  {
    poll.step();
    const std::uint32_t number = this->list.add(ends[i], ends[i + 1]);
    if (!this->hasTriangles())
    {
      continue;
    }
    try
    {
      edits.insert(number);
    }
    catch (const Error& error)
    {
      throw error.code() == ErrorCode::ConstraintsCross
        ? Error(error.code(), static_cast<std::int64_t>(i / 2), error.count())
        : error;
    }
  }
}

void EditableState::removeConstraints(const std::vector<std::uint32_t>& numbers, Monitor& monitor)
{
  this->known.divided = 0;
  if (numbers.empty())
  {
    return;
  }
  ConstrainedEdits edits(
    std::get<EditableMesh<false>>(this->now.mesh), this->list, this->now.counts, monitor);
  StepPoll poll(monitor);
  for (const std::uint32_t number : numbers)
  {
    poll.step();
    if (this->hasTriangles())
    {
      edits.release(number);
    }
    this->list.remove(number);
  }
}

bool EditableState::locate(const double* x, std::int64_t* corners)
{
  if (!this->hasTriangles())
  {
    return false;
  }
  PointFrame next = this->known.frame;
  next.add(x);
  const PointFrame own = std::exchange(this->known.frame, next);
  if (next.scaleExponent(0) != own.scaleExponent(0))
  {
    // Rare: the position is of another magnitude than all points.
    this->known.frame = own;
    this->setFrame(next);
    this->commit();
  }
  else
  {
    this->setGeometry();
  }
  const Vertex p = this->scaled(x, 1);
  const bool found = this->inMesh(
    [&](auto& m)
    {
      std::uint32_t slots[3];
      const bool isInside = m.firstHolding(p, slots);
      for (int i = 0; isInside && i < 3; ++i)
      {
        corners[i] = std::int64_t(slots[i]) - 1;
      }
      return isInside;
    });
  this->known.frame = this->committed.frame;
  this->setGeometry();
  return found;
}

}
