// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Areas and heights above circles, not only their signs: to far more places than a double has.
///
/// They are taken in double-double, with a bound for the error; a value that is small compared with
/// its terms (flat triangles, points nearly on a circle) comes from exact integers. Where the range
/// is too wide, or a sum cancels (see checkSum()), all of a computation is done again in
/// floating-point numbers of 50 digits and any range, and where that is too vague, too, in numbers
/// of 4,400 bits. What is made of these values by products, quotients and sums of one sign is then
/// right to the last places of a double: a value is right to 2^-66, a sum may be 2^-30 of its
/// terms.
///
/// Where 2^-30 is enough, double comes first: there a value is right to 2^-37, or done again, and a
/// sum may be 2^-4 of its terms.
#ifndef flipflop_PlaneValues_h
#define flipflop_PlaneValues_h

#include "Points/Vertex.h"
#include "Predicates/DoubleDouble.h"
#include "Predicates/ErrorBounds.h"
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

inline double toDouble(double a)
{
  return a;
}

inline double toDouble(const DoubleDouble& a)
{
  return a.high;
}

/// An x and a y side by side, in a vector unit where the compiler has such a type.
#if defined(__GNUC__)
using DoublePair = double __attribute__((vector_size(16)));
#else
struct DoublePair
{
  double x, y;

  double operator[](int i) const { return i == 0 ? this->x : this->y; }
  DoublePair operator-() const { return { -this->x, -this->y }; }
  DoublePair operator+(const DoublePair& b) const { return { this->x + b.x, this->y + b.y }; }
  DoublePair operator-(const DoublePair& b) const { return { this->x - b.x, this->y - b.y }; }
  DoublePair operator*(const DoublePair& b) const { return { this->x * b.x, this->y * b.y }; }
  friend DoublePair operator*(double a, const DoublePair& b) { return { a * b.x, a * b.y }; }
};
#endif

/// An x and a y in double-double.
using DoubleDoublePair = DoubleDoubleOf<DoublePair>;

/// value * 2^exponent.
struct ExactValue
{
  WideInteger value;
  int exponent;
};

///@{
/// Exactly, in integers of few bits, where coordinates have few in common.
ExactValue exactDifference(double a, double b);
ExactValue exactArea(const double* a, const double* b, const double* c);
ExactValue exactHeight(const double* a, const double* b, const double* c, const double* p);
///@}

using LongNumber = boost::multiprecision::cpp_bin_float_50;
using LongestNumber = boost::multiprecision::number<
  boost::multiprecision::cpp_bin_float<4400, boost::multiprecision::digit_base_2>>;

///@{
/// Rounded.
void roundTo(const ExactValue& exact, DoubleDouble& result);
void roundTo(const ExactValue& exact, LongNumber& result);
void roundTo(const ExactValue& exact, LongestNumber& result);
///@}

/// Values in double: where no value is small compared with its terms.
struct PlainArithmetic
{
  using Number = double;
  using Pair = DoublePair;

  /// Of its terms, what a sum must have.
  static constexpr double SumShare = 0x1p-4;

  static Number number(double x) { return x; }
  static double high(Number x) { return x; }
  static const Pair& highs(const Pair& x) { return x; }
  static Number at(const Pair& x, int i) { return x[i]; }
  static Pair pairOf(Number x, Number y) { return Pair{ x, y }; }
  static Number difference(double a, double b) { return a - b; }
  static Pair difference(const DoublePair& a, const DoublePair& b) { return a - b; }

  /// A value that is off by less than 2^-49 of its terms.
  /// @return false if it is vague
  template <class Exact>
  static bool settle(Number& value, double most, const Exact&)
  {
    return std::fabs(value) >= 0x1p-12 * most;
  }
};

/// Values in double-double.
struct NearArithmetic
{
  using Number = DoubleDouble;
  using Pair = DoubleDoublePair;

  static constexpr double SumShare = 0x1p-30;

