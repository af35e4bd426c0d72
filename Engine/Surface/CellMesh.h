// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The triangles of a result's cells, linked: each cell as the fan from its first corner.
#ifndef flipflop_CellMesh_h
#define flipflop_CellMesh_h

#include "Mesh/Polyhedron.h"
#include "Points/Vertex.h"
#include "Surface/Topology.h"
#include <flipflop/CellComplex.h>

#include <array>
#include <cstdint>
#include <vector>

namespace flipflop
{

struct CellMesh
{
  Polyhedron polyhedron;            ///< its vertices are the complex's points, by index
  std::vector<std::int64_t> cellOf; ///< by triangle; -1: virtual
  bool any = false;                 ///< there are triangles, no more than half-edges can number
  TopologyFault fault;              ///< where they could not be linked
};

/// @param complex of dimension 2 or 3, of sound structure
/// @param corners the complex's points, by index
/// @param open    close the surface by triangles from its border to a virtual vertex
CellMesh meshOfCells(const CellComplex& complex, const std::vector<Vertex>& corners, bool open);

/// The one polygon of a flat complex, or the one whose fan its triangles are, in any order: corners
/// counter-clockwise, the lowest first. Empty: it is neither.
std::vector<std::int64_t> ringOfCells(const CellComplex& complex);

}

#endif
