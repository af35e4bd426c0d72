// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/EditableTriangulation.h>

#include "Edit/EditableState.h"
#include "Points/ConstraintInput.h"
#include "Points/PointSource.h"
#include "Support/EngineCall.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

namespace
{

/// @throw Error NonFinite
void requireFinite(const PointSource& points)
{
  std::int64_t first = -1;
  std::int64_t count = 0;
  for (std::uint32_t i = 0; i < points.count(); ++i)
  {
    double x[3];
    points.load(i, x);
    if (!isFinite(x))
    {
      first = first < 0 ? i : first;
      ++count;
    }
  }
  if (count > 0)
  {
    throw Error(ErrorCode::NonFinite, first, count);
  }
}

/// @throw Error BadArgument, WeightCount, TooManyPoints, NonFinite
PointSource sourceOf(const PointView& points, const WeightView& weights, bool mayIgnore = false)
{
  requireValid(points, 2);
  requireValid(weights, points.count);
  const PointSource source(points, weights);
  if (!mayIgnore)
  {
    requireFinite(source);
  }
  return source;
}

/// What is to be edited: each is there, and only once.
/// @param contains bool (id)
/// @param missing  what() of an error
/// @param slotOf   std::uint32_t (id)
/// @throw Error BadArgument
template <class Contains, class SlotOf>
std::vector<std::uint32_t> listOf(const std::int64_t* ids, std::int64_t count,
  const Contains& contains, const char* missing, const SlotOf& slotOf)
{
  if (count < 0 || (count > 0 && !ids))
  {
    throw badArgument("ids must be in memory, with a count of 0 or more");
  }
  std::vector<std::uint32_t> slots;
  slots.reserve(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (!contains(ids[i]))
    {
      throw badArgument(missing, i, ids[i]);
    }
    slots.push_back(slotOf(ids[i]));
  }
  std::vector<std::pair<std::uint32_t, std::int64_t>> sorted;
  for (std::int64_t i = 0; count > 1 && i < count; ++i)
  {
    sorted.emplace_back(slots[static_cast<std::size_t>(i)], i);
  }
  std::sort(sorted.begin(), sorted.end());
  std::int64_t again = count;
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    again = sorted[i].first == sorted[i - 1].first ? std::min(again, sorted[i].second) : again;
  }
  if (again < count)
  {
    throw badArgument("an id must not be there twice", again, ids[again]);
  }
  return slots;
}

std::vector<std::uint32_t> slotsOf(
  const EditableState& state, const std::int64_t* ids, std::int64_t count)
{
  return listOf(
    ids, count, [&state](std::int64_t id) { return state.contains(id); },
    "an id must be of a point that is in the triangulation", EditableState::slotOf);
}

/// edit (Monitor&, ProgressOfParts&): all of it is done, or nothing.
template <class Edit>
void inEdit(EditableState& state, std::int64_t points, const Options& options, const Edit& edit)
{
  Monitor monitor(options);
  ProgressOfParts parts(options);
  ArenaLoan arena(threadCount(options.threads, points));
  arena.execute(
    [&]
    {
      try
      {
        monitor.stage(0.0, 0.1, 1);
        edit(monitor, parts);
        monitor.stage(1.0, 1.0, 1);
        state.commit();
      }
      catch (...)
      {
        state.rollback();
        throw;
      }
    });
}

Options oneThread()
{
  Options options;
  options.threads = 1;
  return options;
}

}

EditableTriangulation::EditableTriangulation()
  : state(engineCall([] { return std::make_unique<EditableState>(); }))
{
}

EditableTriangulation::EditableTriangulation(
  const PointView& points, const WeightView& weights, const Options& options)
  : EditableTriangulation()
{
  engineCall(
    [&]
    {
      const bool mayIgnore = options.nonFinite == NonFinitePolicy::Ignore;
      const PointSource source = sourceOf(points, weights, mayIgnore);
      inEdit(*this->state, points.count, options,
        [&](Monitor& monitor, ProgressOfParts& parts)
        { this->state->insert(source, monitor, parts); });
    });
}

EditableTriangulation::EditableTriangulation(const EditableTriangulation& other)
  : state(engineCall([&] { return std::make_unique<EditableState>(*other.state); }))
{
}

EditableTriangulation& EditableTriangulation::operator=(const EditableTriangulation& other)
{
  EditableTriangulation copy(other);
  std::swap(this->state, copy.state);
  return *this;
}

EditableTriangulation::EditableTriangulation(EditableTriangulation&&) noexcept = default;
EditableTriangulation& EditableTriangulation::operator=(EditableTriangulation&&) noexcept = default;
EditableTriangulation::~EditableTriangulation() = default;

std::int64_t EditableTriangulation::insert(double x, double y, double weight)
{
  return engineCall(
    [&]
    {
      const double point[3] = { x, y, weight };
      return this->insert(PointView(point, 1), WeightView(point + 2, 1), oneThread());
    });
}

std::int64_t EditableTriangulation::insert(
  const PointView& points, const WeightView& weights, const Options& options)
{
  return engineCall(
    [&]
    {
      const std::int64_t first = this->state->idCount();
      const PointSource source = sourceOf(points, weights);
      inEdit(*this->state, points.count, options,
        [&](Monitor& monitor, ProgressOfParts& parts)
        { this->state->insert(source, monitor, parts); });
      return first;
    });
}

