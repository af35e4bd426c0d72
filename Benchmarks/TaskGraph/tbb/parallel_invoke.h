// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tasks_parallel_invoke_h
#define flipflop_tasks_parallel_invoke_h

#include "../Recording.h"

#include <typeinfo>

namespace tbb
{

template <class First, class Second>
void parallel_invoke(const First& first, const Second& second, const char* file = __builtin_FILE(),
  int line = __builtin_LINE(), const char* function = __builtin_FUNCTION())
{
  const flipflop_tasks::Place place = { "invoke", file, line, function, typeid(First).name() };
  flipflop_tasks::fork(place, 2, 2, [&](std::size_t task) { task == 0 ? first() : second(); });
}

}

#endif
