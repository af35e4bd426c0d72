// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every family at small sizes, and the small special inputs, against the brute force.
#include "Testing/Engine/Conformance/Kind.h"

namespace flipflop
{
namespace test
{

namespace
{

class SmallFamily : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(SmallFamily, IsTheBruteForces)
{
  const Kind& kind = *this->GetParam().kind;
  for (int count : { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 27, 30, 40 })
  {
    for (std::uint64_t seed = 0; seed < (count < 15 ? 4u : 1u) && !HasFailure(); ++seed)
    {
      const Input input = kind.family(this->GetParam().name, count, 100 * seed + count);
      SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
      const Cloud cloud = input.make();
      kind.expect(cloud, kind.bruteForce(cloud));
    }
  }
}

TEST_P(SmallFamily, InFloatsIsTheBruteForces)
{
  const Kind& kind = *this->GetParam().kind;
  for (int count : { 4, 6, 8, 11, 16, 25, 33 })
  {
    const Input input = kind.family(this->GetParam().name, count, 7000 + count);
    SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
    const Cloud cloud = roundedToFloat(input.make());
    kind.expect(cloud, kind.bruteForce(cloud));
    if (HasFailure())
    {
      return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  ConvexHull, SmallFamily, ::testing::ValuesIn(familiesOf(convexHulls)), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, SmallFamily,
  ::testing::ValuesIn(familiesOf(regularTriangulations)), Named());

class SmallSpecial : public ::testing::TestWithParam<InputOf>
{
};

TEST_P(SmallSpecial, IsTheBruteForces)
{
  const Kind& kind = *this->GetParam().kind;
  SCOPED_TRACE("seed " + std::to_string(this->GetParam().input.seed));
  const Cloud cloud = this->GetParam().input.make();
  kind.expect(cloud, kind.bruteForce(cloud));
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, SmallSpecial,
  ::testing::ValuesIn(inputsOf(convexHulls, smallSpecialInputs())), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, SmallSpecial,
  ::testing::ValuesIn(inputsOf(regularTriangulations, smallWeightedInputs())), Named());

}
}
}
