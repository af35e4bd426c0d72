// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A convex polyhedron to hold tests of points against.
#ifndef flipflop_testing_Solid_h
#define flipflop_testing_Solid_h

#include "Mesh/Polyhedron.h"
#include "Points/CoordinateRange.h"
#include "Surface/Topology.h"
#include "Testing/Engine/Conformance/Compare.h"
#include <flipflop/ConvexHull.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace test
{

/// A convex polyhedron, the hull of a cloud.
struct Solid
{
  Polyhedron polyhedron;
  CoordinateRange range{};
};

inline Solid solidOf(const Cloud& cloud)
{
  const Hull hull = convexHull(viewOf(cloud));
  EXPECT_EQ(hull.dimension, 3);
  Solid solid{ Polyhedron(hull.pointIds.size(), hull.connectivity.size() / 3), {} };
  for (int i = 0; i < 3; ++i)
  {
    solid.range.low[i] = solid.range.smallest[i] = HUGE_VAL;
    solid.range.high[i] = -HUGE_VAL;
  }
  for (std::size_t v = 0; v < hull.pointIds.size(); ++v)
  {
    Vertex& vertex = solid.polyhedron.vertices[v];
    vertex.id = static_cast<std::uint32_t>(hull.pointIds[v]);
    vertex.flags = VertexAlive;
    for (int i = 0; i < 3; ++i)
    {
      const double x = vertex.x[i] = cloud[vertex.id][static_cast<std::size_t>(i)];
      solid.range.low[i] = std::min(solid.range.low[i], x);
      solid.range.high[i] = std::max(solid.range.high[i], x);
      solid.range.smallest[i] = std::min(solid.range.smallest[i], x != 0 ? std::fabs(x) : HUGE_VAL);
    }
  }
  for (std::uint32_t t = 0; t < solid.polyhedron.triangleCount(); ++t)
  {
    Triangle& triangle = solid.polyhedron.triangles[t];
    for (std::uint32_t k = 0; k < 3; ++k)
    {
      triangle.v[k] = static_cast<std::uint32_t>(hull.connectivity[3 * t + k]);
    }
    triangle.flags = triangle.flatEdges = 0;
  }
  EXPECT_FALSE(linkTriangles(solid.polyhedron.triangles.data(), solid.polyhedron.triangleCount(),
    solid.polyhedron.vertexCount())
                 .any);
  return solid;
}

}
}

#endif
