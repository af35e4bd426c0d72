// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points that lie outside each triangle of a polyhedron, in its cone: its conflict list.
#ifndef flipflop_ConflictLists_h
#define flipflop_ConflictLists_h

#include "Points/Vertex.h"
#include <flipflop/Buffer.h>

#include <cstdint>

namespace flipflop
{

/// Triangle t has the points at the indices from begin[t] to begin[t + 1].
struct ConflictLists
{
  Buffer<std::uint32_t> begin; ///< #triangles + 1, indices in vertices
  Buffer<Vertex> vertices;     ///< the polyhedron's vertices, then all triangles' points
};

}

#endif
