// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The triangles of a terrain: a constrained Delaunay triangulation that takes one vertex after
/// another (EditableMesh.h).
#ifndef flipflop_TerrainSurface_h
#define flipflop_TerrainSurface_h

#include "Edit/EditableMesh.h"
#include "Terrain/SurfacePlane.h"
#include "Terrain/TerrainPoints.h"
#include <flipflop/ConstrainedTriangulation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

class TerrainSurface
{
public:
  using Geometry = LiftedGeometry<false>;

  /// @param start    in triangles
  /// @param vertexOf of each of its points, the number in @p points
  TerrainSurface(const Geometry& signs, const TerrainPoints& points,
    const ConstrainedTriangulation& start, const std::vector<std::uint32_t>& vertexOf);

  /// Cells are triangles by index. Those at the virtual vertex, and dead ones, are none.
  std::size_t cellCount() const { return this->mesh.triangleCount(); }
  bool isCell(std::uint32_t t) const { return !this->mesh.isVirtual(t); }

  /// From the lowest id, so that rounded distances are of the triangle alone, however it was made.
  SurfaceCorners corners(std::uint32_t t) const
  {
    const std::uint32_t* const v = this->mesh.triangle(t).v;
    const Vertex* const a = &this->points[this->number[v[0]]];
    const Vertex* const b = &this->points[this->number[v[1]]];
    const Vertex* const c = &this->points[this->number[v[2]]];
    const bool isFirst = a->id < b->id && a->id < c->id;
    return isFirst    ? SurfaceCorners{ a, b, c }
      : b->id < c->id ? SurfaceCorners{ b, c, a }
                      : SurfaceCorners{ c, a, b };
  }

  /// The corners of a cell, by numbers of points.
  void numbers(std::uint32_t t, std::uint32_t* corner) const
  {
    for (int i = 0; i < 3; ++i)
    {
      corner[i] = numberOf(this->mesh.triangle(t).v[i]);
    }
  }

  /// Is no lower cell at a point of a cell?
  bool isLowestAt(std::uint32_t t, const Vertex& p) const;

  /// Orientation of three points.
  int orient(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->mesh.orient(a, b, c);
  }

  /// Soon some cells will be divided: request what that reads, of one ring around them after
  /// another.
  /// @param also (cell): of any that may be replaced
  template <class Also>
  void bringNear(std::vector<std::uint32_t>& cells, const Also& also) const
  {
    constexpr int Rings = 3;
    std::vector<std::uint32_t> next;
    for (int ring = 0; ring < Rings; ++ring)
    {
      for (const std::uint32_t t : cells)
      {
        prefetch(&this->mesh.triangle(t));
        also(t);
      }
      next.clear();
      for (const std::uint32_t t : cells)
      {
        const Triangle& triangle = this->mesh.triangle(t);
        for (int i = 0; i < 3; ++i)
        {
          prefetch(&this->mesh.vertex(triangle.v[i]));
          this->points.prefetch(this->number[triangle.v[i]]);
          next.push_back(triangleOf(triangle.twin[i]));
        }
      }
      cells.swap(next);
    }
  }

  /// Insert point @p v, which is in cell @p t, its border included, but at no vertex.
  /// @throw Error TooManyPoints
  void insert(std::uint32_t v, std::uint32_t t);

  /// Of the last insertion: the triangles that were replaced.
  const std::vector<std::uint32_t>& replaced() const { return this->mesh.replaced(); }

  /// And those in their place, counter-clockwise around the new vertex; some have the same numbers.
  const std::vector<std::uint32_t>& parts() const { return this->mesh.fan(); }

  /// Before findParts().
  void findSpokes();

  /// Which of these holds each of some points of those that were replaced.
  /// @param part receives indices of parts()
  void findParts(const std::vector<std::uint32_t>& some, std::vector<std::uint32_t>& part) const;

  const EditableMesh<false>& triangulation() const { return this->mesh; }
  /// The point in a slot of it, by number. Slots are those of vertices, as they were inserted.
  std::uint32_t numberOf(std::uint32_t slot) const { return this->number[slot]; }

  std::int64_t checkCount() const { return this->mesh.checkCount(); }
  std::int64_t exactCalls() const { return this->mesh.signs().unraised().predicateCounts().exact; }

private:
  /// An edge from the new vertex: the first of a part. Its end is another one's first.
  struct Spoke
  {
    double x, y; ///< relative to the vertex, rounded
    std::uint32_t slot;
  };

  std::uint32_t addSlot(std::uint32_t v);
  bool isLeftOf(const Spoke& spoke, const Vertex& p) const;
  std::size_t partFrom(const Vertex& p, std::size_t i) const;
  void findPartsOfBlock(const std::uint32_t* some, std::size_t size, std::uint32_t* part) const;

  const TerrainPoints& points;
  EditableMesh<false> mesh; ///< its third coordinates are zeros, not heights: signs may read them
  std::vector<std::uint32_t> number; ///< by slot
  std::uint32_t center = 0;          ///< the slot of the last vertex inserted
  std::vector<Spoke> spokes;         ///< of it, one a part
};

}

#endif
