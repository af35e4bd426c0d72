// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tsan_parallel_for_h
#define flipflop_tsan_parallel_for_h

#include "../ForkJoin.h"

namespace tbb
{

class simple_partitioner
{
};

/// body(i) for all i in [first, last), dealt out in turn.
template <class Index, class Body>
void parallel_for(
  Index first, Index last, const Body& body, const simple_partitioner& = simple_partitioner())
{
  if (!(first < last))
  {
    return;
  }
  const Index count = last - first;
  const int most = count < Index(64) ? static_cast<int>(count) : 64;
  const int parts = 1 + flipflop_tsan::takeThreads(most - 1);
  flipflop_tsan::forkJoin(parts,
    [&](int part)
    {
      for (Index i = static_cast<Index>(part); i < count; i += static_cast<Index>(parts))
      {
        body(static_cast<Index>(first + i));
      }
    });
}

}

#endif
