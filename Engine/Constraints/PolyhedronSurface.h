// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The mesh of a run of the Delaunay triangulation, for edges to be inserted (EdgeInsertion.h).
///
/// Signs are without the perturbation. Ties stay as they are, and the finish joins the triangles of
/// one circle: between constraints they form convex polygons, since all their corners are on it,
/// and an edge parts the circle. So the result is unique.
#ifndef flipflop_PolyhedronSurface_h
#define flipflop_PolyhedronSurface_h

#include "Geometry/LiftedGeometry.h"
#include "Mesh/Polyhedron.h"
#include "Support/Monitor.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace flipflop
{

class PolyhedronSurface
{
public:
  using Geometry = LiftedGeometry<false>;

  /// @param polyhedron with flat edges marked
  PolyhedronSurface(const Geometry& signs, Polyhedron& polyhedron, Monitor& monitor)
    : geometry(signs)
    , ownMesh(polyhedron.mesh())
    , half(polyhedron.vertexCount())
  {
    polyhedron.eachTriangle(
      [&](std::uint32_t t, std::size_t)
      {
        if ((t & 0xFFF) == 0)
        {
          monitor.poll();
        }
        this->leaveThrough(t);
      });
  }

  const Mesh& mesh() const { return this->ownMesh; }

  int orient(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->geometry.orient(a, b, c);
  }
  bool isAbove(const Triangle& triangle, const Vertex& p) const
  {
    return this->side(triangle, p) > 0;
  }

  std::uint32_t leaving(std::uint32_t v) const
  {
    return this->half[v].load(std::memory_order_relaxed);
  }
  void setLeaving(std::uint32_t v, std::uint32_t h)
  {
    this->half[v].store(h, std::memory_order_relaxed);
  }
  void leaveThrough(std::uint32_t t)
  {
    for (int e = 0; e < 3; ++e)
    {
      this->setLeaving(this->ownMesh.triangles[t].v[e], halfEdge(t, e));
    }
  }

  void willChange(std::uint32_t) {}
  void changed(const std::vector<std::uint32_t>& triangles)
  {
    this->remade.insert(this->remade.end(), triangles.begin(), triangles.end());
  }

  /// Mark again which edges are flat, where triangles have changed. A fixed edge is not.
  /// @return whether there is a flat one among these
  bool markFlatEdges(Monitor& monitor)
  {
    StepPoll poll(monitor);
    std::sort(this->remade.begin(), this->remade.end());
    this->remade.erase(std::unique(this->remade.begin(), this->remade.end()), this->remade.end());
    bool any = false;
    for (const std::uint32_t t : this->remade)
    {
      poll.step();
      for (int e = 0; e < 3; ++e)
      {
        const bool flat = this->isCocircular(halfEdge(t, e));
        this->ownMesh.setFlat(halfEdge(t, e), flat);
        any = any || flat;
      }
    }
    return any;
  }

private:
  int side(const Triangle& triangle, const Vertex& p) const
  {
    const Vertex* const v = this->ownMesh.vertices;
    return this->geometry.above(v[triangle.v[0]], v[triangle.v[1]], v[triangle.v[2]], p);
  }

  bool isCocircular(std::uint32_t h) const
  {
    const std::uint32_t apex = this->ownMesh.origin(previousHalfEdge(this->ownMesh.twin(h)));
    return !this->ownMesh.isFixed(h) &&
      this->side(this->ownMesh.triangles[triangleOf(h)], this->ownMesh.vertices[apex]) == 0;
  }

  const Geometry& geometry;
  const Mesh ownMesh;
  std::vector<std::atomic<std::uint32_t>> half; ///< by vertex, one that leaves it
  std::vector<std::uint32_t> remade;            ///< triangles, some more than once
};

}

#endif
