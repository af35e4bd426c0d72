// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Real data and a choice of families against what is kept in Testing/Data/Baseline.
#include "Testing/Engine/Conformance/Kind.h"
#include "Testing/Engine/References/BaselineFile.h"

namespace flipflop
{
namespace test
{

namespace
{

class Baselines : public ::testing::TestWithParam<InputOf>
{
};

TEST_P(Baselines, AreTheEngines)
{
  // Cell by cell: so what the file has is in canonical form too.
  const Kind& kind = *this->GetParam().kind;
  const Input& input = this->GetParam().input;
  const Cloud cloud = input.make();
  const Baseline baseline =
    readBaseline(std::string(FLIPFLOP_TEST_DATA) + "/Baseline/" + input.name + ".txt");
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

}
}
}
