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
  SurfaceCorners corners(std::uint32_t t) const;

  /// Insert point @p v, which is in cell @p t, its border included, but at no vertex.
  /// @throw Error TooManyPoints
  void insert(std::uint32_t v, std::uint32_t t);

  /// Of the last insertion: the triangles that were replaced.
  const std::vector<std::uint32_t>& replaced() const { return this->mesh.replaced(); }

  /// And those in their place, counter-clockwise around the new vertex; some have the same numbers.
  const std::vector<std::uint32_t>& parts() const { return this->mesh.fan(); }

  /// Which of these holds each of some points of those that were replaced.
  /// @param part receives indices of parts()
  void findParts(const std::vector<std::uint32_t>& some, std::vector<std::uint32_t>& part) const;

  const EditableMesh<false>& triangulation() const { return this->mesh; }
  /// The point in a slot of it, by number. Slots are in the order of the curve, too: it is memory
  /// that is near for what is near.
  static std::uint32_t numberOf(std::uint32_t slot) { return slot - 1; }
  static std::uint32_t slotOf(std::uint32_t number) { return number + 1; }

  std::int64_t checkCount() const { return this->mesh.checkCount(); }
  std::int64_t exactCalls() const { return this->mesh.signs().unraised().predicateCounts().exact; }

private:
  /// An edge from the new vertex: the first of a part. Its end is another one's first.
  struct Spoke
  {
    double x, y; ///< relative to the vertex, rounded
    std::uint32_t slot;
  };

  void findSpokes();
  bool isLeftOf(const Spoke& spoke, const Vertex& p) const;
  std::size_t partFrom(const Vertex& p, std::size_t i) const;
  void findPartsOfBlock(const std::uint32_t* some, std::size_t size, std::uint32_t* part) const;

  const TerrainPoints& points;
  EditableMesh<false> mesh;
  std::uint32_t center = 0;  ///< the slot of the last vertex inserted
  std::vector<Spoke> spokes; ///< of it, one a part
};

}

#endif
