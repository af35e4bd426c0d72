// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Integers of fixed size against integers of any size: what they tell is exact, and they do tell
// for grids.
#include "Predicates/FixedSigns.h"
#include "Testing/Engine/Predicates/LiftedCases.h"

#include <gtest/gtest.h>

#include <array>

using namespace flipflop;
using namespace flipflop::test;

namespace
{

constexpr unsigned Seed = 20260601;

#if FLIPFLOP_HAS_FIXED_SIGNS

mpz_class toInteger(Int128 value)
{
  const bool negative = value < 0;
  const UInt128 magnitude = negative ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
  mpz_class result(0);
  for (int shift = 96; shift >= 0; shift -= 32) // a long may have 32 bits
  {
    result <<= 32;
    result += static_cast<unsigned long>(static_cast<std::uint32_t>(magnitude >> shift));
  }
  return negative ? mpz_class(-result) : result;
}

/// Below 2^126 in magnitude: of any size, near the limbs' borders, or tiny.
Int128 someInteger(std::mt19937_64& random)
{
  const UInt128 bits = (static_cast<UInt128>(random()) << 64 | random()) >> 2;
  UInt128 magnitude = bits >> below(random, 126);
  if (random() % 4 == 0)
  {
    // A power of two, or next to it; the largest.
    const int exponent = below(random, 127);
    magnitude = (UInt128(1) << exponent) - (exponent == 126 ? 1 : random() % 3);
    magnitude = magnitude >> 126 ? (UInt128(1) << 126) - 1 : magnitude;
  }
  const auto value = static_cast<Int128>(magnitude);
  return random() % 2 ? value : -value;
}

#endif

using Points = std::array<Vertex, 4>;

/// Sign of det[b - a; c - a; d - a] of lifts, or of places in space.
template <bool Weighted>
int exactLifted(const Points& v)
{
  std::vector<Vertex> points(v.begin(), v.end());
  return ExactLift(points).above(v[0], v[1], v[2], v[3]);
}

/// What is told is exact. @return whether it is told
bool checkSpace(const Points& v)
{
  int sign = 7;
  const bool told = fixedOrient3(v[0].x, v[1].x, v[2].x, v[3].x, sign);
  EXPECT_TRUE(!told || sign == exactAbove(v[0], v[1], v[2], v[3]));
  return told;
}

template <bool Weighted>
bool checkLifted(Points v)
{
  for (Vertex& p : v)
  {
    p.x[2] = Weighted ? p.x[2] : 0.0;
  }
  int sign = 7;
  const bool told = fixedLiftedOrient3<Weighted>(v[0].x, v[1].x, v[2].x, v[3].x, sign);
  EXPECT_TRUE(!told || sign == exactLifted<Weighted>(v));
  return told;
}

}

#if FLIPFLOP_HAS_FIXED_SIGNS

TEST(FixedSigns, PlanesContainExactlyTheirPoints)
{
  SCOPED_TRACE(Seed);
  std::mt19937_64 random(Seed);
  int contained = 0;
  for (int i = 0; i < 20000; ++i)
  {
    // z = x + y in units of 2^-bits, and some a unit beside.
    const int bits = 1 + below(random, 52);
    Points v;
    for (Vertex& p : v)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        const auto units = static_cast<double>(random() >> (65 - bits));
        p.x[axis] = std::ldexp(random() % 2 ? units : -units, -bits);
      }
      p.x[2] = p.x[0] + p.x[1] + (random() % 8 ? 0.0 : std::ldexp(1.0, -bits));
    }
    const FixedPlane plane(v[0].x, v[1].x, v[2].x);
    const bool holds = plane.contains(v[3].x);
    contained += holds ? 1 : 0;
    ASSERT_TRUE(!holds || exactAbove(v[0], v[1], v[2], v[3]) == 0) << "case " << i;
  }
  EXPECT_GT(contained, 5000);
}

TEST(FixedSigns, SumsAreExact)
{
  SCOPED_TRACE(Seed);
  std::mt19937_64 random(Seed);
  int zero = 0;
  for (int i = 0; i < 100000; ++i)
  {
    FixedSum256 sum;
    mpz_class exact;
    const auto add = [&](Int128 a, Int128 b)
    {
      sum.addProduct(a, b);
      exact += toInteger(a) * toInteger(b);
    };
    const Int128 a = someInteger(random), b = someInteger(random);
    add(a, b);
    ASSERT_EQ(sum.sign(), sgn(exact));
    if (random() % 2)
    {
      // Back to zero, or to next to it.
      add(random() % 2 ? -a : a, -b);
      add(random() % 3 ? someInteger(random) % 3 : Int128(0), 1);
    }
    else
    {
      add(someInteger(random), someInteger(random));
      add(someInteger(random), someInteger(random));
    }
    ASSERT_EQ(sum.sign(), sgn(exact)) << "case " << i;
    zero += exact == 0 ? 1 : 0;
  }
  EXPECT_GT(zero, 5000);
}

