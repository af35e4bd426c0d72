// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PowerDiagram/PowerCorners.h"

#include "Predicates/DoubleDouble.h"
#include <flipflop/Error.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>

namespace flipflop
{
namespace
{

/// A double-double and a bound on how far it is off (but for a factor of 1 + 2^-10, which covers
/// the rounding of the bounds themselves). Infinite or NaN: nothing is known.
struct Bounded
{
  DoubleDouble value;
  double error;
};

constexpr double unit = 0x1p-100; // more than an operation's relative error

Bounded operator+(const Bounded& a, const Bounded& b)
{
  return { a.value + b.value,
    a.error + b.error + unit * (std::fabs(a.value.high) + std::fabs(b.value.high)) };
}

Bounded operator-(const Bounded& a, const Bounded& b)
{
  return a + Bounded{ { -b.value.high, -b.value.low }, b.error };
}

Bounded operator*(const Bounded& a, const Bounded& b)
{
  const double sizeA = std::fabs(a.value.high);
  const double sizeB = std::fabs(b.value.high);
  return { a.value * b.value,
    sizeA * b.error + sizeB * a.error + a.error * b.error + unit * sizeA * sizeB };
}

/// The quick arithmetic: says when it cannot tell.
class BoundedArithmetic
{
public:
  using Number = Bounded;

  /// a - b; @p degree 1 for lengths, 2 for weights.
  static Bounded difference(double a, double b, int degree = 1)
  {
    Bounded result = { doubleDifference(a, b), 0.0 };
    // Within this range products of three lengths stay clear of overflow and underflow.
    const double size = std::fabs(result.value.high);
    const bool inRange =
      degree == 1 ? size >= 0x1p-150 && size <= 0x1p150 : size >= 0x1p-300 && size <= 0x1p300;
    if (!inRange && size != 0.0)
    {
      result.error = HUGE_VAL;
    }
    return result;
  }

  /// base + numerator / denominator, rounded to nearest; false when it cannot tell which is.
  static bool round(
    double base, const Bounded& numerator, const Bounded& denominator, double& result)
  {
    const double size = std::fabs(denominator.value.high);
    if (!(denominator.error < 0x1p-20 * size && std::fabs(base) <= 0x1p150))
    {
      return false;
    }
    const double first = numerator.value.high / denominator.value.high;
    const DoubleDouble rest = numerator.value - denominator.value * DoubleDouble{ first, 0.0 };
    DoubleDouble quotient;
    twoSum(first, rest.high / denominator.value.high, quotient.high, quotient.low);
    const DoubleDouble sum = DoubleDouble{ base, 0.0 } + quotient;
    double error = (numerator.error + std::fabs(first) * denominator.error) / size +
      4 * unit * (std::fabs(base) + std::fabs(first));
    error = 1.001 * error + 0x1p-50 * std::fabs(sum.low);
    result = sum.high;
    // Both ends of the interval round to the same.
    return sum.high + (sum.low + error) == sum.high && sum.high + (sum.low - error) == sum.high;
  }

  static bool positive(const Bounded& a) { return a.value.high > 1.001 * a.error; }
};

/// The exact arithmetic: lengths are integers times 2^exponent, weights times its square.
template <class Integer>
class IntegerArithmetic
{
public:
  using Number = Integer;

  explicit IntegerArithmetic(int exponent)
    : exponent(exponent)
  {
  }

  Integer difference(double a, double b, int degree = 1) const
  {
    return this->integer(a, degree) - this->integer(b, degree);
  }

  bool round(
    double base, const Integer& numerator, const Integer& denominator, double& result) const
  {
    if (denominator == 0)
    {
      return false;
    }
    Integer n = this->integer(base, 1) * denominator + numerator;
    Integer d = denominator;
    const bool negative = (n < 0) != (d < 0);
    n = abs(n);
    d = abs(d);
    result = 0.0;
    if (n != 0)
    {
      // A quotient of 63 or 64 bits; a remainder shows in the last, far below what is kept.
      const int shift = 63 - static_cast<int>(msb(n)) + static_cast<int>(msb(d));
      shift >= 0 ? n <<= shift : d <<= -shift;
      Integer quotient, remainder;
      divide_qr(n, d, quotient, remainder);
      std::uint64_t bits = static_cast<std::uint64_t>(quotient);
      bool rest = remainder != 0;
      int binary = this->exponent - shift;
      // Of a subnormal number fewer bits are kept: the others must not be rounded before.
      const int drop = std::min(-1074 - 2 - binary, 63);
      if (drop > 0)
      {
        rest = rest || (bits & ((std::uint64_t(1) << drop) - 1)) != 0;
        bits >>= drop;
        binary += drop;
      }
      const double size = std::ldexp(static_cast<double>(bits | (rest ? 1u : 0u)), binary);
      result = negative ? -size : size;
    }
    return true;
  }

  static bool positive(const Integer& a) { return a > 0; }

private:
  Integer integer(double value, int degree) const
  {
    int binary = 0;
    const double fraction = std::frexp(value, &binary);
    Integer result = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    if (result != 0)
    {
      result <<= binary - 53 - degree * this->exponent;
    }
    return result;
  }

