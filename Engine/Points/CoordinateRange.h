// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The range of the coordinates, and what follows from it for the arithmetic.
///
/// Products of differences must neither overflow nor lose bits to underflow where expansions
/// decide. Scaling by a power of two is exact and moves most inputs there. What still does not fit
/// (1e-300 next to 1e300) is decided in wide integers.
#ifndef flipflop_CoordinateRange_h
#define flipflop_CoordinateRange_h

#include <algorithm>
#include <cmath>

namespace flipflop
{

/// Over the finite points, by axis. The third axis is z, or the weight.
struct CoordinateRange
{
  double low[3];
  double high[3];
  double smallest[3]; ///< smallest non-zero magnitude, or infinity

  /// Of no point.
  static CoordinateRange empty()
  {
    return { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL },
      { HUGE_VAL, HUGE_VAL, HUGE_VAL } };
  }

  void add(const double* x)
  {
    for (int i = 0; i < 3; ++i)
    {
      const double magnitude = std::fabs(x[i]);
      this->low[i] = std::min(this->low[i], x[i]);
      this->high[i] = std::max(this->high[i], x[i]);
      this->smallest[i] =
        magnitude > 0 ? std::min(this->smallest[i], magnitude) : this->smallest[i];
    }
  }
  void add(const CoordinateRange& other)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->low[i] = std::min(this->low[i], other.low[i]);
      this->high[i] = std::max(this->high[i], other.high[i]);
      this->smallest[i] = std::min(this->smallest[i], other.smallest[i]);
    }
  }

  double largest(int axis) const
  {
    const double a = this->low[axis] < 0 ? -this->low[axis] : this->low[axis];
    const double b = this->high[axis] < 0 ? -this->high[axis] : this->high[axis];
    return a > b ? a : b;
  }
};

/// What coordinates on a lattice of few bits have in common: pixels, voxels, heights on a grid,
/// many models. There, determinants of differences are exact in double.
struct Lattice
{
  double unit = 0; ///< a power of two; all coordinates are multiples, weights of its square.
                   ///< 0: there is none, or it is too small to be of use
  bool everywhere = false; ///< no two points are too many units apart for that
};

struct Arithmetic
{
  int scaleExponent = 0; ///< coordinates are multiplied by 2^scaleExponent, weights by its square,
                         ///< without loss
  bool wide = false;     ///< expansions do not carry the range: decide in wide integers
};

/// The scaling for points in space.
Arithmetic chooseArithmetic(const CoordinateRange& range);

/// The scaling for weighted points in the plane.
Arithmetic chooseLiftedArithmetic(const CoordinateRange& range);

}

#endif