void EditableTriangulation::remove(std::int64_t id)
{
  engineCall([&] { this->remove(&id, 1, oneThread()); });
}

void EditableTriangulation::remove(
  const std::int64_t* ids, std::int64_t count, const Options& options)
{
  engineCall(
    [&]
    {
      const std::vector<std::uint32_t> slots = slotsOf(*this->state, ids, count);
      inEdit(*this->state, count, options,
        [&](Monitor& monitor, ProgressOfParts& parts)
        { this->state->remove(slots, monitor, parts); });
    });
}

void EditableTriangulation::move(std::int64_t id, double x, double y)
{
  engineCall(
    [&]
    {
      const double point[2] = { x, y };
      this->move(&id, PointView(point, 1, 2), WeightView(), oneThread());
    });
}

void EditableTriangulation::move(const std::int64_t* ids, const PointView& points,
  const WeightView& weights, const Options& options)
{
  engineCall(
    [&]
    {
      const PointSource source = sourceOf(points, weights);
      const std::vector<std::uint32_t> slots = slotsOf(*this->state, ids, points.count);
      inEdit(*this->state, points.count, options,
        [&](Monitor& monitor, ProgressOfParts& parts)
        { this->state->move(slots, source, !weights.data, monitor, parts); });
    });
}

std::int64_t EditableTriangulation::insertConstraints(
  const ConstraintView& constraints, const Options& options)
{
  return engineCall(
    [&]
    {
      const std::int64_t first = this->state->constraints().numberCount();
      requireValid(constraints, this->state->idCount());
      if (constraints.sides != 0)
      {
        throw badArgument("constraints that are edited are no sides of polygons");
      }
      std::vector<std::uint32_t> ends;
      eachEnd(constraints,
        [&](std::int64_t constraint, std::int64_t id)
        {
          if (!this->state->contains(id))
          {
            throw Error(ErrorCode::ConstraintPoint, constraint, id);
          }
          ends.push_back(EditableState::slotOf(id));
        });
      inEdit(*this->state, 1, options,
        [&](Monitor& monitor, ProgressOfParts&) { this->state->insertConstraints(ends, monitor); });
      return first;
    });
}

void EditableTriangulation::removeConstraints(
  const std::int64_t* numbers, std::int64_t count, const Options& options)
{
  engineCall(
    [&]
    {
      const ConstraintList& list = this->state->constraints();
      const std::vector<std::uint32_t> all = listOf(
        numbers, count, [&list](std::int64_t number) { return list.contains(number); },
        "a number must be of a constraint that is in the triangulation",
        [](std::int64_t number) { return static_cast<std::uint32_t>(number); });
      inEdit(*this->state, 1, options,
        [&](Monitor& monitor, ProgressOfParts&) { this->state->removeConstraints(all, monitor); });
    });
}

void EditableTriangulation::skipConstraintNumbers(std::int64_t count)
{
  engineCall(
    [&]
    {
      if (count < 0)
      {
        throw badArgument("a count of numbers must be 0 or more");
      }
      inEdit(*this->state, 1, oneThread(),
        [&](Monitor&, ProgressOfParts&) { this->state->skipConstraints(count); });
    });
}

std::int64_t EditableTriangulation::constraintCount() const
{
  return this->state->constraints().count();
}

std::int64_t EditableTriangulation::constraintNumberCount() const
{
  return this->state->constraints().numberCount();
}

bool EditableTriangulation::containsConstraint(std::int64_t number) const
{
  return this->state->constraints().contains(number);
}

void EditableTriangulation::constraint(std::int64_t number, std::int64_t* ends) const
{
  const ConstraintList& list = this->state->constraints();
  if (!list.contains(number))
  {
    throw badArgument("a number must be of a constraint that is in the triangulation", 0, number);
  }
  for (int which = 0; which < 2; ++which)
  {
    ends[which] = std::int64_t(list.end(static_cast<std::uint32_t>(number), which)) - 1;
  }
}

std::int64_t EditableTriangulation::dividedEdges() const
{
  return this->state->dividedCount();
}

std::int64_t EditableTriangulation::idCount() const
{
  return this->state->idCount();
}

std::int64_t EditableTriangulation::pointCount() const
{
  return this->state->pointCount();
}

bool EditableTriangulation::contains(std::int64_t id) const
{
  return this->state->contains(id);
}

void EditableTriangulation::point(std::int64_t id, double* values) const
{
  engineCall([&] { this->state->load(slotsOf(*this->state, &id, 1).front(), values); });
}

bool EditableTriangulation::locate(double x, double y, std::int64_t* corners)
{
  return engineCall(
    [&]
    {
      const double point[3] = { x, y, 0.0 };
      sourceOf(PointView(point, 1), WeightView());
      try
      {
        return this->state->locate(point, corners);
      }
      catch (...)
      {
        this->state->rollback();
        throw;
      }
    });
}

ConstrainedTriangulation EditableTriangulation::snapshot(const Options& options) const
{
  return engineCall([&] { return this->state->snapshot(options); });
}

}
