// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Weights by a rule are what double arithmetic makes of the numbers, and what makes no weight is
/// an error that names the first point and the count.
#include <flipflop/Error.h>
#include <flipflop/Weights.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

void expectError(const std::vector<double>& numbers, const WeightRule& rule, BadWeight::Fault fault,
  int index, int count)
{
  try
  {
    computeWeights({ numbers.data(), static_cast<std::int64_t>(numbers.size()) }, rule);
    ADD_FAILURE() << "no error";
  }
  catch (const BadWeight& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::BadArgument);
    EXPECT_EQ(error.fault(), fault);
    EXPECT_EQ(error.index(), index);
    EXPECT_EQ(error.count(), count);
  }
}

}

TEST(Weights, OfAnyRuleAndLayout)
{
  const std::vector<double> doubles{ 0.1, 7, 3, 7, 0.0, 7 };
  const std::vector<float> floats{ 0.1f, 7, 3, 7, 0.0f, 7 };
  for (const double factor : { 1.0, 0.3, -0.7, 0.0, 1e-200 })
  {
    for (const bool areRadii : { false, true })
    {
      const Buffer<double> wide = computeWeights({ doubles.data(), 3, 2 }, { areRadii, factor });
      const Buffer<double> narrow = computeWeights({ floats.data(), 3, 2 }, { areRadii, factor });
      ASSERT_EQ(wide.size(), 3u);
      ASSERT_EQ(narrow.size(), 3u);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const double product = factor * doubles[2 * i];
        EXPECT_EQ(wide[i], areRadii ? product * product : product);
        const double rounded = factor * double(floats[2 * i]);
        EXPECT_EQ(narrow[i], areRadii ? rounded * rounded : rounded);
      }
    }
  }
  EXPECT_EQ(computeWeights(WeightView(), { true, 2.0 }).size(), 0u);
}

TEST(Weights, Errors)
{
  expectError({ 1, -1, NaN, -1e-300 }, { true, 1.0 }, BadWeight::Fault::NegativeRadius, 1, 2);
  expectError({ 1, 1e200, -1e200 }, { false, 1e200 }, BadWeight::Fault::Overflow, 1, 2);
  expectError({ 2e154, Infinity }, { true, 1.0 }, BadWeight::Fault::Overflow, 0, 1);
  for (const double factor : { Infinity, -Infinity, NaN })
  {
    const double number = 1.0;
    EXPECT_THROW(computeWeights({ &number, 1 }, { false, factor }), Error);
  }
  // What is not finite is for the triangulation to report or to ignore.
  const std::vector<double> numbers{ -Infinity, NaN, 2 };
  const Buffer<double> weights = computeWeights({ numbers.data(), 3 }, { true, 0.5 });
  EXPECT_EQ(weights[0], Infinity);
  EXPECT_NE(weights[1], weights[1]);
  EXPECT_EQ(weights[2], 1.0);
}

}
}
