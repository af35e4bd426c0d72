// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An array in an executor's memory that grows on demand.
#ifndef flipflop_ExecutorArray_h
#define flipflop_ExecutorArray_h

#include "Rounds/Kernel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace flipflop
{

/// Over the values that an array keeps when it grows.
template <class T>
struct KeepValues : Kernel
{
  static constexpr const char* Name = "keep values";
  static constexpr int Bytes = 2 * sizeof(T);
  T* to;
  const T* from;

  FF_HD void operator()(std::uint32_t i, Local&) const { this->to[i] = this->from[i]; }
};

/// Uninitialised plain values. Growing keeps what is used.
template <class Executor, class T>
class ExecutorArray
{
  static_assert(std::is_trivially_copyable<T>::value, "kernels share plain values only");

public:
  explicit ExecutorArray(Executor& where)
    : executor(where)
  {
  }
  ExecutorArray(Executor& where, std::size_t size)
    : executor(where)
  {
    this->reserve(size);
  }
  ExecutorArray(const ExecutorArray&) = delete;
  ExecutorArray& operator=(const ExecutorArray&) = delete;
  ~ExecutorArray() { this->clear(); }

  /// Have space for @p size values. Keeps none.
  void reserve(std::size_t size)
  {
    if (size > this->allocated)
    {
      this->clear();
      this->first = static_cast<T*>(this->executor.allocate(size * sizeof(T)));
      this->allocated = size;
    }
  }

  /// Have space for @p size values, of which the first keep theirs: as many as @p used holds in the
  /// executor's memory, but not more than @p most. What was never written is not read. Grows by
  /// half at least.
  void grow(std::size_t size, std::size_t most, const std::uint32_t* used)
  {
    if (size <= this->allocated)
    {
      return;
    }
    ExecutorArray wider(this->executor, std::max(size, this->allocated + this->allocated / 2));
    const auto least = static_cast<std::uint32_t>(std::min(most, this->allocated));
    this->executor.each(least, used, KeepValues<T>{ {}, wider.first, this->first });
    std::swap(this->first, wider.first);
    std::swap(this->allocated, wider.allocated);
  }

  void clear() noexcept
  {
    if (this->first)
    {
      this->executor.release(this->first, this->allocated * sizeof(T));
    }
    this->first = nullptr;
    this->allocated = 0;
  }

  T* data() { return this->first; }
  std::size_t capacity() const { return this->allocated; }

private:
  Executor& executor;
  T* first = nullptr;
  std::size_t allocated = 0;
};

}

#endif