TEST(FixedSigns, SumsTakeTheLargestProducts)
{
  const Int128 most = (Int128(1) << 126) - 1;
  for (const Int128 a : { most, -most })
  {
    FixedSum256 sum;
    for (int i = 0; i < 3; ++i)
    {
      sum.addProduct(a, most);
      EXPECT_EQ(sum.sign(), a > 0 ? 1 : -1);
    }
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(sum.sign(), a > 0 ? 1 : -1);
      sum.addProduct(a, -most);
    }
    EXPECT_EQ(sum.sign(), 0);
    sum.addProduct(a > 0 ? -1 : 1, 1);
    EXPECT_EQ(sum.sign(), a > 0 ? -1 : 1);
  }
}

TEST(FixedSigns, UnitsAreExact)
{
  SCOPED_TRACE(Seed + 1);
  std::mt19937_64 random(Seed + 1);
  int told = 0;
  int squares = 0;
  for (int i = 0; i < 50000; ++i)
  {
    const int exponent = below(random, 700) - 350;
    const double largest = std::ldexp(uniform(random), exponent);
    const double value = std::ldexp(largest, -below(random, 15)) * (random() % 2 ? 1 : 0.75);
    const FixedUnit unit(std::fabs(largest));
    // The largest itself is a multiple, below 2^61.
    std::int64_t one = 0;
    std::int64_t many = 0;
    ASSERT_TRUE(unit.convert(largest, many));
    ASSERT_LT(std::abs(many), std::int64_t(1) << 61);
    ASSERT_GE(std::abs(many), std::int64_t(1) << 60);
    const double perUnit = static_cast<double>(many) / largest;
    if (unit.convert(value, one))
    {
      ASSERT_EQ(mpq_class(value) * mpq_class(perUnit), mpq_class(toInteger(one)));
      ++told;
    }
    Int128 square = 0;
    const double weight =
      std::ldexp(uniform(random), 2 * std::ilogb(largest) + 2 - below(random, 90));
    if (unit.convertSquare(weight, square))
    {
      const mpq_class units = mpq_class(perUnit) * mpq_class(perUnit);
      ASSERT_EQ(mpq_class(weight) * units, mpq_class(toInteger(square)));
      ASSERT_LE(abs(toInteger(square)), mpz_class(1) << 124);
      ++squares;
    }
  }
  EXPECT_GT(told, 10000);
  EXPECT_GT(squares, 10000);

  Int128 square = 0;
  EXPECT_FALSE(FixedUnit(1.0).convertSquare(17.0, square));
  EXPECT_TRUE(FixedUnit(1.0).convertSquare(-15.0, square));
  std::int64_t one = 0;
  EXPECT_FALSE(FixedUnit(1.0).convert(0x1p-61, one));
  EXPECT_FALSE(FixedUnit(1e300).convert(1.0, one));
  EXPECT_FALSE(FixedUnit(1e-300).convert(1e-300, one));
}

TEST(FixedSigns, TheyTellForGrids)
{
  SCOPED_TRACE(Seed + 2);
  std::mt19937_64 random(Seed + 2);
  int ties = 0;
  for (int i = 0; i < 10000; ++i)
  {
    // Rectangles of a decimal grid: four points on a circle but for rounding.
    const double per[3] = { 10.0, 100.0, 1000.0 };
    const double unit = per[i % 3];
    const double start = random() % 2 ? 0.0 : 5.0;
    const double x[2] = { start + below(random, 50) / unit,
      start + (50 + below(random, 50)) / unit };
    const double y[2] = { start + below(random, 50) / unit,
      start + (50 + below(random, 50)) / unit };
    Points v = { makeVertex(x[0], y[0], 0, 0), makeVertex(x[1], y[0], 0, 1),
      makeVertex(x[0], y[1], 0, 2), makeVertex(x[1], y[1], 0, 3) };
    std::shuffle(v.begin(), v.end(), random);
    int sign = 7;
    bool exactlyApart = true;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double* side = axis == 0 ? x : y;
      double apart;
      exactlyApart = exactlyApart && exactDifference(side[1], side[0], apart);
    }
    ASSERT_EQ(checkLifted<false>(v), exactlyApart);
    ASSERT_EQ(checkLifted<true>(v), exactlyApart);
    if (exactlyApart)
    {
      ASSERT_TRUE(fixedLiftedOrient3<false>(v[0].x, v[1].x, v[2].x, v[3].x, sign));
      ASSERT_EQ(sign, 0);
      ++ties;
    }

    // Integers up to a million, with any integers for weights; in any power of two for unit.
    const int exponent = below(random, 200) - 100;
    const int limit = i % 2 ? 1000000 : 4;
    for (Vertex& p : v)
    {
      p.x[0] = std::ldexp(below(random, limit) - limit / 2, exponent);
      p.x[1] = std::ldexp(below(random, limit) - limit / 2, exponent);
      p.x[2] = std::ldexp(below(random, limit) - limit / 2, exponent);
    }
    ASSERT_TRUE(checkSpace(v)) << "case " << i;
    for (Vertex& p : v)
    {
      p.x[2] = std::ldexp(p.x[2], exponent);
    }
    ASSERT_TRUE(checkLifted<false>(v)) << "case " << i;
    // Weights far above the squares of the places do not fit.
    const bool together = std::all_of(v.begin(), v.end(),
      [&v](const Vertex& p) { return p.x[0] == v[0].x[0] && p.x[1] == v[0].x[1]; });
    ASSERT_TRUE(checkLifted<true>(v) || together) << "case " << i;
    if (testing::Test::HasFailure())
    {
      FAIL() << "case " << i;
    }
  }
  EXPECT_GT(ties, 2000);
}

