// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells that many threads found, and their corners numbered as one thread would that takes cell
/// after cell: each position once, in order of first use.
#ifndef flipflop_CornerNumbers_h
#define flipflop_CornerNumbers_h

#include "PowerDiagram/CellRepair.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <array>
#include <cstdint>
#include <vector>

namespace flipflop
{

using Position = std::array<double, 2>;

struct CellCorner
{
  Position x;
  std::uint32_t facet; ///< whose center it is, or NoIndex
};
using CellPolygon = std::vector<CellCorner>;

/// The cells of some sites that follow each other.
class CellChunk
{
public:
  /// @param facetCount of the triangulation
  explicit CellChunk(std::size_t facetCount)
    : facetCount(facetCount)
  {
  }

  /// @p cell is in the domain. What rounding made equal is one; a cell of two corners is an edge
  /// that its neighbours share.
  void add(std::int64_t id, CellPolygon& cell);

  std::size_t facetCount;
  std::vector<std::uint32_t> corners; ///< of every cell: a facet, or facetCount and an index in cut
  std::vector<Position> cut;          ///< other corners
  std::vector<std::uint32_t> sizes;   ///< of cells
  std::vector<std::int64_t> ids;      ///< of their sites
};

/// @param runs    in the order of their sites; their corners are lost
/// @param centers of the facets; -0 is not among them
/// @throw Error   TooManyPoints, Aborted
RoundedCells numberCorners(
  std::vector<CellChunk>& chunks, const Buffer<Position>& centers, Monitor& monitor);

}

#endif
