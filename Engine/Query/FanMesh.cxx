// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/FanMesh.h"

#include "PowerDiagram/TriangulationInput.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace flipflop
{

void FanMesh::renumber(const Buffer<std::uint32_t>& order, Monitor& monitor)
{
  const std::size_t vertexCount = order.size();
  const std::size_t count = this->triangles.size();
  Buffer<std::uint32_t> rank(vertexCount);
  eachChunk(vertexCount, SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        rank[order[k]] = static_cast<std::uint32_t>(k);
      }
    });
  // Triangles go by their first vertex.
  const auto firstOf = [&](std::size_t t)
  {
    const std::uint32_t* v = this->triangles[t].v;
    return std::min(std::min(rank[v[0]], rank[v[1]]), rank[v[2]]);
  };
  Buffer<std::uint32_t> next(vertexCount + 1);
  std::fill(next.begin(), next.end(), 0);
  monitor.poll();
  for (std::size_t t = 0; t < count; ++t)
  {
    ++next[firstOf(t) + 1];
  }
  for (std::size_t k = 0; k < vertexCount; ++k)
  {
    next[k + 1] += next[k];
  }
  Buffer<std::uint32_t> numberOf(count);
  monitor.poll();
  for (std::size_t t = 0; t < count; ++t)
  {
    numberOf[t] = next[firstOf(t)]++;
  }
  Buffer<Triangle> moved(count);
  Buffer<std::uint32_t> movedCells(count);
  eachChunk(count, FacetsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      monitor.poll();
      for (std::size_t t = begin; t < end; ++t)
      {
        Triangle& triangle = moved[numberOf[t]];
        triangle = this->triangles[t];
        for (int i = 0; i < 3; ++i)
        {
          const std::uint32_t twin = triangle.twin[i];
          triangle.v[i] = rank[triangle.v[i]];
          triangle.twin[i] =
            twin == NoIndex ? NoIndex : halfEdge(numberOf[triangleOf(twin)], cornerOf(twin));
        }
        movedCells[numberOf[t]] = this->cells[t];
      }
    });
  this->lowestCellAt.allocate(vertexCount);
  eachChunk(vertexCount, SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        this->lowestCellAt[k] = this->cells[this->lowestAt[order[k]]];
      }
    });
  this->triangles = std::move(moved);
  this->cells = std::move(movedCells);
  for (std::size_t t = count; t-- > 0;)
  {
    for (const std::uint32_t v : this->triangles[t].v)
    {
      this->lowestAt[v] = static_cast<std::uint32_t>(t);
    }
  }
}

}
