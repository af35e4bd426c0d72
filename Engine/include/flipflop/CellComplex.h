// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells over some of the input's points, in the canonical form that all results have.
#ifndef flipflop_CellComplex_h
#define flipflop_CellComplex_h

#include <flipflop/Buffer.h>
#include <flipflop/Statistics.h>

#include <cstdint>

namespace flipflop
{

/// The form is a function of the input alone: points in ascending order of id; each cell starts at
/// its lowest corner; cells in lexicographic order.
struct CellComplex
{
  int dimension = -1; ///< of what the input spans, 0 to 3; -1: there was no point

  /// The id (index in the input) of each point that appears, ascending.
  Buffer<std::int64_t> pointIds;

  /// The corners of all cells, one cell after another: indices into pointIds.
  Buffer<std::int64_t> connectivity;

  /// Where each cell begins in connectivity, ascending from 0; then the size of connectivity. Empty
  /// if all cells have cellSize corners.
  Buffer<std::int64_t> offsets;

  /// Number of corners of a cell, if it is the same for all cells; 0 if offsets hold it.
  std::int64_t cellSize = 0;

  Statistics statistics; ///< of the run

  /// How many cells there are.
  std::int64_t cellCount() const
  {
    return this->cellSize ? static_cast<std::int64_t>(this->connectivity.size()) / this->cellSize
      : this->offsets.empty() ? 0
                              : static_cast<std::int64_t>(this->offsets.size()) - 1;
  }
  /// Where a cell begins in connectivity.
  /// @param cell 0 to cellCount(), which gives the size of connectivity
  std::int64_t cellBegin(std::int64_t cell) const
  {
    return this->cellSize ? cell * this->cellSize : this->offsets[static_cast<std::size_t>(cell)];
  }
};

/// Turn polygons into the triangles that FacetMode::Triangles gives, bit for bit: each polygon's
/// fan from its lowest corner, in canonical order. Nothing is done where there are none.
/// @param complex   of polygons and triangles, in canonical form; its statistics stay
/// @throw Error     OutOfMemory; the complex is as it was then
void fanPolygons(CellComplex& complex);

}

#endif
