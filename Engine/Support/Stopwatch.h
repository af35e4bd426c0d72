// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Wall time between two calls.
#ifndef flipflop_Stopwatch_h
#define flipflop_Stopwatch_h

#include <chrono>

namespace flipflop
{

class Stopwatch
{
public:
  /// Seconds since construction or the last lap.
  double lap()
  {
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - this->last).count();
    this->last = now;
    return seconds;
  }

  /// Seconds since construction.
  double total()
  {
    this->lap();
    return std::chrono::duration<double>(this->last - this->first).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  const Clock::time_point first = Clock::now();
  Clock::time_point last = this->first;
};

}

#endif
