// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/PlaneValues.h"

#include "Support/PowersOfTwo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

// GCC 12 takes Boost's small integers for uninitialised memory.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wstringop-overflow"
#endif

namespace flipflop
{

namespace
{

/// Doubles as integers, in the largest power of two that all are multiples of: few bits, mostly.
class CommonUnit
{
public:
  /// @param axes of the points; the third coordinate is a weight, a multiple of the unit's square
  template <std::size_t Count>
  CommonUnit(const std::array<const double*, Count>& points, int axes)
  {
    for (const double* p : points)
    {
      for (int i = 0; i < axes; ++i)
      {
        this->include(p[i], i < 2 ? 1 : 2);
      }
    }
    this->exponent = this->exponent == Nothing ? 0 : this->exponent;
  }

  int power() const { return this->exponent; }

  WideInteger of(double x, int square = 1) const
  {
    const ScaledInteger parts = partsOf(x);
    return WideInteger(parts.integer) << (x == 0 ? 0 : parts.exponent - square * this->exponent);
  }
  WideInteger offset(const double* p, const double* origin, int axis) const
  {
    const int square = axis < 2 ? 1 : 2;
    return this->of(p[axis], square) - this->of(origin[axis], square);
  }

private:
  static constexpr int Nothing = 10000;

  /// With an odd integer, or zero.
  static ScaledInteger partsOf(double x)
  {
    ScaledInteger parts = scaledInteger(x);
    for (int step = 32; step > 0; step /= 2)
    {
      const std::int64_t unit = std::int64_t(1) << step;
      while (parts.integer != 0 && parts.integer % unit == 0)
      {
        parts.integer /= unit;
        parts.exponent += step;
      }
    }
    return parts;
  }

  void include(double x, int square)
  {
    if (x != 0)
    {
      const int lowest = partsOf(x).exponent;
      const int halved = lowest >= 0 ? lowest / 2 : (lowest - 1) / 2;
      this->exponent = std::min(this->exponent, square == 1 ? lowest : halved);
    }
  }

  int exponent = Nothing;
};

template <class Number>
void roundToFloat(const ExactValue& exact, Number& result)
{
  result = ldexp(Number(exact.value), exact.exponent);
}

}

ExactValue exactDifference(double a, double b)
{
  const CommonUnit unit(std::array<const double*, 2>{ &a, &b }, 1);
  return { unit.of(a) - unit.of(b), unit.power() };
}

ExactValue exactArea(const double* a, const double* b, const double* c)
{
  const CommonUnit unit(std::array<const double*, 3>{ a, b, c }, 2);
  return { unit.offset(b, a, 0) * unit.offset(c, a, 1) -
      unit.offset(b, a, 1) * unit.offset(c, a, 0),
    2 * unit.power() };
}

ExactValue exactHeight(const double* a, const double* b, const double* c, const double* p)
{
  const CommonUnit unit(std::array<const double*, 4>{ a, b, c, p }, 3);
  const double* const row[3] = { b, c, p };
  WideInteger u[3][3];
  for (int i = 0; i < 3; ++i)
  {
    u[i][0] = unit.offset(row[i], a, 0);
    u[i][1] = unit.offset(row[i], a, 1);
    u[i][2] = unit.offset(row[i], a, 2) - u[i][0] * u[i][0] - u[i][1] * u[i][1];
  }
  return { (u[0][0] * u[1][1] - u[0][1] * u[1][0]) * u[2][2] +
      (u[1][0] * u[2][1] - u[1][1] * u[2][0]) * u[0][2] +
      (u[2][0] * u[0][1] - u[2][1] * u[0][0]) * u[1][2],
    4 * unit.power() };
}

void roundTo(const ExactValue& exact, DoubleDouble& result)
{
  constexpr int Bits = 120; // some more than two doubles have
  const int bits =
    exact.value.is_zero() ? 0 : static_cast<int>(msb(WideInteger(abs(exact.value)))) + 1;
  const int spare = std::max(0, bits - Bits);
  const WideInteger leading = exact.value >> spare;
  const double high = leading.convert_to<double>();
  const double low = WideInteger(leading - WideInteger(high)).convert_to<double>();
  result = { std::ldexp(high, spare + exact.exponent), std::ldexp(low, spare + exact.exponent) };
}

void roundTo(const ExactValue& exact, LongNumber& result)
{
  roundToFloat(exact, result);
}

void roundTo(const ExactValue& exact, LongestNumber& result)
{
  roundToFloat(exact, result);
}

}
