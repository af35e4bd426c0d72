// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PowerDiagram/PowerCorners.h"

#include "PowerDiagram/SiteRange.h"

namespace flipflop
{
namespace
{

/// 2 (x - a).u for the points x of equal power to a and b, where u = b - a.
template <class Arithmetic, class Number>
Number level(const Arithmetic& k, const Number* u, const PowerSite& a, const PowerSite& b)
{
  return u[0] * u[0] + u[1] * u[1] - k.difference(b.weight, a.weight, 2);
}

template <class Arithmetic>
bool center(
  const Arithmetic& k, const PowerSite& a, const PowerSite& b, const PowerSite& c, double* result)
{
  using Number = typename Arithmetic::Number;
  const Number u[2] = { k.difference(b.x[0], a.x[0]), k.difference(b.x[1], a.x[1]) };
  const Number v[2] = { k.difference(c.x[0], a.x[0]), k.difference(c.x[1], a.x[1]) };
  const Number p = level(k, u, a, b);
  const Number q = level(k, v, a, c);
  const Number half = u[0] * v[1] - u[1] * v[0];
  const Number denominator = half + half;
  return k.positive(denominator) && k.round(a.x[0], p * v[1] - q * u[1], denominator, result[0]) &&
    k.round(a.x[1], q * u[0] - p * v[0], denominator, result[1]);
}

/// Nearly all centers come of this.
FF_FLATTEN bool quickCenter(
  const PowerSite& a, const PowerSite& b, const PowerSite& c, double* result)
{
  return center(BoundedArithmetic<>(), a, b, c, result);
}

}

void powerCenter(const PowerSite& a, const PowerSite& b, const PowerSite& c, double* result)
{
  if (!quickCenter(a, b, c, result))
  {
    ExponentRange range;
    addSite(range, a);
    addSite(range, b);
    addSite(range, c);
    decide(range, [&](const auto& k) { return center(k, a, b, c, result); });
  }
}

}
