// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every weighted family at small sizes, and the small special inputs, against the brute force.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

namespace flipflop
{
namespace test
{

namespace
{

class SmallFamily : public ::testing::TestWithParam<const char*>
{
};

TEST_P(SmallFamily, IsTheBruteForceTriangulation)
{
  for (int count : { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 30 })
  {
    for (std::uint64_t seed = 0; seed < (count < 15 ? 2u : 1u); ++seed)
    {
      const Input input = fromWeightedFamily(this->GetParam(), count, 100 * seed + count);
      SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
      const Cloud cloud = input.make();
      expectTriangulation(cloud, bruteForceTriangulation(cloud));
      if (HasFatalFailure() || HasNonfatalFailure())
      {
        return;
      }
    }
  }
}

TEST_P(SmallFamily, InFloatsIsTheBruteForceTriangulation)
{
  for (int count : { 4, 6, 8, 11, 16, 25 })
  {
    const Input input = fromWeightedFamily(this->GetParam(), count, 7000 + count);
    SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
    const Cloud cloud = roundedToFloat(input.make());
    expectTriangulation(cloud, bruteForceTriangulation(cloud));
    if (HasFatalFailure() || HasNonfatalFailure())
    {
      return;
    }
  }
}

std::vector<const char*> familyNames()
{
  std::vector<const char*> names;
  for (const Family& family : weightedFamilies())
  {
    names.push_back(family.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, SmallFamily, ::testing::ValuesIn(familyNames()),
  [](const auto& given) { return std::string(given.param); });

class SmallSpecial : public ::testing::TestWithParam<Input>
{
};

TEST_P(SmallSpecial, IsTheBruteForceTriangulation)
{
  const Cloud cloud = this->GetParam().make();
  SCOPED_TRACE("seed " + std::to_string(this->GetParam().seed));
  expectTriangulation(cloud, bruteForceTriangulation(cloud));
}

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, SmallSpecial,
  ::testing::ValuesIn(smallWeightedInputs()), [](const auto& given) { return given.param.name; });

}
}
}
