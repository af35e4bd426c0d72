// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exponents from a double's bits are those of the mathematical library.
#include "Support/PowersOfTwo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

TEST(PowersOfTwo, AreTheLibrarys)
{
  for (int exponent = -1074; exponent <= 1023; ++exponent)
  {
    const double power = std::ldexp(1.0, exponent);
    EXPECT_EQ(exponentOf(power), exponent);
    EXPECT_EQ(exponentOf(1.75 * power), std::ilogb(1.75 * power));
    if (exponent >= -1022)
    {
      EXPECT_EQ(powerOfTwo(exponent), power);
    }
  }
  EXPECT_EQ(exponentOf(std::numeric_limits<double>::max()), 1023);
}

}
}
}
