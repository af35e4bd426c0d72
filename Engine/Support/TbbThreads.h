// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The threads that Parallel.h asks for, by oneTBB.
#ifndef flipflop_TbbThreads_h
#define flipflop_TbbThreads_h

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace flipflop
{

namespace tbbThreads
{

using Arena = tbb::task_arena;

inline int allowed()
{
  return static_cast<int>(
    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

class Allowance
{
public:
  explicit Allowance(int threads)
    : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads))
  {
  }

private:
  tbb::global_control control;
};

template <class Body>
void each(std::size_t count, const Body& body)
{
  tbb::parallel_for(std::size_t(0), count, body);
}

template <class Body>
void eachAlone(std::size_t count, const Body& body)
{
  tbb::parallel_for(std::size_t(0), count, body, tbb::simple_partitioner());
}

template <class First, class Second>
void invoke(const First& first, const Second& second)
{
  tbb::parallel_invoke(first, second);
}

template <class Iterator, class Less>
void sort(Iterator first, Iterator last, const Less& less)
{
  tbb::parallel_sort(first, last, less);
}

}

namespace threads = tbbThreads;

}

#endif
