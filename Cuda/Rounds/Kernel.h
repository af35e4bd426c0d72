// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a kernel is: a plain struct that is called once for each item of a list, in any order and
/// all at once, and means the same in each.
///
/// So a kernel writes only what no other item of the same launch reads or writes, but for the
/// atomic operations of Atomics.h. It uses neither shared memory nor barriers: hence an executor
/// may run it on a GPU or on host threads, forwards, backwards or shuffled (see HostExecutor and
/// CudaExecutor).
///
/// A kernel has
///   static constexpr const char* Name     for reports
///   static constexpr int Bytes            read and written an item, counted by hand, for reports
///   static constexpr bool Exact           exact arithmetic: much stack, few threads at a time
///   static constexpr unsigned LeastBlocks that a multiprocessor has space for at a time, which
///                                         bounds each thread's registers; 0: the compiler chooses
///   Local begin() const                   what one thread keeps while it takes items
///   void operator()(i, Local&) const      item i
///   void end(const Local&) const          add up what the thread has kept
///   void once() const                     called by one thread, at any time during the launch
/// of which the struct Kernel has those that do nothing.
#ifndef flipflop_Kernel_h
#define flipflop_Kernel_h

#include "Support/HostDevice.h"

#include <cstdint>

namespace flipflop
{

struct Kernel
{
  static constexpr bool Exact = false;
  static constexpr unsigned LeastBlocks = 0;

  struct Local
  {
  };
  FF_HD Local begin() const { return Local(); }
  FF_HD void end(const Local&) const {}
  FF_HD void once() const {}
};

/// One thread's share of a launch: items first, first + step, ... below count.
template <class K>
FF_HD void runItems(const K& kernel, std::uint32_t first, std::uint32_t step, std::uint32_t count)
{
  if (first == 0)
  {
    kernel.once();
  }
  if (first >= count)
  {
    return;
  }
  auto local = kernel.begin();
  for (std::uint64_t i = first; i < count; i += step)
  {
    kernel(static_cast<std::uint32_t>(i), local);
  }
  kernel.end(local);
}

}

#endif
