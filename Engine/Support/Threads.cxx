// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Threads.h"

#include "Support/StrictArithmetic.h"

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
  std::map<int, std::vector<std::unique_ptr<threads::Arena>>> idle;
  std::size_t made = 0;

  /// Never destroyed: oneTBB may be gone before our statics are.
  static Arenas& all()
  {
    static Arenas* const arenas = new Arenas;
    return *arenas;
  }

  threads::Arena* acquire(int threads)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    std::vector<std::unique_ptr<threads::Arena>>& waiting = this->idle[threads];
    if (waiting.empty())
    {
      // Space for it, so that giving it back cannot fail.
      waiting.reserve(++this->made);
      return new threads::Arena(threads);
    }
    threads::Arena* const arena = waiting.back().release();
    waiting.pop_back();
    return arena;
  }

  void release(int threads, threads::Arena* arena) noexcept
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->idle[threads].emplace_back(arena);
  }
};

}

int threadCount(int requested, std::int64_t points)
{
  const std::int64_t worth = points / pointsPerThread().load(std::memory_order_relaxed);
  const std::int64_t wanted = requested > 0 ? std::min<std::int64_t>(requested, worth) : worth;
  // The limit is read only where it matters: that starts the threads' library.
  return wanted <= 1 ? 1 : static_cast<int>(std::min<std::int64_t>(wanted, threads::allowed()));
}

ArenaLoan::ArenaLoan(int count)
  : threads(count)
  , arena(count > 1 ? Arenas::all().acquire(count) : nullptr)
{
}

ArenaLoan::~ArenaLoan()
{
  if (this->arena)
  {
    Arenas::all().release(this->threads, this->arena);
  }
}

std::size_t ArenaLoan::made()
{
  const std::lock_guard<std::mutex> lock(Arenas::all().mutex);
  return Arenas::all().made;
}

void runSideBySide(std::size_t count, int threads, const std::function<void(std::size_t)>& body)
{
  ArenaLoan arena(threads);
  arena.execute([&] { threads::eachAlone(count, body); });
}

}
