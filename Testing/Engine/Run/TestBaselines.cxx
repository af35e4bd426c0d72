// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Real data and a choice of families against what is kept in Testing/Data/Baseline.
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/References/BaselineFile.h"

#include <cstdio>
#include <stdexcept>

namespace flipflop
{
namespace test
{

namespace
{

std::string pathOf(const Input& input)
{
  return std::string(FLIPFLOP_TEST_DATA) + "/Baseline/" + input.name + ".txt";
}

class Baselines : public ::testing::TestWithParam<InputOf>
{
};

TEST_P(Baselines, AreTheEngines)
{
  // Cell by cell: so what the file has is in canonical form too.
  const Kind& kind = *this->GetParam().kind;
  const Input& input = this->GetParam().input;
  const Cloud cloud = input.make();
  const Baseline baseline = readBaseline(pathOf(input));
  ASSERT_EQ(baseline.kind, &kind == &convexHulls ? "hull" : "triangulation");
  ASSERT_EQ(baseline.points, static_cast<std::int64_t>(cloud.size()));
  ASSERT_EQ(baseline.hash, hashOf(cloud)) << "the input differs from the baseline's";
  ASSERT_FALSE(baseline.hull.cells.empty());
  kind.expect(cloud, baseline.hull);
}

INSTANTIATE_TEST_SUITE_P(
  ConvexHull, Baselines, ::testing::ValuesIn(inputsOf(convexHulls, baselineInputs())), Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, Baselines,
  ::testing::ValuesIn(inputsOf(regularTriangulations, weightedBaselineInputs())), Named());

class WeightedBaselines : public ::testing::TestWithParam<Input>
{
};

TEST_P(WeightedBaselines, AreCgals)
{
  const Cloud cloud = this->GetParam().make();
  EXPECT_TRUE(cgalTriangulation(cloud, kernelForWeighted(cloud)) ==
    readBaseline(pathOf(this->GetParam())).hull);
}

INSTANTIATE_TEST_SUITE_P(RegularTriangulation, WeightedBaselines,
  ::testing::ValuesIn(weightedBaselineInputs()),
  [](const auto& given) { return given.param.name; });

TEST(BaselinesMadeAnew, AreTheSame)
{
  int made = 0;
  for (const Input& input : baselineInputs())
  {
    if (input.name == "spot" || input.name == "cospherical5201" || input.name == "far15_20000" ||
      input.name == "cubeSurfaceGrid20rotated" || input.name == "autzen_thin_las")
    {
      EXPECT_TRUE(cgalHull(input.make()) == readBaseline(pathOf(input)).hull) << input.name;
      ++made;
    }
  }
  EXPECT_EQ(made, 5);
}

TEST(BaselinesMadeAnew, AFileSaysWhatWasWritten)
{
  const Input input = { "cube", 0, []() { return integerGrid(2); } };
  const ReferenceHull hull = bruteForceHull(input.make());
  const std::string path = ::testing::TempDir() + "flipflop_baseline_cube.txt";
  writeBaseline(path, "hull", input, hull);
  const Baseline baseline = readBaseline(path);
  EXPECT_TRUE(baseline.hull == hull);
  EXPECT_EQ(baseline.kind, "hull");
  EXPECT_EQ(baseline.points, 8);
  EXPECT_EQ(baseline.hash, hashOf(input.make()));
  std::remove(path.c_str());
  EXPECT_THROW(readBaseline(path), std::runtime_error);
}

}
}
}
