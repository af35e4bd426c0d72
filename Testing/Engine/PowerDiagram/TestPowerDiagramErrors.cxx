// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Power diagrams of boxes that are none, or of another's triangulation, are refused.
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Validate/TriangulationClaims.h"
#include <flipflop/PowerDiagram.h>
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

void expectError(ErrorCode code, const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const double* box)
{
  test::expectError([&] { powerDiagram(points, weights, triangulation, box); }, code);
}

TEST(PowerDiagramErrors, BadArguments)
{
  const ErrorCode bad = ErrorCode::BadArgument;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Cloud sites = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  const PointView points = viewOf(sites);
  const WeightView weights = weightsOf(sites);
  const auto triangulationOf = [&](int dimension, const std::vector<Cell>& cells)
  { return claim(sites, dimension, cells); };
  const Triangulation good = triangulationOf(2, { { 0, 1, 2, 3 } });
  const double box[] = { 0, 1, 0, 1 };
  EXPECT_EQ(powerDiagram(points, weights, good, box).siteIds.size(), 4u);
  EXPECT_EQ(powerDiagram(points, WeightView(), good, box).siteIds.size(), 4u);

  expectError(bad, points, weights, good, nullptr);
  for (const std::array<double, 4>& wrong : { std::array<double, 4>{ 1, 0, 0, 1 }, { 0, 0, 0, 1 },
         { 0, 1, 1, 1 }, { nan, 1, 0, 1 }, { 0, 1, 0, infinity }, { -infinity, 1, 0, 1 } })
  {
    expectError(bad, points, weights, good, wrong.data());
  }

  // Triangulations of something else, or of nothing.
  expectError(bad, PointView(sites.data()->data(), 3), WeightView(), good, box);
  expectError(bad, points, weights, triangulationOf(3, { { 0, 1, 2, 3 } }), box);
  expectError(bad, points, weights, triangulationOf(-1, { { 0 } }), box);
  expectError(bad, points, weights, triangulationOf(0, { { 0 }, { 1 } }), box);
  expectError(bad, points, weights, triangulationOf(1, { { 0 } }), box);
  expectError(bad, points, weights, triangulationOf(1, { { 0, 1 }, { 0, 2 }, { 0, 3 } }), box);
  expectError(bad, points, weights, triangulationOf(1, { { 0, 0 }, { 1, 1 } }), box);
  expectError(bad, points, weights, triangulationOf(2, { { 0, 1 } }), box);
  expectError(bad, points, weights, triangulationOf(2, { { 0, 2, 1 } }), box);
  expectError(bad, points, weights, triangulationOf(2, { { 0, 1, 2 }, { 0, 1, 3 } }), box);
  expectError(bad, points, weights, triangulationOf(2, { { 0, 1, 2 }, { 0, 1, 2 } }), box);
  expectError(bad, points, weights, triangulationOf(2, { { 0, 0, 1 } }), box);
  const auto spoilt = [&](auto change)
  {
    Triangulation result = triangulationOf(2, { { 0, 1, 2 }, { 0, 2, 3 } });
    change(result);
    return result;
  };
  expectError(bad, points, weights, spoilt([](Triangulation& t) { t.connectivity[4] = 4; }), box);
  expectError(bad, points, weights, spoilt([](Triangulation& t) { t.connectivity[0] = -1; }), box);
  expectError(bad, points, weights, spoilt([](Triangulation& t) { t.pointIds[3] = 4; }), box);
  expectError(bad, points, weights, spoilt([](Triangulation& t) { t.pointIds[3] = 2; }), box);
  expectError(bad, points, weights, spoilt([](Triangulation& t) { t.offsets[0] = 1; }), box);
  expectError(bad, points, weights, spoilt([](Triangulation& t) { t.offsets[1] = 7; }), box);
  expectError(bad, points, weights, spoilt([](Triangulation& t) { t.offsets[2] = 5; }), box);
  expectError(bad, points, weights, spoilt([](Triangulation& t) { t.cellSize = -1; }), box);
  expectError(bad, points, weights, spoilt([](Triangulation& t) { t.cellSize = 4; }), box);
}

TEST(PowerDiagramErrors, OtherWeights)
{
  // Corners of another diagram than the triangulation's turn cells over.
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Cloud sites(200);
    for (Point& site : sites)
    {
      site = { random.uniform(), random.uniform(), 0 };
    }
    const Triangulation triangulation = regularTriangulation(viewOf(sites), weightsOf(sites));
    for (Point& site : sites)
    {
      site[2] = random.uniform();
    }
    const double box[] = { 0, 1, 0, 1 };
    expectError(ErrorCode::BadArgument, viewOf(sites), weightsOf(sites), triangulation, box);
    const double polygon[] = { 0, 0, 1, 0, 1, 1, 0, 1 };
    test::expectError([&]
      { powerDiagram(viewOf(sites), weightsOf(sites), triangulation, ConvexDomain(polygon, 4)); },
      ErrorCode::BadArgument);
  }
}

}
}
}
