// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Results as arrays and back, for pickle and copy: the sizes of each result's arrays, the numbers
/// of all these arrays one after another, and the figures.
#ifndef flipflop_State_h
#define flipflop_State_h

#include "Results.h"
#include "Views.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Hull.h>
#include <flipflop/Statistics.h>
#include <flipflop/Triangulation.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace flipflop
{

using Figures =
  nanobind::ndarray<const double, nanobind::ndim<1>, nanobind::c_contig, nanobind::device::cpu>;

/// What a pickle holds of results: sizes, numbers, figures.
using State = std::tuple<IdArray, IdArray, Figures>;

/// use(array) for the arrays of a result.
template <class Result, class Use>
void eachArray(Result& result, Use&& use)
{
  use(result.pointIds);
  use(result.connectivity);
  use(result.offsets);
  using Plain = std::remove_const_t<Result>;
  if constexpr (std::is_base_of_v<Triangulation, Plain>)
  {
    use(result.hiddenIds);
  }
  if constexpr (std::is_base_of_v<ConstrainedTriangulation, Plain>)
  {
    use(result.fixedEdges);
    use(result.constraintOf);
    use(result.balance);
    use(result.sideOf);
  }
}

/// use(number) for the figures of a result.
template <class Result, class Use>
void eachFigure(Result& result, Use&& use)
{
  if constexpr (std::is_same_v<std::remove_const_t<Result>, Hull>)
  {
    use(result.volume);
    use(result.area);
  }
  if constexpr (std::is_same_v<std::remove_const_t<Result>, ConstrainedTriangulation>)
  {
    use(result.sides);
  }
  Statistics::eachField([&](const char*, auto field) { use(result.statistics.*field); });
  use(result.statistics.threads);
}

/// @param at const Result& (std::size_t)
template <class At>
nanobind::tuple stateOf(std::size_t count, const At& at)
{
  std::vector<std::int64_t> sizes;
  std::vector<double> figures;
  std::size_t total = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& result = at(i);
    sizes.push_back(result.dimension);
    sizes.push_back(result.cellSize);
    eachArray(result,
      [&](const Buffer<std::int64_t>& array)
      {
        sizes.push_back(static_cast<std::int64_t>(array.size()));
        total += array.size();
      });
    eachFigure(result, [&](auto figure) { figures.push_back(static_cast<double>(figure)); });
  }
  Buffer<std::int64_t> numbers(total);
  std::int64_t* to = numbers.data();
  for (std::size_t i = 0; i < count; ++i)
  {
    eachArray(at(i),
      [&](const Buffer<std::int64_t>& array) { to = std::copy(array.begin(), array.end(), to); });
  }
  const auto bufferOf = [](const auto& values)
  {
    Buffer<std::decay_t<decltype(values[0])>> copy(values.size());
    std::copy(values.begin(), values.end(), copy.begin());
    return arrayOf(std::move(copy));
  };
  return nanobind::make_tuple(bufferOf(sizes), arrayOf(std::move(numbers)), bufferOf(figures));
}

/// Whether indices are in range: all that readers of a result rely on.
template <class Result>
bool isSound(const Result& result)
{
  const auto areBelow = [](const Buffer<std::int64_t>& indices, std::size_t end)
  {
    return std::all_of(indices.begin(), indices.end(),
      [end](std::int64_t i) { return i >= 0 && i < static_cast<std::int64_t>(end); });
  };
  const Buffer<std::int64_t>& offsets = result.offsets;
  const auto corners = static_cast<std::int64_t>(result.connectivity.size());
  bool sound = result.dimension >= -1 && result.dimension <= 3 && result.cellSize >= 0 &&
    areBelow(result.connectivity, result.pointIds.size()) &&
    (result.cellSize > 0  ? corners % result.cellSize == 0
        : offsets.empty() ? corners == 0
                          : offsets[0] == 0 && offsets[offsets.size() - 1] == corners &&
          std::is_sorted(offsets.begin(), offsets.end()));
  if constexpr (std::is_base_of_v<ConstrainedTriangulation, Result>)
  {
    sound = sound && areBelow(result.fixedEdges, result.pointIds.size()) &&
      result.fixedEdges.size() == 2 * result.constraintOf.size() &&
      result.balance.size() == result.constraintOf.size() &&
      result.sideOf.size() == result.constraintOf.size();
  }
  return sound;
}

/// @throw nanobind::value_error if that is no state of such results
template <class Result>
std::vector<Result> restoredResults(const State& state)
{
  const auto& [sizes, numbers, figures] = state;
  const auto rest = [](const auto& array, std::size_t at) { return array.shape(0) - at; };
  std::vector<Result> results;
  std::size_t size = 0;
  std::size_t number = 0;
  std::size_t figure = 0;
  bool sound = true;
  const auto next = [&]
  {
    sound = sound && rest(sizes, size) > 0;
    return sound ? sizes.data()[size++] : 0;
  };
  while (sound && rest(sizes, size) > 0)
  {
    Result& result = results.emplace_back();
    result.dimension = static_cast<int>(next());
    result.cellSize = next();
    eachArray(result,
      [&](Buffer<std::int64_t>& array)
      {
        const std::int64_t count = next();
        sound = sound && count >= 0 && static_cast<std::size_t>(count) <= rest(numbers, number);
        if (sound)
        {
          array.allocate(static_cast<std::size_t>(count));
          std::copy_n(numbers.data() + number, array.size(), array.begin());
          number += array.size();
        }
      });
    eachFigure(result,
      [&](auto& value)
      {
        sound = sound && rest(figures, figure) > 0;
        value = static_cast<std::decay_t<decltype(value)>>(sound ? figures.data()[figure++] : 0.0);
      });
    sound = sound && isSound(result);
  }
  if (!sound || rest(numbers, number) > 0 || rest(figures, figure) > 0)
  {
    throw nanobind::value_error("this is no state of a result of this version");
  }
  return results;
}

/// @throw nanobind::value_error if that is no state of one
template <class Result>
Result restoredResult(const State& state)
{
  std::vector<Result> results = restoredResults<Result>(state);
  if (results.size() != 1)
  {
    throw nanobind::value_error("this is no state of one result");
  }
  return std::move(results.front());
}

/// Handles can be pickled.
template <class Result>
void bindState(nanobind::class_<Handle<Result>>& bound)
{
  bound
    .def("__getstate__",
      [](const Handle<Result>& self)
      {
        return stateOf(1, [&](std::size_t) -> const Result& { return *self.result; });
      })
    .def("__setstate__",
      [](Handle<Result>& self, const State& state)
      { new (&self) Handle<Result>(handleOf(restoredResult<Result>(state))); });
}

}

#endif
