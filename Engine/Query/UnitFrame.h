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
    : place(std::size_t(3) * count)
  {
    double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    double high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
    for (std::uint32_t i = 0; i < count; ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        // Halves, against overflow. No corner is so small that they lose a bit that counts.
        const double x = 0.5 * corners[i].x[k];
        this->place[3 * std::size_t(i) + k] = x;
        low[k] = std::min(low[k], x);
        high[k] = std::max(high[k], x);
      }
    }
    double longest = 0;
    for (int k = 0; k < 3; ++k)
    {
      this->centre[k] = 0.5 * low[k] + 0.5 * high[k];
      longest = std::max(longest, high[k] - low[k]);
    }
    for (int k = 0; k < 3; ++k)
    {
      const double extent = eachAxis ? high[k] - low[k] : longest;
      this->exponent[k] = extent > 0 ? -std::ilogb(extent) : 0;
    }
    for (std::size_t i = 0; i < this->place.size(); ++i)
    {
      this->place[i] = std::ldexp(this->place[i] - this->centre[i % 3], this->exponent[i % 3]);
    }
  }

  /// Corner @p i in the frame.
  const double* at(std::uint32_t i) const { return this->place.data() + 3 * std::size_t(i); }

  /// What a length of one along an axis of the frame is to the corners, as a power of two.
  int lengthExponent(int axis) const { return 1 - this->exponent[axis]; }

  /// From the frame back to the corners' coordinates times 2^-exponent.
  double toCorners(double x, int axis, int cornersExponent) const
  {
    return std::ldexp(
      std::ldexp(x, -this->exponent[axis]) + this->centre[axis], 1 - cornersExponent);
  }

private:
  Buffer<double> place; ///< three coordinates a corner
  double centre[3];     ///< of the corners' halves
  int exponent[3];
};

}

#endif
