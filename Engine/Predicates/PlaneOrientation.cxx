// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Predicates/PlaneOrientation.h"

#include "Predicates/WideIntegers.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

int exactPlaneTurn(const double* a, const double* b, const double* c, const double* d)
{
  const DoubleDouble x1 = doubleDifference(b[0], a[0]), y1 = doubleDifference(b[1], a[1]);
  const DoubleDouble x2 = doubleDifference(d[0], c[0]), y2 = doubleDifference(d[1], c[1]);
  // A zero is mostly of differences that are exact. Their products must have errors, too.
  const double most =
    std::max({ std::fabs(x1.high), std::fabs(y1.high), std::fabs(x2.high), std::fabs(y2.high) });
  const bool isExact =
    x1.low == 0 && y1.low == 0 && x2.low == 0 && y2.low == 0 && most < MinorCeiling;
  int sign = 0;
  if (isExact ? ExpansionSigns::signOfExactMinor(x1.high, y1.high, x2.high, y2.high, sign)
              : ExpansionSigns::signOfMinor(x1, y1, x2, y2, 0.0, 0.0, sign))
  {
    return sign;
  }
  const WideInteger det =
    wideOffset(b, a, 0) * wideOffset(d, c, 1) - wideOffset(b, a, 1) * wideOffset(d, c, 0);
  return det.sign();
}

}
