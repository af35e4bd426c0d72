// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Fork and join on std::thread, within a number of threads.
#ifndef flipflop_tsan_ForkJoin_h
#define flipflop_tsan_ForkJoin_h

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace flipflop_tsan
{

/// How many more threads the current arena allows. Relaxed throughout: it must not order anything.
inline std::atomic<int>& allThreads()
{
  static std::atomic<int> spare(static_cast<int>(std::thread::hardware_concurrency()) - 1);
  return spare;
}

/// The arena that this thread works in.
inline std::atomic<int>*& spareThreads()
{
  thread_local std::atomic<int>* spare = &allThreads();
  return spare;
}

/// Take up to @p wanted threads from the arena.
inline int takeThreads(int wanted)
{
  std::atomic<int>& spare = *spareThreads();
  int available = spare.load(std::memory_order_relaxed);
  int taken = 0;
  do
  {
    taken = available < wanted ? available : wanted;
    taken = taken < 0 ? 0 : taken;
  } while (!spare.compare_exchange_weak(available, available - taken, std::memory_order_relaxed));
  return taken;
}

/// Run body(0), ..., body(parts - 1): body(0) here, each other one on a thread of its own. The
/// first exception, by part, is thrown again when all have ended.
inline void forkJoin(int parts, const std::function<void(int)>& body)
{
  std::vector<std::exception_ptr> errors(static_cast<std::size_t>(parts));
  const auto guarded = [&](int part)
  {
    try
    {
      body(part);
    }
    catch (...)
    {
      errors[static_cast<std::size_t>(part)] = std::current_exception();
    }
  };
  std::atomic<int>* const arena = spareThreads();
  std::vector<std::thread> threads;
  for (int part = 1; part < parts; ++part)
  {
    threads.emplace_back(
      [&, part]
      {
        spareThreads() = arena;
        guarded(part);
      });
  }
  guarded(0);
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  arena->fetch_add(parts - 1, std::memory_order_relaxed);
  for (const std::exception_ptr& error : errors)
  {
    if (error)
    {
      std::rethrow_exception(error);
    }
  }
}

}

#endif
