// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Orientation in the plane for any finite doubles, unscaled.
#ifndef flipflop_PlaneOrientation_h
#define flipflop_PlaneOrientation_h

#include "Predicates/DoubleDouble.h"
#include "Predicates/WideSigns.h"

namespace flipflop
{

/// Positive when p, q, r turn left. Each has an x and a y.
inline int planeOrientation(const double* p, const double* q, const double* r)
{
  int sign = 0;
  if (ExpansionSigns::filterOrient2(p, q, r, 0, 1, sign) ||
    ExpansionSigns::signOfMinor(doubleDifference(q[0], p[0]), doubleDifference(q[1], p[1]),
      doubleDifference(r[0], p[0]), doubleDifference(r[1], p[1]), 0.0, 0.0, sign))
  {
    return sign;
  }
  return WideSigns::orient2(p, q, DeterminantRow<1>{ { r } }, 0, 1);
}

}

#endif
