// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A move-only array of plain values, left uninitialised.
///
/// Large arrays here are written exactly once, often by many threads, so clearing them first would
/// double the memory traffic. A caller can take the memory over (VTK's arrays adopt it), so results
/// leave the engine by move, never by copy.
#ifndef flipflop_Buffer_h
#define flipflop_Buffer_h

#include <flipflop/Error.h>
#include <flipflop/Memory.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace flipflop
{

/// The array: what results are made of.
/// @tparam T trivially copyable
template <class T>
class Buffer
{
  static_assert(std::is_trivially_copyable<T>::value, "Buffer holds plain values only");

public:
  Buffer() = default;

  /// @throw Error OutOfMemory if there is not enough memory.
  explicit Buffer(std::size_t size) { this->allocate(size); }

  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  /// Takes the memory over; @p other is left empty.
  Buffer(Buffer&& other) noexcept
    : first(std::exchange(other.first, nullptr))
    , count(std::exchange(other.count, 0))
  {
  }
  /// Exchanges the memory with @p other's.
  Buffer& operator=(Buffer&& other) noexcept
  {
    std::swap(this->first, other.first);
    std::swap(this->count, other.count);
    return *this;
  }
  ~Buffer() { freeMemory(this->first); }

  /// Drop the contents and hold @p size uninitialised values.
  /// @throw Error OutOfMemory
  void allocate(std::size_t size)
  {
    freeMemory(std::exchange(this->first, nullptr));
    this->count = 0;
    if (size == 0)
    {
      return;
    }
    if (size > SIZE_MAX / sizeof(T))
    {
      throw Error(ErrorCode::OutOfMemory, -1, INT64_MAX);
    }
    // Aligned for records of half a cache line. Large arrays are read and written all over: in huge
    // pages, where the system has them, that costs a fraction of the page faults and look-ups.
    constexpr std::size_t HugePage = std::size_t(1) << 21;
    const std::size_t alignment = size * sizeof(T) >= 2 * HugePage ? HugePage : Line;
    const std::size_t bytes = (size * sizeof(T) + alignment - 1) / alignment * alignment;
    // A small run has many small arrays: these have no alignment of their own.
    constexpr std::size_t Small = 1024;
    const bool anyAddress = alignof(T) <= alignof(std::max_align_t) && bytes <= Small;
    this->first =
      static_cast<T*>(allocateMemory(anyAddress ? alignof(std::max_align_t) : alignment, bytes));
    if (!this->first)
    {
      throw Error(ErrorCode::OutOfMemory, -1, static_cast<std::int64_t>(bytes));
    }
    if (alignment == HugePage)
    {
      adviseHugePages(this->first, bytes);
    }
    this->count = size;
  }

  /// A buffer of @p size uninitialised values in the memory of @p other, if that is large enough;
  /// otherwise in new memory. The rest of @p other's memory is freed.
  template <class Other>
  static Buffer recycle(Buffer<Other>&& other, std::size_t size)
  {
    const std::size_t had = other.size() * sizeof(Other);
    const std::size_t wanted = size * sizeof(T);
    Buffer result;
    if (size == 0 || wanted > had)
    {
      other = Buffer<Other>();
      result.allocate(size);
      return result;
    }
    void* const memory = other.release();
    // Shrinking can fail; then the memory stays as large as it is.
    void* const kept = had - wanted > had / 8 ? shrinkMemory(memory, wanted) : nullptr;
    result.first = static_cast<T*>(kept ? kept : memory);
    result.count = size;
    return result;
  }

  /// Forget the values past @p size; the memory stays.
  void truncate(std::size_t size) { this->count = size < this->count ? size : this->count; }

  /// Give the memory to the caller, who frees it with freeMemory().
  T* release()
  {
    this->count = 0;
    return std::exchange(this->first, nullptr);
  }

  ///@{
  /// The first value; null when empty. More than a kilobyte from allocate() is aligned to 64 bytes
  /// at least.
  T* data() { return this->first; }
  const T* data() const { return this->first; }
  ///@}

  /// How many values there are.
  std::size_t size() const { return this->count; }

  /// Whether there are none.
  bool empty() const { return this->count == 0; }

  ///@{
  /// Value @p i, from 0 to size() - 1, which is not checked.
  T& operator[](std::size_t i) { return this->first[i]; }
  const T& operator[](std::size_t i) const { return this->first[i]; }
  ///@}

  ///@{
  /// From the first value to past the last, for loops over all.
  T* begin() { return this->first; }
  T* end() { return this->first + this->count; }
  const T* begin() const { return this->first; }
  const T* end() const { return this->first + this->count; }
  ///@}

private:
  static constexpr std::size_t Line = 64; // bytes of a cache line

  T* first = nullptr;
  std::size_t count = 0;
};

}

#endif
