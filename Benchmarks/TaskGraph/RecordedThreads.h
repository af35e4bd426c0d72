// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The threads that Parallel.h asks for, played by the one that asks: tasks run here and now, in
/// their order, and are told to the Recording under way.
#ifndef flipflop_tasks_RecordedThreads_h
#define flipflop_tasks_RecordedThreads_h

#include "Recording.h"

#include <algorithm>
#include <cstddef>
#include <typeinfo>
#include <utility>

namespace flipflop_tasks
{

/// A number of threads, as if. What runs where there is one alone forks nothing.
class Arena
{
public:
  explicit Arena(int threads)
    : threads(threads)
  {
  }

  template <class Body>
  void execute(Body&& body)
  {
    struct Restore
    {
      int before;
      ~Restore() { Recording::allowed() = this->before; }
    };
    const Restore restore = { std::exchange(Recording::allowed(), this->threads) };
    body();
  }

private:
  const int threads;
};

/// As many as the recording pretends to have.
inline int allowed()
{
  return Recording::allowed();
}

/// The recording alone says how many.
class Allowance
{
public:
  explicit Allowance(int) {}
};

/// A task is a run of calls.
template <class Body>
void each(std::size_t count, const Body& body, const char* file = __builtin_FILE(),
  int line = __builtin_LINE(), const char* function = __builtin_FUNCTION())
{
  if (count == 0)
  {
    return;
  }
  const std::size_t tasks = tasksOf(count);
  const Place place = { "for", file, line, function, typeid(Body).name() };
  fork(place, count, tasks,
    [&](std::size_t task)
    {
      const std::size_t end = count * (task + 1) / tasks;
      for (std::size_t i = count * task / tasks; i < end; ++i)
      {
        body(i);
      }
    });
}

template <class Body>
void eachAlone(std::size_t count, const Body& body, const char* file = __builtin_FILE(),
  int line = __builtin_LINE(), const char* function = __builtin_FUNCTION())
{
  each(count, body, file, line, function);
}

template <class First, class Second>
void invoke(const First& first, const Second& second, const char* file = __builtin_FILE(),
  int line = __builtin_LINE(), const char* function = __builtin_FUNCTION())
{
  const Place place = { "invoke", file, line, function, typeid(First).name() };
  fork(place, 2, 2, [&](std::size_t task) { task == 0 ? first() : second(); });
}

/// Recorded as one task: the player knows how oneTBB would share it.
template <class Iterator, class Less>
void sort(Iterator first, Iterator last, const Less& less, const char* file = __builtin_FILE(),
  int line = __builtin_LINE(), const char* function = __builtin_FUNCTION())
{
  const Place place = { "sort", file, line, function, typeid(Less).name() };
  fork(place, static_cast<std::size_t>(last - first), 1,
    [&](std::size_t) { std::sort(first, last, less); });
}

}

namespace flipflop
{

namespace threads = flipflop_tasks;

}

#endif
