// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Orientations in the plane for any finite doubles, unscaled.
#ifndef flipflop_PlaneOrientation_h
#define flipflop_PlaneOrientation_h

#include "Predicates/ErrorBounds.h"
#include "Predicates/ExactSigns.h"

#include <cmath>

namespace flipflop
{

/// planeTurn without a filter.
int exactPlaneTurn(const double* a, const double* b, const double* c, const double* d);

/// The sign of (b - a) x (d - c): positive when the direction from c to d is on the left of that
/// from a to b. Each point has an x and a y.
inline int planeTurn(const double* a, const double* b, const double* c, const double* d)
{
  const double x1 = b[0] - a[0], y1 = b[1] - a[1];
  const double x2 = d[0] - c[0], y2 = d[1] - c[1];
  const double left = x1 * y2;
  const double right = y1 * x2;
  const double turn = left - right;
  const double most = std::fabs(left) + std::fabs(right);
  if (most > PlaneFloor && std::fabs(turn) > PlaneError * most)
  {
    return turn > 0 ? 1 : -1;
  }
  const bool isZero = (x1 == 0 || y2 == 0) && (y1 == 0 || x2 == 0); // as along an axis
  return isZero ? 0 : exactPlaneTurn(a, b, c, d);
}

/// Positive when p, q, r turn left. Each has an x and a y.
inline int planeOrientation(const double* p, const double* q, const double* r)
{
  int sign = 0;
  return ExpansionSigns::filterOrient2(p, q, r, 0, 1, sign) ? sign : exactPlaneTurn(p, q, p, r);
}

}

#endif
