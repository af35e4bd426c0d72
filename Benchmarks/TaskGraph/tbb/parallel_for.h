// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tasks_parallel_for_h
#define flipflop_tasks_parallel_for_h

#include "../Recording.h"

#include <typeinfo>

namespace tbb
{

class simple_partitioner
{
};

/// body(i) for all i in [first, last), in their order; a task is a run of them.
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body,
  const simple_partitioner& = simple_partitioner(), const char* file = __builtin_FILE(),
  int line = __builtin_LINE(), const char* function = __builtin_FUNCTION())
{
  if (!(first < last))
  {
    return;
  }
  const auto calls = static_cast<std::size_t>(last - first);
  const std::size_t tasks = flipflop_tasks::tasksOf(calls);
  const flipflop_tasks::Place place = { "for", file, line, function, typeid(Body).name() };
  flipflop_tasks::fork(place, calls, tasks,
    [&](std::size_t task)
    {
      const auto end = static_cast<Index>(first + static_cast<Index>(calls * (task + 1) / tasks));
      for (auto i = static_cast<Index>(first + static_cast<Index>(calls * task / tasks)); i < end;
           ++i)
      {
        body(i);
      }
    });
}

}

#endif
