// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which vertex stands for a point: its own, or where it is a duplicate, that at its position.
#ifndef flipflop_VertexAt_h
#define flipflop_VertexAt_h

#include "Constraints/Position.h"
#include "Mesh/Polyhedron.h"
#include "Points/PointSource.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include <flipflop/ConstrainedTriangulation.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace flipflop
{

class VertexAt
{
public:
  /// @param source      of the points, scaled as the surface's vertices are
  /// @param surface     without weights: all positions have a vertex
  /// @param constraints whose ends will be requested; they are points
  VertexAt(const PointSource& source, const Polyhedron& surface, const ConstraintView& constraints,
    Monitor& monitor)
    : vertexOf(source.count())
  {
    constexpr std::size_t ItemsPerTask = 1 << 14;
    eachChunk(this->vertexOf.size(), ItemsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        monitor.poll();
        std::fill(this->vertexOf.begin() + begin, this->vertexOf.begin() + end, NoIndex);
      });
    const auto eachVertex = [&](const auto& use)
    {
      eachChunk(surface.vertexCount(), ItemsPerTask,
        [&](std::size_t begin, std::size_t end, std::size_t)
        {
          monitor.poll();
          for (std::size_t v = begin; v < end; ++v)
          {
            const Vertex& vertex = surface.vertices[v];
            if ((vertex.flags & (VertexAlive | VertexVirtual)) == VertexAlive)
            {
              use(static_cast<std::uint32_t>(v), vertex);
            }
          }
        });
    };
    eachVertex([this](std::uint32_t v, const Vertex& vertex) { this->vertexOf[vertex.id] = v; });

    // What remains are duplicates: few, so their positions are collected, and all vertices
    // examined.
    std::unordered_map<Position, std::uint32_t, PositionHash> duplicates;
    const auto eachDuplicate = [&](const auto& use)
    {
      for (std::int64_t i = 0; i < 2 * constraints.count; ++i)
      {
        const auto id = static_cast<std::uint32_t>(constraints.ends[i]);
        if (this->vertexOf[id] == NoIndex)
        {
          use(id, positionOf(source.vertex(id)));
        }
      }
    };
    eachDuplicate(
      [&](std::uint32_t, const Position& position) { duplicates.emplace(position, NoIndex); });
    if (duplicates.empty())
    {
      return;
    }
    eachVertex(
      [&](std::uint32_t v, const Vertex& vertex)
      {
        const auto found = duplicates.find(positionOf(vertex));
        if (found != duplicates.end())
        {
          found->second = v; // no other vertex is there
        }
      });
    eachDuplicate(
      [&](std::uint32_t id, const Position& position)
      {
        this->vertexOf[id] = duplicates.find(position)->second;
        ensure(this->vertexOf[id] != NoIndex);
      });
  }

  std::uint32_t operator()(std::int64_t id) const
  {
    return this->vertexOf[static_cast<std::size_t>(id)];
  }

private:
  Buffer<std::uint32_t> vertexOf; ///< by id
};

}

#endif
