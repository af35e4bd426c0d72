// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Offsets from a point, times a power of two that makes the longest about one. Differences come
/// first, so that a small hull far from the origin loses nothing; only where they overflow, or are
/// large, are the coordinates scaled before. What is lost then is too small to count against them.
#ifndef flipflop_OffsetFrame_h
#define flipflop_OffsetFrame_h

#include "Support/BoxTree.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

class OffsetFrame
{
public:
  /// The exponent that suits lengths up to @p reach, which may be infinite: more than a double has.
  static int exponentFor(double reach)
  {
    constexpr int Most = 1022; // 2^-Most is a normal number
    return !(reach > 0)      ? 0
      : std::isfinite(reach) ? std::clamp(std::ilogb(reach), -Most, Most)
                             : Most;
  }

  /// The farthest that a point of the box is away along an axis.
  static double reachOf(const double* x, const Box& box)
  {
    double reach = 0;
    for (int i = 0; i < 3; ++i)
    {
      reach = std::max({ reach, x[i] - box.low[i], box.high[i] - x[i] });
    }
    return reach;
  }

  /// @param x as it was given
  OffsetFrame(const double* x, int lengthExponent)
    : exponent(lengthExponent)
    , before(std::ldexp(1.0, -std::max(lengthExponent, 0)))
    , after(std::ldexp(1.0, -std::min(lengthExponent, 0)))
  {
    for (int i = 0; i < 3; ++i)
    {
      this->origin[i] = x[i] * this->before;
    }
  }

  /// Where a corner is, from the point.
  void offset(const double* corner, double* result) const
  {
    for (int i = 0; i < 3; ++i)
    {
      result[i] = (corner[i] * this->before - this->origin[i]) * this->after;
    }
  }

  /// From corner a to corner b. What is so short that its square could vanish is made longer: its
  /// direction counts.
  void edge(const double* a, const double* b, double* result) const
  {
    double longest = 0;
    for (int i = 0; i < 3; ++i)
    {
      result[i] = (b[i] * this->before - a[i] * this->before) * this->after;
      longest = std::max(longest, std::fabs(result[i]));
    }
    constexpr double Short = 0x1p-300;
    if (longest < Short && longest > 0)
    {
      const int by = std::min(-std::ilogb(longest), 1023);
      for (int i = 0; i < 3; ++i)
      {
        result[i] = std::ldexp(result[i], by);
      }
    }
  }

  /// The square of the distance from a box; rounded.
  double squareFrom(const Box& box) const
  {
    double low[3], high[3];
    this->offset(box.low, low);
    this->offset(box.high, high);
    double sum = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double gap = std::max(0.0, std::max(low[i], -high[i]));
      sum += gap * gap;
    }
    return sum;
  }

  /// From a length in the frame to one in the unit of the coordinates.
  double lengthOf(double x) const { return std::ldexp(x, this->exponent); }

private:
  int exponent;
  double before; ///< the coordinates are times this,
  double after;  ///< and offsets are times this; one of the two is 1
  double origin[3];
};

}

#endif
