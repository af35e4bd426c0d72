// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A convex hull, in its one canonical form.
#ifndef flipflop_Hull_h
#define flipflop_Hull_h

#include "Buffer.h"
#include "Statistics.h"

#include <cstdint>

namespace flipflop
{

/// The convex hull of a point set, whatever its dimension:
///
/// | dimension | cells                                                             |
/// |-----------|-------------------------------------------------------------------|
/// | -1        | none: there was no point                                          |
/// | 0         | one cell of one corner                                            |
/// | 1         | one cell of two corners: the ends                                 |
/// | 2         | the polygon once (or its triangles); its normal's last non-zero   |
/// |           | component is positive                                             |
/// | 3         | the facets (or their triangles), counter-clockwise from outside   |
///
/// The form is a function of the input alone: points in ascending order of id, each the lowest id
/// of its position and strictly extreme; each cell starts at its lowest corner; cells in
/// lexicographic order.
struct Hull
{
  int dimension = -1;

  /// #points: the ids (positions in the input) of the hull's points, ascending.
  Buffer<std::int64_t> pointIds;

  /// Corners of every cell, one after another: indices into pointIds.
  Buffer<std::int64_t> connectivity;

  /// #cells + 1 starts into connectivity. Empty when all cells have cellSize corners.
  Buffer<std::int64_t> offsets;

  /// Corners a cell, when the same for all; 0 when offsets tell.
  std::int64_t cellSize = 0;

  double volume = 0; ///< of the solid; 0 below dimension 3
  double area = 0;   ///< of the surface; of the polygon, once, in dimension 2

  Statistics statistics;

  std::int64_t cellCount() const
  {
    return this->cellSize ? static_cast<std::int64_t>(this->connectivity.size()) / this->cellSize
      : this->offsets.empty() ? 0
                              : static_cast<std::int64_t>(this->offsets.size()) - 1;
  }
  std::int64_t cellBegin(std::int64_t cell) const
  {
    return this->cellSize ? cell * this->cellSize : this->offsets[static_cast<std::size_t>(cell)];
  }
};

}

#endif
