// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Threads.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace flipflop
{

namespace
{

/// The arenas that wait for a run, by their number of threads.
struct Arenas
{
  std::mutex mutex;
  std::map<int, std::vector<std::unique_ptr<tbb::task_arena>>> idle;
  std::size_t made = 0;

  /// Never destroyed: oneTBB may be gone before our statics are.
  static Arenas& all()
  {
    static Arenas* const arenas = new Arenas;
    return *arenas;
  }

  tbb::task_arena* take(int threads)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    std::vector<std::unique_ptr<tbb::task_arena>>& waiting = this->idle[threads];
    if (waiting.empty())
    {
      // Room for it, so that giving it back cannot fail.
      waiting.reserve(++this->made);
      return new tbb::task_arena(threads);
    }
    tbb::task_arena* const arena = waiting.back().release();
    waiting.pop_back();
    return arena;
  }

  void giveBack(int threads, tbb::task_arena* arena) noexcept
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->idle[threads].emplace_back(arena);
  }
};

}

int threadCount(int asked, std::int64_t points)
{
  const auto most = static_cast<std::int64_t>(
    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  const std::int64_t worth = points / pointsPerThread().load(std::memory_order_relaxed);
  const std::int64_t wanted = asked > 0 ? std::min<std::int64_t>(asked, most) : most;
  return static_cast<int>(std::max<std::int64_t>(1, std::min(wanted, worth)));
}

ArenaLoan::ArenaLoan(int count)
  : threads(count)
  , arena(Arenas::all().take(count))
{
}

ArenaLoan::~ArenaLoan()
{
  Arenas::all().giveBack(this->threads, this->arena);
}

std::size_t ArenaLoan::made()
{
  const std::lock_guard<std::mutex> lock(Arenas::all().mutex);
  return Arenas::all().made;
}

void runSideBySide(std::size_t count, int threads, const std::function<void(std::size_t)>& body)
{
  ArenaLoan arena(threads);
  arena.execute([&] { tbb::parallel_for(std::size_t(0), count, body, tbb::simple_partitioner()); });
}

}
