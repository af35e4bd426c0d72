// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every family at every size, and the special inputs, in doubles and in floats: small ones against
/// the brute force, others against CGAL.
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/References/BaselineFile.h"

namespace flipflop
{
namespace test
{

namespace
{

void expectReference(const Kind& kind, const Input& input, bool inFloats = false)
{
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = inFloats ? roundedToFloat(input.make()) : input.make();
  EXPECT_TRUE(!inFloats || isFloat(cloud)); // a compiler has left some numbers as they were
  kind.expect(cloud, cloud.size() <= 15 ? kind.bruteForce(cloud) : kind.cgal(cloud));
}

class SmallFamily : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(SmallFamily, IsTheBruteForces)
{
  const FamilyOf& of = this->GetParam();
  for (int count : { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 27, 30, 40 })
  {
    for (std::uint64_t seed = 0; seed < (count < 15 ? 2u : 1u) && !HasFailure(); ++seed)
    {
      expectReference(*of.kind, of.kind->family(of.name, count, 100 * seed + count));
    }
    expectReference(*of.kind, of.kind->family(of.name, count, 7000 + count), true);
  }
}

INSTANTIATE_TEST_SUITE_P(
  ConvexHull, SmallFamily, ::testing::ValuesIn(familiesOf(convexHulls)), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, SmallFamily,
  ::testing::ValuesIn(familiesOf(regularTriangulations)), Named());

class LargeFamily : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(LargeFamily, IsCgals)
{
  // Rounding to float makes many points share coordinates, lines, planes and circles.
  const FamilyOf& of = this->GetParam();
  expectReference(
    *of.kind, of.kind->family(of.name, effort(of.count), 1000003u + of.count), of.count == 3000);
}

// The sizes lie on both sides of where an implementation may change its ways.
INSTANTIATE_TEST_SUITE_P(ConvexHull, LargeFamily,
  ::testing::ValuesIn(familiesOf(convexHulls, { 64, 500, 1500, 2500, 3000 })), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, LargeFamily,
  ::testing::ValuesIn(familiesOf(regularTriangulations, { 64, 500, 2040, 2500, 3000 })), Named());

INSTANTIATE_TEST_SUITE_P(ConvexHullOfThousands, LargeFamily,
  ::testing::ValuesIn(familiesOf(convexHulls,
    { "cube", "ball", "shell0", "shell1e2", "boxShell", "boxFaces", "gaussian", "clustered",
      "paraboloid", "smallIntegers", "doubled", "thin12", "needle", "far8", "far15", "skewPlane",
      "parallelPlanes", "coplanarAndOutlier", "collinearAlmost", "planeXyz0" },
    { 5000, 20000 })),
  Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulationOfThousands, LargeFamily,
  ::testing::ValuesIn(familiesOf(regularTriangulations,
    { "uniform", "uniformHeavy", "uniformHiding", "oneGiant", "grid", "gridOfTwoWeights",
      "smallIntegers", "smallIntegersLight", "doubled", "wheel", "parabola", "lineAlongY",
      "diagonalRounded", "coplanarLiftsAlmost", "creasedLifts", "clusters", "far8", "far15",
      "thin" },
    { 12000 })),
  Named());
INSTANTIATE_TEST_SUITE_P(ConvexHullOfMany, LargeFamily,
  ::testing::ValuesIn(familiesOf(convexHulls,
    { "cube", "ball", "shell1e2", "shell1e4", "boxFaces", "clustered", "far15",
      "coplanarAndOutlier" },
    { 100000 })),
  Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulationOfMany, LargeFamily,
  ::testing::ValuesIn(familiesOf(regularTriangulations, { "uniform", "uniformHeavy" }, { 50000 })),
  Named());

class Special : public ::testing::TestWithParam<InputOf>
{
};

TEST_P(Special, IsTheReferences)
{
  expectReference(*this->GetParam().kind, this->GetParam().input);
}

INSTANTIATE_TEST_SUITE_P(SmallConvexHull, Special,
  ::testing::ValuesIn(inputsOf(convexHulls, smallSpecialInputs())), Named());
INSTANTIATE_TEST_SUITE_P(SmallRegularTriangulation, Special,
  ::testing::ValuesIn(inputsOf(regularTriangulations, smallWeightedInputs())), Named());
INSTANTIATE_TEST_SUITE_P(LargeConvexHull, Special,
  ::testing::ValuesIn(inputsOf(convexHulls, largeSpecialInputs())), Named());
INSTANTIATE_TEST_SUITE_P(LargeRegularTriangulation, Special,
  ::testing::ValuesIn(inputsOf(regularTriangulations, largeWeightedInputs())), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulationOfRealData, Special,
  ::testing::ValuesIn(inputsOf(regularTriangulations, realWeightedInputs())), Named());

}
}
}
