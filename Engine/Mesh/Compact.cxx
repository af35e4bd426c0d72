// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Compact.h"

#include "Support/Parallel.h"

#include <algorithm>
#include <vector>

namespace flipflop
{

namespace
{

constexpr std::size_t VerticesPerTask = 1 << 15;

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

/// use(vertex, chunk) for every vertex, in parallel by chunks.
template <class Use>
void eachVertex(Polyhedron& polyhedron, Use&& use)
{
  eachChunk(polyhedron.vertices.size(), VerticesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t chunk)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        if (polyhedron.vertices[v].flags & VertexAlive)
        {
          use(polyhedron.vertices[v], chunk);
        }
      }
    });
}

}

Polyhedron compact(Polyhedron&& old)
{
  // How many stay, by piece and by chunk of vertices.
  std::vector<std::uint32_t> triangleNext(old.pieces.size());
  std::vector<std::uint32_t> vertexNext(chunkCount(old.vertices.size(), VerticesPerTask));
  old.eachTriangle([&](std::uint32_t, std::size_t piece) { ++triangleNext[piece]; });
  eachVertex(old, [&](const Vertex&, std::size_t chunk) { ++vertexNext[chunk]; });
  const std::uint32_t triangleCount = startsFromCounts(triangleNext);
  const std::uint32_t vertexCount = startsFromCounts(vertexNext);
  Polyhedron result(vertexCount, triangleCount);

  // New numbers, where the flags were. None is as high as TriangleDead.
  old.eachTriangle(
    [&](std::uint32_t t, std::size_t piece) { old.triangles[t].flags = triangleNext[piece]++; });
  eachVertex(old,
    [&](Vertex& vertex, std::size_t chunk)
    {
      ensure(!(vertex.flags & VertexLabelled)); // or a flip is missing
      const std::uint32_t index = vertexNext[chunk]++;
      result.vertices[index] = vertex;
      result.vertices[index].flags = vertex.flags & (VertexAlive | VertexVirtual);
      vertex.flags = index;
    });

  old.eachTriangle(
    [&](std::uint32_t t, std::size_t)
    {
      Triangle& triangle = old.triangles[t];
      Triangle& copy = result.triangles[triangle.flags];
      for (int e = 0; e < 3; ++e)
      {
        const std::uint32_t twin = triangle.twin[e];
        copy.v[e] = old.vertices[triangle.v[e]].flags;
        copy.twin[e] = halfEdge(old.triangles[triangleOf(twin)].flags, cornerOf(twin));
      }
      copy.flags = 0;
      copy.flatEdges = 0;
    });
  return result;
}

}
