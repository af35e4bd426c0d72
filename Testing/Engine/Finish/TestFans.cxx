// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The fans of a result's polygons are the triangles that another run gives.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <gtest/gtest.h>

namespace flipflop
{
namespace test
{

namespace
{

constexpr int Count = 700;
constexpr std::uint64_t Seed = 11;

TEST(Fans, AreTheTrianglesOfHulls)
{
  for (const Family& family : families())
  {
    SCOPED_TRACE(family.name);
    const Cloud cloud = fromFamily(family.name, Count, Seed).make();
    Options options;
    const Hull triangles = convexHull(viewOf(cloud), options);
    options.facets = FacetMode::Polygons;
    Hull fans = convexHull(viewOf(cloud), options);
    fanPolygons(fans);
    EXPECT_EQ(bitDifference(fans, triangles), "");
  }
}

TEST(Fans, AreTheTrianglesOfTriangulations)
{
  for (const Family& family : weightedFamilies())
  {
    SCOPED_TRACE(family.name);
    const Cloud cloud = fromWeightedFamily(family.name, Count, Seed).make();
    Options options;
    const Triangulation triangles = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
    options.facets = FacetMode::Polygons;
    Triangulation fans = regularTriangulation(viewOf(cloud), weightsOf(cloud), options);
    fanPolygons(fans);
    EXPECT_EQ(bitDifference(fans, triangles), "");
  }
}

}
}
}
