// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulation as queries walk on it: the fans of its cells, in the order of the cells until
/// they are renumbered, with their neighbours across the edges. SurfaceCheck.h has what they must
/// be.
#ifndef flipflop_FanMesh_h
#define flipflop_FanMesh_h

#include "Mesh/Mesh.h"
#include "Support/Monitor.h"
#include "Surface/CellMesh.h"
#include <flipflop/Buffer.h>

#include <cstdint>

namespace flipflop
{

struct FanMesh : CellMesh
{
  /// Renumbers vertices, and with them triangles, so that what is near in the plane is near in
  /// memory.
  /// @param order the vertices' numbers until now
  void renumber(const Buffer<std::uint32_t>& order, Monitor& monitor);

  /// No triangle.
  bool empty() const { return this->triangles.empty(); }

  std::uint32_t cellOf(std::uint32_t t) const { return this->cells[t]; }

  /// The triangle at the end of its half-edge.
  std::uint32_t twin(std::uint32_t h) const
  {
    return this->triangles[triangleOf(h)].twin[cornerOf(h)];
  }
  std::uint32_t origin(std::uint32_t h) const
  {
    return this->triangles[triangleOf(h)].v[cornerOf(h)];
  }

  /// A half-edge that leaves vertex @p v, of the lowest triangle there.
  std::uint32_t leaving(std::uint32_t v) const
  {
    const std::uint32_t t = this->lowestAt[v];
    const std::uint32_t* corner = this->triangles[t].v;
    return halfEdge(t, corner[0] == v ? 0 : (corner[1] == v ? 1 : 2));
  }

  /// Around vertex @p v, until one of them returns false: left(h) for the half-edges that leave it,
  /// counter-clockwise from leaving(v) on; where the border ends that, right(h) clockwise from
  /// leaving(v) on.
  template <class Left, class Right>
  void walkStar(std::uint32_t v, const Left& left, const Right& right) const
  {
    const std::uint32_t first = this->leaving(v);
    std::uint32_t h = first;
    do
    {
      if (!left(h))
      {
        return;
      }
      h = this->twin(previousHalfEdge(h));
    } while (h != first && h != NoIndex);
    for (std::uint32_t out = h == NoIndex ? first : NoIndex; out != NoIndex && right(out);)
    {
      const std::uint32_t across = this->twin(out);
      out = across == NoIndex ? NoIndex : nextHalfEdge(across);
    }
  }

  /// use(h) for the half-edges h that leave vertex @p v, of its triangles, until it returns false.
  template <class Use>
  void eachLeaving(std::uint32_t v, Use&& use) const
  {
    const std::uint32_t first = this->leaving(v);
    this->walkStar(v, use, [&](std::uint32_t h) { return h == first || use(h); });
  }

  /// use(u) for the neighbours u of vertex @p v, until it returns false.
  template <class Use>
  void eachNeighbour(std::uint32_t v, Use&& use) const
  {
    this->walkStar(
      v, [&](std::uint32_t h) { return use(this->origin(previousHalfEdge(h))); },
      [&](std::uint32_t h) { return use(this->origin(nextHalfEdge(h))); });
  }

  Buffer<std::uint32_t> lowestCellAt; ///< of each vertex
};

}

#endif
