// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Edit/EditableState.h"

#include "Geometry/HilbertCurve.h"
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <cmath>

namespace flipflop
{

namespace
{

/// Slots in the order of a curve through their points.
template <class VertexOf>
void sortAlongCurve(std::vector<std::uint32_t>& slots, const VertexOf& vertexOf, Monitor& monitor)
{
  const HilbertCurve curve = curveThrough(slots.size(), monitor,
    [&](std::size_t i, double* uv) { std::copy_n(vertexOf(slots[i]).x, 2, uv); });
  std::vector<std::uint64_t> keys;
  keys.reserve(slots.size());
  for (const std::uint32_t slot : slots)
  {
    keys.push_back(std::uint64_t(curve.at(vertexOf(slot).x)) << 32 | slot);
  }
  std::sort(keys.begin(), keys.end());
  std::transform(keys.begin(), keys.end(), slots.begin(),
    [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
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
  if (auto* const without = std::get_if<EditableMesh<false>>(&this->mesh))
  {
    without->setGeometry(this->known.frame.geometry<false>());
  }
  else
  {
    std::get<EditableMesh<true>>(this->mesh).setGeometry(this->known.frame.geometry<true>());
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
  if (next.anyWeight())
  {
    if (auto* const without = std::get_if<EditableMesh<false>>(&this->mesh))
    {
      this->before = std::move(*without);
      this->mesh = EditableMesh<true>(
        next.geometry<true>(), EditableMesh<false>(std::get<EditableMesh<false>>(*this->before)));
      return;
    }
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
  this->committed = this->known;
}

void EditableState::rollback() noexcept
{
  if (this->before)
  {
    this->mesh = std::move(*this->before);
    this->before.reset();
  }
  this->inMesh([](auto& m) { m.rollback(); });
  this->known = this->committed;
  this->setGeometry();
}

/// Do so many edits take longer one by one than a triangulation of all?
bool EditableState::paysAnew(std::size_t edits) const
{
  constexpr std::size_t Few = 64;
  return edits > Few && 10 * edits >= static_cast<std::size_t>(this->known.present);
}

void EditableState::insert(const PointSource& points, Monitor& monitor, const Options& options)
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
  this->insertAll(slots, monitor, options);
}

/// Insert points that are not there.
void EditableState::insertAll(
  std::vector<std::uint32_t>& slots, Monitor& monitor, const Options& options)
{
  this->known.present += static_cast<std::int64_t>(slots.size());
  if (this->paysAnew(slots.size()))
  {
    for (const std::uint32_t slot : slots)
    {
      this->inMesh([slot](auto& m) { m.wait(slot); });
    }
    this->triangulate(monitor, options);
    return;
  }
  if (slots.size() > 1)
  {
    sortAlongCurve(
      slots, [this](std::uint32_t slot) { return this->vertex(slot); }, monitor);
  }
  StepPoll poll(monitor);
  for (const std::uint32_t slot : slots)
  {
    poll.step();
    this->insertSlot(slot, options);
  }
}

void EditableState::insertSlot(std::uint32_t slot, const Options& options)
{
  if (this->hasTriangles())
  {
    this->inMesh([slot](auto& m) { m.insert(slot); });
    return;
  }
  this->inMesh([slot](auto& m) { m.wait(slot); });
  std::uint32_t* const span = this->known.span;
  if (span[1] == 0 || slot < span[0])
  {
    this->findSpan(span[0] == 0 ? slot : std::min(slot, span[0]));
    return;
  }
  const bool isBeside = this->inMesh([&](const auto& m)
    { return m.signs().orient(m.vertex(span[0]), m.vertex(span[1]), m.vertex(slot)) != 0; });
  if (isBeside)
  {
    Monitor monitor(options);
    this->triangulate(monitor, options);
  }
}

/// @param from all points that wait have this slot or a later one
void EditableState::findSpan(std::uint32_t from)
{
  std::uint32_t* const span = this->known.span;
  span[0] = span[1] = 0;
  for (std::uint32_t slot = from; slot <= this->idCount() && span[1] == 0; ++slot)
  {
    const Vertex& v = this->vertex(slot);
    if (v.flags != 0 && span[0] == 0)
    {
      span[0] = slot;
    }
    else if (v.flags != 0 && !LiftedGeometry<true>::samePlanePosition(this->vertex(span[0]), v))
    {
      span[1] = slot;
    }
  }
}

void EditableState::remove(
  const std::vector<std::uint32_t>& slots, Monitor& monitor, const Options& options)
{
  const bool anew = this->hasTriangles() && this->paysAnew(slots.size());
  StepPoll poll(monitor);
  for (const std::uint32_t slot : slots)
  {
    poll.step();
    if (anew)
    {
      this->inMesh([slot](auto& m) { m.forget(slot); });
    }
    else
    {
      this->removeSlot(slot, options);
    }
  }
  this->known.present -= static_cast<std::int64_t>(slots.size());
  if (anew)
  {
    this->triangulate(monitor, options);
  }
}

void EditableState::removeSlot(std::uint32_t slot, const Options& options)
{
  if (!this->hasTriangles())
  {
    this->inMesh([slot](auto& m) { m.forget(slot); });
    const std::uint32_t* const span = this->known.span;
    if (slot == span[0] || slot == span[1])
    {
      this->findSpan(span[0]);
    }
    return;
  }
  if (!this->inMesh([slot](auto& m) { return m.remove(slot); }))
  {
    this->inMesh([slot](auto& m) { m.forget(slot); });
    Monitor monitor(options);
    this->triangulate(monitor, options);
  }
}

void EditableState::move(const std::vector<std::uint32_t>& slots, const PointSource& points,
  bool keepWeights, Monitor& monitor, const Options& options)
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
  const bool anew = this->hasTriangles() && this->paysAnew(slots.size());
  StepPoll poll(monitor);
  for (std::size_t i = 0; i < slots.size(); ++i)
  {
    poll.step();
    if (!anew)
    {
      this->removeSlot(slots[i], options);
    }
    this->setPoint(slots[i], this->scaled(&given[3 * i], slots[i]));
    if (!anew)
    {
      this->insertSlot(slots[i], options);
      continue;
    }
    this->inMesh([&](auto& m) { m.wait(slots[i]); });
  }
  if (anew)
  {
    this->triangulate(monitor, options);
  }
}

std::vector<std::uint32_t> EditableState::presentSlots() const
{
  std::vector<std::uint32_t> slots;
  slots.reserve(static_cast<std::size_t>(this->known.present));
  for (std::uint32_t slot = 1; slot <= this->idCount(); ++slot)
  {
    if (this->vertex(slot).flags != 0)
    {
      slots.push_back(slot);
    }
  }
  return slots;
}

/// @return with indices of the slots for ids
Triangulation EditableState::triangulationOf(
  const std::vector<std::uint32_t>& slots, const Options& options) const
{
  std::vector<double> numbers;
  numbers.reserve(3 * slots.size());
  for (const std::uint32_t slot : slots)
  {
    const double* const x = this->vertex(slot).x;
    numbers.insert(numbers.end(), x, x + 3);
  }
  const auto count = static_cast<std::int64_t>(slots.size());
  return regularTriangulation(PointView(numbers.data(), count, 3),
    count > 0 ? WeightView(numbers.data() + 2, count, 3) : WeightView(), options);
}

/// Make the mesh anew, of all points.
void EditableState::triangulate(Monitor& monitor, const Options& options)
{
  const std::vector<std::uint32_t> slots = this->presentSlots();
  Options forAll = options;
  forAll.facets = FacetMode::Triangles;
  const Triangulation made = this->triangulationOf(slots, forAll);
  this->inMesh(
    [&](auto& m)
    {
      using MeshOfPoints = std::decay_t<decltype(m)>;
      MeshOfPoints fresh(m.signs().unraised());
      for (std::uint32_t slot = 1; slot < m.slotCount(); ++slot)
      {
        Vertex v = m.vertex(slot);
        v.flags = 0;
        fresh.addSlot(v);
      }
      if (made.dimension < 2)
      {
        for (const std::uint32_t slot : slots)
        {
          fresh.wait(slot);
        }
      }
      else
      {
        std::vector<std::uint32_t> corners;
        corners.reserve(made.connectivity.size());
        for (const std::int64_t corner : made.connectivity)
        {
          corners.push_back(
            slots[static_cast<std::size_t>(made.pointIds[static_cast<std::size_t>(corner)])]);
        }
        fresh.adopt(corners);
        std::vector<std::uint32_t> hidden;
        for (const std::int64_t id : made.hiddenIds)
        {
          hidden.push_back(slots[static_cast<std::size_t>(id)]);
        }
        sortAlongCurve(
          hidden, [&m](std::uint32_t slot) { return m.vertex(slot); }, monitor);
        StepPoll poll(monitor);
        for (const std::uint32_t slot : hidden)
        {
          poll.step();
          fresh.insert(slot);
        }
      }
      fresh.commit();
      if (!this->before)
      {
        this->before = std::move(m);
      }
      m = std::move(fresh);
    });
  this->findSpan(this->hasTriangles() ? NoIndex : 1);
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
