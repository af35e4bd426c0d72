// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Progress and abort of one run, counted by any thread, reported on the caller's.
#ifndef flipflop_Monitor_h
#define flipflop_Monitor_h

#include "Support/FloatingPointEnvironment.h"
#include <flipflop/Error.h>
#include <flipflop/Options.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>
#include <utility>

namespace flipflop
{

/// Work is counted in points; each stage owns a share of the whole.
class Monitor
{
public:
  /// @param interval the least time between two calls of the progress function in a stage
  explicit Monitor(const Options& options,
    std::chrono::steady_clock::duration interval = std::chrono::milliseconds(20))
    : function(options.progress)
    , step(options.step)
    , context(options.progressContext)
    , caller(std::this_thread::get_id())
    , between(interval)
  {
  }

  /// Begin a stage that takes the run from @p from to @p to while @p work units are done.
  /// @param name what the run does now, for users; null: what it did before
  /// @throw Error Aborted
  void stage(double from, double to, std::int64_t work, const char* name = nullptr)
  {
    if (name && this->step && std::this_thread::get_id() == this->caller)
    {
      const CallersFloatingPointEnvironment callers;
      this->step(name, this->context);
    }
    this->begin = from;
    this->end = to;
    this->total = work > 0 ? work : 1;
    this->done.store(0, std::memory_order_relaxed);
    this->report(true);
  }

  /// Count work done; call it some thousand points apart.
  /// @throw Error Aborted
  void advance(std::int64_t work)
  {
    this->done.fetch_add(work, std::memory_order_relaxed);
    this->report(false);
  }

  /// Look for an abort request only.
  /// @throw Error Aborted
  void poll() { this->report(false); }

private:
  void report(bool always)
  {
    if (this->stop.load(std::memory_order_relaxed))
    {
      throw Error(ErrorCode::Aborted);
    }
    if (std::this_thread::get_id() != this->caller || !this->function)
    {
      return;
    }
    const auto now = std::chrono::steady_clock::now();
    if (!always && now - this->last < this->between)
    {
      return;
    }
    this->last = now;
    const double share = static_cast<double>(this->done.load(std::memory_order_relaxed)) /
      static_cast<double>(this->total);
    const double fraction = this->begin + (this->end - this->begin) * (share < 1.0 ? share : 1.0);
    if (fraction >= this->reported)
    {
      this->reported = fraction;
    }
    if (!this->callFunction())
    {
      this->stop.store(true, std::memory_order_relaxed);
      throw Error(ErrorCode::Aborted);
    }
  }

  /// A function that throws is not called again, whatever tasks are left to the caller's thread.
  bool callFunction()
  {
    const CallersFloatingPointEnvironment callers;
    const ProgressFunction called = std::exchange(this->function, nullptr);
    const bool goesOn = called(this->reported, this->context);
    this->function = called;
    return goesOn;
  }

  ProgressFunction function; ///< for the caller's thread alone
  StepFunction step;
  void* context;
  std::thread::id caller;
  std::chrono::steady_clock::duration between;
  double begin = 0;
  double end = 0;
  double reported = 0;
  std::int64_t total = 1;
  std::chrono::steady_clock::time_point last;
  std::atomic<std::int64_t> done{ 0 };
  std::atomic<bool> stop{ false };
};

/// Polls in loops of many short steps.
class StepPoll
{
public:
  static constexpr std::uint32_t Every = 1 << 14; ///< steps

  explicit StepPoll(Monitor& toPoll)
    : monitor(toPoll)
  {
  }

  /// Call it once a step.
  /// @throw Error Aborted
  void step()
  {
    if (++this->steps % Every == 0)
    {
      this->monitor.poll();
    }
  }

private:
  Monitor& monitor;
  std::uint32_t steps = 0;
};

}

#endif
