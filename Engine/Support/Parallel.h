// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops on the run's threads. All that knows a library of threads is here and in the headers that
/// this one chooses from.
///
/// A library is a header that offers in the namespace threads:
///
///   Arena(n).execute(body)     body(), and its loops on n threads: the caller and others
///   allowed()                  as many threads as a run may have
///   Allowance(n)               while it lives, that is n
///   each(count, body)          body(i) for each i below count, in no order, several a task
///   eachAlone(count, body)     the same, each a task
///   invoke(first, second)      both
///   isolated(body)             body(), which while it waits is given no task of others
///   sort(first, last, less)
///
/// Tasks run in the default floating-point environment, if the caller does.
/// Calls wait for their tasks; tasks may call in turn. What one of them throws comes out of the
/// call: one of it, where several throw. By then all tasks have ended, but not all have begun.
/// A call that returns has run all of its tasks, also within a call of which another task threw.
///
/// Most runs are small, and most of their loops are one task: the caller does it at once,
/// since handing a task to the threads' library costs more than a few points do.
#ifndef flipflop_Parallel_h
#define flipflop_Parallel_h

#include <flipflop/Error.h>

// The build chooses (CMake/FlipFlopThreads.cmake).
#ifndef FLIPFLOP_THREADS_HEADER
#define FLIPFLOP_THREADS_HEADER "Support/TbbThreads.h"
#endif
#include FLIPFLOP_THREADS_HEADER

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace flipflop
{

/// use(i) for each task from 0 up to @p count, in no order.
template <class Use>
void eachTask(std::size_t count, const Use& use)
{
  if (count == 1)
  {
    use(std::size_t(0));
    return;
  }
  threads::each(count, use);
}

/// How many chunks of @p size cover @p count items: the last may be shorter.
constexpr std::size_t chunkCount(std::size_t count, std::size_t size)
{
  return (count + size - 1) / size;
}

/// Where part @p i begins when @p count items are cut into @p parts that differ by one at most.
constexpr std::uint32_t partBegin(std::uint32_t count, std::size_t parts, std::size_t i)
{
  return static_cast<std::uint32_t>(std::uint64_t(count) * i / parts);
}

/// use(begin, end, number) for chunks of @p count items, a task each.
/// @param size of a chunk
template <class Use>
void eachChunk(std::size_t count, std::size_t size, const Use& use)
{
  eachTask(chunkCount(count, size),
    [&](std::size_t number) { use(number * size, std::min(count, (number + 1) * size), number); });
}

/// The same for chunks that may throw BadArgument. Where several do, the error of the
/// lowest-numbered chunk is thrown in the end, so it does not depend on the threads. Other errors
/// end the loop.
template <class Use>
void eachCheckedChunk(std::size_t count, std::size_t size, const Use& use)
{
  std::mutex mutex;
  std::atomic<std::size_t> first{ SIZE_MAX };
  std::optional<Error> found;
  eachChunk(count, size,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      if (number > first.load(std::memory_order_relaxed))
      {
        return;
      }
      try
      {
        use(begin, end, number);
      }
      catch (const Error& error)
      {
        if (error.code() != ErrorCode::BadArgument)
        {
          throw;
        }
        const std::lock_guard<std::mutex> lock(mutex);
        if (number < first.load(std::memory_order_relaxed))
        {
          first.store(number, std::memory_order_relaxed);
          found.emplace(error);
        }
      }
    });
  if (found)
  {
    throw Error(*found);
  }
}

/// Compact what is found among @p count items: number it in the items' order.
/// @param size     of a chunk
/// @param find     void (begin, end, emit): emit(x) for each that is found in a chunk; it is called
///                 twice
/// @param allocate void (std::size_t): how many are found
/// @param put      void (std::size_t number, x)
template <class Find, class Allocate, class Put>
void parallelCompact(
  std::size_t count, std::size_t size, const Find& find, const Allocate& allocate, const Put& put)
{
  std::vector<std::size_t> cursor(chunkCount(count, size));
  eachChunk(count, size,
    [&](std::size_t begin, std::size_t end, std::size_t chunk)
    {
      std::size_t found = 0;
      find(begin, end, [&](const auto&) { ++found; });
      cursor[chunk] = found;
    });
  std::size_t total = 0;
  for (std::size_t& at : cursor)
  {
    total += std::exchange(at, total);
  }
  allocate(total);
  eachChunk(count, size,
    [&](std::size_t begin, std::size_t end, std::size_t chunk)
    {
      std::size_t at = cursor[chunk];
      find(begin, end, [&](const auto& x) { put(at++, x); });
    });
}

}

#endif
