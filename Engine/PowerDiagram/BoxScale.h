// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Areas and turns of corners in a box, rounded, at any scale of the box.
#ifndef flipflop_BoxScale_h
#define flipflop_BoxScale_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

/// Brings the box to about 1, so that areas neither overflow nor vanish.
class BoxScale
{
public:
  explicit BoxScale(const double* box)
  {
    for (int k = 0; k < 2; ++k)
    {
      int exponent = 0;
      std::frexp(
        std::min(box[2 * k + 1] - box[2 * k], std::numeric_limits<double>::max()), &exponent);
      this->factor[k] = std::ldexp(0.5, std::min(-exponent, 1023));
    }
  }

  double offset(const double* from, const double* to, int k) const
  {
    return to[k] * this->factor[k] - from[k] * this->factor[k];
  }

  /// Twice a triangle's, rounded; positive when it turns left.
  double area(const double* a, const double* b, const double* c) const
  {
    return this->offset(a, b, 0) * this->offset(a, c, 1) -
      this->offset(a, b, 1) * this->offset(a, c, 0);
  }

  /// Can no rounding of corners explain that the way turns right? The true ones turn left, and each
  /// coordinate is off by half a unit in its last place. (A bound of 1 would do for that; the rest
  /// is for the rounding in here.)
  bool turnsTooFar(const double* a, const double* b, const double* c) const
  {
    double unit[2];
    double size[2];
    for (int k = 0; k < 2; ++k)
    {
      const double most = std::max({ std::fabs(a[k]), std::fabs(b[k]), std::fabs(c[k]) });
      unit[k] = std::max(0x1p-52 * most, 0x1p-1074) * this->factor[k];
      size[k] = std::fabs(this->offset(a, b, k)) + std::fabs(this->offset(a, c, k)) + unit[k];
    }
    return this->area(a, b, c) < -8 * (unit[0] * size[1] + unit[1] * size[0]);
  }

private:
  double factor[2];
};

}

#endif
