// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Determinants in 256-bit integers, exactly: for what double-double leaves open.
///
/// What is left open mostly is zero, and mostly comes from points on some grid (decimals, scans,
/// models). Their differences are exact in double and multiples of one unit not much smaller than
/// they are: then integers of fixed size give the sign, many times faster than expansions.
#ifndef flipflop_FixedSigns_h
#define flipflop_FixedSigns_h

#include "Predicates/Expansion.h"
#include "Support/HostDevice.h"

#include <cmath>
#include <cstdint>

// Where the compiler has no integers of 128 bits, expansions decide the signs: the same, later. A
// build can request that (FLIPFLOP_NO_INT128).
#if defined(__SIZEOF_INT128__) && !defined(FLIPFLOP_NO_INT128)
#define FLIPFLOP_HAS_FIXED_SIGNS 1
#else
#define FLIPFLOP_HAS_FIXED_SIGNS 0
#endif

namespace flipflop
{

#if FLIPFLOP_HAS_FIXED_SIGNS

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// A sum of a few products of 128-bit integers below 2^126.
class FixedSum256
{
public:
  FF_HD void addProduct(Int128 a, Int128 b)
  {
    const bool negative = (a < 0) != (b < 0);
    const UInt128 x = a < 0 ? -static_cast<UInt128>(a) : static_cast<UInt128>(a);
    const UInt128 y = b < 0 ? -static_cast<UInt128>(b) : static_cast<UInt128>(b);
    const UInt128 low = part(x, 0) * part(y, 0);
    const UInt128 first = part(x, 0) * part(y, 1);
    const UInt128 second = part(x, 1) * part(y, 0);
    const UInt128 high = part(x, 1) * part(y, 1);
    const UInt128 middle = part(low, 1) + part(first, 0) + part(second, 0);
    const UInt128 upper = part(middle, 1) + part(first, 1) + part(second, 1) + part(high, 0);
    const std::uint64_t limb[4] = { static_cast<std::uint64_t>(low),
      static_cast<std::uint64_t>(middle), static_cast<std::uint64_t>(upper),
      static_cast<std::uint64_t>(part(upper, 1) + part(high, 1)) };
    UInt128 carry = negative ? 1 : 0;
    for (int i = 0; i < 4; ++i)
    {
      carry += static_cast<UInt128>(this->sum[i]) + (negative ? ~limb[i] : limb[i]);
      this->sum[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
  }

  FF_HD int sign() const
  {
    if (this->sum[3] >> 63)
    {
      return -1;
    }
    return (this->sum[0] | this->sum[1] | this->sum[2] | this->sum[3]) ? 1 : 0;
  }

private:
  FF_HD static UInt128 part(UInt128 x, int half) { return half ? x >> 64 : x & ~std::uint64_t(0); }

  std::uint64_t sum[4] = { 0, 0, 0, 0 }; ///< two's complement, lowest first
};

/// A unit, a power of two, in which a few doubles are integers below 2^61.
class FixedUnit
{
public:
  /// @param largest magnitude of the doubles
  FF_HD explicit FixedUnit(double largest)
  {
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    this->known = exponent > -400 && exponent < 400;
    this->perUnit = this->known ? std::ldexp(1.0, 60 - exponent) : 1.0;
  }

  /// @return false when it is no multiple of the unit
  FF_HD bool convert(double value, std::int64_t& result) const
  {
    const double scaled = this->known ? value * this->perUnit : 0.0;
    result = static_cast<std::int64_t>(scaled);
    return isWhole(scaled, static_cast<double>(result), value);
  }

  /// The same for values of at most the square of the largest, in squares of the unit.
  FF_HD bool convertSquare(double value, Int128& result) const
  {
    const double scaled = value * this->perUnit * this->perUnit;
    const bool fits = this->known && std::fabs(scaled) < 0x1p124;
    result = fits ? static_cast<Int128>(scaled) : 0;
    return fits && isWhole(scaled, static_cast<double>(result), value);
  }

private:
  /// What vanished in scaling is no multiple of the unit.
  FF_HD static bool isWhole(double scaled, double rounded, double value)
  {
    return rounded == scaled && (scaled != 0.0 || value == 0.0);
  }

  double perUnit;
  bool known; ///< in reach of the exponents
};

/// b - a, where that is exact.
FF_HD inline bool exactDifference(double b, double a, double& result)
{
  double low;
  twoSum(b, -a, result, low);
  return low == 0.0;
}

/// The determinant of three rows of which the last column may be products.
FF_HD inline int fixedDeterminant(
  const std::int64_t (&x)[3], const std::int64_t (&y)[3], const Int128 (&z)[3])
{
  FixedSum256 sum;
  for (int i = 0; i < 3; ++i)
  {
    const int j = i == 2 ? 0 : i + 1;
    const int k = i == 0 ? 2 : i - 1;
    sum.addProduct(static_cast<Int128>(x[j]) * y[k] - static_cast<Int128>(x[k]) * y[j], z[i]);
  }
  return sum.sign();
}

/// Sign of det[b - a; c - a; d - a], where it can be decided so.
FF_HD FF_OUTLINED inline bool fixedOrient3(
  const double* a, const double* b, const double* c, const double* d, int& sign)
{
  const double* const row[3] = { b, c, d };
  std::int64_t column[3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    double offset[3];
    double largest = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      if (!exactDifference(row[i][axis], a[axis], offset[i]))
      {
        return false;
      }
      largest = std::fmax(largest, std::fabs(offset[i]));
    }
    const FixedUnit unit(largest);
    for (int i = 0; i < 3; ++i)
    {
      if (!unit.convert(offset[i], column[axis][i]))
      {
        return false;
      }
    }
  }
  const Int128 z[3] = { column[2][0], column[2][1], column[2][2] };
  sign = fixedDeterminant(column[0], column[1], z);
  return true;
}

/// The plane of three points, for many queries.
class FixedPlane
{
public:
  FixedPlane() = default;

