// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangulations that are edited.
#include "Calls.h"
#include "Constrained.h"
#include "Results.h"
#include "Views.h"

#include <flipflop/EditableTriangulation.h>

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

std::int64_t countOf(const IdArray& ids)
{
  return static_cast<std::int64_t>(ids.shape(0));
}

/// use(id, x, y and weight) for each id that was given: NaN of those that no point has.
template <class Use>
void eachPoint(const EditableTriangulation& self, const Use& use)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::int64_t id = 0; id < self.idCount(); ++id)
  {
    double x[3] = { none, none, none };
    if (self.contains(id))
    {
      self.point(id, x);
    }
    use(static_cast<std::size_t>(id), x);
  }
}

auto pointsOf(const EditableTriangulation& self)
{
  const auto count = static_cast<std::size_t>(self.idCount());
  Buffer<double> points(2 * count);
  eachPoint(
    self, [&](std::size_t i, const double* x) { std::copy_n(x, 2, points.data() + 2 * i); });
  return arrayOf(std::move(points), { count, 2 });
}

auto weightsOf(const EditableTriangulation& self)
{
  Buffer<double> weights(static_cast<std::size_t>(self.idCount()));
  eachPoint(self, [&](std::size_t i, const double* x) { weights[i] = x[2]; });
  return arrayOf(std::move(weights));
}

std::vector<std::int64_t> numbersOf(const EditableTriangulation& self)
{
  std::vector<std::int64_t> numbers;
  for (std::int64_t number = 0; number < self.constraintNumberCount(); ++number)
  {
    if (self.containsConstraint(number))
    {
      numbers.push_back(number);
    }
  }
  return numbers;
}

/// The constraints' numbers, and their ends.
nb::tuple constraintsOf(const EditableTriangulation& self)
{
  const std::vector<std::int64_t> all = numbersOf(self);
  Buffer<std::int64_t> numbers(all.size());
  Buffer<std::int64_t> ends(2 * all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    numbers[i] = all[i];
    self.constraint(all[i], ends.data() + 2 * i);
  }
  return nb::make_tuple(arrayOf(std::move(numbers)), arrayOf(std::move(ends), { all.size(), 2 }));
}

/// Insert constraints with the numbers that they had, of so many that were given.
/// @param numbers ascending
void restoreConstraints(EditableTriangulation& self, const IdArray& numbers, const EndsArray& ends,
  std::int64_t count, const Settings& settings)
{
  if (numbers.shape(0) != ends.shape(0))
  {
    throw nb::value_error("this is no state of a triangulation");
  }
  const std::int64_t* const number = numbers.data();
  const std::size_t size = numbers.shape(0);
  const auto skipTo = [&](std::int64_t next)
  { self.skipConstraintNumbers(next - self.constraintNumberCount()); };
  settings.run(
    [&](const Options& options)
    {
      for (std::size_t begin = 0, end = 0; begin < size; begin = end)
      {
        for (end = begin + 1; end < size && number[end] == number[end - 1] + 1; ++end)
        {
        }
        skipTo(number[begin]);
        const auto run = static_cast<std::int64_t>(end - begin);
        self.insertConstraints(ConstraintView(ends.data() + 2 * begin, run), options);
      }
      skipTo(count);
      return 0;
    });
}

/// As a constrained triangulation if there are constraints, with rows of those for numbers.
nb::object snapshotOf(const EditableTriangulation& self, const Settings& settings)
{
  ConstrainedTriangulation made =
    settings.run([&](const Options& options) { return self.snapshot(options); });
  if (self.constraintCount() == 0)
  {
    return nb::cast(handleOf(Triangulation(std::move(made))));
  }
  const std::vector<std::int64_t> numbers = numbersOf(self);
  for (std::int64_t& number : made.constraintOf)
  {
    number = std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin();
  }
  Constrained result;
  result.whole = std::make_shared<const ConstrainedTriangulation>(std::move(made));
  result.inside = { result.whole };
  return nb::cast(result);
}

}

void bindEdits(nb::module_& module)
{
  using Edited = EditableTriangulation;
  nb::class_<Edited>(module, "EditableTriangulation")
    .def(
      "__init__",
      [](Edited* self, const InputArray& points, const std::optional<InputArray>& weights,
        const Settings& settings)
      {
        const PointView view = pointView(points, 2);
        const WeightView weighted = weightView(weights);
        new (self) Edited(
          settings.run([&](const Options& options) { return Edited(view, weighted, options); }));
      },
      "points"_a, "weights"_a.none(), "settings"_a)
    .def("copy", [](const Edited& self) { return Edited(self); })
    .def(
      "insert",
      [](Edited& self, const InputArray& points, const std::optional<InputArray>& weights,
        const Settings& settings)
      {
        const PointView view = pointView(points, 2);
        const WeightView weighted = weightView(weights);
        return settings.run(
          [&](const Options& options) { return self.insert(view, weighted, options); });
      },
      "points"_a, "weights"_a.none(), "settings"_a)
    .def("insert_one",
      [](Edited& self, double x, double y, double weight) { return self.insert(x, y, weight); })
    .def("remove_one", [](Edited& self, std::int64_t id) { self.remove(id); })
    .def("remove",
      [](Edited& self, const IdArray& ids, const Settings& settings)
      {
        settings.run(
          [&](const Options& options)
          {
            self.remove(ids.data(), countOf(ids), options);
            return 0;
          });
      })
    .def(
      "move",
      [](Edited& self, const IdArray& ids, const InputArray& points,
        const std::optional<InputArray>& weights, const Settings& settings)
      {
        const PointView view = pointView(points, 2);
        const WeightView weighted = weightView(weights);
        if (view.count != countOf(ids))
        {
          throw nb::value_error("there are not as many ids as points");
        }
        settings.run(
          [&](const Options& options)
          {
            self.move(ids.data(), view, weighted, options);
            return 0;
          });
      },
      "ids"_a, "points"_a, "weights"_a.none(), "settings"_a)
    .def("insert_constraints",
      [](Edited& self, const EndsArray& ends, const Settings& settings)
      {
        const ConstraintView view(ends.data(), static_cast<std::int64_t>(ends.shape(0)));
        return settings.run(
          [&](const Options& options) { return self.insertConstraints(view, options); });
      })
    .def("remove_constraints",
      [](Edited& self, const IdArray& numbers, const Settings& settings)
      {
        settings.run(
          [&](const Options& options)
          {
            self.removeConstraints(numbers.data(), countOf(numbers), options);
            return 0;
          });
      })
    .def("restore_constraints", &restoreConstraints)
    .def_prop_ro("id_count", &Edited::idCount)
    .def_prop_ro("constraint_number_count", &Edited::constraintNumberCount)
    .def_prop_ro("point_count", &Edited::pointCount)
    .def_prop_ro("constraint_count", &Edited::constraintCount)
    .def_prop_ro("divided_edges", &Edited::dividedEdges)
    .def("contains", &Edited::contains)
    .def("points", &pointsOf)
    .def("weights", &weightsOf)
    .def("constraints", &constraintsOf)
    .def("snapshot", &snapshotOf);
}

}
