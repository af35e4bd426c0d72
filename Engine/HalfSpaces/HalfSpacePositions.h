// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where dual points and vertices are: fractions of the given numbers, rounded to nearest, or
/// compared exactly.
#ifndef flipflop_HalfSpacePositions_h
#define flipflop_HalfSpacePositions_h

#include "HalfSpaces/HalfSpaceRow.h"
#include "Predicates/RoundedFractions.h"

#include <algorithm>
#include <utility>

namespace flipflop
{

/// Of integers of up to so many bits, what is rounded here fits the stack: a numerator has degree
/// four, and is shifted until it has 64 bits more than a denominator of degree three.
constexpr int MostBitsInRows = 200;

/// A fraction of the numbers of a range, rounded to nearest; infinite beyond doubles.
/// @param fraction void (k, numerator, denominator): the numerator of one degree more
template <class Fraction>
double roundedFraction(const ExponentRange& range, const Fraction& fraction)
{
  double result = 0;
  const auto recipe = [&](const auto& k)
  {
    const auto parts = fraction(k);
    return k.round(0.0, parts.first, parts.second, result);
  };
  if (!recipe(BoundedArithmetic<>()))
  {
    ensure(inIntegers(range, MostBitsInRows, recipe));
  }
  return result;
}

/// The dual point of a half-space.
inline void dualPointOf(const double* row, const double* c, double* dual)
{
  for (int i = 0; i < 3; ++i)
  {
    dual[i] = row[i] == 0
      ? 0.0
      : roundedFraction(rangeAt(row, c),
          [&](const auto& k)
          {
            return std::make_pair(
              k.difference(row[i], 0.0) * k.difference(1.0, 0.0, 2), depthAt(k, row, c));
          });
  }
}

/// Where the borders of three half-spaces meet: Cramer's rule, along an axis.
inline double meetingPoint(const HalfSpaceRow* const* rows, int axis)
{
  ExponentRange range;
  range.add(1.0);
  for (int i = 0; i < 3; ++i)
  {
    std::for_each(rows[i]->number, rows[i]->number + 4, [&](double x) { range.add(x); });
  }
  return roundedFraction(range,
    [&](const auto& k)
    {
      // In the column of the axis, the bounds.
      const auto entry = [&](int i, int column)
      { return k.difference(rows[i]->number[column == axis ? 3 : column], 0.0); };
      const auto of = [&](const auto& at)
      {
        const auto minor = [&](int i, int j) { return at(i, 1) * at(j, 2) - at(i, 2) * at(j, 1); };
        return at(0, 0) * minor(1, 2) - at(1, 0) * minor(0, 2) + at(2, 0) * minor(0, 1);
      };
      const auto plain = [&](int i, int column)
      { return k.difference(rows[i]->number[column], 0.0); };
      return std::make_pair(of(entry) * k.difference(1.0, 0.0), of(plain));
    });
}

/// The order of dual points, exactly: by their first coordinates that differ. 0: both half-spaces
/// are the same.
inline int compareDuals(const double* a, const double* b, const double* c)
{
  for (int i = 0; i < 3; ++i)
  {
    const int sign = exactSign(
      [&](const auto& k, int& result)
      {
        return k.sign(
          k.difference(a[i], 0.0) * depthAt(k, b, c) - k.difference(b[i], 0.0) * depthAt(k, a, c),
          result);
      },
      [&]
      {
        ExponentRange range = rangeAt(a, c);
        std::for_each(b, b + 4, [&range](double x) { range.add(x); });
        return range;
      });
    if (sign != 0)
    {
      return sign;
    }
  }
  return 0;
}

}

#endif
