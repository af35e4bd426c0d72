// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Corners moved to about the origin and scaled, so that the longest side of their box is from 1 to
/// 2: there, squares and products of three neither overflow nor underflow. Each coordinate is off
/// by 2^-51 at most.
#ifndef flipflop_UnitFrame_h
#define flipflop_UnitFrame_h

#include "Points/Vertex.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

class UnitFrame
{
public:
  /// @param eachAxis scale each axis by itself: volumes keep their ratios, shapes do not
  UnitFrame(const Vertex* corners, std::uint32_t count, bool eachAxis = false)
    : coordinates(std::size_t(3) * count)
  {
    double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    double high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
    for (std::uint32_t i = 0; i < count; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        low[k] = std::min(low[k], corners[i].x[k]);
        high[k] = std::max(high[k], corners[i].x[k]);
      }
    }
    int longest = -Nothing;
    for (int k = 0; k < 3; ++k)
    {
      // Halves, against overflow, along the axis that requests them: elsewhere they could lose the
      // last bit of what is all there is.
      this->halvings[k] = high[k] - low[k] > 0x1p1000 ? 1 : 0;
      low[k] = std::ldexp(low[k], -this->halvings[k]);
      high[k] = std::ldexp(high[k], -this->halvings[k]);
      this->centre[k] = low[k] + 0.5 * (high[k] - low[k]);
      const double extent = high[k] - low[k];
      this->exponent[k] = extent > 0 ? std::ilogb(extent) + this->halvings[k] : -Nothing;
      longest = std::max(longest, this->exponent[k]);
    }
    for (int& e : this->exponent)
    {
      e = eachAxis ? e : longest;
      e = e == -Nothing ? 0 : e;
    }
    for (std::size_t i = 0; i < this->coordinates.size(); ++i)
    {
      const std::size_t k = i % 3;
      const double x = std::ldexp(corners[i / 3].x[k], -this->halvings[k]);
      this->coordinates[i] = std::ldexp(x - this->centre[k], this->halvings[k] - this->exponent[k]);
    }
  }

  /// Corner @p i in the frame.
  const double* at(std::uint32_t i) const { return this->coordinates.data() + 3 * std::size_t(i); }

  /// What a length of one along an axis of the frame is to the corners, as a power of two.
  int lengthExponent(int axis) const { return this->exponent[axis]; }

  /// From the frame back to the corners' coordinates times 2^-exponent.
  double toCorners(double x, int axis, int cornersExponent) const
  {
    const int halves = this->halvings[axis];
    return std::ldexp(
      std::ldexp(x, this->exponent[axis] - halves) + this->centre[axis], halves - cornersExponent);
  }

private:
  static constexpr int Nothing = 10000; ///< negated, the exponent of nothing

  Buffer<double> coordinates; ///< three coordinates a corner
  int halvings[3];            ///< 1: of corners along an axis, the halves are meant; else 0
  double centre[3];           ///< of the corners, or of their halves
  int exponent[3];            ///< of what a length of one is
};

}

#endif
