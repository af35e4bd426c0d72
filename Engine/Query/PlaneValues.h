// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Areas and heights above circles, not only their signs: to far more places than a double has.
///
/// They are taken in double-double, with a bound for the error. Where that does not tell enough
/// (flat triangles, extreme ranges), all of a computation is done again, from exact integers, in
/// floating-point numbers of 50 digits and any range. What is made of these values by products,
/// quotients and sums of one sign is then right to the last places of a double.
#ifndef flipflop_PlaneValues_h
#define flipflop_PlaneValues_h

#include "Points/Vertex.h"
#include "Predicates/DoubleDouble.h"
#include "Predicates/WideIntegers.h"
#include "Support/HostDevice.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>

namespace flipflop
{

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b)
{
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble{ first, 0.0 };
  DoubleDouble result;
  twoSum(first, (rest.high + rest.low) / b.high, result.high, result.low);
  return result;
}

inline double toDouble(const DoubleDouble& a)
{
  return a.high;
}

/// Values in double-double. A computation that finds isVague set is worth nothing.
class NearValues
{
public:
  using Number = DoubleDouble;

  bool isVague() const { return this->vague; }

  static Number number(double x) { return { x, 0.0 }; }
  static bool isZero(const Number& x) { return x.high == 0.0; }
  /// And in range.
  static bool isPositive(const Number& x) { return x.high > 0.0 && std::isfinite(x.high); }

  /// a - b.
  Number difference(double a, double b)
  {
    const Number result = doubleDifference(a, b);
    this->limit(std::fabs(result.high));
    return result;
  }

  /// Twice the area of abc, positive where it turns left; zero only where it is.
  FF_FLAT Number area(const double* a, const double* b, const double* c)
  {
    const Number ux = this->difference(b[0], a[0]), uy = this->difference(b[1], a[1]);
    const Number vx = this->difference(c[0], a[0]), vy = this->difference(c[1], a[1]);
    const Number left = ux * vy, right = uy * vx;
    return this->checked(left - right, std::fabs(left.high) + std::fabs(right.high));
  }

  /// How high p is above the plane of abc, which turns left, times twice the area; positive in the
  /// power circle; zero only where it is. Third coordinates are weights.
  FF_FLAT Number heightAbove(const double* a, const double* b, const double* c, const double* p)
  {
    const double* const row[3] = { b, c, p };
    Number u[3][3];
    double size[3];
    for (int i = 0; i < 3; ++i)
    {
      u[i][0] = this->difference(row[i][0], a[0]);
      u[i][1] = this->difference(row[i][1], a[1]);
      const Number square = u[i][0] * u[i][0] + u[i][1] * u[i][1];
      const Number weight = this->difference(row[i][2], a[2]);
      u[i][2] = weight - square;
      size[i] = square.high + std::fabs(weight.high);
    }
    Number det = { 0.0, 0.0 };
    double most = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const int j = i == 2 ? 0 : i + 1;
      const int k = i == 0 ? 2 : i - 1;
      const Number left = u[j][0] * u[k][1], right = u[j][1] * u[k][0];
      det = det + (left - right) * u[i][2];
      most += (std::fabs(left.high) + std::fabs(right.high)) * size[i];
    }
    return this->checked(det, most);
  }

private:
  /// It is off by less than 2^-94 of its terms.
  Number checked(const Number& value, double most)
  {
    const double size = std::fabs(value.high);
    this->vague = this->vague || size < 0x1p-34 * most;
    return value;
  }

  /// Products of four neither overflow nor lose their low parts.
  void limit(double size)
  {
    this->vague = this->vague || !(size == 0.0 || (size >= 0x1p-120 && size <= 0x1p240));
  }

  bool vague = false;
};

/// The same in numbers of any range, from exact integers.
class FarValues
{
public:
  using Number = boost::multiprecision::cpp_bin_float_50;

  static constexpr bool isVague() { return false; }

  static Number number(double x) { return Number(x); }
  static bool isZero(const Number& x) { return x.is_zero(); }
  static bool isPositive(const Number& x) { return x > 0; }

  Number difference(double a, double b) const
  {
    return ldexp(Number(toInteger(a) - toInteger(b)), -1074);
  }

  Number area(const double* a, const double* b, const double* c) const
  {
    const WideInteger det =
      wideOffset(b, a, 0) * wideOffset(c, a, 1) - wideOffset(b, a, 1) * wideOffset(c, a, 0);
    return ldexp(Number(det), -2 * 1074);
  }

  Number heightAbove(const double* a, const double* b, const double* c, const double* p) const
  {
    const double* const row[3] = { b, c, p };
    WideInteger u[3][3];
    for (int i = 0; i < 3; ++i)
    {
      u[i][0] = wideOffset(row[i], a, 0);
      u[i][1] = wideOffset(row[i], a, 1);
      u[i][2] = (wideOffset(row[i], a, 2) << 1074) - u[i][0] * u[i][0] - u[i][1] * u[i][1];
    }
    const WideInteger det = (u[0][0] * u[1][1] - u[0][1] * u[1][0]) * u[2][2] +
      (u[1][0] * u[2][1] - u[1][1] * u[2][0]) * u[0][2] +
      (u[2][0] * u[0][1] - u[2][1] * u[0][0]) * u[1][2];
    return ldexp(Number(det), -4 * 1074);
  }
};

inline double toDouble(const FarValues::Number& a)
{
  return a.convert_to<double>();
}

/// In double-double; again in numbers of any range where that is too vague.
/// @param compute bool (values): false if what is made of the values is no result
template <class Compute>
void withValues(const Compute& compute)
{
  NearValues nearby;
  if (!compute(nearby) || nearby.isVague())
  {
    FarValues far;
    compute(far);
  }
}

}

#endif
