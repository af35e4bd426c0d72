// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Insertion marks the edges at which it met ties, and each flat edge is marked so, or at a
/// triangle without area that has a marked edge.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include "FlipFlop/CpuBuilder.h"
#include "Run/TriangulationRun.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

using Geometry = LiftedGeometry<false>;

/// Has the triangle two corners at one position, and a marked edge?
bool isMarkedStrip(const Mesh& mesh, const Triangle& triangle)
{
  bool isStrip = false;
  for (int e = 0; e < 3; ++e)
  {
    isStrip = isStrip ||
      samePosition(mesh.vertices[triangle.v[e]], mesh.vertices[triangle.v[nextCorner(e)]]);
  }
  return isStrip && (triangle.flags & EdgesTied) != 0;
}

/// The CPU's engine, and a look at every edge of what it built.
class CheckedBuilder : public PolyhedronBuilder<Geometry>
{
public:
  Polyhedron build(const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override
  {
    CpuBuilder<Geometry> engine;
    Polyhedron built = engine.build(task, std::move(start), tally, statistics);
    EXPECT_TRUE(built.tiesMarked);
    const Mesh mesh = built.mesh();
    for (const Piece& piece : built.pieces)
    {
      for (std::uint32_t t = piece.begin; t < piece.end; ++t)
      {
        const Triangle& triangle = mesh.triangles[t];
        for (int e = 0; e < 3 && !(triangle.flags & TriangleDead); ++e)
        {
          const std::uint32_t twin = triangle.twin[e];
          const Triangle& other = mesh.triangles[triangleOf(twin)];
          const bool isFlat = task.geometry.above(mesh.vertices[triangle.v[0]],
                                mesh.vertices[triangle.v[1]], mesh.vertices[triangle.v[2]],
                                mesh.vertices[mesh.origin(previousHalfEdge(twin))]) == 0;
          this->flat += isFlat ? 1 : 0;
          const bool isMarked = (triangle.flags & EdgeTied << e) != 0;
          EXPECT_EQ(isMarked, (other.flags & EdgeTied << cornerOf(twin)) != 0);
          const bool isTold =
            isMarked || isMarkedStrip(mesh, triangle) || isMarkedStrip(mesh, other);
          this->missed += isFlat && !isTold ? 1 : 0;
        }
      }
    }
    return built;
  }

  int flat = 0;
  int missed = 0;
};

TEST(FlatEdges, AreMarked)
{
  int flat = 0;
  for (const Family& family : weightedFamilies())
  {
    for (const int count :
      isSanitized() ? std::vector<int>{ 60, 300 } : std::vector<int>{ 60, 700, 3000 })
    {
      for (const int threads : threadsTried())
      {
        SCOPED_TRACE(family.name + std::string(", ") + std::to_string(count) + " points, " +
          std::to_string(threads) + " threads");
        Random random(7);
        const Cloud cloud = family.make(count, random);
        Options options;
        options.threads = threads;
        CheckedBuilder builder;
        TriangulationRun<false> run(viewOf(cloud), WeightView(), options);
        run.execute<Triangulation>(
          [&](Triangulation& result) { run.triangulate(builder, result); });
        EXPECT_EQ(builder.missed, 0);
        flat += builder.flat;
      }
    }
  }
  EXPECT_GT(flat, 1000);
}

}
}
}
