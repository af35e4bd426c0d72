// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The mesh of a triangulation in the plane without weights, in less memory than Mesh.h: vertices
/// and triangles of 24 bytes, and a byte of marks for each triangle, which only ties make use of.
/// Fresh pages have to be cleared, and caches are small: each byte less is time.
///
/// What algorithms need of it is the same as of Mesh, but for borders, which it has not.
#ifndef flipflop_PlaneMesh_h
#define flipflop_PlaneMesh_h

#include "Mesh/Mesh.h"
#include "Points/Vertex.h"

#include <cstdint>

namespace flipflop
{

struct PlaneVertex
{
  double x[2];         ///< NaN for the virtual vertex
  std::uint32_t id;    ///< position in the input, the lowest of all points here
  std::uint32_t flags; ///< VertexFlags

  /// As the predicates take it.
  Vertex full() const { return { { this->x[0], this->x[1], 0.0 }, this->id, this->flags }; }
};

inline PlaneVertex withoutWeight(const Vertex& vertex)
{
  return { { vertex.x[0], vertex.x[1] }, vertex.id, vertex.flags };
}

inline bool samePosition(const PlaneVertex& a, const PlaneVertex& b)
{
  return a.x[0] == b.x[0] && a.x[1] == b.x[1];
}

struct PlaneTriangle
{
  std::uint32_t v[3];    ///< corners, counter-clockwise from outside; the first is NoIndex: dead
  std::uint32_t twin[3]; ///< opposite half-edges

  bool isDead() const { return this->v[0] == NoIndex; }
};

/// The mesh's arrays, owned elsewhere.
struct PlaneMesh
{
  PlaneTriangle* triangles = nullptr;
  PlaneVertex* vertices = nullptr;
  std::uint8_t* ties = nullptr; ///< of each triangle, bit e: the edge e is flat

  Vertex vertex(std::uint32_t v) const { return this->vertices[v].full(); }
  std::uint32_t twin(std::uint32_t h) const { return this->triangles[h >> 2].twin[h & 3]; }
  std::uint32_t origin(std::uint32_t h) const { return this->triangles[h >> 2].v[h & 3]; }

  /// Make two half-edges each other's opposite.
  FF_INLINE void link(std::uint32_t h, std::uint32_t other) const
  {
    this->triangles[h >> 2].twin[h & 3] = other;
    this->triangles[other >> 2].twin[other & 3] = h;
  }

  /// A triangle with these corners, without marks. Its opposites are left as they are.
  void setTriangle(std::uint32_t t, std::uint32_t a, std::uint32_t b, std::uint32_t c) const
  {
    this->triangles[t].v[0] = a;
    this->triangles[t].v[1] = b;
    this->triangles[t].v[2] = c;
    this->ties[t] = 0;
  }

  void removeTriangle(std::uint32_t t) const
  {
    this->triangles[t].v[0] = NoIndex;
    this->ties[t] = 0;
  }
  bool isDead(std::uint32_t t) const { return this->triangles[t].isDead(); }

  /// Bit e: the edge e is marked.
  std::uint32_t marks(std::uint32_t t) const { return this->ties[t]; }
  void setMarks(std::uint32_t t, std::uint32_t edges) const
  {
    this->ties[t] = static_cast<std::uint8_t>(edges);
  }

  /// Mark the edge of h, on both sides.
  void markTied(std::uint32_t h) const
  {
    const std::uint32_t other = this->twin(h);
    this->setMarks(triangleOf(h), this->marks(triangleOf(h)) | 1u << cornerOf(h));
    this->setMarks(triangleOf(other), this->marks(triangleOf(other)) | 1u << cornerOf(other));
  }
};

}

#endif
