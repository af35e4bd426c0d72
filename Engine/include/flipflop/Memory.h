// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Aligned memory as each system has it, in a way that VTK's arrays can end, too.
///
/// C++'s own aligned_alloc is missing on Windows and on older macOS, and what its operator new
/// gives cannot shrink in place. Windows has calls of its own, and free() does not end their
/// memory.
#ifndef flipflop_Memory_h
#define flipflop_Memory_h

#include <cstddef>
#include <cstdlib>

#if defined(_WIN32)
#include <malloc.h>
#else
#include <stdlib.h>
#endif

namespace flipflop
{

/// Memory that freeMemory() ends; or VTK's arrays, as VTK_DATA_ARRAY_ALIGNED_FREE.
/// @param alignment a power of two
/// @param bytes     1 or more
/// @return null where it is not to be had
inline void* allocateMemory(std::size_t alignment, std::size_t bytes)
{
#if defined(_WIN32)
  return _aligned_malloc(bytes, alignment);
#else
  if (alignment <= alignof(std::max_align_t))
  {
    // Out of malloc's caches, which are no help where an alignment is asked for.
    return std::malloc(bytes);
  }
  void* memory = nullptr;
  return posix_memalign(&memory, alignment, bytes) == 0 ? memory : nullptr;
#endif
}

/// Ends what allocateMemory() gave; null is nothing.
inline void freeMemory(void* memory)
{
#if defined(_WIN32)
  _aligned_free(memory);
#else
  std::free(memory);
#endif
}

/// Gives back what is past @p bytes, if that can be done.
/// @param alignment as the memory was asked for; elsewhere than on Windows it may be lost
/// @return where the memory is now; null where it stayed as it was
inline void* shrinkMemory(void* memory, [[maybe_unused]] std::size_t alignment, std::size_t bytes)
{
#if defined(_WIN32)
  return _aligned_realloc(memory, bytes, alignment);
#else
  return std::realloc(memory, bytes);
#endif
}

}

#endif