  static Number number(double x) { return { x, 0.0 }; }
  static double high(const Number& x) { return x.high; }
  static const DoublePair& highs(const Pair& x) { return x.high; }
  static Number at(const Pair& x, int i) { return { x.high[i], x.low[i] }; }
  static Pair pairOf(const Number& x, const Number& y)
  {
    return { DoublePair{ x.high, y.high }, DoublePair{ x.low, y.low } };
  }
  static Number difference(double a, double b) { return doubleDifference(a, b); }
  static Pair difference(const DoublePair& a, const DoublePair& b)
  {
    return doubleDifference(a, b);
  }

  /// A value that is off by less than 2^-100 of its terms; small ones come from exact integers.
  /// @return false if it is vague
  template <class Exact>
  static bool settle(Number& value, double most, const Exact& exact)
  {
    if (std::fabs(value.high) >= PlaneValueShare * most)
    {
      return true;
    }
    roundTo(exact(), value);
    const double size = std::fabs(value.high);
    return size == 0.0 || size >= 0x1p-480;
  }
};

/// Values by such arithmetic. A computation that finds isVague set is worth nothing.
template <class Arithmetic>
class RoundedValues
{
public:
  using Number = typename Arithmetic::Number;
  using Size = double;                    ///< how large a number is, roughly
  using Pair = typename Arithmetic::Pair; ///< an x and a y

  bool isVague() const { return this->vague; }

  static Number number(double x) { return Arithmetic::number(x); }
  static bool isZero(const Number& x) { return Arithmetic::high(x) == 0.0; }
  /// And in range.
  static bool isPositive(const Number& x)
  {
    return Arithmetic::high(x) > 0.0 && std::isfinite(Arithmetic::high(x));
  }
  static Size sizeOf(const Number& x) { return std::fabs(Arithmetic::high(x)); }

  /// A sum of products of computed numbers, with the sum of its terms' sizes: is it vague?
  void checkSum(const Number& sum, Size terms)
  {
    this->vague = this->vague || (terms > 0 && !(sizeOf(sum) >= Arithmetic::SumShare * terms));
  }

  /// a - b.
  Number difference(double a, double b)
  {
    const Number result = Arithmetic::difference(a, b);
    this->limit(sizeOf(result));
    return result;
  }

  /// The same of an x and of a y.
  Pair differences(const double* a, const double* b)
  {
    const Pair result = Arithmetic::difference(DoublePair{ a[0], a[1] }, DoublePair{ b[0], b[1] });
    this->limit(sizeOf(result, 0));
    this->limit(sizeOf(result, 1));
    return result;
  }

  static Size sizeOf(const Pair& x, int i) { return std::fabs(Arithmetic::highs(x)[i]); }
  static Number at(const Pair& x, int i) { return Arithmetic::at(x, i); }
  static Pair pairOf(const Number& x, const Number& y) { return Arithmetic::pairOf(x, y); }

  /// u x v.
  static Number cross(const Pair& u, const Pair& v)
  {
    const Pair sides = u * turned(v);
    return Arithmetic::at(sides, 0) - Arithmetic::at(sides, 1);
  }

  /// Twice the area of abc, positive where it turns left; zero only where it is.
  FF_FLATTEN Number area(const double* a, const double* b, const double* c)
  {
    const Pair u = this->differences(b, a), v = this->differences(c, a);
    const Pair sides = u * turned(v);
    const Number left = Arithmetic::at(sides, 0), right = Arithmetic::at(sides, 1);
    return this->checked(
      left - right, sizeOf(left) + sizeOf(right), [&] { return exactArea(a, b, c); });
  }

  /// How high p is above the plane of abc, which turns left, times twice the area; positive in the
  /// power circle; zero only where it is. Third coordinates are weights.
  FF_FLATTEN Number heightAbove(const double* a, const double* b, const double* c, const double* p)
  {
    const double* const row[3] = { b, c, p };
    Pair u[3];
    Number height[3];
    double size[3];
    for (int i = 0; i < 3; ++i)
    {
      u[i] = this->differences(row[i], a);
      const Pair squares = u[i] * u[i];
      const Number square = Arithmetic::at(squares, 0) + Arithmetic::at(squares, 1);
      const Number weight = this->difference(row[i][2], a[2]);
      height[i] = weight - square;
      size[i] = sizeOf(square) + sizeOf(weight);
    }
    Number det = number(0.0);
    double most = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const int j = i == 2 ? 0 : i + 1;
      const int k = i == 0 ? 2 : i - 1;
      const Pair sides = u[j] * turned(u[k]);
      const Number left = Arithmetic::at(sides, 0), right = Arithmetic::at(sides, 1);
      det = det + (left - right) * height[i];
      most += (sizeOf(left) + sizeOf(right)) * size[i];
    }
    return this->checked(det, most, [&] { return exactHeight(a, b, c, p); });
  }