TEST(FixedSigns, TheLastBitCounts)
{
  SCOPED_TRACE(Seed + 4);
  std::mt19937_64 random(Seed + 4);
  int told = 0;
  int left = 0;
  for (int i = 0; i < 60000; ++i)
  {
    // Small integers around the first point, at zero, where differences are exact; one of the
    // others' zeros is a little more.
    const int limit = i % 8 ? 3 : 9;
    Points v = { makeVertex(0, 0, 0, 0) };
    for (std::uint32_t k = 1; k < 4; ++k)
    {
      const auto coordinate = [&] { return below(random, limit) - limit / 2; };
      v[k] = makeVertex(coordinate(), coordinate(), coordinate(), k);
    }
    const bool isTie = exactAbove(v[0], v[1], v[2], v[3]) == 0;
    const bool isLiftedTie = exactLifted<true>(v) == 0;
    double& x = v[1 + random() % 3].x[random() % 3];
    if (x != 0 || !(isTie || isLiftedTie))
    {
      continue;
    }
    x = std::ldexp(random() % 2 ? 1.0 : -1.0, -55 - below(random, i % 2 ? 10 : 80));
    bool isTold = checkSpace(v);
    isTold = checkLifted<true>(v) && isTold;
    if (testing::Test::HasFailure())
    {
      FAIL() << "case " << i;
    }
    (isTold ? told : left) += 1;
  }
  EXPECT_GT(told, 500);
  EXPECT_GT(left, 500);
}

#endif

TEST(FixedSigns, WhatTheyTellIsExact)
{
  SCOPED_TRACE(Seed + 3);
  std::mt19937_64 random(Seed + 3);
  int told = 0;
  int toldLifted = 0;
  int toldWeighted = 0;
  for (int i = 0; i < 30000; ++i)
  {
    Points v;
    const int bits = 1 + below(random, 53);
    const int spread = 1 + below(random, 40);
    const int base = i % 4 ? 0 : below(random, 200) - 100;
    const bool flat = random() % 2;
    for (std::uint32_t k = 0; k < 4; ++k)
    {
      // Numbers of some bits, of some range of sizes; some coordinates are shared.
      v[k] = makeVertex(0, 0, 0, k);
      for (int axis = 0; axis < 3; ++axis)
      {
        const double mantissa =
          std::ldexp(std::nearbyint(std::ldexp(uniform(random), bits)), -bits);
        const int exponent = (flat && axis == 2 ? 2 : 1) * (base - below(random, spread));
        const bool shared = k > 0 && random() % 3 == 0;
        v[k].x[axis] = shared ? v[random() % k].x[axis] : std::ldexp(mantissa, exponent);
      }
    }
    told += checkSpace(v) ? 1 : 0;
    toldLifted += checkLifted<false>(v) ? 1 : 0;
    toldWeighted += checkLifted<true>(v) ? 1 : 0;
    if (testing::Test::HasFailure())
    {
      FAIL() << "case " << i;
    }
  }
#if FLIPFLOP_HAS_FIXED_SIGNS
  EXPECT_GT(told, 3000);
  EXPECT_GT(toldLifted, 3000);
  EXPECT_GT(toldWeighted, 2000);
  EXPECT_LT(told, 29000);
  EXPECT_LT(toldWeighted, 29000);
#else
  EXPECT_EQ(told + toldLifted + toldWeighted, 0);
#endif
}
