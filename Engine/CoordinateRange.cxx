// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoordinateRange.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

Arithmetic chooseArithmetic(const CoordinateRange& range)
{
  // Expansions need, for coordinates that are multiples of 2^bottom below 2^top, 3 * bottom >=
  // -1074 and 3 * (top + 4) <= 1023, with room for the halves of a product. A computed kernel point
  // is a rounded mean: its bits reach lower than the points', by no more than the 170 places left
  // here.
  constexpr int lowestBottom = -300;
  constexpr int highestTop = 300;

  Arithmetic result;
  if (range.largest == 0.0)
  {
    return result;
  }
  const int top = std::ilogb(range.largest) + 1;
  // A coordinate's lowest bit is at most 52 places below its highest, and never below 2^-1074.
  const int bottom = std::max(std::ilogb(range.smallest) - 52, -1074);
  if (top <= highestTop && bottom >= lowestBottom)
  {
    return result;
  }
  if (bottom - top >= lowestBottom)
  {
    result.scaleExponent = -top;
    return result;
  }
  // As near to one as possible without pushing the lowest bit below 2^-1074, and away from overflow
  // if that too is possible: the filters take an overflow for "undecided".
  result.wide = true;
  const int lossless = -1074 - bottom;
  result.scaleExponent = std::max(std::min(std::max(-top, lossless), 1021 - top), lossless);
  return result;
}

}
