// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A part of the plane's points, triangulated: what its neighbours need to know of it, and the way
/// around its border.
///
/// The triangulation of m points is in 2 m slots of triangles, of which two at least are free. It
/// is a Delaunay triangulation by exact signs without perturbation: no triangle has zero area, and
/// every point on the border is a vertex of it. Virtual triangles join the border's edges to the
/// virtual vertex, so the triangulation is a closed mesh. Of collinear points, the virtual
/// triangles are on both sides of the edges between them; one point has none.
#ifndef flipflop_PlanePart_h
#define flipflop_PlanePart_h

#include "Mesh/PlaneMesh.h"

#include <cstdint>
#include <type_traits>

namespace flipflop
{

/// What parts are triangulated in.
template <bool Weighted>
using PartMesh = std::conditional_t<Weighted, Mesh, PlaneMesh>;

/// The place of the virtual vertex in the array: before all points.
constexpr std::uint32_t PlaneVirtual = 0;

/// The directions in which a part keeps its farthest vertex. Of several, the one with the least
/// other coordinate.
enum PlaneSide
{
  LeastX,
  MostX,
  LeastY,
  MostY
};

struct PlanePart
{
  /// By side: the farthest vertex, and the half-edge from the virtual vertex to it in the virtual
  /// triangle whose edge begins there, clockwise around the part; NoIndex of a single point.
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

/// Is p farther than q to a side?
inline bool isFarther(int side, const double* p, const double* q)
{
  const int axis = side / 2;
  if (p[axis] != q[axis])
  {
    return (side % 2 == 1) == (p[axis] > q[axis]);
  }
  return p[1 - axis] < q[1 - axis];
}

/// Set the part's farthest vertices by a walk around its border, from any of its spokes.
template <class AnyMesh>
void findFarthest(const AnyMesh& mesh, std::uint32_t spoke, PlanePart& part)
{
  const BorderRing<AnyMesh> ring(mesh);
  for (int side = 0; side < 4; ++side)
  {
    part.spoke[side] = spoke;
  }
  for (std::uint32_t s = ring.next(spoke); s != spoke; s = ring.next(s))
  {
    for (int side = 0; side < 4; ++side)
    {
      if (isFarther(
            side, mesh.vertices[ring.begin(s)].x, mesh.vertices[ring.begin(part.spoke[side])].x))
      {
        part.spoke[side] = s;
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
