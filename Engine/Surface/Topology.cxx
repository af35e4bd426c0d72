// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/Topology.h"

#include "Surface/Sides.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <vector>

namespace flipflop
{

namespace
{

void note(TopologyFault& fault, std::uint32_t triangle)
{
  fault.any = true;
  ++fault.count;
  fault.triangle = fault.triangle < 0
    ? static_cast<std::int64_t>(triangle)
    : std::min(fault.triangle, static_cast<std::int64_t>(triangle));
}

/// Vertices whose triangles are more than one fan.
TopologyFault checkFans(const Triangle* triangles, std::uint32_t count, std::uint32_t vertexCount)
{
  TopologyFault fault;
  fault.code = ErrorCode::NotManifold;
  std::vector<std::uint32_t> degree(vertexCount, 0);
  std::vector<std::uint32_t> spoke(vertexCount, NoIndex);
  for (std::uint32_t t = 0; t < count; ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t v = triangles[t].v[e];
      ++degree[v];
      spoke[v] = spoke[v] == NoIndex ? halfEdge(t, e) : spoke[v];
    }
  }
  for (std::uint32_t v = 0; v < vertexCount; ++v)
  {
    if (spoke[v] == NoIndex)
    {
      continue;
    }
    std::uint32_t h = spoke[v];
    std::uint32_t around = 0;
    do
    {
      ++around;
      const std::uint32_t previous = previousHalfEdge(h);
      h = triangles[triangleOf(previous)].twin[cornerOf(previous)];
    } while (h != spoke[v]);
    if (around != degree[v])
    {
      note(fault, triangleOf(spoke[v]));
    }
  }
  return fault;
}

}

TopologyFault linkTriangles(Triangle* triangles, std::uint32_t count, std::uint32_t vertexCount)
{
  TopologyFault crowded, open, turned;
  crowded.code = ErrorCode::NotManifold;
  open.code = ErrorCode::NotClosed;
  turned.code = ErrorCode::NotOriented;

  Buffer<CellSide> sides(std::size_t(3) * count);
  for (std::uint32_t t = 0; t < count; ++t)
  {
    const std::uint32_t* v = triangles[t].v;
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t a = v[e];
      const std::uint32_t b = v[nextCorner(e)];
      sides[std::size_t(3) * t + e] = CellSide(a, b, halfEdge(t, e));
    }
  }
  eachEdge(sides,
    [&](const CellSide* side, const CellSide* end)
    {
      const std::uint32_t h = side->index;
      if (end - side == 1)
      {
        note(open, triangleOf(h));
      }
      else if (end - side > 2)
      {
        note(crowded, triangleOf(h));
      }
      else
      {
        const std::uint32_t g = side[1].index;
        Triangle& first = triangles[triangleOf(h)];
        Triangle& second = triangles[triangleOf(g)];
        first.twin[cornerOf(h)] = g;
        second.twin[cornerOf(g)] = h;
        if (first.v[cornerOf(h)] == second.v[cornerOf(g)])
        {
          note(turned, triangleOf(h));
        }
      }
    });
  for (const TopologyFault& fault : { crowded, open, turned })
  {
    if (fault.any)
    {
      return fault;
    }
  }
  return checkFans(triangles, count, vertexCount);
}

}
