// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Corners of power diagrams are the doubles next to the exact ones.
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/PowerDiagram/ExactPolygons.h"

#include "PowerDiagram/PowerCorners.h"
#include <flipflop/Error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

namespace
{

struct Rational
{
  mpq_class x, y, weight;
};
Rational rationalOf(const PowerSite& site)
{
  return { mpq_class(site.x[0]), mpq_class(site.x[1]), mpq_class(site.weight) };
}

/// a x + b y = c for the points of equal power.
struct Line
{
  mpq_class a, b, c;
};
Line lineOf(const Rational& p, const Rational& q)
{
  return { 2 * (q.x - p.x), 2 * (q.y - p.y),
    q.x * q.x + q.y * q.y - q.weight - p.x * p.x - p.y * p.y + p.weight };
}

void expectCorners(const PowerSite& p, const PowerSite& q, PowerSite r)
{
  const Rational a = rationalOf(p);
  const Rational b = rationalOf(q);
  const Rational c = rationalOf(r);
  const Line l = lineOf(a, b);
  const Line m = lineOf(a, c);
  const mpq_class det = l.a * m.b - l.b * m.a;
  double corner[2];
  if (det > 0)
  {
    powerCenter(p, q, r, corner);
    expectRounded(corner[0], mpq_class(l.c * m.b - l.b * m.c) / det);
    expectRounded(corner[1], mpq_class(l.a * m.c - l.c * m.a) / det);
  }
  else
  {
    EXPECT_THROW(powerCenter(p, q, r, corner), Error);
  }
  // The normal meets the line where (x, y) = a + t (l.a, l.b).
  const mpq_class square = l.a * l.a + l.b * l.b;
  if (square != 0)
  {
    const mpq_class t = (l.c - l.a * a.x - l.b * a.y) / square;
    powerMiddle(p, q, corner);
    expectRounded(corner[0], a.x + t * l.a);
    expectRounded(corner[1], a.y + t * l.b);
  }
  if (l.b != 0)
  {
    const double at = r.x[0];
    const double y = powerCrossing(p, q, 0, at);
    expectRounded(y, (l.c - l.a * mpq_class(at)) / l.b);
    EXPECT_EQ(powerCrossing(q, p, 0, at), y);
  }
  if (l.a != 0)
  {
    const double at = r.x[1];
    const double x = powerCrossing(p, q, 1, at);
    expectRounded(x, (l.c - l.b * mpq_class(at)) / l.a);
    EXPECT_EQ(powerCrossing(q, p, 1, at), x);
  }
}

TEST(PowerCorners, AreCorrectlyRounded)
{
  Random random(12);
  // Ranges of exponents; 0: small integers, full of ties; -1: decimals, likewise; -2: nearly flat.
  for (const int range : { 0, -1, -2, 1, 10, 100, 140, 300, 1000, 1070 })
  {
    const auto length = [&]() -> double
    {
      if (range == 0)
      {
        return random.integer(-4, 4);
      }
      if (range == -1)
      {
        return 0.1 * random.integer(-30, 30);
      }
      return std::ldexp(
        random.uniform(-1, 1), random.integer(-std::abs(range), std::min(std::abs(range), 1000)));
    };
    for (int i = 0; i < (range > 200 ? 300 : 2000); ++i)
    {
      PowerSite sites[3];
      for (PowerSite& site : sites)
      {
        const double w = length();
        site = { { length(), length() },
          random.integer(0, 3) == 0 ? 0.0 : w * std::fabs(length()) };
        if (!std::isfinite(site.weight))
        {
          site.weight = 0;
        }
      }
      if (range == -2)
      {
        // The third on the line of the others, but for rounding.
        const double t = random.uniform(-2, 2);
        for (int k = 0; k < 2; ++k)
        {
          sites[2].x[k] = sites[0].x[k] + t * (sites[1].x[k] - sites[0].x[k]);
        }
      }
      SCOPED_TRACE("range " + std::to_string(range) + ", case " + std::to_string(i));
      expectCorners(sites[0], sites[1], sites[2]);
      expectCorners(sites[0], sites[2], sites[1]);
    }
  }
}

TEST(PowerCorners, SubnormalsAreRoundedOnce)
{
  // Half of an odd number of smallest units and 2^-31 more: up, though 53 bits show but the half.
  const double unit = std::numeric_limits<double>::denorm_min();
  const double odd = (0x1p30 + 1) * unit;
  const double y = powerCrossing({ { 0, 0 }, 0 }, { { unit, odd }, 0 }, 0, 0);
  EXPECT_EQ(y, (0x1p29 + 1) * unit);
}

}
}
}
