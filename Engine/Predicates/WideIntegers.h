// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Coordinates and heights as integers of any size: every finite double is a multiple of 2^-1074.
/// It takes Boost's headers along, so few files include it.
#ifndef flipflop_WideIntegers_h
#define flipflop_WideIntegers_h

#include "Support/PowersOfTwo.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace flipflop
{

using WideInteger = boost::multiprecision::cpp_int;

/// value * 2^1074.
inline WideInteger toInteger(double value)
{
  const ScaledInteger scaled = scaledInteger(value);
  WideInteger result = scaled.integer;
  const int shift = scaled.exponent + 1074;
  // Of a denormal's 53 bits those below 2^-1074 are zero.
  shift >= 0 ? result <<= shift : result >>= -shift;
  return result;
}

/// p - a in one coordinate, in units of 2^-1074.
inline WideInteger wideOffset(const double* point, const double* origin, int axis)
{
  return toInteger(point[axis]) - toInteger(origin[axis]);
}

/// The same, and heights of weighted points in units of the square of that.
inline WideInteger liftedOffset(const double* p, const double* a, int axis)
{
  if (axis < 2)
  {
    return wideOffset(p, a, axis);
  }
  WideInteger height = wideOffset(p, a, 2) << 1074;
  for (int i = 0; i < 2; ++i)
  {
    height -= wideOffset(p, a, i) * (toInteger(p[i]) + toInteger(a[i]));
  }
  return height;
}

}

#endif
