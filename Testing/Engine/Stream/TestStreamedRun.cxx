// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A streamed run has what one run has: all families of the engine's tests.
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/Stream/StreamedRuns.h"

#include <functional>

namespace flipflop
{
namespace test
{

namespace
{

/// What differs from one run; empty when nothing does.
std::string fault(BlockShape shape, Cloud cloud, std::int64_t pieces, int blocks, int threads)
{
  const StreamFolder folder;
  StreamSettings settings =
    settingsOf(shape, static_cast<std::int64_t>(cloud.size()) / blocks + 1, threads, folder);
  settings.options.facets = blocks % 2 ? FacetMode::Polygons : FacetMode::Triangles;
  Gathered gathered;
  const StreamReport report =
    streamedRun(settings, pieces, Pieces{ cloud, pieces }, std::ref(gathered));
  EXPECT_EQ(report.points, static_cast<std::int64_t>(cloud.size()));
  EXPECT_EQ(gathered.calls, report.blocks);
  EXPECT_FALSE(std::filesystem::exists(folder.path));
  for (Point& p : cloud)
  {
    p[2] = shape == BlockShape::Delaunay ? 0 : p[2];
  }
  return differenceFromOneRun(shape, cloud, gathered.report(report), settings.options);
}

class StreamedRun : public ::testing::TestWithParam<InputOf>
{
};

TEST_P(StreamedRun, IsOneRun)
{
  const Cloud cloud = this->GetParam().input.make();
  const SmallSamples small;
  if (this->GetParam().kind->dimension == 3)
  {
    EXPECT_EQ(fault(BlockShape::Hull, cloud, 3, 5, 2), "");
    EXPECT_EQ(fault(BlockShape::Hull, cloud, 1, 4, 1), "");
    return;
  }
  EXPECT_EQ(fault(BlockShape::RegularTriangulation, cloud, 3, 5, 1), "");
  EXPECT_EQ(fault(BlockShape::Delaunay, cloud, 1, 4, 2), "");
}

INSTANTIATE_TEST_SUITE_P(Hulls, StreamedRun, ::testing::ValuesIn(blockInputs(convexHulls)));
INSTANTIATE_TEST_SUITE_P(
  Triangulations, StreamedRun, ::testing::ValuesIn(blockInputs(regularTriangulations)));

TEST(StreamedRunOfMany, IsOneRun)
{
  const Cloud cloud = randomSites(100000, 0.0001, 1);
  EXPECT_EQ(fault(BlockShape::RegularTriangulation, cloud, 10, 16, 2), "");
  EXPECT_EQ(fault(BlockShape::Delaunay, cloud, 100, 7, 1), "");
}

TEST(StreamedRunOfNothing, HasNoCells)
{
  EXPECT_EQ(fault(BlockShape::Delaunay, {}, 0, 1, 1), "");
  EXPECT_EQ(fault(BlockShape::Hull, {}, 5, 1, 1), "");
}

}

}
}
