// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The finish in the executor's memory: where it is taken, and that its result is the CPU engine's.
#include "Testing/Cuda/Rounds/RoundsOnHost.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace flipflop
{
namespace test
{

namespace
{

bool finishedThere(const WatchedExecutor& executor)
{
  const auto& launches = executor.tallies();
  EXPECT_NE(launches.count("write cells"), launches.count("gather triangles"));
  return launches.count("write cells") != 0;
}

/// @return whether the cells were written in the executor's memory
bool hullIsTheSame(const Cloud& cloud, const Options& options)
{
  WatchedExecutor executor(HostExecutor::Order::Shuffled, 5);
  const Hull found = hullByRounds(executor, viewOf(cloud), options);
  EXPECT_EQ(bitDifference(found, convexHull(viewOf(cloud), options)), "");
  EXPECT_EQ(executor.bytesOut(), 0);
  return finishedThere(executor);
}

bool triangulationIsTheSame(const Cloud& cloud, const Options& options)
{
  WatchedExecutor executor(HostExecutor::Order::Shuffled, 5);
  const Triangulation found =
    triangulationByRounds(executor, viewOf(cloud), weightsOf(cloud), options);
  const Triangulation wanted = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
  EXPECT_EQ(bitDifference(found, wanted), "");
  EXPECT_TRUE(sameBits(found.hiddenIds, wanted.hiddenIds));
  return finishedThere(executor);
}

}

TEST(CellWriter, WritesWhereNoSignIsATie)
{
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Options options;
    options.facets = facets;
    for (const char* family : { "ball", "shell0", "cube", "skewNeedle" })
    {
      SCOPED_TRACE(family);
      EXPECT_TRUE(hullIsTheSame(fromFamily(family, 3000, 17).make(), options));
    }
    for (const char* family : { "uniform", "uniformHeavy", "uniformHiding", "clusters" })
    {
      SCOPED_TRACE(family);
      EXPECT_TRUE(triangulationIsTheSame(fromWeightedFamily(family, 3000, 17).make(), options));
    }
  }
}

TEST(CellWriter, LeavesTiesToTheHost)
{
  for (const char* family : { "smallIntegers", "boxFaces", "coplanarAndOutlier" })
  {
    SCOPED_TRACE(family);
    EXPECT_FALSE(hullIsTheSame(fromFamily(family, 1000, 18).make(), Options()));
  }
  for (const char* family : { "grid", "coplanarLifts" })
  {
    SCOPED_TRACE(family);
    EXPECT_FALSE(triangulationIsTheSame(fromWeightedFamily(family, 400, 18).make(), Options()));
  }
}

TEST(CellWriter, KnowsTheLowestIdOfAPosition)
{
  // A later copy of a point becomes the vertex where its cone's furthest key says so, or is dropped
  // at it: either way the lowest id stands for all.
  Cloud cloud = fromFamily("shell0", 2000, 19).make();
  const Cloud once = cloud;
  cloud.insert(cloud.end(), once.rbegin(), once.rend());
  EXPECT_TRUE(hullIsTheSame(cloud, Options()));
  std::rotate(cloud.begin(), cloud.begin() + 700, cloud.end());
  EXPECT_TRUE(hullIsTheSame(cloud, Options()));
}

TEST(CellWriter, FewPointsOfVeryMany)
{
  // Four corners, far apart in the input, are all of the result.
  Cloud cloud = fromFamily("ball", 60000, 20).make();
  cloud[7] = { 900, 0, 0 };
  cloud[20001] = { -500, 800, 1 };
  cloud[40002] = { -500, -800, 2 };
  cloud[59999] = { 3, 5, 900 };
  cloud[31] = { 1, 2, -900 };
  EXPECT_TRUE(hullIsTheSame(cloud, Options()));
}

}
}
