// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Numbers as unevaluated sums of two doubles: about 106 bits, rounded (T. J. Dekker, 1971). An
/// operation's error is FarUnit (ErrorBounds.h).
#ifndef flipflop_DoubleDouble_h
#define flipflop_DoubleDouble_h

#include "Predicates/Expansion.h"

namespace flipflop
{

/// @tparam T double, or a vector of doubles: a number in each of its elements
template <class T>
struct DoubleDoubleOf
{
  T high;
  T low;
};

using DoubleDouble = DoubleDoubleOf<double>;

/// a - b, exactly.
template <class T>
FF_HD inline DoubleDoubleOf<T> doubleDifference(T a, T b)
{
  DoubleDoubleOf<T> result;
  twoSum(a, -b, result.high, result.low);
  return result;
}

template <class T>
FF_HD inline DoubleDoubleOf<T> operator+(const DoubleDoubleOf<T>& a, const DoubleDoubleOf<T>& b)
{
  T high, low, tail, tailLow;
  twoSum(a.high, b.high, high, low);
  twoSum(a.low, b.low, tail, tailLow);
  twoSum(high, low + tail, high, low);
  DoubleDoubleOf<T> result;
  twoSum(high, low + tailLow, result.high, result.low);
  return result;
}

template <class T>
FF_HD inline DoubleDoubleOf<T> operator-(const DoubleDoubleOf<T>& a, const DoubleDoubleOf<T>& b)
{
  return a + DoubleDoubleOf<T>{ -b.high, -b.low };
}

template <class T>
FF_HD inline DoubleDoubleOf<T> operator*(const DoubleDoubleOf<T>& a, const DoubleDoubleOf<T>& b)
{
  T high, low;
  twoProduct(a.high, b.high, high, low);
  DoubleDoubleOf<T> result;
  twoSum(high, low + (a.high * b.low + a.low * b.high), result.high, result.low);
  return result;
}

/// Products and sums whose low part may overlap the high one, for determinants of which the sign
/// alone is needed: fewer operations, and fewer that wait for one another. Of their errors
/// rounded-lifted-determinant.gappa has more.
/// @{
template <class T>
FF_HD inline DoubleDoubleOf<T> looseProduct(const DoubleDoubleOf<T>& a, const DoubleDoubleOf<T>& b)
{
  DoubleDoubleOf<T> result;
  twoProduct(a.high, b.high, result.high, result.low);
  result.low += a.high * b.low + a.low * b.high;
  return result;
}

template <class T>
FF_HD inline DoubleDoubleOf<T> looseSum(const DoubleDoubleOf<T>& a, const DoubleDoubleOf<T>& b)
{
  DoubleDoubleOf<T> result;
  twoSum(a.high, b.high, result.high, result.low);
  result.low += a.low + b.low;
  return result;
}

template <class T>
FF_HD inline DoubleDoubleOf<T> looseDifference(
  const DoubleDoubleOf<T>& a, const DoubleDoubleOf<T>& b)
{
  return looseSum(a, DoubleDoubleOf<T>{ -b.high, -b.low });
}
/// @}

}

#endif
