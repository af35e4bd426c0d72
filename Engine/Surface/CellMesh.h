// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points of given cells, and their triangles, linked: each cell as the fan from its first
/// corner.
#ifndef flipflop_CellMesh_h
#define flipflop_CellMesh_h

#include "Mesh/Mesh.h"
#include "Points/PointSource.h"
#include "Points/Vertex.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>
#include <flipflop/Validate.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// The points of a complex, by index.
/// @param source of the input, or of the complex's points alone
std::vector<Vertex> cornersIn(const PointSource& source, const CellComplex& complex);

/// Structure, at a corner that is not finite.
Validation checkFinite(const std::vector<Vertex>& corners);

struct CellMesh
{
  /// Make the fans of all cells, and link them.
  /// @param complex   in range; of dimension 2 in the plane, or 3
  /// @param mayBeOpen it may have a border
  /// @return NotClosed: around a corner of this cell there is no one fan, or it is open; Structure:
  ///         a point without cells
  /// @throw Error TooManyPoints, OutOfMemory, Aborted
  Validation link(const CellComplex& complex, bool mayBeOpen, Monitor& monitor);

  Buffer<Triangle> triangles;     ///< of points by index, in the order of cells; twin: NoIndex at
                                  ///< the border
  Buffer<std::uint32_t> cells;    ///< of each triangle its cell
  Buffer<std::uint32_t> lowestAt; ///< of each point its lowest triangle

private:
  void addFan(const CellComplex& complex, std::int64_t cell);
};

/// The one polygon of a flat complex, or the one whose fan its triangles are, in any order: corners
/// counter-clockwise, the lowest first. Empty: it is neither.
std::vector<std::int64_t> ringOfCells(const CellComplex& complex);

}

#endif
