// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Compact.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace flipflop
{

namespace
{

constexpr std::size_t VertexRun = 1 << 15;

/// Turn counts into starts; the total comes back.
std::uint32_t startsFromCounts(std::vector<std::uint32_t>& counts)
{
  std::uint32_t total = 0;
  for (std::uint32_t& count : counts)
  {
    const std::uint32_t start = total;
    total += count;
    count = start;
  }
  return total;
}

}

Polyhedron compact(const Mesh& mesh,
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pieces, std::size_t vertexCount)
{
  const auto isDead = [&mesh](std::uint32_t t)
  { return (mesh.triangles[t].flags & TriangleDead) != 0; };

  // How many stay, by piece and by run of vertices.
  std::vector<std::uint32_t> triangleStart(pieces.size());
  tbb::parallel_for(std::size_t(0), pieces.size(),
    [&](std::size_t piece)
    {
      std::uint32_t alive = 0;
      for (std::uint32_t t = pieces[piece].first; t < pieces[piece].second; ++t)
      {
        alive += isDead(t) ? 0 : 1;
      }
      triangleStart[piece] = alive;
    });
  std::vector<std::uint32_t> vertexStart((vertexCount + VertexRun - 1) / VertexRun);
  tbb::parallel_for(std::size_t(0), vertexStart.size(),
    [&](std::size_t run)
    {
      std::uint32_t alive = 0;
      const std::size_t end = std::min(vertexCount, (run + 1) * VertexRun);
      for (std::size_t v = run * VertexRun; v < end; ++v)
      {
        alive += mesh.vertices[v].flags & VertexAlive ? 1 : 0;
      }
      vertexStart[run] = alive;
    });

  Polyhedron result;
  result.triangles.allocate(startsFromCounts(triangleStart));
  result.vertices.allocate(startsFromCounts(vertexStart));

  // New numbers; a vertex keeps its own where its flags were.
  tbb::parallel_for(std::size_t(0), pieces.size(),
    [&](std::size_t piece)
    {
      std::uint32_t index = triangleStart[piece];
      for (std::uint32_t t = pieces[piece].first; t < pieces[piece].second; ++t)
      {
        if (!isDead(t))
        {
          mesh.triangles[t].index = index++;
        }
      }
    });
  tbb::parallel_for(std::size_t(0), vertexStart.size(),
    [&](std::size_t run)
    {
      std::uint32_t index = vertexStart[run];
      const std::size_t end = std::min(vertexCount, (run + 1) * VertexRun);
      for (std::size_t v = run * VertexRun; v < end; ++v)
      {
        Vertex& vertex = mesh.vertices[v];
        if (vertex.flags & VertexAlive)
        {
          vertex.flags = index;
          Vertex& copy = result.vertices[index++];
          copy = vertex;
          copy.flags = VertexAlive;
        }
      }
    });

  tbb::parallel_for(std::size_t(0), pieces.size(),
    [&](std::size_t piece)
    {
      for (std::uint32_t t = pieces[piece].first; t < pieces[piece].second; ++t)
      {
        if (isDead(t))
        {
          continue;
        }
        const Triangle& triangle = mesh.triangles[t];
        Triangle& copy = result.triangles[triangle.index];
        for (int e = 0; e < 3; ++e)
        {
          copy.v[e] = mesh.vertices[triangle.v[e]].flags;
          const std::uint32_t twin = triangle.twin[e];
          copy.twin[e] = halfEdge(mesh.triangles[triangleOf(twin)].index, cornerOf(twin));
        }
        copy.flags = 0;
        copy.index = 0;
      }
    });
  return result;
}

}
