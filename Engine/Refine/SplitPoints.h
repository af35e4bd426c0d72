// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where new points are, and how they are rounded: to multiples of one unit, the spacing of doubles
/// at the greatest coordinate. So a point that divides a segment is off it by half a unit at most
/// along each axis; in narrow places, by one and a half.
#ifndef flipflop_SplitPoints_h
#define flipflop_SplitPoints_h

#include "Points/CoordinateRange.h"
#include "Predicates/DoubleDouble.h"
#include "Support/PowersOfTwo.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

class RoundedPositions
{
public:
  /// @param range     of all points
  /// @param leastUnit no unit is smaller
  RoundedPositions(const CoordinateRange& range, double leastUnit)
  {
    const double most = std::max(range.largest(0), range.largest(1));
    std::copy_n(range.low, 2, this->low);
    std::copy_n(range.high, 2, this->high);
    this->unit = most > 0 ? std::max(std::ldexp(1.0, std::ilogb(most) - 52), leastUnit) : leastUnit;
  }

  double step() const { return this->unit; }

  /// Within the range of all points, also of what is no number.
  double within(double x, int axis) const
  {
    return !(x > this->low[axis]) ? this->low[axis] : std::min(x, this->high[axis]);
  }

  /// Of a point anywhere.
  double rounded(double x, int axis) const
  {
    return this->within(std::nearbyint(x / this->unit) * this->unit, axis);
  }

  /// from + share (to - from), rounded once.
  double between(double from, double to, double share) const
  {
    const DoubleDouble sum =
      DoubleDouble{ from, 0.0 } + doubleDifference(to, from) * DoubleDouble{ share, 0.0 };
    const double high = std::nearbyint(sum.high / this->unit);
    const double rest = (sum.high / this->unit - high) + sum.low / this->unit;
    return (high + std::nearbyint(rest)) * this->unit;
  }

private:
  double unit;
  double low[2], high[2];
};

/// Where a part of a segment is divided that begins where others leave at a small angle: at the
/// roundest distance from there that is in its middle third. So those, too, are divided on this
/// circle; the first time at a power of two (J. Ruppert, "A Delaunay refinement algorithm for
/// quality 2-dimensional mesh generation", 1995, section 5).
/// @param near,far of its ends, from the small angle
inline double roundestBetween(double near, double far)
{
  const double low = near + (far - near) / 3;
  const double high = far - (far - near) / 3;
  for (double step = powerOfTwo(exponentOf(high));; step /= 2)
  {
    const double result = std::ceil(low / step) * step;
    if (result <= high || step < low * std::numeric_limits<double>::epsilon())
    {
      return std::min(result, high);
    }
  }
}

}

#endif
