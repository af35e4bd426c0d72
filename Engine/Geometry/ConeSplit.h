// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which of the three children of a split cone holds a point?
///
/// The cone of abc is split by v inside it into the children abv (0), bcv (1) and cav (2). The
/// planes of the kernel point, v and a corner part them.
#ifndef flipflop_ConeSplit_h
#define flipflop_ConeSplit_h

#include "Support/HostDevice.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

/// By the sides of the planes through a, b and c: is kernelBeneath(v, corner, p) positive?
FF_HD inline int childOf(bool a, bool b, bool c)
{
  const int first = static_cast<int>(a) & static_cast<int>(!b);
  const int second = static_cast<int>(b) & static_cast<int>(!c);
  return (1 - first) * (2 - second); // no branch: which child is anyone's guess
}

/// By rounded values of the same, each off by @p error at most; -1 when one is too close to decide.
inline int childOf(double a, double b, double c, double error)
{
  const double least = std::min({ std::fabs(a), std::fabs(b), std::fabs(c) });
  return least > error ? childOf(a > 0, b > 0, c > 0) : -1;
}

}

#endif
