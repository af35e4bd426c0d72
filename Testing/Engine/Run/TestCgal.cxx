// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every family at larger sizes, the large special inputs and real data, against CGAL.
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/References/BaselineFile.h"

namespace flipflop
{
namespace test
{

namespace
{

class LargeFamily : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(LargeFamily, IsCgals)
{
  const FamilyOf& of = this->GetParam();
  const Input input = of.kind->family(of.name, effort(of.count), 1000003u + of.count);
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = input.make();
  of.kind->expect(cloud, of.kind->cgal(cloud));
}

const auto nameAndCount = [](const auto& given)
{ return given.param.name + "_" + std::to_string(given.param.count); };

// The sizes lie on both sides of where an implementation may change its ways.
INSTANTIATE_TEST_SUITE_P(ConvexHull, LargeFamily,
  ::testing::ValuesIn(familiesOf(convexHulls, { 64, 500, 1500, 2500 })), nameAndCount);
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, LargeFamily,
  ::testing::ValuesIn(familiesOf(regularTriangulations, { 64, 500, 2040, 2500 })), nameAndCount);

INSTANTIATE_TEST_SUITE_P(ConvexHullOfThousands, LargeFamily,
  ::testing::ValuesIn(familiesOf(convexHulls,
    { "cube", "ball", "shell0", "shell1e2", "boxShell", "boxFaces", "gaussian", "clustered",
      "paraboloid", "smallIntegers", "doubled", "thin12", "needle", "far8", "far15", "skewPlane",
      "parallelPlanes", "coplanarAndOutlier", "collinearAlmost", "planeXyz0" },
    { 5000, 20000 })),
  nameAndCount);
INSTANTIATE_TEST_SUITE_P(RegularTriangulationOfThousands, LargeFamily,
  ::testing::ValuesIn(familiesOf(regularTriangulations,
    { "uniform", "uniformHeavy", "uniformHiding", "oneGiant", "grid", "gridOfTwoWeights",
      "smallIntegers", "smallIntegersLight", "doubled", "wheel", "parabola", "lineAlongY",
      "diagonalRounded", "coplanarLiftsAlmost", "creasedLifts", "clusters", "far8", "far15",
      "thin" },
    { 12000 })),
  nameAndCount);

INSTANTIATE_TEST_SUITE_P(ConvexHullOfMany, LargeFamily,
  ::testing::ValuesIn(familiesOf(convexHulls,
    { "cube", "ball", "shell1e2", "shell1e4", "boxFaces", "clustered", "far15",
      "coplanarAndOutlier" },
    { 100000 })),
  nameAndCount);
INSTANTIATE_TEST_SUITE_P(RegularTriangulationOfMany, LargeFamily,
  ::testing::ValuesIn(familiesOf(regularTriangulations, { "uniform", "uniformHeavy" }, { 50000 })),
  nameAndCount);

class FloatFamily : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(FloatFamily, IsCgals)
{
  // Rounding to float makes many points share coordinates, lines, planes and circles.
  const FamilyOf& of = this->GetParam();
  const Input input = of.kind->family(of.name, effort(of.count), 77);
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = roundedToFloat(input.make());
  of.kind->expect(cloud, of.kind->cgal(cloud));
}

INSTANTIATE_TEST_SUITE_P(
  ConvexHull, FloatFamily, ::testing::ValuesIn(familiesOf(convexHulls, { 3000 })), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, FloatFamily,
  ::testing::ValuesIn(familiesOf(regularTriangulations, { 3000 })), Named());

class LargeSpecial : public ::testing::TestWithParam<InputOf>
{
};

TEST_P(LargeSpecial, IsCgals)
{
  const Kind& kind = *this->GetParam().kind;
  SCOPED_TRACE("seed " + std::to_string(this->GetParam().input.seed));
  const Cloud cloud = this->GetParam().input.make();
  kind.expect(cloud, kind.cgal(cloud));
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, LargeSpecial,
  ::testing::ValuesIn(inputsOf(convexHulls, largeSpecialInputs())), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, LargeSpecial,
  ::testing::ValuesIn(inputsOf(regularTriangulations, largeWeightedInputs())), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulationOfRealData, LargeSpecial,
  ::testing::ValuesIn(inputsOf(regularTriangulations, realWeightedInputs())), Named());

}
}
}
