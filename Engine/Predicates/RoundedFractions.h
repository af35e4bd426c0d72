// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Two arithmetics for polynomials of coordinates and weights: a quick one, which bounds its
/// error and returns when it cannot decide, and an exact one in integers.
///
/// A recipe is a template over the arithmetic k, and so is written once. It takes differences of
/// coordinates (k.difference) and forms polynomials up to degree six of them with + - and *. Then
/// it calls for a sign (k.sign), or rounds a fraction of degree three to the nearest double
/// (k.round). It returns what that returns: false, where k cannot decide.
///
/// It takes Boost's headers along, so few files include it.
#ifndef flipflop_RoundedFractions_h
#define flipflop_RoundedFractions_h

#include "Predicates/DoubleDouble.h"
#include "Predicates/ErrorBounds.h"
#include "Support/PowersOfTwo.h"
#include <flipflop/Error.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace flipflop
{

/// What bounded numbers require of their values.
/// @{
inline double leading(double a)
{
  return a;
}
inline double leading(const DoubleDouble& a)
{
  return a.high;
}
inline double negative(double a)
{
  return -a;
}
inline DoubleDouble negative(const DoubleDouble& a)
{
  return { -a.high, -a.low };
}
/// An operation's relative error.
template <class Value>
constexpr double RoundingUnit = std::is_same<Value, double>::value ? NearUnit : FarUnit;
/// @}

/// A double or a double-double, and a bound on how far it is off, but for a factor of BoundedSlack,
/// which covers the rounding of the bounds themselves. Infinite or NaN: nothing is known.
template <class Value>
struct Bounded
{
  Value value;
  double error;

  friend Bounded operator+(const Bounded& a, const Bounded& b)
  {
    return { a.value + b.value,
      a.error + b.error +
        RoundingUnit<Value> * (std::fabs(leading(a.value)) + std::fabs(leading(b.value))) };
  }

  friend Bounded operator-(const Bounded& a, const Bounded& b)
  {
    return a + Bounded{ negative(b.value), b.error };
  }

  friend Bounded operator*(const Bounded& a, const Bounded& b)
  {
    const double sizeA = std::fabs(leading(a.value));
    const double sizeB = std::fabs(leading(b.value));
    return { a.value * b.value,
      sizeA * b.error + sizeB * a.error + a.error * b.error + RoundingUnit<Value> * sizeA * sizeB +
        BoundedUnderflow };
  }
};

/// The quick arithmetic: returns when it cannot decide. In double-double it decides nearly always.
template <class Value = DoubleDouble>
class BoundedArithmetic
{
public:
  using Number = Bounded<Value>;

  /// a - b; @p degree 1 for lengths, 2 for weights.
  static Number difference(double a, double b, int degree = 1)
  {
    Number result = { Value(), 0.0 };
    if constexpr (std::is_same<Value, double>::value)
    {
      result.value = a - b;
      result.error = RoundingUnit<Value> * std::fabs(result.value);
    }
    else
    {
      result.value = doubleDifference(a, b);
    }
    // Within this range products of six lengths stay clear of overflow.
    const double size = std::fabs(leading(result.value));
    const double least = degree == 1 ? 0x1p-150 : 0x1p-300;
    const double most = degree == 1 ? 0x1p150 : 0x1p300;
    const bool inRange = (size >= least) & (size <= most);
    result.error = inRange | (size == 0.0) ? result.error : HUGE_VAL;
    return result;
  }

  /// A number without a unit.
  static Number whole(int value)
  {
    if constexpr (std::is_same<Value, double>::value)
    {
      return { double(value), 0.0 };
    }
    else
    {
      return { { double(value), 0.0 }, 0.0 };
    }
  }

  /// @return false when it cannot decide
  static bool sign(const Number& a, int& result)
  {
    result = leading(a.value) > 0.0 ? 1 : -1;
    return std::fabs(leading(a.value)) > BoundedSlack * a.error;
  }

  /// base + numerator / denominator, rounded to nearest; false when it cannot decide which is.
  static bool round(double base, const Number& numerator, const Number& denominator, double& result)
  {
    const double size = std::fabs(denominator.value.high);
    const bool inRange = (denominator.error < 0x1p-20 * size) & (std::fabs(base) <= 0x1p150);
    const double first = numerator.value.high / denominator.value.high;
    const DoubleDouble rest = numerator.value - denominator.value * DoubleDouble{ first, 0.0 };
    DoubleDouble quotient;
    twoSum(first, rest.high / denominator.value.high, quotient.high, quotient.low);
    const DoubleDouble sum = DoubleDouble{ base, 0.0 } + quotient;
    double error = (numerator.error + std::fabs(first) * denominator.error) / size +
      FractionError * (std::fabs(base) + std::fabs(first));
    error = BoundedSlack * error + FractionLowError * std::fabs(sum.low);
    result = sum.high;
    // Both ends of the interval round to the same.
    return inRange & (sum.high + (sum.low + error) == sum.high) &
      (sum.high + (sum.low - error) == sum.high);
  }

  static bool positive(const Number& a) { return leading(a.value) > BoundedSlack * a.error; }
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

  /// The least double a with a |a| >= numerator / denominator, a fraction of degree two.
  /// @param denominator positive
  double leastRoot(const Integer& numerator, const Integer& denominator) const
  {
    if (numerator == 0)
    {
      return 0.0;
    }
    // Of a quotient of 126 to 128 bits the root has 63 or 64.
    Integer n = abs(numerator);
    Integer d = denominator;
    int shift = 126 - static_cast<int>(msb(n)) + static_cast<int>(msb(d));
    shift += shift % 2 != 0 ? 1 : 0;
    shift >= 0 ? n <<= shift : d <<= -shift;
    Integer quotient, remainder;
    divide_qr(n, d, quotient, remainder);
    const Integer root = sqrt(quotient);
    const bool isExact = remainder == 0 && root * root == quotient;
    const int binary = this->exponent - shift / 2;
    const auto bits = static_cast<std::uint64_t>(root);
    return numerator > 0 ? ceilingOf(bits, binary, isExact) : 0.0 - floorOf(bits, binary);
  }

  static Integer whole(int value) { return value; }

  static bool positive(const Integer& a) { return a > 0; }

  static bool sign(const Integer& a, int& result)
  {
    result = a.sign();
    return true;
  }

private:
  /// How many of 63 or 64 bits no double keeps of bits * 2^binary; 64: all.
  static int dropped(std::uint64_t bits, int binary)
  {
    return std::min(std::max(bits >> 63 ? 11 : 10, -1074 - binary), 64);
  }

  /// The greatest finite double up to bits * 2^binary.
  static double floorOf(std::uint64_t bits, int binary)
  {
    const int drop = dropped(bits, binary);
    const std::uint64_t kept = drop < 64 ? bits >> drop : 0;
    return std::min(
      std::ldexp(static_cast<double>(kept), binary + drop), std::numeric_limits<double>::max());
  }

  /// The least double from bits * 2^binary on, or from what is greater by less than 2^binary.
  static double ceilingOf(std::uint64_t bits, int binary, bool isExact)
  {
    const int drop = dropped(bits, binary);
    const std::uint64_t kept = drop < 64 ? bits >> drop : 0;
    const bool isKept = isExact && drop < 64 && kept << drop == bits;
    return std::ldexp(static_cast<double>(isKept ? kept : kept + 1), binary + drop);
  }

  Integer integer(double value, int degree) const
  {
    const ScaledInteger scaled = scaledInteger(value);
    Integer result = scaled.integer;
    if (result != 0)
    {
      result <<= scaled.exponent - degree * this->exponent;
    }
    return result;
  }

  int exponent;
};

/// The exponents of some numbers.
class ExponentRange
{
public:
  void add(double length)
  {
    if (length != 0.0)
    {
      int binary = 0;
      std::frexp(length, &binary);
      this->add(binary - 53, binary);
    }
  }

  /// A number that is a multiple of 2^bottom, and below 2^top.
  void add(int bottom, int top)
  {
    this->low = std::min(this->low, bottom);
    this->high = std::max(this->high, top);
  }

  /// All lengths are multiples of 2 to this.
  int exponent() const { return this->low == INT_MAX ? 0 : this->low; }

  int bits() const { return this->low == INT_MAX ? 0 : this->high - this->low; }

private:
  int low = INT_MAX;
  int high = INT_MIN;
};

/// Integers on the stack.
constexpr unsigned StackBits = 1024;
using StackInteger = boost::multiprecision::number<
  boost::multiprecision::cpp_int_backend<StackBits, StackBits,
    boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>,
  boost::multiprecision::et_off>;
using HeapInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
  boost::multiprecision::et_off>;

/// Run @p recipe in the cheapest exact arithmetic that can.
/// @param mostBits of the sites, with which its integers fit the stack
template <class Recipe>
bool inIntegers(const ExponentRange& range, int mostBits, const Recipe& recipe)
{
  return range.bits() <= mostBits ? recipe(IntegerArithmetic<StackInteger>(range.exponent()))
                                  : recipe(IntegerArithmetic<HeapInteger>(range.exponent()));
}

/// Lengths of up to so many bits, of which k.round fits the stack: numerators are of degree three,
/// and are shifted by up to 64 bits more than a denominator has.
constexpr int MostBitsToRound = 300;

/// The same for a recipe that ends in k.round.
/// @throw Error BadArgument where it returns false: the points are not as they should be
template <class Recipe>
void decide(const ExponentRange& range, const Recipe& recipe)
{
  if (!inIntegers(range, MostBitsToRound, recipe))
  {
    throw badArgument("the triangulation must be one of these points: its cells turn left");
  }
}

/// Of lengths of at most so many bits, formulas of degree six fit integers on the stack:
/// they have less than 6 * (bits + 2) + 2.
constexpr int BitsOfSites = 160;
static_assert(6 * (BitsOfSites + 2) + 2 < int(StackBits), "the integers are too short");

/// The sign of a formula.
/// @param formula   bool (arithmetic, int& sign): false where it cannot decide
/// @param findRange ExponentRange (): of its lengths; seldom requested
/// @throw Error     BadArgument where integers cannot decide: the sites are not as they should be
template <class Formula, class FindRange>
int exactSign(const Formula& formula, const FindRange& findRange)
{
  int sign = 0;
  if (!formula(BoundedArithmetic<double>(), sign) && !formula(BoundedArithmetic<>(), sign) &&
    !inIntegers(findRange(), BitsOfSites, [&](const auto& k) { return formula(k, sign); }))
  {
    throw badArgument("the triangulation must be one of these points: its cells turn left");
  }
  return sign;
}

}

#endif
