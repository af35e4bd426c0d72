// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// NumPy's arrays as the engine's views, and the engine's memory as NumPy's arrays. Nothing is
/// copied.
///
/// The Python layer (Package/_input.py) has seen to types and shapes. What is checked here once
/// more is what a view relies on.
#ifndef flipflop_Views_h
#define flipflop_Views_h

#include <flipflop/Buffer.h>
#include <flipflop/Error.h>
#include <flipflop/PointView.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>

namespace flipflop
{

/// Any array in the memory of this machine.
using InputArray = nanobind::ndarray<nanobind::ro, nanobind::device::cpu>;

/// An array that Python may read, but not change.
template <class T>
using OutputArray = nanobind::ndarray<nanobind::numpy, const T>;

/// The type of an array's numbers.
/// @throw nanobind::type_error of any other than float and double
inline ScalarType scalarTypeOf(const InputArray& array)
{
  if (array.dtype() == nanobind::dtype<double>())
  {
    return ScalarType::Float64;
  }
  if (array.dtype() == nanobind::dtype<float>())
  {
    return ScalarType::Float32;
  }
  throw nanobind::type_error("float32 or float64 is wanted");
}

/// Memory of a device, by its address.
inline const void* deviceMemory(std::uintptr_t address)
{
  return reinterpret_cast<const void*>(address);
}

/// A view of points, one a row.
/// @param columns the rows have that many at least
inline PointView pointView(const InputArray& array, std::size_t columns)
{
  if (array.ndim() != 2 || array.shape(1) < columns ||
    (array.shape(0) > 0 && (array.stride(1) != 1 || (array.shape(0) > 1 && array.stride(0) < 0))))
  {
    throw nanobind::type_error("points are rows of adjacent coordinates");
  }
  PointView view;
  view.data = array.data();
  view.type = scalarTypeOf(array);
  view.count = static_cast<std::int64_t>(array.shape(0));
  // Of a single row, the stride may be anything.
  view.stride = view.count > 1 ? array.stride(0) : static_cast<std::int64_t>(array.shape(1));
  return view;
}

/// A view of weights; of none, where there is no array.
inline WeightView weightView(const std::optional<InputArray>& array)
{
  WeightView view;
  if (!array)
  {
    return view;
  }
  if (array->ndim() != 1)
  {
    throw nanobind::type_error("weights are an array of one dimension");
  }
  // No weight is still not the same as no weights.
  static constexpr double Nothing = 0.0;
  view.data = array->size() ? array->data() : &Nothing;
  view.type = scalarTypeOf(*array);
  view.count = static_cast<std::int64_t>(array->shape(0));
  view.stride = view.count > 1 ? array->stride(0) : 1;
  return view;
}

/// A contiguous array of ids as the engine reads them.
using IdArray = nanobind::ndarray<const std::int64_t, nanobind::ndim<1>, nanobind::c_contig,
  nanobind::device::cpu>;

/// Of each constraint the ids of both ends.
using EndsArray = nanobind::ndarray<const std::int64_t, nanobind::shape<-1, 2>, nanobind::c_contig,
  nanobind::device::cpu>;

/// An array of memory that @p owner keeps.
/// @param data null only if there is nothing
template <class T, class Owner>
OutputArray<T> arrayOf(
  const T* data, std::initializer_list<std::size_t> shape, std::shared_ptr<const Owner> owner)
{
  using Kept = std::shared_ptr<const Owner>;
  static const T nothing{};
  auto kept = std::make_unique<Kept>(std::move(owner));
  const nanobind::capsule keeper(
    kept.get(), [](void* memory) noexcept { delete static_cast<Kept*>(memory); });
  kept.release();
  return OutputArray<T>(data ? data : &nothing, shape, keeper);
}

/// An array of the memory of a buffer that @p owner keeps.
template <class T, class Owner>
OutputArray<T> arrayOf(const Buffer<T>& buffer, std::shared_ptr<const Owner> owner)
{
  return arrayOf(buffer.data(), { buffer.size() }, std::move(owner));
}

/// An array that owns the memory of a buffer.
template <class T>
OutputArray<T> arrayOf(Buffer<T>&& buffer, std::initializer_list<std::size_t> shape)
{
  auto owner = std::make_shared<const Buffer<T>>(std::move(buffer));
  const T* data = owner->data();
  return arrayOf(data, shape, std::move(owner));
}
template <class T>
OutputArray<T> arrayOf(Buffer<T>&& buffer)
{
  const std::size_t size = buffer.size();
  return arrayOf(std::move(buffer), { size });
}

}

#endif
