// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops on the run's threads.
///
/// Most runs are small, and most of their loops are one task: the caller does it at once, for to
/// hand a task to the threads' library costs more than a few points do.
#ifndef flipflop_Parallel_h
#define flipflop_Parallel_h

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace flipflop
{

/// use(i) for each task from 0 up to @p count, in no order.
template <class Use>
void eachTask(std::size_t count, const Use& use)
{
  if (count == 1)
  {
    use(std::size_t(0));
    return;
  }
  tbb::parallel_for(std::size_t(0), count, use);
}

/// use(begin, end, number) for runs of @p count things, a task each.
/// @param size of a run
template <class Use>
void eachRun(std::size_t count, std::size_t size, const Use& use)
{
  eachTask((count + size - 1) / size,
    [&](std::size_t number) { use(number * size, std::min(count, (number + 1) * size), number); });
}

}

#endif