  int exponent;
};

/// The exponents of some numbers.
class ExponentRange
{
public:
  void add(const PowerSite& site)
  {
    this->add(site.x[0]);
    this->add(site.x[1]);
    if (site.weight != 0.0)
    {
      int binary = 0;
      std::frexp(site.weight, &binary);
      // Halves, rounded outwards.
      this->low = std::min(this->low, (binary - 53 - 1) / 2 - 1);
      this->high = std::max(this->high, (binary + 1) / 2 + 1);
    }
  }
  void add(double length)
  {
    if (length != 0.0)
    {
      int binary = 0;
      std::frexp(length, &binary);
      this->low = std::min(this->low, binary - 53);
      this->high = std::max(this->high, binary);
    }
  }

  /// All lengths are multiples of 2 to this.
  int exponent() const { return this->low == INT_MAX ? 0 : this->low; }

  int bits() const { return this->low == INT_MAX ? 0 : this->high - this->low; }

private:
  int low = INT_MAX;
  int high = INT_MIN;
};

/// Integers on the stack, for sites of up to MostBits bits: numerators are of degree three, and are
/// shifted by up to 64 bits more than a denominator has.
constexpr unsigned StackBits = 1024;
constexpr int MostBits = 300;
using StackInteger = boost::multiprecision::number<
  boost::multiprecision::cpp_int_backend<StackBits, StackBits,
    boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>,
  boost::multiprecision::et_off>;
using HeapInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
  boost::multiprecision::et_off>;

/// Run @p recipe in the cheapest arithmetic that can.
template <class Recipe>
void decide(const ExponentRange& range, const Recipe& recipe)
{
  const bool done = range.bits() <= MostBits
    ? recipe(IntegerArithmetic<StackInteger>(range.exponent()))
    : recipe(IntegerArithmetic<HeapInteger>(range.exponent()));
  if (!done)
  {
    throw Error(ErrorCode::BadArgument);
  }
}

/// 2 (x - a).u for the points x of equal power to a and b, where u = b - a.
template <class Arithmetic, class Number>
Number level(const Arithmetic& k, const Number* u, const PowerSite& a, const PowerSite& b)
{
  return u[0] * u[0] + u[1] * u[1] - k.difference(b.weight, a.weight, 2);
}

template <class Arithmetic>
bool center(
  const Arithmetic& k, const PowerSite& a, const PowerSite& b, const PowerSite& c, double* result)
{
  using Number = typename Arithmetic::Number;
  const Number u[2] = { k.difference(b.x[0], a.x[0]), k.difference(b.x[1], a.x[1]) };
  const Number v[2] = { k.difference(c.x[0], a.x[0]), k.difference(c.x[1], a.x[1]) };
  const Number p = level(k, u, a, b);
  const Number q = level(k, v, a, c);
  const Number half = u[0] * v[1] - u[1] * v[0];
  const Number denominator = half + half;
  return k.positive(denominator) && k.round(a.x[0], p * v[1] - q * u[1], denominator, result[0]) &&
    k.round(a.x[1], q * u[0] - p * v[0], denominator, result[1]);
}

template <class Arithmetic>
bool middle(const Arithmetic& k, const PowerSite& a, const PowerSite& b, double* result)
{
  using Number = typename Arithmetic::Number;
  const Number u[2] = { k.difference(b.x[0], a.x[0]), k.difference(b.x[1], a.x[1]) };
  const Number p = level(k, u, a, b);
  const Number half = u[0] * u[0] + u[1] * u[1];
  const Number denominator = half + half;
  return k.round(a.x[0], p * u[0], denominator, result[0]) &&
    k.round(a.x[1], p * u[1], denominator, result[1]);
}

template <class Arithmetic>
bool crossing(
  const Arithmetic& k, const PowerSite& a, const PowerSite& b, int axis, double at, double& result)
{
  using Number = typename Arithmetic::Number;
  const Number u[2] = { k.difference(b.x[0], a.x[0]), k.difference(b.x[1], a.x[1]) };
  const Number along = u[axis] * k.difference(at, a.x[axis]);
  const Number numerator = level(k, u, a, b) - (along + along);
  return k.round(a.x[1 - axis], numerator, u[1 - axis] + u[1 - axis], result);
}

/// Nearly all centers come of this.
FF_FLAT bool quickCenter(const PowerSite& a, const PowerSite& b, const PowerSite& c, double* result)
{
  return center(BoundedArithmetic(), a, b, c, result);
}

}

void powerCenter(const PowerSite& a, const PowerSite& b, const PowerSite& c, double* result)
{
  if (!quickCenter(a, b, c, result))
  {
    ExponentRange range;
    range.add(a);
    range.add(b);
    range.add(c);
    decide(range, [&](const auto& k) { return center(k, a, b, c, result); });
  }
}

void powerMiddle(const PowerSite& a, const PowerSite& b, double* result)
{
  if (!middle(BoundedArithmetic(), a, b, result))
  {
    ExponentRange range;
    range.add(a);
    range.add(b);
    decide(range, [&](const auto& k) { return middle(k, a, b, result); });
  }
}

double powerCrossing(const PowerSite& a, const PowerSite& b, int axis, double at)
{
  double result = 0.0;
  if (!crossing(BoundedArithmetic(), a, b, axis, at, result))
  {
    ExponentRange range;
    range.add(a);
    range.add(b);
    range.add(at);
    decide(range, [&](const auto& k) { return crossing(k, a, b, axis, at, result); });
  }
  return result;
}

}
