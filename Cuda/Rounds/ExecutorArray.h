// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An array in an executor's memory that grows on demand.
#ifndef flipflop_ExecutorArray_h
#define flipflop_ExecutorArray_h

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace flipflop
{

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
    this->reserve(size, 0);
  }
  ExecutorArray(const ExecutorArray&) = delete;
  ExecutorArray& operator=(const ExecutorArray&) = delete;
  ~ExecutorArray() { this->clear(); }

  /// Have room for @p size values, of which the first @p used keep theirs. Grows by half at least.
  void reserve(std::size_t size, std::size_t used)
  {
    if (size <= this->room)
    {
      return;
    }
    const std::size_t wanted = used ? std::max(size, this->room + this->room / 2) : size;
    if (!used)
    {
      this->clear();
    }
    ExecutorArray wider(this->executor);
    wider.first = static_cast<T*>(this->executor.allocate(wanted * sizeof(T)));
    wider.room = wanted;
    if (used)
    {
      this->executor.copy(wider.first, this->first, std::min(used, this->room) * sizeof(T));
    }
    std::swap(this->first, wider.first);
    std::swap(this->room, wider.room);
  }

  void clear() noexcept
  {
    if (this->first)
    {
      this->executor.release(this->first, this->room * sizeof(T));
    }
    this->first = nullptr;
    this->room = 0;
  }

  T* data() { return this->first; }
  std::size_t capacity() const { return this->room; }

private:
  Executor& executor;
  T* first = nullptr;
  std::size_t room = 0;
};

}

#endif
