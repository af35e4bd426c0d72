// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tsan_parallel_invoke_h
#define flipflop_tsan_parallel_invoke_h

#include "../ForkJoin.h"

namespace tbb
{

template <class First, class Second>
void parallel_invoke(const First& first, const Second& second)
{
  if (flipflop_tsan::takeThreads(1) == 0)
  {
    first();
    second();
    return;
  }
  flipflop_tsan::forkJoin(2, [&](int part) { part == 0 ? first() : second(); });
}

}

#endif
