// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The square of a circle of power distance 0 from one, two or three sites, as a fraction of
/// polynomials, and its comparison with the square of a length: in double, near a tie in
/// double-double, and then in integers.
#ifndef flipflop_CircleSquare_h
#define flipflop_CircleSquare_h

#include "PowerDiagram/SiteRange.h"
#include "PowerDiagram/TriangulationInput.h"
#include <flipflop/Error.h>

#include <algorithm>
#include <cmath>

namespace flipflop
{

/// A square, of two lengths.
template <class Number>
struct SquareFraction
{
  Number numerator;
  Number denominator; ///< positive
};

/// The exponents of some sites.
template <class... Sites>
ExponentRange rangeOf(const Sites&... sites)
{
  ExponentRange range;
  (addSite(range, sites), ...);
  return range;
}

/// A position and its offset from a site, as numbers.
template <class Arithmetic>
struct SiteOffset
{
  using Number = typename Arithmetic::Number;

  Number x, y;
  Number fall; ///< the first site's weight less this one's

  SiteOffset(const Arithmetic& k, const PowerSite& from, const PowerSite& to)
    : x(k.difference(to.x[0], from.x[0]))
    , y(k.difference(to.x[1], from.x[1]))
    , fall(k.difference(from.weight, to.weight, 2))
  {
  }

  Number square() const { return this->x * this->x + this->y * this->y; }
  Number level() const { return this->square() + this->fall; }
};

/// The least circle of one or two sites, and the circle of three.
class CircleSquare
{
public:
  explicit CircleSquare(const PowerSite& a)
    : site{ &a, nullptr, nullptr }
    , count(1)
  {
  }
  CircleSquare(const PowerSite& a, const PowerSite& b)
    : site{ &a, &b, nullptr }
    , count(2)
  {
  }
  /// @param c to the left of a and b
  CircleSquare(const PowerSite& a, const PowerSite& b, const PowerSite& c)
    : site{ &a, &b, &c }
    , count(3)
  {
  }

  /// Is it greater than alpha |alpha|?
  bool exceeds(double alpha) const
  {
    if (std::isinf(alpha))
    {
      return alpha < 0;
    }
    return exactSign(
             [&](const auto& k, int& sign)
             {
               SquareFraction<Number<decltype(k)>> square;
               return this->find(k, square) && this->compare(k, square, alpha, sign);
             },
             [&]
             {
               ExponentRange range = this->range();
               range.add(alpha);
               return range;
             }) > 0;
  }

  /// The least double that it does not exceed.
  double leastAlpha() const
  {
    double alpha = 0.0;
    if (this->quickLeastAlpha(alpha))
    {
      return alpha;
    }
    const bool isFound = inIntegers(this->range(), BitsOfSites,
      [&](const auto& k)
      {
        SquareFraction<Number<decltype(k)>> square;
        if (!this->find(k, square))
        {
          return false;
        }
        alpha = k.leastRoot(square.numerator, square.denominator);
        return true;
      });
    if (!isFound)
    {
      throw badArgument(NotATriangulation);
    }
    return alpha;
  }

private:
  template <class Arithmetic>
  using Number = typename std::decay_t<Arithmetic>::Number;

  /// @return false: it cannot decide, or the sites do not turn left
  template <class Arithmetic>
  bool find(const Arithmetic& k, SquareFraction<Number<Arithmetic>>& result) const
  {
    const PowerSite& a = *this->site[0];
    const auto weight = k.difference(a.weight, 0.0, 2);
    if (this->count == 1)
    {
      result = { k.whole(0) - weight, k.whole(1) };
      return true;
    }
    const SiteOffset<Arithmetic> u(k, a, *this->site[1]);
    if (this->count == 2)
    {
      const auto four = k.whole(4) * u.square();
      result = { u.level() * u.level() - four * weight, four };
      return k.positive(four);
    }
    // The center is (x, y) / 2 turn.
    const SiteOffset<Arithmetic> v(k, a, *this->site[2]);
    const auto p = u.level();
    const auto q = v.level();
    const auto turn = u.x * v.y - u.y * v.x;
    const auto x = p * v.y - q * u.y;
    const auto y = q * u.x - p * v.x;
    const auto four = k.whole(4) * turn * turn;
    result = { x * x + y * y - four * weight, four };
    return k.positive(turn);
  }

  template <class Arithmetic>
  static bool compare(
    const Arithmetic& k, const SquareFraction<Number<Arithmetic>>& square, double alpha, int& sign)
  {
    const auto length = k.difference(alpha, 0.0);
    const auto limit = square.denominator * length * length;
    return k.sign(alpha < 0 ? square.numerator + limit : square.numerator - limit, sign);
  }

  /// @return false: it cannot decide
  bool quickLeastAlpha(double& alpha) const
  {
    const BoundedArithmetic<> k;
    SquareFraction<Number<decltype(k)>> square;
    if (!this->find(k, square))
    {
      return false;
    }
    const double guess = leading(square.numerator.value) / leading(square.denominator.value);
    const double root = std::copysign(std::sqrt(std::fabs(guess)), guess);
    int sign = 0;
    if (!std::isfinite(root) || !this->compare(k, square, root, sign))
    {
      return false;
    }
    // The guess and the double next to it: one is exceeded, the other is not.
    const double next = std::nextafter(root, sign > 0 ? HUGE_VAL : -HUGE_VAL);
    int other = 0;
    if (!std::isfinite(next) || !this->compare(k, square, next, other) || other == sign)
    {
      return false;
    }
    alpha = sign > 0 ? next : root;
    return true;
  }

  ExponentRange range() const
  {
    ExponentRange range;
    std::for_each(this->site, this->site + this->count,
      [&range](const PowerSite* one) { addSite(range, *one); });
    return range;
  }

  const PowerSite* site[3];
  int count;
};

/// Has site @p c a negative power distance from the least circle of a and b?
inline bool isInCircle(const PowerSite& a, const PowerSite& b, const PowerSite& c)
{
  return exactSign(
           [&](const auto& k, int& sign)
           {
             using Arithmetic = std::decay_t<decltype(k)>;
             const SiteOffset<Arithmetic> u(k, a, b);
             const SiteOffset<Arithmetic> v(k, a, c);
             return k.sign(u.square() * v.level() - u.level() * (u.x * v.x + u.y * v.y), sign);
           },
           [&] { return rangeOf(a, b, c); }) < 0;
}

/// Has site @p b a negative power distance from the circle of site a?
inline bool isInCircle(const PowerSite& a, const PowerSite& b)
{
  return exactSign([&](const auto& k, int& sign)
           { return k.sign(SiteOffset<std::decay_t<decltype(k)>>(k, a, b).level(), sign); },
           [&] { return rangeOf(a, b); }) < 0;
}

}

#endif
