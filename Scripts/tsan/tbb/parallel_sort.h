// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tsan_parallel_sort_h
#define flipflop_tsan_parallel_sort_h

#include <algorithm>

namespace tbb
{

/// On one thread: how oneTBB sorts is not ours to check.
template <class Iterator, class Less>
void parallel_sort(Iterator first, Iterator last, const Less& less)
{
  std::sort(first, last, less);
}

}

#endif
