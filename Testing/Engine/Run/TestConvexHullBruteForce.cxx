// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every family at small sizes, and the small special inputs, against the brute force.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"

namespace flipflop
{
namespace test
{

namespace
{

class SmallFamily : public ::testing::TestWithParam<const char*>
{
};

TEST_P(SmallFamily, IsTheBruteForceHull)
{
  for (int count : { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 27, 40 })
  {
    for (std::uint64_t seed = 0; seed < (count < 15 ? 4u : 1u); ++seed)
    {
      const Input input = fromFamily(this->GetParam(), count, 100 * seed + count);
      SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
      const Cloud cloud = input.make();
      expectHull(cloud, bruteForceHull(cloud));
      if (HasFatalFailure() || HasNonfatalFailure())
      {
        return;
      }
    }
  }
}

TEST_P(SmallFamily, InFloatsIsTheBruteForceHull)
{
  for (int count : { 4, 6, 8, 11, 16, 25, 33 })
  {
    const Input input = fromFamily(this->GetParam(), count, 7000 + count);
    SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
    const Cloud cloud = roundedToFloat(input.make());
    expectHull(cloud, bruteForceHull(cloud));
    if (HasFatalFailure() || HasNonfatalFailure())
    {
      return;
    }
  }
}

std::vector<const char*> familyNames()
{
  std::vector<const char*> names;
  for (const Family& family : families())
  {
    names.push_back(family.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, SmallFamily, ::testing::ValuesIn(familyNames()),
  [](const auto& given) { return std::string(given.param); });

class SmallSpecial : public ::testing::TestWithParam<Input>
{
};

TEST_P(SmallSpecial, IsTheBruteForceHull)
{
  const Cloud cloud = this->GetParam().make();
  SCOPED_TRACE("seed " + std::to_string(this->GetParam().seed));
  expectHull(cloud, bruteForceHull(cloud));
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, SmallSpecial, ::testing::ValuesIn(smallSpecialInputs()),
  [](const auto& given) { return given.param.name; });

}
}
}