  FixedPlane(const double* a, const double* b, const double* c)
    : most(4 * largestMagnitude(a, b, c))
    , unit(2 * this->most)
  {
    std::int64_t u[3], v[3], w[3];
    this->known = this->convert(a, u) && this->convert(b, v) && this->convert(c, w);
    for (int i = 0; this->known && i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      this->origin[i] = u[i];
      const Int128 n = static_cast<Int128>(v[j] - u[j]) * (w[k] - u[k]) -
        static_cast<Int128>(v[k] - u[k]) * (w[j] - u[j]);
      this->low[i] = static_cast<std::uint64_t>(n);
      this->high[i] = static_cast<std::int64_t>(n >> 64);
    }
  }

  /// Is p on the plane? False also where that cannot be decided so.
  bool contains(const double* p) const
  {
    std::int64_t x[3];
    if (!this->known || !this->convert(p, x))
    {
      return false;
    }
    Int128 lowSum = 0, highSum = 0;
    for (int i = 0; i < 3; ++i)
    {
      const std::int64_t offset = x[i] - this->origin[i];
      lowSum += static_cast<Int128>(this->low[i]) * offset;
      highSum += static_cast<Int128>(this->high[i]) * offset;
    }
    return static_cast<std::uint64_t>(lowSum) == 0 && highSum + (lowSum >> 64) == 0;
  }

private:
  static double largestMagnitude(const double* a, const double* b, const double* c)
  {
    double largest = 0;
    for (int i = 0; i < 3; ++i)
    {
      largest =
        std::fmax(largest, std::fmax(std::fabs(a[i]), std::fmax(std::fabs(b[i]), std::fabs(c[i]))));
    }
    return largest;
  }

  /// Below 2^60: then offsets are below 2^61, the normal below 2^123, and each sum below 2^127.
  bool convert(const double* p, std::int64_t* result) const
  {
    for (int i = 0; i < 3; ++i)
    {
      if (!(std::fabs(p[i]) < this->most && this->unit.convert(p[i], result[i])))
      {
        return false;
      }
    }
    return true;
  }

  double most = 0; ///< other points are below
  FixedUnit unit{ 0 };
  std::int64_t origin[3];
  std::uint64_t low[3]; ///< of the normal
  std::int64_t high[3];
  bool known = false;
};

/// fixedOrient3() with heights w - x^2 - y^2 for the last column.
template <bool Weighted>
FF_HD FF_OUTLINED bool fixedLiftedOrient3(
  const double* a, const double* b, const double* c, const double* d, int& sign)
{
  const double* const row[3] = { b, c, d };
  double offset[3][2];
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      if (!exactDifference(row[i][axis], a[axis], offset[i][axis]))
      {
        return false;
      }
      largest = std::fmax(largest, std::fabs(offset[i][axis]));
    }
  }
  const FixedUnit unit(largest);
  std::int64_t x[3], y[3];
  Int128 height[3];
  for (int i = 0; i < 3; ++i)
  {
    if (!unit.convert(offset[i][0], x[i]) || !unit.convert(offset[i][1], y[i]))
    {
      return false;
    }
    height[i] = -(static_cast<Int128>(x[i]) * x[i] + static_cast<Int128>(y[i]) * y[i]);
    if (Weighted)
    {
      double weight;
      Int128 squares;
      if (!exactDifference(row[i][2], a[2], weight) || !unit.convertSquare(weight, squares))
      {
        return false;
      }
      height[i] += squares;
    }
  }
  sign = fixedDeterminant(x, y, height);
  return true;
}

#else

class FixedPlane
{
public:
  FixedPlane() = default;
  FixedPlane(const double*, const double*, const double*) {}
  bool contains(const double*) const { return false; }
};

FF_HD inline bool fixedOrient3(const double*, const double*, const double*, const double*, int&)
{
  return false;
}

template <bool Weighted>
FF_HD bool fixedLiftedOrient3(const double*, const double*, const double*, const double*, int&)
{
  return false;
}

#endif

}

#endif
