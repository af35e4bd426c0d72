// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Expansions hold exactly what they should, whatever cancels.
#include "Predicates/Expansion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <gmpxx.h>

using namespace flipflop;

namespace
{

template <class Sum>
mpq_class valueOf(const Sum& sum)
{
  mpq_class value = 0;
  if constexpr (std::is_same_v<Sum, ProductSum>)
  {
    for (int i = 0; i < sum.size(); ++i)
    {
      value += mpq_class(sum[i]);
    }
  }
  else
  {
    for (int i = 0; i < sum.length; ++i)
    {
      value += mpq_class(sum.component[i]);
    }
  }
  return value;
}

/// Components by increasing magnitude that do not overlap: each is below the last bit of the next.
template <int Capacity>
void expectOrdered(const Expansion<Capacity>& e)
{
  ASSERT_LE(e.length, Capacity);
  for (int i = 0; i + 1 < e.length; ++i)
  {
    EXPECT_NE(e.component[i], 0.0);
    int exponent = std::ilogb(e.component[i + 1]) - 52;
    while (std::fmod(e.component[i + 1], std::ldexp(1.0, exponent + 1)) == 0)
    {
      ++exponent;
    }
    EXPECT_LT(std::fabs(e.component[i]), std::ldexp(1.0, exponent));
  }
}

/// Doubles of few or many bits and of widely different sizes, so that much cancels and much does
/// not.
double someDouble(std::mt19937_64& random)
{
  const int exponent = static_cast<int>(random() % 120) - 60;
  const double mantissa = random() % 3 == 0
    ? static_cast<double>(static_cast<int>(random() % 17) - 8)
    : static_cast<double>(static_cast<std::int64_t>(random() >> 11)) * 0x1p-53 - 0.5;
  return std::ldexp(mantissa, exponent);
}

}

TEST(Expansion, SumsAndProductsAreExact)
{
  constexpr unsigned seed = 20260101;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 20000; ++i)
  {
    const double a = someDouble(random), b = someDouble(random);
    const double c = random() % 4 == 0 ? a : someDouble(random), d = someDouble(random);
    const auto e = difference(a, b);
    const auto f = difference(c, d);
    ASSERT_EQ(valueOf(e), mpq_class(a) - mpq_class(b));
    const auto s = sum(e, f, -1.0);
    ASSERT_EQ(valueOf(s), valueOf(e) - valueOf(f));
    const auto p = product(e, f);
    ASSERT_EQ(valueOf(p), valueOf(e) * valueOf(f));
    const auto q = sum(p, s);
    ASSERT_EQ(valueOf(scale(q, d)), valueOf(q) * mpq_class(d));
    ProductSum total;
    total.add(q, s);
    total.add(s, e);
    total.add(p, f, -1.0);
    const mpq_class value =
      valueOf(q) * valueOf(s) + valueOf(s) * valueOf(e) - valueOf(p) * valueOf(f);
    ASSERT_EQ(valueOf(total), value);
    ASSERT_EQ(total.sign(), sgn(value));
    if (i % 500 == 0)
    {
      expectOrdered(s);
      expectOrdered(p);
      expectOrdered(q);
    }
  }
}

TEST(Expansion, ASumOfProductsIsExactAndShort)
{
  constexpr unsigned seed = 20260102;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  // As long as factors come, of components that lie far apart: much is left out when the next
  // product cancels it, and all of a double's range is in use.
  const auto longOne = [&random](int lowest, int highest)
  {
    Expansion<18> result;
    for (int i = 0; i < 18; ++i)
    {
      const int exponent = lowest + (highest - lowest) * i / 18;
      const double mantissa =
        random() % 2 ? 1.0 : 1.0 + static_cast<double>(random() % 1024) * 0x1p-10;
      result.append(
        random() % 5 == 0 ? 0.0 : std::ldexp(random() % 2 ? mantissa : -mantissa, exponent));
    }
    return result;
  };
  int longest = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const auto a = longOne(-400, 480), b = longOne(-480, 400);
    const auto c = longOne(-200, 220), d = random() % 2 ? a : longOne(-480, 480);
    ProductSum total;
    total.add(a, b);
    total.add(c, d);
    total.add(d, b, -1.0);
    const mpq_class value =
      valueOf(a) * valueOf(b) + valueOf(c) * valueOf(d) - valueOf(d) * valueOf(b);
    ASSERT_EQ(valueOf(total), value);
    ASSERT_EQ(total.sign(), sgn(value));
    longest = std::max(longest, total.size());
    total.add(a, b, -1.0);
    total.add(c, d, -1.0);
    total.add(d, b);
    ASSERT_EQ(total.sign(), 0);
  }
  // 53 bits a component and more: a double's range has no room for more than 40.
  EXPECT_LE(longest, 40);
  EXPECT_GE(longest, 20);
}

TEST(Expansion, WhatCancelsIsZero)
{
  const auto e = difference(0.1, 0.3);
  EXPECT_EQ(sum(e, e, -1.0).sign(), 0);
  EXPECT_EQ(sum(e, e, -1.0).length, 0);
  EXPECT_EQ(product(e, difference(2.0, 2.0)).length, 0);
  EXPECT_EQ(difference(1.0, 1.0 + 0x1p-52).sign(), -1);
}
