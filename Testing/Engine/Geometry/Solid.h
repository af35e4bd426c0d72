// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A polyhedron as the engine has it inside, of plain points and triangles.
#ifndef flipflop_testing_Solid_h
#define flipflop_testing_Solid_h

#include "Mesh/Polyhedron.h"
#include "Points/CoordinateRange.h"
#include "Surface/Topology.h"
#include "Testing/Engine/Inputs/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace test
{

struct Solid
{
  Polyhedron polyhedron;
  CoordinateRange range{};
};

inline Solid solidOf(const Surface& surface)
{
  Solid solid{ Polyhedron(surface.points.size(), surface.triangles.size()),
    CoordinateRange::empty() };
  Buffer<Vertex>& vertices = solid.polyhedron.vertices;
  for (std::size_t v = 0; v < surface.points.size(); ++v)
  {
    vertices[v].id = static_cast<std::uint32_t>(v);
    vertices[v].flags = VertexAlive;
    std::copy(surface.points[v].begin(), surface.points[v].end(), vertices[v].x);
  }
  for (const Point& p : surface.points)
  {
    solid.range.add(p.data());
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    Triangle& triangle = solid.polyhedron.triangles[t];
    std::copy(surface.triangles[t].begin(), surface.triangles[t].end(), triangle.v);
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
