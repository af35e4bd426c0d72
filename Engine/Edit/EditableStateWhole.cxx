// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The whole of an editable triangulation: made of all points and constraints, and written.
#include "Edit/EditableState.h"
#include "Edit/MeshSnapshot.h"
#include "Edit/SlotOrder.h"
#include "Support/Threads.h"
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <type_traits>

namespace flipflop
{

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

std::vector<std::uint32_t> EditableState::presentConstraints() const
{
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t number = 0; this->list.count() > 0 && number < this->list.numberCount();
       ++number)
  {
    if (this->list.contains(number))
    {
      numbers.push_back(number);
    }
  }
  return numbers;
}

/// From nothing.
/// @return with indices of the slots for ids
ConstrainedTriangulation EditableState::triangulationOf(
  const std::vector<std::uint32_t>& slots, const Options& options) const
{
  std::vector<double> values;
  values.reserve(3 * slots.size());
  for (const std::uint32_t slot : slots)
  {
    const double* const x = this->vertex(slot).x;
    values.insert(values.end(), x, x + 3);
  }
  const PointView points(values.data(), static_cast<std::int64_t>(slots.size()), 3);
  ConstrainedTriangulation result;
  const std::vector<std::uint32_t> numbers = this->presentConstraints();
  if (numbers.empty())
  {
    static_cast<Triangulation&>(result) = regularTriangulation(points,
      slots.empty() ? WeightView() : WeightView(values.data() + 2, points.count, 3), options);
    return result;
  }
  std::vector<std::int64_t> ends;
  for (const std::uint32_t number : numbers)
  {
    for (int which = 0; which < 2; ++which)
    {
      const std::uint32_t slot = this->list.end(number, which);
      ends.push_back(std::lower_bound(slots.begin(), slots.end(), slot) - slots.begin());
    }
  }
  try
  {
    result = constrainedTriangulation(
      points, ConstraintView(ends.data(), static_cast<std::int64_t>(numbers.size())), options);
  }
  catch (const Error& error)
  {
    throw error.code() == ErrorCode::ConstraintsCross
      ? Error(error.code(), -1, numbers[static_cast<std::size_t>(error.count())])
      : error;
  }
  for (std::int64_t& number : result.constraintOf)
  {
    number = numbers[static_cast<std::size_t>(number)];
  }
  return result;
}

/// Make the mesh again, of all points and constraints.
void EditableState::triangulate(Edit& edit)
{
  const std::vector<std::uint32_t> slots = this->presentSlots();
  const ConstrainedTriangulation made = this->triangulationOf(slots, edit.parts.options(0.1, 0.8));
  edit.monitor.stage(0.8, 1.0, 1);
  this->inMesh(
    [&](auto& m)
    {
      std::decay_t<decltype(m)> fresh(m.signs().unraised());
      for (std::uint32_t slot = 1; slot < m.slotCount(); ++slot)
      {
        Vertex v = m.vertex(slot);
        v.flags = 0;
        fresh.addSlot(v);
      }
      this->adopt(fresh, slots, made, edit);
      fresh.commit();
      if (!this->before)
      {
        this->before = Made{ std::move(m), std::move(this->now.counts) };
      }
      m = std::move(fresh);
      this->now.counts = EdgeCounts();
    });
  std::fill_n(this->known.span, 2, 0u);
  for (std::size_t i = 0; !this->hasTriangles() && i < slots.size(); ++i)
  {
    this->addToSpan(slots[i]);
  }
  if (this->list.count() > 0 && this->hasTriangles())
  {
    ConstrainedEdits(
      std::get<EditableMesh<false>>(this->now.mesh), this->list, this->now.counts, edit.monitor)
      .countAll();
  }
}

/// @param fresh of the points, without triangles
template <bool Weighted>
void EditableState::adopt(EditableMesh<Weighted>& fresh, const std::vector<std::uint32_t>& slots,
  const ConstrainedTriangulation& made, Edit& edit) const
{
  if (made.dimension < 2)
  {
    for (const std::uint32_t slot : slots)
    {
      fresh.wait(slot);
    }
    return;
  }
  fresh.adopt(made,
    [&](std::int64_t corner)
    { return slots[static_cast<std::size_t>(made.pointIds[static_cast<std::size_t>(corner)])]; });
  std::vector<std::uint32_t> hidden;
  for (const std::int64_t id : made.hiddenIds)
  {
    hidden.push_back(slots[static_cast<std::size_t>(id)]);
  }
  sortAlongCurve(
    hidden, [&fresh](std::uint32_t slot) { return fresh.vertex(slot); }, edit.monitor);
  StepPoll poll(edit.monitor);
  for (const std::uint32_t slot : hidden)
  {
    poll.step();
    fresh.insertNext(slot);
  }
}

ConstrainedTriangulation EditableState::snapshot(const Options& options) const
{
  ConstrainedTriangulation result;
  const std::vector<std::uint32_t> slots = this->presentSlots();
  if (!this->hasTriangles())
  {
    result = this->triangulationOf(slots, options);
    for (Buffer<std::int64_t>* ids : { &result.pointIds, &result.hiddenIds })
    {
      for (std::int64_t& id : *ids)
      {
        id = std::int64_t(slots[static_cast<std::size_t>(id)]) - 1;
      }
    }
    return result;
  }
  Monitor monitor(options);
  ArenaLoan arena(threadCount(options.threads, this->known.present));
  arena.execute(
    [&]
    {
      monitor.stage(0.0, 1.0, 1);
      this->inMesh(
        [&](const auto& m) { writeCells(m, m.slotCount() - 1, options, monitor, result); });
    });
  result.hiddenIds.allocate(slots.size() - result.pointIds.size());
  const std::int64_t* visible = result.pointIds.begin();
  std::int64_t* hidden = result.hiddenIds.begin();
  for (const std::uint32_t slot : slots)
  {
    const std::int64_t id = std::int64_t(slot) - 1;
    if (visible != result.pointIds.end() && *visible == id)
    {
      ++visible;
    }
    else
    {
      *hidden++ = id;
    }
  }
  if (this->list.count() > 0)
  {
    const auto& without = std::get<EditableMesh<false>>(this->now.mesh);
    const std::vector<std::uint32_t> standsFor = without.visibleOfAll();
    std::vector<MeshConstraint> constraints;
    for (const std::uint32_t number : this->presentConstraints())
    {
      constraints.push_back({ standsFor[this->list.end(number, 0)],
        standsFor[this->list.end(number, 1)], number, false });
    }
    writeConstraints(without, constraints, result);
  }
  result.statistics.points = this->known.present;
  return result;
}

}
