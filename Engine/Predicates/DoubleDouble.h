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

struct DoubleDouble
{
  double high;
  double low;
};

/// a - b, exactly.
FF_HD inline DoubleDouble doubleDifference(double a, double b)
{
  DoubleDouble result;
  twoSum(a, -b, result.high, result.low);
  return result;
}

FF_HD inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b)
{
  double high, low, tail, tailLow;
  twoSum(a.high, b.high, high, low);
  twoSum(a.low, b.low, tail, tailLow);
  twoSum(high, low + tail, high, low);
  DoubleDouble result;
  twoSum(high, low + tailLow, result.high, result.low);
  return result;
}

FF_HD inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b)
{
  return a + DoubleDouble{ -b.high, -b.low };
}

FF_HD inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b)
{
  double high, low;
  twoProduct(a.high, b.high, high, low);
  DoubleDouble result;
  twoSum(high, low + (a.high * b.low + a.low * b.high), result.high, result.low);
  return result;
}

}

#endif
