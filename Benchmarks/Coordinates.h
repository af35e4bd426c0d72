// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Input points, kept off the heap: measured processes inherit the heap of the process that made
/// the input, and large blocks that came and went there would change a run's peak of memory.
#ifndef flipflop_Coordinates_h
#define flipflop_Coordinates_h

#include <cstddef>
#include <new>
#include <vector>

#include <sys/mman.h>

namespace flipflop
{

/// Takes pages from the system and gives them back.
template <class T>
struct PageAllocator
{
  using value_type = T;

  T* allocate(std::size_t count)
  {
    void* pages =
      mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED)
    {
      throw std::bad_alloc();
    }
    return static_cast<T*>(pages);
  }
  void deallocate(T* pages, std::size_t count) { munmap(pages, count * sizeof(T)); }

  bool operator==(const PageAllocator&) const { return true; }
  bool operator!=(const PageAllocator&) const { return false; }
};

/// x y z of each point, one after another.
using Coordinates = std::vector<double, PageAllocator<double>>;

}

#endif
