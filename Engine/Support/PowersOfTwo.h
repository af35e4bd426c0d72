// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Binary exponents from a double's bits. The mathematical library's functions do the same, but to
/// bind it and to page it in takes longer than the first triangulation of few points.
#ifndef flipflop_PowersOfTwo_h
#define flipflop_PowersOfTwo_h

#include <cmath>
#include <cstdint>
#include <cstring>

namespace flipflop
{

/// @{
/// Of numbers from 0 on, bits have the same order.
inline std::uint64_t bitsOf(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits;
}

inline double doubleOf(std::uint64_t bits)
{
  double x;
  std::memcpy(&x, &bits, sizeof(x));
  return x;
}
/// @}

/// std::ilogb of a finite number above zero.
inline int exponentOf(double x)
{
  const int biased = static_cast<int>(bitsOf(x) >> 52);
  return biased > 0 ? biased - 1023 : std::ilogb(x); // a subnormal's bits begin lower
}

/// A number as an integer below 2^53 times a power of two.
struct ScaledInteger
{
  std::int64_t integer;
  int exponent;
};

/// @param x finite
inline ScaledInteger scaledInteger(double x)
{
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return { static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53 };
}

/// 2^exponent, from -1022 to 1023.
inline double powerOfTwo(int exponent)
{
  return doubleOf(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}

#endif
