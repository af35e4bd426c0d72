// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Alpha complexes are CGAL's alpha shapes: the triangles, and the edges and points beside them.
#include "Testing/Engine/Query/PlaneQueries.h"
#include "Testing/Engine/References/ReferenceAlpha.h"

#include <flipflop/AlphaComplex.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace flipflop
{
namespace test
{

namespace
{

ReferenceAlpha alphaOf(const Cloud& sites, double alpha)
{
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const AlphaComplex complex =
    alphaComplex(viewOf(sites), weightsOf(sites), triangulation, alpha, true);
  const std::vector<Cell> cells = cellsOf(triangulation);
  const auto id = [&](std::int64_t v) { return triangulation.pointIds[v]; };
  ReferenceAlpha result;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    if (complex.cells[c])
    {
      result.triangles.push_back(cells[c]);
      std::sort(result.triangles.back().begin(), result.triangles.back().end());
    }
  }
  for (std::size_t i = 0; i < complex.edges.size(); i += 2)
  {
    result.edges.push_back({ id(complex.edges[i]), id(complex.edges[i + 1]) });
  }
  for (const std::int64_t v : complex.vertices)
  {
    result.vertices.push_back({ id(v) });
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  return result;
}

TEST(AlphaByCgal, AgreesOnRandomSites)
{
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t vertices = 0;
  for (const double weight : { 0.0, 1e-3, 1e-2 })
  {
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
    {
      const Cloud sites = randomSites(seed < 4 ? 12 : 300, weight, seed);
      for (const double alpha : { 0.0, 0.01, 0.02, 0.03, 0.05, 0.1, 0.3, 1.0, 1e3 })
      {
        const ReferenceAlpha found = alphaOf(sites, alpha);
        const ReferenceAlpha expected = cgalAlpha(sites, alpha);
        ASSERT_EQ(found.triangles, expected.triangles) << weight << " " << seed << " " << alpha;
        ASSERT_EQ(found.edges, expected.edges) << weight << " " << seed << " " << alpha;
        triangles += found.triangles.size();
        edges += found.edges.size();
        if (weight == 0.0) // CGAL's points enter at 0, whatever they weigh
        {
          ASSERT_EQ(found.vertices, expected.vertices) << weight << " " << seed << " " << alpha;
          vertices += found.vertices.size();
        }
      }
    }
  }
  EXPECT_GT(triangles, 1000u);
  EXPECT_GT(edges, 1000u);
  EXPECT_GT(vertices, 1000u);
}

}
}
}
