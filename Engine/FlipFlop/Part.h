// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A part of the points, triangulated: what its neighbours need to know of it, and the way around
/// its border.
///
/// In the plane, virtual triangles join the border's edges to the virtual vertex, so the
/// triangulation is a closed mesh. In space, a part is the hull of its points and of the kernel
/// point, which is the virtual vertex: all of the part lies on one side of a plane through it.
/// Seen from there, the other triangles are a triangulation, with a convex border, as in the plane:
/// the orientation of three points is the side of the plane through the kernel point and two of
/// them on which the third is, and the circle test is the side of the plane through three.
///
/// The triangulation of m points is in 2 m slots of triangles, of which two at least are free.
/// In the plane without weights, it is a Delaunay triangulation by exact signs without
/// perturbation: no triangle has zero area, and every point on the border is a vertex of it. Of
/// collinear points, the virtual triangles are on both sides of the edges between them; one point
/// has none.
///
/// With weights and in space, it is the one by perturbed signs, in which no three points are
/// collinear. Hidden points are in the part's range, but not alive, nor are their triangles.
#ifndef flipflop_Part_h
#define flipflop_Part_h

#include "Mesh/PlaneMesh.h"

#include <cstdint>
#include <type_traits>
#include <utility>

namespace flipflop
{

/// What parts are triangulated in.
template <class Geometry>
using PartMesh = std::conditional_t<Geometry::AllExtreme, PlaneMesh, Mesh>;
template <class Geometry>
using PartVertex = std::conditional_t<Geometry::AllExtreme, PlaneVertex, Vertex>;

/// The slot of the virtual vertex in the array: before all points.
constexpr std::uint32_t VirtualSlot = 0;

/// A part's triangles begin here, if its vertices begin there.
constexpr std::uint32_t firstTriangleOf(std::uint32_t firstVertex)
{
  return 2 * (firstVertex - 1);
}

/// The directions in which a part of the plane keeps its farthest vertex. Of several, the one with
/// the least other coordinate.
enum PlaneSide
{
  LeastX,
  MostX,
  LeastY,
  MostY
};

struct Part
{
  /// By side, in space of any: the farthest vertex, and the half-edge from the virtual vertex to it
  /// in the virtual triangle whose edge begins there, clockwise around the part; NoIndex of a
  /// single point.
  std::uint32_t vertex[4] = { NoIndex, NoIndex, NoIndex, NoIndex };
  std::uint32_t spoke[4] = { NoIndex, NoIndex, NoIndex, NoIndex };
  std::uint32_t firstFree = 0; ///< this triangle and the next are free

  bool isSingle() const { return this->spoke[0] == NoIndex; }
};

/// Around a part's border, clockwise: by half-edges from the virtual vertex to a border vertex, in
/// the virtual triangle of the border edge that begins there.
/// @tparam AnyMesh a PartMesh
template <class AnyMesh>
class BorderRing
{
public:
  explicit BorderRing(const AnyMesh& meshToWalk)
    : mesh(meshToWalk)
  {
  }

  std::uint32_t begin(std::uint32_t spoke) const { return this->mesh.origin(nextHalfEdge(spoke)); }
  std::uint32_t end(std::uint32_t spoke) const
  {
    return this->mesh.origin(previousHalfEdge(spoke));
  }
  std::uint32_t next(std::uint32_t spoke) const { return this->mesh.twin(previousHalfEdge(spoke)); }
  std::uint32_t previous(std::uint32_t spoke) const { return nextHalfEdge(this->mesh.twin(spoke)); }

private:
  const AnyMesh mesh;
};

/// Is p, of the plane, farther than q to a side? With weights, as the perturbation moves them: the
/// lower id most.
template <class Geometry>
bool isFarther(int side, const PartVertex<Geometry>& p, const PartVertex<Geometry>& q)
{
  const int axis = side / 2;
  const bool isMost = side % 2 == 1;
  if (p.x[axis] != q.x[axis])
  {
    return isMost == (p.x[axis] > q.x[axis]);
  }
  return Geometry::AllExtreme ? p.x[1 - axis] < q.x[1 - axis] : isMost == (p.id < q.id);
}

/// Make the first triangle of a part, of its first vertices that are not collinear, and the three
/// virtual ones. These vertices come to the front.
/// @param geometry its kernel point is the virtual vertex
/// @return false: there are none
template <class AnyMesh, class Geometry>
bool startPart(
  const AnyMesh& mesh, std::uint32_t begin, std::uint32_t end, const Geometry& geometry)
{
  auto* const v = mesh.vertices;
  const auto orient = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
  { return geometry.orient(mesh.vertex(a), mesh.vertex(b), mesh.vertex(c)); };
  std::uint32_t second = begin + 1;
  while (second < end && geometry.sameDirection(mesh.vertex(begin), mesh.vertex(second)))
  {
    ++second;
  }
  std::uint32_t third = second + 1;
  while (third < end && orient(begin, second, third) == 0)
  {
    ++third;
  }
  if (third >= end)
  {
    return false;
  }
  std::swap(v[begin + 1], v[second]);
  std::swap(v[begin + 2], v[third]);
  if (orient(begin, begin + 1, begin + 2) < 0)
  {
    std::swap(v[begin + 1], v[begin + 2]);
  }
  const std::uint32_t inner = firstTriangleOf(begin);
  const auto vertexOf = [begin](int i) { return begin + static_cast<std::uint32_t>(i); };
  const auto outerOf = [inner](int side) { return inner + 1 + static_cast<std::uint32_t>(side); };
  mesh.setTriangle(inner, vertexOf(0), vertexOf(1), vertexOf(2));
  for (int i = 0; i < 3; ++i)
  {
    mesh.setTriangle(outerOf(i), vertexOf(nextCorner(i)), vertexOf(i), VirtualSlot);
    mesh.link(halfEdge(inner, i), halfEdge(outerOf(i), 0));
    mesh.vertices[vertexOf(i)].flags = VertexAlive;
  }
  for (int i = 0; i < 3; ++i)
  {
    mesh.link(halfEdge(outerOf(i), 1), halfEdge(outerOf(previousCorner(i)), 2));
  }
  return true;
}

/// The first half-edge from the virtual vertex, of the triangles from @p first on.
template <class AnyMesh>
std::uint32_t anySpoke(const AnyMesh& mesh, std::uint32_t first)
{
  std::uint32_t spoke = halfEdge(first, 0);
  while (mesh.origin(spoke) != VirtualSlot || mesh.isDead(triangleOf(spoke)))
  {
    spoke = cornerOf(spoke) == 2 ? halfEdge(triangleOf(spoke) + 1, 0) : spoke + 1;
  }
  return spoke;
}

/// Set the part's border vertices from any of its spokes: in the plane the farthest, by a walk
/// around the border.
template <class Geometry>
void setBorder(const PartMesh<Geometry>& mesh, std::uint32_t spoke, Part& part)
{
  const BorderRing<PartMesh<Geometry>> ring(mesh);
  for (int side = 0; side < 4; ++side)
  {
    part.spoke[side] = spoke;
  }
  if constexpr (Geometry::IsPlanar)
  {
    for (std::uint32_t s = ring.next(spoke); s != spoke; s = ring.next(s))
    {
      for (int side = 0; side < 4; ++side)
      {
        if (isFarther<Geometry>(
              side, mesh.vertices[ring.begin(s)], mesh.vertices[ring.begin(part.spoke[side])]))
        {
          part.spoke[side] = s;
        }
      }
    }
  }
  for (int side = 0; side < 4; ++side)
  {
    part.vertex[side] = ring.begin(part.spoke[side]);
  }
}

}

#endif
