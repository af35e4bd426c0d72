// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An array whose changes since the last commit can be taken back.
///
/// An edit of a triangulation is many small writes, and memory may run out at each of them. So the
/// old value of all that an edit overwrites is kept until it is complete: then all arrays commit.
/// If it fails, they roll back, which needs no memory.
#ifndef flipflop_JournaledArray_h
#define flipflop_JournaledArray_h

#include <flipflop/Buffer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam T trivially copyable
template <class T>
class JournaledArray
{
public:
  JournaledArray() = default;

  /// Take over an array's memory, committed.
  explicit JournaledArray(Buffer<T>&& from)
    : values(std::move(from))
    , count(values.size())
    , committed(count)
  {
  }

  /// A copy of a committed array.
  JournaledArray(const JournaledArray& other)
    : values(other.count)
    , count(other.count)
    , committed(other.count)
  {
    std::copy_n(other.values.begin(), this->count, this->values.begin());
  }
  JournaledArray(JournaledArray&&) noexcept = default;
  JournaledArray& operator=(JournaledArray&&) noexcept = default;

  std::size_t size() const { return this->count; }
  const T& operator[](std::size_t i) const { return this->values[i]; }
  const T* data() const { return this->values.data(); }

  /// A value to be written at once: the next edit or append ends the reference.
  T& edit(std::size_t i)
  {
    if (i < this->committed)
    {
      this->old.push_back({ static_cast<std::uint32_t>(i), this->values[i] });
    }
    return this->values[i];
  }

  /// A value that edit() was called for since the last commit, or marks in it that are cleared
  /// before the edit is complete.
  T& again(std::size_t i) { return this->values[i]; }

  void append(const T& value)
  {
    if (this->count == this->values.size())
    {
      constexpr std::size_t Least = 16;
      Buffer<T> more(std::max(Least, this->count + this->count / 2));
      std::copy_n(this->values.begin(), this->count, more.begin());
      this->values = std::move(more);
    }
    this->values[this->count++] = value;
  }

  void commit() noexcept
  {
    this->old.clear();
    this->committed = this->count;
  }

  /// @param restore void (T&): called for each old value once it is back
  template <class Restore>
  void rollback(const Restore& restore) noexcept
  {
    this->count = this->committed;
    for (; !this->old.empty(); this->old.pop_back())
    {
      T& value = this->values[this->old.back().index];
      value = this->old.back().value;
      restore(value);
    }
  }

private:
  struct Old
  {
    std::uint32_t index;
    T value;
  };

  Buffer<T> values; ///< with space for more
  std::size_t count = 0;
  std::size_t committed = 0; ///< as many values as there were then
  std::vector<Old> old;      ///< those overwritten, in order
};

}

#endif
