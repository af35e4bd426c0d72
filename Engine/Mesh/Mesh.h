// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulated sphere with half-edges, and the two flips on it. A flip is a plan first: one
/// thread carries it out at once (flip), many in rounds of their own (Cuda/Rounds/FlipKernels.h).
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

#include "Points/Vertex.h"
#include "Support/HostDevice.h"

#include <cstdint>
#include <initializer_list>

namespace flipflop
{

struct alignas(32) Triangle
{
  std::uint32_t v[3];      ///< corners, counter-clockwise from outside
  std::uint32_t flags;     ///< TriangleDead; or bit e: half-edge e waits; EdgeTied, EdgeFixed
  std::uint32_t twin[3];   ///< opposite half-edges, or border slots
  std::uint32_t flatEdges; ///< in the finish, bit e: the edge e is exactly flat; before, 0
};

constexpr std::uint32_t TriangleDead = 0x80000000u;

/// Shifted by e: the edge e was found flat when it was tested. Both its half-edges are marked.
constexpr std::uint32_t EdgeTied = 8;
constexpr std::uint32_t EdgesTied = 7 * EdgeTied;

/// Shifted by e: the edge e is a part of a constraint, and is never flipped. Both its half-edges
/// are marked.
constexpr std::uint32_t EdgeFixed = 64;

FF_HD constexpr int nextCorner(int e)
{
  return e == 2 ? 0 : e + 1;
}
FF_HD constexpr int previousCorner(int e)
{
  return e == 0 ? 2 : e - 1;
}
FF_HD constexpr std::uint32_t halfEdge(std::uint32_t triangle, int e)
{
  return triangle << 2 | static_cast<std::uint32_t>(e);
}
FF_HD constexpr std::uint32_t triangleOf(std::uint32_t h)
{
  return h >> 2;
}
FF_HD constexpr int cornerOf(std::uint32_t h)
{
  return static_cast<int>(h & 3);
}
FF_HD constexpr std::uint32_t nextHalfEdge(std::uint32_t h)
{
  return (h & 3) == 2 ? h - 2 : h + 1;
}
FF_HD constexpr std::uint32_t previousHalfEdge(std::uint32_t h)
{
  return (h & 3) == 0 ? h + 2 : h - 1;
}

inline void setTwin(Triangle* triangles, std::uint32_t h, std::uint32_t twin)
{
  triangles[triangleOf(h)].twin[cornerOf(h)] = twin;
}

/// The mesh's arrays, owned elsewhere.
struct Mesh
{
  Triangle* triangles = nullptr;
  Vertex* vertices = nullptr;
  std::uint32_t* border = nullptr;     ///< border slots: the half-edge at each
  std::uint32_t borderBegin = NoIndex; ///< twins from here on are border slots

  FF_HD bool isBorder(std::uint32_t twin) const { return twin >= this->borderBegin; }

  FF_HD std::uint32_t twin(std::uint32_t h) const { return this->triangles[h >> 2].twin[h & 3]; }
  FF_HD std::uint32_t origin(std::uint32_t h) const { return this->triangles[h >> 2].v[h & 3]; }

  const Vertex& vertex(std::uint32_t v) const { return this->vertices[v]; }

  /// A triangle with these corners, without marks. Its opposites are left as they are.
  void setTriangle(std::uint32_t t, std::uint32_t a, std::uint32_t b, std::uint32_t c) const
  {
    Triangle& triangle = this->triangles[t];
    triangle.v[0] = a;
    triangle.v[1] = b;
    triangle.v[2] = c;
    triangle.flags = 0;
    triangle.flatEdges = 0;
  }

  void removeTriangle(std::uint32_t t) const { this->triangles[t].flags = TriangleDead; }
  bool isDead(std::uint32_t t) const { return (this->triangles[t].flags & TriangleDead) != 0; }

  /// Bit e: the edge e is marked EdgeTied. To set them ends all waiting.
  std::uint32_t marks(std::uint32_t t) const
  {
    return (this->triangles[t].flags & EdgesTied) / EdgeTied;
  }
  void setMarks(std::uint32_t t, std::uint32_t edges) const
  {
    this->triangles[t].flags = edges * EdgeTied;
  }

