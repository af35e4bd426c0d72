// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A point as the algorithms carry it: one half of a cache line.
#ifndef flipflop_Vertex_h
#define flipflop_Vertex_h

#include "Support/HostDevice.h"

#include <cstdint>
#include <limits>

namespace flipflop
{

/// No vertex, no triangle, no id.
constexpr std::uint32_t NoIndex = 0xFFFFFFFFu;

struct alignas(32) Vertex
{
  double x[3];         ///< x, y, and z or the weight; NaN for the virtual vertex
  std::uint32_t id;    ///< position in the input: perturbation and ties go by it
  std::uint32_t flags; ///< VertexFlags
};

enum VertexFlags : std::uint32_t
{
  VertexAlive = 1,    ///< a vertex of the polyhedron
  VertexLabelled = 2, ///< labelled non-extreme (paper, section 2.3): to be removed
  VertexVirtual = 4   ///< the vertex at infinity (paper, section 4): no point, never removed
};

/// The vertex at infinity: nowhere, and behind all ids.
inline Vertex virtualVertex()
{
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  return { { nowhere, nowhere, nowhere }, NoIndex, VertexAlive | VertexVirtual };
}

FF_HD inline bool samePosition(const Vertex& a, const Vertex& b)
{
  return a.x[0] == b.x[0] && a.x[1] == b.x[1] && a.x[2] == b.x[2];
}

}

#endif
