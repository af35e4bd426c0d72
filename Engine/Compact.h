// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Renumber a mesh without its dead triangles and unused vertices.
#ifndef flipflop_Compact_h
#define flipflop_Compact_h

#include "Polyhedron.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace flipflop
{

/// @param mesh        all twins are half-edges; its triangles' index fields and its vertices' flags
/// are used up
/// @param pieces      ranges of the triangle array, in the order wanted
/// @param vertexCount vertices to look at; those flagged VertexAlive stay, in their order
Polyhedron compact(const Mesh& mesh,
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pieces, std::size_t vertexCount);

}

#endif
