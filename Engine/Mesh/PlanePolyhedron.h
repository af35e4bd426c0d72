// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulation of the plane without weights, closed at its border by virtual triangles, and the
/// memory it lies in. To the finish, it is the same as a Polyhedron.
#ifndef flipflop_PlanePolyhedron_h
#define flipflop_PlanePolyhedron_h

#include "Mesh/PlaneMesh.h"
#include "Mesh/Polyhedron.h"
#include "Support/Parallel.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// Each flat edge between triangles of points is marked, on both sides, and no other is.
///
/// All points are extreme, and each was inserted by exact signs without perturbation
/// (PartTriangulation.h). An edge that was tested as it is now was a tie, and marked. Not tested
/// are the edges at the new vertex v. Before v came, all points of one empty circle were corners of
/// one facet. If v is on that circle, it lies beyond a chord between two neighbouring corners,
/// whose edge is the border of the facet and is tested, flat, and stays. So v has one triangle on
/// the circle, and no edge at v is flat. In a merge, each edge of the seam is tested. A mark does
/// not become wrong: a point strictly inside the circle of one of a flat edge's triangles is inside
/// the other's, the same, and then neither triangle stays, nor does the edge between them.
struct PlanePolyhedron
{
  Buffer<PlaneVertex> vertices; ///< duplicates are not flagged VertexAlive
  Buffer<PlaneTriangle> triangles;
  Buffer<std::uint8_t> ties;

  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(this->vertices.size()); }
  std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(this->triangles.size()); }
  std::uint32_t flatEdges(std::uint32_t t) const { return this->ties[t]; }
  void clearFlatEdges(std::uint32_t t) { this->ties[t] = 0; }

  PlaneMesh mesh() { return { this->triangles.data(), this->vertices.data(), this->ties.data() }; }

  std::size_t pieceCount() const { return chunkCount(this->triangles.size(), PieceSize); }
  std::size_t pieceEnd(std::size_t piece) const { return (piece + 1) * PieceSize; }

  /// use(triangle, piece) for every triangle, in parallel by pieces.
  template <class Use>
  void eachTriangle(Use&& use) const
  {
    this->eachOf([this](std::size_t t) { return !this->triangles[t].isDead(); }, use);
  }

  /// The same for those that have a flat edge.
  template <class Use>
  void eachFlatTriangle(Use&& use) const
  {
    this->eachOf([this](std::size_t t) { return this->ties[t] != 0; }, use);
  }

  /// The same as a Polyhedron, for algorithms that change it. The numbers of vertices and triangles
  /// stay.
  Polyhedron full() const
  {
    Polyhedron result(this->vertices.size(), this->triangles.size());
    eachChunk(this->vertices.size(), PieceSize,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        std::transform(this->vertices.begin() + begin, this->vertices.begin() + end,
          result.vertices.begin() + begin, [](const PlaneVertex& v) { return v.full(); });
      });
    eachChunk(this->triangles.size(), PieceSize,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t t = begin; t < end; ++t)
        {
          const PlaneTriangle& from = this->triangles[t];
          Triangle& to = result.triangles[t];
          to.flags = from.isDead() ? TriangleDead : 0;
          std::copy(from.v, from.v + 3, to.v);
          std::copy(from.twin, from.twin + 3, to.twin);
          to.flatEdges = this->ties[t];
        }
      });
    return result;
  }

private:
  static constexpr std::size_t PieceSize = 1 << 13;

  template <class IsWanted, class Use>
  void eachOf(const IsWanted& isWanted, Use&& use) const
  {
    eachChunk(this->triangles.size(), PieceSize,
      [&](std::size_t begin, std::size_t end, std::size_t piece)
      {
        for (std::size_t t = begin; t < end; ++t)
        {
          if (isWanted(t))
          {
            use(static_cast<std::uint32_t>(t), piece);
          }
        }
      });
  }
};

}

#endif
