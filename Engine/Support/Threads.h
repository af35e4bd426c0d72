// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How many threads a run gets, and where they work.
///
/// oneTBB up to 2021.8 keeps some kilobytes of every task_arena for ever, and looks all of them
/// over in each later run. So arenas are lent, given back, and lent again: there are as many as
/// runs were ever under way at once.
#ifndef flipflop_Threads_h
#define flipflop_Threads_h

#include "Support/Parallel.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace flipflop
{

constexpr std::int64_t UsualPointsPerThread = 4096;

/// A thread more is worth waking for this many points. Tests set it to 1.
inline std::atomic<std::int64_t>& pointsPerThread()
{
  static std::atomic<std::int64_t> points{ UsualPointsPerThread };
  return points;
}

/// @param requested threads; 0 or less: as many as there are
/// @param points    how many the threads are to share
/// @return 1 or more: no more than requested, than are allowed (oneTBB's global_control limits
///         that), and than @p points are worth
int threadCount(int requested, std::int64_t points);

/// An arena of so many threads, the caller's among them, for one run at a time.
class ArenaLoan
{
public:
  explicit ArenaLoan(int threads);
  ArenaLoan(const ArenaLoan&) = delete;
  ArenaLoan& operator=(const ArenaLoan&) = delete;
  ~ArenaLoan();

  template <class Body>
  void execute(Body&& body)
  {
    if (this->arena)
    {
      this->arena->execute(std::forward<Body>(body));
      return;
    }
    threads::Arena(1).execute(std::forward<Body>(body));
  }

  /// Arenas that were ever made in this process.
  static std::size_t made();

private:
  const int threads;
  threads::Arena* const arena; ///< null: for one thread, which takes no time to make
};

/// Calls @p body (i) for each i from 0 up to @p count, in no order, by so many threads: the caller
/// and others. It is for runs too small to have several threads each.
/// @param body throws nothing
void runSideBySide(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}

#endif
