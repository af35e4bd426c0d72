// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Half-edges from bare triangles: is this a closed, oriented manifold?
#ifndef flipflop_Topology_h
#define flipflop_Topology_h

#include "Error.h"
#include "Mesh.h"

#include <cstdint>

namespace flipflop
{

/// What is wrong with the topology, and where.
struct TopologyFault
{
  bool any = false;
  ErrorCode code = ErrorCode::BadTriangle;
  std::int64_t triangle = -1; ///< the first at fault
  std::int64_t count = 0; ///< triangles (BadTriangle), edges, or vertices (NotManifold) at fault
};

/// Set the twins of triangles whose corners are given (below @p vertexCount), and check, in this
/// order: that the corners of each are different, that no edge has three triangles, that none has
/// one, that its two run it in opposite directions, and that the triangles of each vertex form one
/// fan.
TopologyFault linkTriangles(Triangle* triangles, std::uint32_t count, std::uint32_t vertexCount);

}

#endif
