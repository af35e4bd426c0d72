// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every family at larger sizes, and the large special inputs, against CGAL.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"

namespace flipflop
{
namespace test
{

namespace
{

/// Which of CGAL's kernels is right and bearable: the inexact one only where nothing is extreme.
CgalKernel kernelFor(const Cloud& cloud)
{
  const Scale scale = commonScale(cloud);
  if (scale.bits > 500 || scale.exponent + scale.bits > 500 || scale.exponent < -500)
  {
    return CgalKernel::Rational;
  }
  return cloud.size() > 6000 && scale.bits < 100 ? CgalKernel::Inexact : CgalKernel::Lazy;
}

class LargeFamily : public ::testing::TestWithParam<Sized>
{
};

TEST_P(LargeFamily, IsCgalsHull)
{
  const Sized sized = this->GetParam();
  const Input input = fromFamily(sized.family, effort(sized.count), 1000003u + sized.count);
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = input.make();
  expectHull(cloud, cgalHull(cloud, kernelFor(cloud)));
}

/// Sizes on both sides of where an implementation may change its ways.
std::vector<Sized> sizedFamilies()
{
  std::vector<Sized> all;
  for (const Family& family : families())
  {
    for (int count : { 64, 500, 1500, 2500 })
    {
      all.push_back({ family.name, count });
    }
  }
  for (const char* name :
    { "cube", "ball", "shell0", "shell1e2", "boxShell", "boxFaces", "gaussian", "clustered",
      "paraboloid", "smallIntegers", "doubled", "thin12", "needle", "far8", "far15", "skewPlane",
      "parallelPlanes", "coplanarAndOutlier", "collinearAlmost", "planeXyz0" })
  {
    all.push_back({ name, 5000 });
    all.push_back({ name, 20000 });
  }
  for (const char* name : { "cube", "ball", "shell1e2", "shell1e4", "boxFaces", "clustered",
         "far15", "coplanarAndOutlier" })
  {
    all.push_back({ name, 100000 });
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, LargeFamily, ::testing::ValuesIn(sizedFamilies()),
  [](const auto& given)
  { return std::string(given.param.family) + "_" + std::to_string(given.param.count); });

class FloatFamily : public ::testing::TestWithParam<const char*>
{
};

TEST_P(FloatFamily, IsCgalsHull)
{
  // Rounding to float makes many points share coordinates, lines and planes.
  const Input input = fromFamily(this->GetParam(), effort(3000), 77);
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = roundedToFloat(input.make());
  expectHull(cloud, cgalHull(cloud, kernelFor(cloud)));
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

INSTANTIATE_TEST_SUITE_P(ConvexHull, FloatFamily, ::testing::ValuesIn(familyNames()),
  [](const auto& given) { return std::string(given.param); });

class LargeSpecial : public ::testing::TestWithParam<Input>
{
};

TEST_P(LargeSpecial, IsCgalsHull)
{
  SCOPED_TRACE("seed " + std::to_string(this->GetParam().seed));
  const Cloud cloud = this->GetParam().make();
  expectHull(cloud, cgalHull(cloud, kernelFor(cloud)));
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, LargeSpecial, ::testing::ValuesIn(largeSpecialInputs()),
  [](const auto& given) { return given.param.name; });

}
}
}
