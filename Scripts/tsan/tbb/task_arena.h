// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tsan_task_arena_h
#define flipflop_tsan_task_arena_h

#include "../ForkJoin.h"

namespace tbb
{

/// A number of threads, the caller among them.
class task_arena
{
public:
  explicit task_arena(int threads)
    : spare(threads - 1)
  {
  }

  template <class Body>
  auto execute(Body&& body) -> decltype(body())
  {
    struct Restore
    {
      std::atomic<int>* before;
      ~Restore() { flipflop_tsan::spareThreads() = this->before; }
    };
    const Restore restore = { flipflop_tsan::spareThreads() };
    flipflop_tsan::spareThreads() = &this->spare;
    return body();
  }

private:
  std::atomic<int> spare;
};

}

#endif
