// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A star-shaped polyhedron at rest: compact, no borders, nothing dead.
#ifndef flipflop_Polyhedron_h
#define flipflop_Polyhedron_h

#include "Buffer.h"
#include "Mesh.h"

namespace flipflop
{

struct Polyhedron
{
  Buffer<Vertex> vertices;
  Buffer<Triangle> triangles;

  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(this->vertices.size()); }
  std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(this->triangles.size()); }

  Mesh mesh()
  {
    Mesh result;
    result.triangles = this->triangles.data();
    result.vertices = this->vertices.data();
    return result;
  }
};

}

#endif
