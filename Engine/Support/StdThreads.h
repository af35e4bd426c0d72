// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The threads that Parallel.h requests, by std::thread alone.
///
/// An arena's threads are started when its first loops want them, wait between loops, and end with
/// its execute(). So no thread outlives a run: nothing is left for the end of the process, for a
/// library that is unloaded, or for a fork.
///
/// A loop takes the arena's threads that have nothing to do, and never waits for one to come free;
/// its caller takes part. Whoever waits, waits for the tasks of its own loop, and these for the
/// loops inside them: there is no circle, so loops in loops and trees of invoke() end.
#ifndef flipflop_StdThreads_h
#define flipflop_StdThreads_h

#include "Support/SortByHalves.h"

#include <cstddef>
#include <functional>

namespace flipflop
{

namespace stdThreads
{

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
    this->run(std::ref(body));
  }

private:
  void run(const std::function<void()>& body) const;

  const int threads;
};

int allowed();

/// Not by several threads at once.
class Allowance
{
public:
  explicit Allowance(int threads);
  Allowance(const Allowance&) = delete;
  Allowance& operator=(const Allowance&) = delete;
  ~Allowance();

private:
  const int before;
};

/// Out of an arena, a loop makes one of its own.
void fork(std::size_t count, const std::function<void(std::size_t)>& body);

template <class Body>
void each(std::size_t count, const Body& body)
{
  fork(count, std::cref(body));
}

template <class Body>
void eachAlone(std::size_t count, const Body& body)
{
  fork(count, std::cref(body));
}

template <class First, class Second>
void invoke(const First& first, const Second& second)
{
  fork(2, [&](std::size_t task) { task == 0 ? first() : second(); });
}

template <class Body>
void isolated(const Body& body)
{
  body();
}

template <class Iterator, class Less>
void sort(Iterator first, Iterator last, const Less& less)
{
  sortByHalves(
    first, last, less, [](const auto& low, const auto& high) { stdThreads::invoke(low, high); });
}

}

namespace threads = stdThreads;

}

#endif
