// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every weighted family at larger sizes, the large special inputs and real data, against CGAL.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/References/BaselineFile.h"

namespace flipflop
{
namespace test
{

namespace
{

class LargeFamily : public ::testing::TestWithParam<Sized>
{
};

TEST_P(LargeFamily, IsCgalsTriangulation)
{
  const Sized sized = this->GetParam();
  const Input input = fromWeightedFamily(sized.family, effort(sized.count), 1000003u + sized.count);
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = input.make();
  expectTriangulation(cloud, cgalTriangulation(cloud, kernelForWeighted(cloud)));
}

/// Sizes on both sides of where an implementation may change its ways.
std::vector<Sized> sizedFamilies()
{
  std::vector<Sized> all;
  for (const Family& family : weightedFamilies())
  {
    for (int count : { 64, 500, 2040, 2500 })
    {
      all.push_back({ family.name, count });
    }
  }
  for (const char* name : { "uniform", "uniformHeavy", "uniformHiding", "oneGiant", "grid",
         "gridOfTwoWeights", "smallIntegers", "smallIntegersLight", "doubled", "wheel", "parabola",
         "lineAlongY", "diagonalRounded", "coplanarLiftsAlmost", "creasedLifts", "clusters", "far8",
         "far15", "thin" })
  {
    all.push_back({ name, 12000 });
  }
  for (const char* name : { "uniform", "uniformHeavy" })
  {
    all.push_back({ name, 50000 });
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, LargeFamily, ::testing::ValuesIn(sizedFamilies()),
  [](const auto& given)
  { return std::string(given.param.family) + "_" + std::to_string(given.param.count); });

class FloatFamily : public ::testing::TestWithParam<const char*>
{
};

TEST_P(FloatFamily, IsCgalsTriangulation)
{
  // Rounding to float makes many points share coordinates, lines and circles.
  const Input input = fromWeightedFamily(this->GetParam(), effort(3000), 77);
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = roundedToFloat(input.make());
  expectTriangulation(cloud, cgalTriangulation(cloud, kernelForWeighted(cloud)));
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

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, FloatFamily, ::testing::ValuesIn(familyNames()),
  [](const auto& given) { return std::string(given.param); });

class LargeSpecial : public ::testing::TestWithParam<Input>
{
};

TEST_P(LargeSpecial, IsCgalsTriangulation)
{
  SCOPED_TRACE("seed " + std::to_string(this->GetParam().seed));
  const Cloud cloud = this->GetParam().make();
  expectTriangulation(cloud, cgalTriangulation(cloud, kernelForWeighted(cloud)));
}

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, LargeSpecial,
  ::testing::ValuesIn(largeWeightedInputs()), [](const auto& given) { return given.param.name; });

INSTANTIATE_TEST_SUITE_P(RegularTriangulationOfRealData, LargeSpecial,
  ::testing::ValuesIn(realWeightedInputs()), [](const auto& given) { return given.param.name; });

}
}
}
