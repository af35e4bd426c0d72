// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Aligned memory on every system, such that VTK's arrays can free it, too.
///
/// std::aligned_alloc is missing on Windows and on older macOS, and memory from operator new cannot
/// shrink in place. Windows has calls of its own, and free() does not free their memory.
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

/// Allocates memory. freeMemory() frees it, and so do VTK's arrays (VTK_DATA_ARRAY_ALIGNED_FREE).
/// @param alignment a power of two
/// @param bytes     1 or more
/// @return null where there is not enough memory
inline void* allocateMemory(std::size_t alignment, std::size_t bytes)
{
#if defined(_WIN32)
  return _aligned_malloc(bytes, alignment);
#else
  if (alignment <= alignof(std::max_align_t))
  {
    // From malloc's caches, which posix_memalign does not use.
    return std::malloc(bytes);
  }
  void* memory = nullptr;
  return posix_memalign(&memory, alignment, bytes) == 0 ? memory : nullptr;
#endif
}

/// Frees memory from allocateMemory().
/// @param memory null: nothing is done
inline void freeMemory(void* memory)
{
#if defined(_WIN32)
  _aligned_free(memory);
#else
  std::free(memory);
#endif
}

/// Asks the system for huge pages, where it has them.
/// @param memory from allocateMemory()
/// @param bytes  of it
void adviseHugePages(void* memory, std::size_t bytes);

/// Gives the memory past the first bytes back, if that can be done. Not on Windows: there the
/// alignment of the allocation would have to be known.
/// @param memory from allocateMemory()
/// @param bytes  to keep: 1 or more
/// @return where the memory is now, with any alignment; null where it stayed as it was
inline void* shrinkMemory([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#if defined(_WIN32)
  return nullptr;
#else
  return std::realloc(memory, bytes);
#endif
}

}

#endif
