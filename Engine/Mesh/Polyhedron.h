// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A star-shaped polyhedron at rest: a mesh without borders, and the memory it lies in.
#ifndef flipflop_Polyhedron_h
#define flipflop_Polyhedron_h

#include "Mesh/Mesh.h"
#include "Support/Parallel.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// A range of the triangle array.
struct Piece
{
  std::uint32_t begin;
  std::uint32_t end;
};

/// After growing and flipping, the arrays have gaps: what lies outside the pieces was never
/// written, some triangles in them are dead, and only vertices flagged VertexAlive belong to the
/// polyhedron.
struct Polyhedron
{
  Buffer<Vertex> vertices;
  Buffer<Triangle> triangles;
  std::vector<Piece> pieces; ///< of a size that suits a task

  Polyhedron() = default;

  /// Space for a polyhedron without gaps.
  Polyhedron(std::size_t vertexCount, std::size_t triangleCount)
    : vertices(vertexCount)
    , triangles(triangleCount)
  {
    constexpr std::size_t PieceSize = 1 << 13;
    this->pieces.reserve(chunkCount(triangleCount, PieceSize));
    for (std::size_t begin = 0; begin < triangleCount; begin += PieceSize)
    {
      this->pieces.push_back({ static_cast<std::uint32_t>(begin),
        static_cast<std::uint32_t>(std::min(triangleCount, begin + PieceSize)) });
    }
  }

  /// Only the first @p count triangles are in use.
  void limitTriangles(std::size_t count)
  {
    const auto end = static_cast<std::uint32_t>(count);
    while (!this->pieces.empty() && this->pieces.back().begin >= end)
    {
      this->pieces.pop_back();
    }
    if (!this->pieces.empty())
    {
      this->pieces.back().end = std::min(this->pieces.back().end, end);
    }
  }

  /// Numbers of the arrays' slots: of the vertices and triangles themselves only where there are no
  /// gaps.
  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(this->vertices.size()); }
  std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(this->triangles.size()); }
  std::size_t pieceCount() const { return this->pieces.size(); }
  std::size_t pieceEnd(std::size_t piece) const { return this->pieces[piece].end; }

  /// In the finish: of a triangle.
  std::uint32_t flatEdges(std::uint32_t t) const { return this->triangles[t].flatEdges; }
  void clearFlatEdges(std::uint32_t t) { this->triangles[t].flatEdges = 0; }

  /// The ids of the points among the vertices, ascending.
  std::vector<std::uint32_t> pointIds() const
  {
    std::vector<std::uint32_t> ids;
    ids.reserve(this->vertices.size());
    for (const Vertex& v : this->vertices)
    {
      if (!(v.flags & VertexVirtual))
      {
        ids.push_back(v.id);
      }
    }
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  Mesh mesh()
  {
    Mesh result;
    result.triangles = this->triangles.data();
    result.vertices = this->vertices.data();
    return result;
  }

  /// use(triangle, piece) for every triangle, in parallel by pieces.
  template <class Use>
  void eachTriangle(Use&& use) const
  {
    eachTask(this->pieces.size(),
      [&](std::size_t piece)
      {
        for (std::uint32_t t = this->pieces[piece].begin; t < this->pieces[piece].end; ++t)
        {
          if (!(this->triangles[t].flags & TriangleDead))
          {
            use(t, piece);
          }
        }
      });
  }

  /// The same for those that have a flat edge, in the finish.
  template <class Use>
  void eachFlatTriangle(Use&& use) const
  {
    this->eachTriangle(
      [&](std::uint32_t t, std::size_t piece)
      {
        if (this->flatEdges(t) != 0)
        {
          use(t, piece);
        }
      });
  }
};

}

#endif
