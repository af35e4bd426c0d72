// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tasks_parallel_sort_h
#define flipflop_tasks_parallel_sort_h

#include "../Recording.h"

#include <algorithm>
#include <typeinfo>

namespace tbb
{

/// Recorded as one task: the player knows how oneTBB would share it.
template <class Iterator, class Less>
void parallel_sort(Iterator first, Iterator last, const Less& less,
  const char* file = __builtin_FILE(), int line = __builtin_LINE(),
  const char* function = __builtin_FUNCTION())
{
  const flipflop_tasks::Place place = { "sort", file, line, function, typeid(Less).name() };
  flipflop_tasks::fork(place, static_cast<std::size_t>(last - first), 1,
    [&](std::size_t) { std::sort(first, last, less); });
}

}

#endif
