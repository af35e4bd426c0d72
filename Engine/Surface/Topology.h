// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Half-edges from bare triangles: is this a closed, oriented manifold?
#ifndef flipflop_Topology_h
#define flipflop_Topology_h

#include "Mesh/VertexStars.h"
#include <flipflop/Error.h>

#include <cstdint>
#include <utility>

namespace flipflop
{

/// What is wrong with the topology, and where.
struct TopologyFault
{
  bool any = false;
  ErrorCode code = ErrorCode::NotManifold;
  std::int64_t triangle = -1; ///< the first at fault
  std::int64_t count = 0;     ///< edges, or vertices, at fault
};

/// Set the twins of triangles, each with three different corners below @p vertexCount, and check,
/// in this order: that no edge has three triangles, that none has one, that its two run it in
/// opposite directions, and that the triangles of each vertex form one fan.
inline TopologyFault linkTriangles(
  Triangle* triangles, std::uint32_t count, std::uint32_t vertexCount)
{
  const VertexStars<TriangleSides> stars(TriangleSides(triangles, count, vertexCount));
  LinkFaults faults;
  FaultyCells parted;
  stars.eachStar([] {},
    [&](std::uint32_t v, Star& star)
    {
      if (star.isFan())
      {
        stars.eachTwin(
          star, [triangles](std::uint32_t h, std::uint32_t twin) { setTwin(triangles, h, twin); });
      }
      else if (!star.leaving.empty())
      {
        parted.add(triangleOf(star.leaving.front()));
      }
      if (!star.isFan() || !star.isClosed)
      {
        stars.eachEdge(
          v, star, [&](const LinkedEdge& edge) { faults.add(edge, triangleOf(edge.sides[0])); });
      }
    });
  const std::pair<ErrorCode, const FaultyCells*> inOrder[] = {
    { ErrorCode::NotManifold, &faults.crowded }, { ErrorCode::NotClosed, &faults.open },
    { ErrorCode::NotOriented, &faults.turned }, { ErrorCode::NotManifold, &parted }
  };
  for (const auto& [code, found] : inOrder)
  {
    if (found->count() > 0)
    {
      return { true, code, found->first(), found->count() };
    }
  }
  return TopologyFault();
}

}

#endif
