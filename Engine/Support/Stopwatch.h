// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Wall time between two places.
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

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last = Clock::now();
};

}

#endif
