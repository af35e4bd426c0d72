// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constraints/Crossing.h"

#include "Predicates/RoundedFractions.h"

namespace flipflop
{

namespace
{

template <class Arithmetic>
bool round(const Arithmetic& k, const Position& a, const Position& b, const Position& c,
  const Position& d, Position& result)
{
  using Number = typename Arithmetic::Number;
  const Number u[2] = { k.difference(b.x[0], a.x[0]), k.difference(b.x[1], a.x[1]) };
  const Number v[2] = { k.difference(d.x[0], c.x[0]), k.difference(d.x[1], c.x[1]) };
  const Number w[2] = { k.difference(c.x[0], a.x[0]), k.difference(c.x[1], a.x[1]) };
  const Number denominator = u[0] * v[1] - u[1] * v[0];
  const Number along = w[0] * v[1] - w[1] * v[0]; // over the denominator: of the way from a to b
  return k.round(a.x[0], u[0] * along, denominator, result.x[0]) &&
    k.round(a.x[1], u[1] * along, denominator, result.x[1]);
}

}

Position crossingOf(const Position& a, const Position& b, const Position& c, const Position& d)
{
  Position result{};
  if (!round(BoundedArithmetic<>(), a, b, c, d, result))
  {
    ExponentRange range;
    for (const Position* const position : { &a, &b, &c, &d })
    {
      range.add(position->x[0]);
      range.add(position->x[1]);
    }
    decide(range, [&](const auto& k) { return round(k, a, b, c, d, result); });
  }
  // A zero has one sign.
  return { { result.x[0] + 0.0, result.x[1] + 0.0 } };
}

}
