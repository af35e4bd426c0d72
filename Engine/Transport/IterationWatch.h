// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The options of the calls within an iteration: they let the caller stop, and report how
/// far all iterations are.
#ifndef flipflop_IterationWatch_h
#define flipflop_IterationWatch_h

#include "Support/FloatingPointEnvironment.h"
#include "Support/Stopwatch.h"
#include <flipflop/Options.h>

#include <algorithm>

namespace flipflop
{

/// @throw Error BadArgument
inline void requireLimits(std::int64_t iterations, double tolerance)
{
  if (iterations < 0)
  {
    throw badArgument("the most iterations must be 0 or more");
  }
  if (!(tolerance >= 0)) // or NaN
  {
    throw badArgument("the tolerance must be 0 or more");
  }
}

class IterationWatch
{
public:
  explicit IterationWatch(const Options& options)
    : caller(options)
  {
  }
  IterationWatch(const IterationWatch&) = delete;
  IterationWatch& operator=(const IterationWatch&) = delete;

  /// Of a call that takes the whole from what is done to @p next; its steps have no names.
  Options options(double next)
  {
    Options result;
    result.threads = this->caller.threads;
    this->begin = this->done;
    this->end = std::max(this->begin, next);
    if (this->caller.progress)
    {
      result.progress = [](double fraction, void* self)
      { return static_cast<IterationWatch*>(self)->report(fraction); };
      result.progressContext = this;
    }
    return result;
  }

  /// For Monitor::stage: the name of what all iterations do.
  void name(const char* step) const
  {
    if (this->caller.step)
    {
      const CallersFloatingPointEnvironment callers;
      this->caller.step(step, this->caller.progressContext);
    }
  }

private:
  /// Called in the caller's environment, by a run's Monitor.
  bool report(double fraction)
  {
    const DefaultFloatingPointEnvironment environment;
    this->done = std::max(this->done, this->begin + fraction * (this->end - this->begin));
    const CallersFloatingPointEnvironment callers;
    return this->caller.progress(this->done, this->caller.progressContext);
  }

  const Options& caller;
  double done = 0;
  double begin = 0;
  double end = 0;
};

/// The result of work(), with the seconds of the whole.
template <class Work>
auto withSeconds(const Work& work)
{
  Stopwatch watch;
  auto result = work();
  result.statistics.secondsTotal = watch.lap();
  return result;
}

}

#endif
