// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The options of public calls that are parts of a whole: they let the caller stop, and report how
/// far the whole is.
#ifndef flipflop_ProgressOfParts_h
#define flipflop_ProgressOfParts_h

#include "Support/FloatingPointEnvironment.h"
#include <flipflop/Options.h>

#include <algorithm>

namespace flipflop
{

class ProgressOfParts
{
public:
  explicit ProgressOfParts(const Options& options)
    : caller(options)
  {
  }
  ProgressOfParts(const ProgressOfParts&) = delete;
  ProgressOfParts& operator=(const ProgressOfParts&) = delete;

  /// Of a call that takes the whole from what is done to @p next; its steps have no names. Besides
  /// the progress, only the threads are the caller's.
  Options options(double next) { return this->options(this->done, next); }

  /// The same, from @p from on if less is done.
  Options options(double from, double next)
  {
    Options result;
    result.threads = this->caller.threads;
    this->begin = std::max(this->done, from);
    this->end = std::max(this->begin, next);
    if (this->caller.progress)
    {
      result.progress = [](double fraction, void* self)
      { return static_cast<ProgressOfParts*>(self)->report(fraction); };
      result.progressContext = this;
    }
    return result;
  }

  /// For Monitor::stage: the name of what the whole does.
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

}

#endif
