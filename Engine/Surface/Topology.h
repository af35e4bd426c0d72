// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Half-edges from bare triangles: is this a closed, oriented manifold?
#ifndef flipflop_Topology_h
#define flipflop_Topology_h

#include "Mesh/Mesh.h"
#include <flipflop/Error.h>

#include <cstdint>

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
TopologyFault linkTriangles(Triangle* triangles, std::uint32_t count, std::uint32_t vertexCount);

}

#endif