  /// Mark the edge of h, on both sides.
  void markTied(std::uint32_t h) const
  {
    const std::uint32_t other = this->twin(h);
    this->triangles[triangleOf(h)].flags |= EdgeTied << cornerOf(h);
    this->triangles[triangleOf(other)].flags |= EdgeTied << cornerOf(other);
  }

  bool isFixed(std::uint32_t h) const
  {
    return (this->triangles[triangleOf(h)].flags >> cornerOf(h) & EdgeFixed) != 0;
  }

  ///@{
  /// In the finish: is the edge of h exactly flat? Marked on both sides.
  bool isFlat(std::uint32_t h) const
  {
    return (this->triangles[triangleOf(h)].flatEdges >> cornerOf(h) & 1) != 0;
  }
  void setFlat(std::uint32_t h, bool flat = true) const
  {
    for (const std::uint32_t side : { h, this->twin(h) })
    {
      std::uint32_t& edges = this->triangles[triangleOf(side)].flatEdges;
      const std::uint32_t edge = 1u << cornerOf(side);
      edges = flat ? edges | edge : edges & ~edge;
    }
  }
  ///@}

  /// Make h and other (a half-edge or a border slot) each other's opposite.
  FF_INLINE void link(std::uint32_t h, std::uint32_t other) const
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
};

/// What a flip does, derived from the mesh before it: which triangles are replaced, by which, and
/// where their outer half-edges go.
struct FlipPlan
{
  int outerCount;              ///< 4, or 3 for a 3-1 flip
  std::uint32_t from[4];       ///< the outer half-edges as they are
  std::uint32_t to[4];         ///< and as they will be
  int triangleCount;           ///< as many as there are: 2, or 3 for a 3-1 flip
  std::uint32_t triangle[3];   ///< the first, for a 2-2 flip the second too, stay
  std::uint32_t corners[2][3]; ///< of those that stay
  std::uint32_t removed;       ///< the vertex that goes in a 3-1 flip; NoIndex
};

/// The flip of the edge ab of h, with the link c, d, to cd. The triangle of h becomes adc, its
/// opposite dbc; the outer half-edges are ad, ca, db, bc.
FF_HD FF_INLINE FlipPlan planFlip22(const Mesh& mesh, std::uint32_t h)
{
  const std::uint32_t g = mesh.twin(h);
  const std::uint32_t s = triangleOf(h);
  const std::uint32_t t = triangleOf(g);
  const std::uint32_t a = mesh.origin(h);
  const std::uint32_t b = mesh.origin(g);
  const std::uint32_t c = mesh.origin(previousHalfEdge(h));
  const std::uint32_t d = mesh.origin(previousHalfEdge(g));
  return { 4, { nextHalfEdge(g), previousHalfEdge(h), previousHalfEdge(g), nextHalfEdge(h) },
    { halfEdge(s, 0), halfEdge(s, 2), halfEdge(t, 0), halfEdge(t, 1) }, 2, { s, t, NoIndex },
    { { a, d, c }, { d, b, c } }, NoIndex };
}

/// The removal of the origin a of h, which has three triangles: abc (of h), bad and acd become dbc,
/// in the triangle of h; the outer half-edges are db, bc, cd.
FF_HD FF_INLINE FlipPlan planFlip31(const Mesh& mesh, std::uint32_t h)
{
  const std::uint32_t g = mesh.twin(h);                   // ba of bad
  const std::uint32_t k = mesh.twin(previousHalfEdge(h)); // ac of acd
  const std::uint32_t s = triangleOf(h);
  const std::uint32_t b = mesh.origin(g);
  const std::uint32_t c = mesh.origin(previousHalfEdge(h));
  const std::uint32_t d = mesh.origin(previousHalfEdge(g));
  return { 3, { previousHalfEdge(g), nextHalfEdge(h), nextHalfEdge(k), NoIndex },
    { halfEdge(s, 0), halfEdge(s, 1), halfEdge(s, 2), NoIndex }, 3,
    { s, triangleOf(g), triangleOf(k) }, { { d, b, c }, { NoIndex, NoIndex, NoIndex } },
    mesh.origin(h) };
}

/// Write the plan's triangles, but for the opposites of its outer half-edges.
FF_HD FF_INLINE void replaceTriangles(const Mesh& mesh, const FlipPlan& plan)
{
  const int staying = plan.outerCount == 4 ? 2 : 1;
  for (int i = 0; i < 2; ++i)
  {
    if (i < staying)
    {
      Triangle& triangle = mesh.triangles[plan.triangle[i]];
      triangle.v[0] = plan.corners[i][0];
      triangle.v[1] = plan.corners[i][1];
      triangle.v[2] = plan.corners[i][2];
      triangle.flags = 0;
    }
  }
  if (staying == 2)
  {
    mesh.triangles[plan.triangle[0]].twin[1] = halfEdge(plan.triangle[1], 2);
    mesh.triangles[plan.triangle[1]].twin[2] = halfEdge(plan.triangle[0], 1);
    return;
  }
  mesh.vertices[plan.removed].flags = 0;
  mesh.triangles[plan.triangle[1]].flags = TriangleDead;
  mesh.triangles[plan.triangle[2]].flags = TriangleDead;
}

/// Flip at once: for one thread in a patch of its own. The outer edges keep their marks.
FF_INLINE void flip(const Mesh& mesh, const FlipPlan& plan)
{
  std::uint32_t other[4];
  std::uint32_t marks[4];
  std::uint32_t anyMark = 0;
  for (int i = 0; i < plan.outerCount; ++i)
  {
    const Triangle& triangle = mesh.triangles[triangleOf(plan.from[i])];
    other[i] = triangle.twin[cornerOf(plan.from[i])];
    marks[i] = triangle.flags >> cornerOf(plan.from[i]) & (EdgeTied | EdgeFixed);
    anyMark |= marks[i];
  }
  replaceTriangles(mesh, plan);
  for (int i = 0; i < plan.outerCount; ++i)
  {
    mesh.link(plan.to[i], other[i]);
  }
  for (int i = 0; anyMark && i < plan.outerCount; ++i)
  {
    mesh.triangles[triangleOf(plan.to[i])].flags |= marks[i] << cornerOf(plan.to[i]);
  }
}

/// Split the triangle abc of @p child[0] by the vertex v into abv, bcv and cav: child[0], [1], [2].
/// Its edges keep their marks.
/// @tparam AnyMesh Mesh, or PlaneMesh
template <class AnyMesh>
inline void splitTriangle(const AnyMesh& mesh, const std::uint32_t* child, std::uint32_t v)
{
  const auto parent = mesh.triangles[child[0]];
  const std::uint32_t marks = mesh.marks(child[0]);
  for (int i = 0; i < 3; ++i)
  {
    mesh.setTriangle(child[i], parent.v[i], parent.v[nextCorner(i)], v);
    mesh.setMarks(child[i], marks >> i & 1);
    mesh.triangles[child[i]].twin[1] = halfEdge(child[nextCorner(i)], 2);
    mesh.triangles[child[i]].twin[2] = halfEdge(child[previousCorner(i)], 1);
  }
  for (int i = 0; i < 3; ++i)
  {
    mesh.link(halfEdge(child[i], 0), parent.twin[i]);
  }
}

/// An edge and what is around it: the half-edge h runs from a to b, its triangle is abc, its
/// opposite's bad.
struct EdgeSurroundings
{
  std::uint32_t twin;
  std::uint32_t a, b, c, d;
  bool threeAtA; ///< three triangles in all are around a
  bool threeAtB;
};

FF_HD FF_INLINE EdgeSurroundings surroundingsOf(const Mesh& mesh, std::uint32_t h)
{
  const Triangle& first = mesh.triangles[triangleOf(h)];
  const int e = cornerOf(h);
  const std::uint32_t twin = first.twin[e];
  const Triangle& second = mesh.triangles[triangleOf(twin)];
  const int g = cornerOf(twin);
  const std::uint32_t ac = first.twin[previousCorner(e)];
  const std::uint32_t cb = first.twin[nextCorner(e)];
  const std::uint32_t da = second.twin[nextCorner(g)];
  const std::uint32_t bd = second.twin[previousCorner(g)];
  // Triangles at a border are in different patches, hence never the same one.
  const bool threeAtA =
    triangleOf(ac) == triangleOf(da) && !mesh.isBorder(ac) && !mesh.isBorder(da);
  const bool threeAtB =
    triangleOf(cb) == triangleOf(bd) && !mesh.isBorder(cb) && !mesh.isBorder(bd);
  return { twin, first.v[e], first.v[nextCorner(e)], first.v[previousCorner(e)],
    second.v[previousCorner(g)], threeAtA, threeAtB };
}

}

#endif