private:
  /// y and x.
  static Pair turned(const Pair& a) { return pairOf(Arithmetic::at(a, 1), Arithmetic::at(a, 0)); }

  template <class Exact>
  Number checked(Number value, double most, const Exact& exact)
  {
    this->vague = this->vague || !Arithmetic::settle(value, most, exact);
    return value;
  }

  /// Products of four neither overflow nor lose their low parts.
  void limit(double size)
  {
    this->vague = this->vague || !(size == 0.0 || (size >= 0x1p-120 && size <= 0x1p240));
  }

  bool vague = false;
};

using PlainValues = RoundedValues<PlainArithmetic>;
using NearValues = RoundedValues<NearArithmetic>;

/// The same in numbers of any range, from exact integers.
template <class Float, int Spare>
class FarValues
{
public:
  using Number = Float;
  using Size = Float;
  struct Pair
  {
    Number high[2]; ///< all of them

    friend Pair operator*(const Pair& a, const Pair& b)
    {
      return { { Number(a.high[0] * b.high[0]), Number(a.high[1] * b.high[1]) } };
    }
    friend Pair operator+(const Pair& a, const Pair& b)
    {
      return { { Number(a.high[0] + b.high[0]), Number(a.high[1] + b.high[1]) } };
    }
  };

  bool isVague() const { return this->vague; }

  static Number number(double x) { return Number(x); }
  static bool isZero(const Number& x) { return x.is_zero(); }
  static bool isPositive(const Number& x) { return x > 0; }
  static Size sizeOf(const Number& x) { return abs(x); }

  Number difference(double a, double b) const { return rounded(exactDifference(a, b)); }
  Pair differences(const double* a, const double* b) const
  {
    return { { this->difference(a[0], b[0]), this->difference(a[1], b[1]) } };
  }
  static Pair pairOf(const Number& x, const Number& y) { return { { x, y } }; }
  static Size sizeOf(const Pair& x, int i) { return abs(x.high[i]); }
  static Number at(const Pair& x, int i) { return x.high[i]; }
  static Number cross(const Pair& u, const Pair& v)
  {
    return u.high[0] * v.high[1] - u.high[1] * v.high[0];
  }
  Number area(const double* a, const double* b, const double* c) const
  {
    return rounded(exactArea(a, b, c));
  }
  Number heightAbove(const double* a, const double* b, const double* c, const double* p) const
  {
    return rounded(exactHeight(a, b, c, p));
  }

  /// See NearValues.
  void checkSum(const Number& sum, const Size& terms)
  {
    this->vague = this->vague || (terms > 0 && abs(sum) < ldexp(terms, -Spare));
  }

private:
  static Number rounded(const ExactValue& exact)
  {
    Number result;
    roundTo(exact, result);
    return result;
  }

  bool vague = false;
};

/// Of 50 digits.
using LongValues = FarValues<LongNumber, 100>;

/// Of so many bits that no sum of terms along edges can be vague: the sine of an angle between two
/// differences of doubles is 2^-4197 or more.
using LongestValues = FarValues<LongestNumber, 4300>;

template <class Backend, boost::multiprecision::expression_template_option Option>
double toDouble(const boost::multiprecision::number<Backend, Option>& a)
{
  return a.template convert_to<double>();
}

/// In double-double; again in numbers of any range where that is too vague, and in longer ones.
/// @param compute bool (values): false if what is made of the values is no result
template <class Compute>
void withValues(const Compute& compute)
{
  const auto isDone = [&](auto values) { return compute(values) && !values.isVague(); };
  isDone(NearValues()) || isDone(LongValues()) || isDone(LongestValues());
}

/// The same, in double before.
template <class Compute>
void withPlainValues(const Compute& compute)
{
  PlainValues values;
  if (!compute(values) || values.isVague())
  {
    withValues(compute);
  }
}

}

#endif
