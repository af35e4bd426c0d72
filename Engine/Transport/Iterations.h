// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What runs that iterate have in common.
#ifndef flipflop_Iterations_h
#define flipflop_Iterations_h

#include "Support/Stopwatch.h"
#include <flipflop/Error.h>

#include <cstdint>

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
