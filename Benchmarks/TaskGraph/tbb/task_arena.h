// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_tasks_task_arena_h
#define flipflop_tasks_task_arena_h

#include "../Recording.h"

#include <utility>

namespace tbb
{

/// A number of threads, as if. What runs where there is one alone forks nothing.
class task_arena
{
public:
  explicit task_arena(int threads)
    : threads(threads)
  {
  }

  template <class Body>
  auto execute(Body&& body) -> decltype(body())
  {
    struct Restore
    {
      int before;
      ~Restore() { flipflop_tasks::Recording::allowed() = this->before; }
    };
    const Restore restore = { std::exchange(flipflop_tasks::Recording::allowed(), this->threads) };
    return body();
  }

private:
  const int threads;
};

}

#endif
