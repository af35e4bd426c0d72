// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Points/CoordinateRange.h"

#include "Support/PowersOfTwo.h"
#include "Support/StrictArithmetic.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace flipflop
{

namespace
{

/// All values of some axes are multiples of 2^bottom and below 2^top in magnitude.
struct Bits
{
  int top;
  int bottom;
};

/// @return false when all of them are zero
bool bitsOf(const CoordinateRange& range, int firstAxis, int endAxis, Bits& bits)
{
  double largest = 0;
  double smallest = HUGE_VAL;
  for (int axis = firstAxis; axis < endAxis; ++axis)
  {
    largest = std::max(largest, range.largest(axis));
    smallest = std::min(smallest, range.smallest[axis]);
  }
  if (largest == 0)
  {
    return false;
  }
  bits.top = exponentOf(largest) + 1;
  // A value's lowest bit is at most 52 places below its highest, and never below 2^-1074.
  bits.bottom = std::max(exponentOf(smallest) - 52, -1074);
  return true;
}

}

Arithmetic chooseArithmetic(const CoordinateRange& range)
{
  // Expansions need, for coordinates that are multiples of 2^bottom below 2^top, 3 * bottom >=
  // -1074 and 3 * (top + 4) <= 1023, with space for the halves of a product. A kernel point that is
  // computed is a rounded mean, or on a grid (see seekKernel): its bits reach lower than the
  // points', by no more than the 170 places left here. One that is given counts in the range.
  constexpr int lowestBottom = -300;
  constexpr int highestTop = 300;

  Arithmetic result;
  Bits bits;
  if (!bitsOf(range, 0, 3, bits))
  {
    return result;
  }
  const int top = bits.top;
  const int bottom = bits.bottom;
  if (top <= highestTop && bottom >= lowestBottom)
  {
    return result;
  }
  if (bottom - top >= lowestBottom)
  {
    result.scaleExponent = -top;
    return result;
  }
  // As near to one as possible without pushing the lowest bit below 2^-1074. What overflows then is
  // "undecided" to the filters.
  result.wide = true;
  result.scaleExponent = std::max(-top, -1074 - bottom);
  return result;
}

Arithmetic chooseLiftedArithmetic(const CoordinateRange& range)
{
  // Expansions carry x * y * (x^2 + y^2 - w), four coordinates to the product, when its lowest bit
  // is above 2^-1074 and it stays below 2^1023 with some space for sums.
  constexpr int lowestProduct = -1000;
  // Far from one either way the filters decide less.
  constexpr int ordinaryTop = 40;

  Arithmetic result;
  Bits position = { 0, 0 };
  Bits weight = { 0, 0 };
  const bool anyPosition = bitsOf(range, 0, 2, position);
  const bool anyWeight = bitsOf(range, 2, 3, weight);
  if (!anyPosition && !anyWeight)
  {
    return result;
  }
  if (!anyPosition || !anyWeight)
  {
    // Zeros have any bits.
    (anyPosition ? weight : position) = anyPosition ? Bits{ 2 * position.top, 2 * position.bottom }
                                                    : Bits{ weight.top / 2, weight.bottom / 2 };
  }
  const int top = std::max(position.top, (weight.top + 1) / 2 + 1);
  const int product = 2 * position.bottom + std::min(2 * position.bottom, weight.bottom);
  if (std::abs(top) <= ordinaryTop && product >= lowestProduct)
  {
    return result;
  }
  if (product - 4 * top >= lowestProduct)
  {
    result.scaleExponent = -top;
    return result;
  }
  result.wide = true;
  return result;
}

}
