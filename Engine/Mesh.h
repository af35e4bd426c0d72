// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulated sphere with half-edges, and the two flips on it.
///
/// Half-edge h = 4 * t + e runs from corner e of triangle t to corner e + 1; corner e + 2 is its
/// apex. A triangle is 32 bytes, so that half-edges need shifts only and no triangle straddles a
/// cache line.
///
/// While several threads work on patches of one mesh, a triangle at a patch's border does not name
/// its neighbour but a border slot, which holds the half-edge that is at this place of the border
/// now. So a flip only ever writes to triangles and slots of its own patch.
#ifndef flipflop_Mesh_h
#define flipflop_Mesh_h

#include "Vertex.h"

#include <cstdint>

namespace flipflop
{

struct alignas(32) Triangle
{
  std::uint32_t v[3];    ///< corners, counter-clockwise from outside
  std::uint32_t flags;   ///< TriangleDead, or bit e: half-edge e waits to be checked
  std::uint32_t twin[3]; ///< opposite half-edges, or border slots
  std::uint32_t index;   ///< a new number, or which edges are flat; 0 until then
};

constexpr std::uint32_t TriangleDead = 0x80000000u;

constexpr int nextCorner(int e)
{
  return e == 2 ? 0 : e + 1;
}
constexpr int previousCorner(int e)
{
  return e == 0 ? 2 : e - 1;
}
constexpr std::uint32_t halfEdge(std::uint32_t triangle, int e)
{
  return triangle << 2 | static_cast<std::uint32_t>(e);
}
constexpr std::uint32_t triangleOf(std::uint32_t h)
{
  return h >> 2;
}
constexpr int cornerOf(std::uint32_t h)
{
  return static_cast<int>(h & 3);
}
constexpr std::uint32_t nextHalfEdge(std::uint32_t h)
{
  return (h & 3) == 2 ? h - 2 : h + 1;
}
constexpr std::uint32_t previousHalfEdge(std::uint32_t h)
{
  return (h & 3) == 0 ? h + 2 : h - 1;
}

/// The mesh's arrays, owned elsewhere.
struct Mesh
{
  Triangle* triangles = nullptr;
  Vertex* vertices = nullptr;
  std::uint32_t* border = nullptr;     ///< border slots: the half-edge at each
  std::uint32_t borderBegin = NoIndex; ///< twins from here on are border slots

  bool isBorder(std::uint32_t twin) const { return twin >= this->borderBegin; }

  std::uint32_t twin(std::uint32_t h) const { return this->triangles[h >> 2].twin[h & 3]; }
  std::uint32_t origin(std::uint32_t h) const { return this->triangles[h >> 2].v[h & 3]; }

  /// Make h and other (a half-edge or a border slot) each other's opposite.
  void link(std::uint32_t h, std::uint32_t other) const
  {
    this->triangles[h >> 2].twin[h & 3] = other;
    if (this->isBorder(other))
    {
      this->border[other - this->borderBegin] = h;
    }
    else
    {
      this->triangles[other >> 2].twin[other & 3] = h;
    }
  }

  /// Replace the edge ab of h, with the link c, d, by cd. The triangle of h becomes adc, its
  /// opposite dbc.
  /// @return the four outer half-edges: ad, ca, db, bc.
  void flip22(std::uint32_t h, std::uint32_t outer[4]) const
  {
    const std::uint32_t g = this->twin(h);
    const std::uint32_t bc = this->twin(nextHalfEdge(h));
    const std::uint32_t ca = this->twin(previousHalfEdge(h));
    const std::uint32_t ad = this->twin(nextHalfEdge(g));
    const std::uint32_t db = this->twin(previousHalfEdge(g));
    Triangle& first = this->triangles[triangleOf(h)];
    Triangle& second = this->triangles[triangleOf(g)];
    const std::uint32_t a = first.v[cornerOf(h)];
    const std::uint32_t b = second.v[cornerOf(g)];
    const std::uint32_t c = first.v[cornerOf(previousHalfEdge(h))];
    const std::uint32_t d = second.v[cornerOf(previousHalfEdge(g))];
    const std::uint32_t s = triangleOf(h);
    const std::uint32_t t = triangleOf(g);
    setCorners(first, a, d, c);
    setCorners(second, d, b, c);
    outer[0] = halfEdge(s, 0);
    outer[1] = halfEdge(s, 2);
    outer[2] = halfEdge(t, 0);
    outer[3] = halfEdge(t, 1);
    this->link(outer[0], ad);
    this->link(outer[1], ca);
    this->link(outer[2], db);
    this->link(outer[3], bc);
    this->link(halfEdge(s, 1), halfEdge(t, 2));
  }

  /// Remove the origin a of h, which has three triangles: abc (of h), adb and acd become dbc, in
  /// the triangle of h.
  /// @return the three half-edges: db, bc, cd.
  void flip31(std::uint32_t h, std::uint32_t outer[3]) const
  {
    const std::uint32_t g = this->twin(h);                   // ba of bad
    const std::uint32_t k = this->twin(previousHalfEdge(h)); // ac of acd
    const std::uint32_t bc = this->twin(nextHalfEdge(h));
    const std::uint32_t db = this->twin(previousHalfEdge(g));
    const std::uint32_t cd = this->twin(nextHalfEdge(k));
    const std::uint32_t s = triangleOf(h);
    Triangle& first = this->triangles[s];
    Triangle& second = this->triangles[triangleOf(g)];
    Triangle& third = this->triangles[triangleOf(k)];
    const std::uint32_t a = first.v[cornerOf(h)];
    const std::uint32_t b = second.v[cornerOf(g)];
    const std::uint32_t c = first.v[cornerOf(previousHalfEdge(h))];
    const std::uint32_t d = second.v[cornerOf(previousHalfEdge(g))];
    this->vertices[a].flags = 0;
    second.flags = TriangleDead;
    third.flags = TriangleDead;
    setCorners(first, d, b, c);
    outer[0] = halfEdge(s, 0);
    outer[1] = halfEdge(s, 1);
    outer[2] = halfEdge(s, 2);
    this->link(outer[0], db);
    this->link(outer[1], bc);
    this->link(outer[2], cd);
  }

private:
  static void setCorners(Triangle& t, std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    t.v[0] = a;
    t.v[1] = b;
    t.v[2] = c;
    t.flags = 0;
  }
};

}

#endif
