// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What all blocks agree on before any of them begins: what the points span, how they are scaled,
/// who has which of them.
#ifndef flipflop_BlockFrame_h
#define flipflop_BlockFrame_h

#include "Blocks/BlockPatch.h"
#include "Blocks/BlockSite.h"
#include "Blocks/ConflictBound.h"
#include "Points/CoordinateRange.h"
#include <flipflop/BlockRun.h>
#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>

#include <vector>

namespace flipflop
{

/// The hull or the triangulation of points, with polygons as facets.
CellComplex cellsOf(BlockShape shape, const std::vector<BlockSite>& sites, const Options& options);

/// The same choices for a run next to the main one: it reports no progress, and can be aborted.
/// @param chosen lives as long as the options
Options quiet(const Options& chosen);

class BlockFrame
{
public:
  BlockFrame() = default;

  /// @param introductions of all blocks, by number
  BlockFrame(BlockShape shape, const std::vector<BlockMessage>& summaries, const Options& options);

  bool isLifted() const { return this->shape != BlockShape::Hull; }

  /// Is the result one facet, which one block gathers?
  bool isOneFacet() const { return !this->isLifted() && this->dimension < 3; }

  /// Into the units of the frame, or, with @p sign -1, back. Exact.
  void scale(double* x, int sign = 1) const;

  /// Does the arithmetic carry a scaled point? Not if a message was damaged: its signs would be
  /// none.
  bool holds(const double* x) const;

  /// Of a triangle, or of a border's edge, without @p c.
  ConflictBound boundOf(const double* a, const double* b, const double* c) const;

  /// A point off the line that all points are on.
  BlockSite pointOffLine() const;

  BlockShape shape = BlockShape::Hull;
  int blocks = 0;     ///< how many there are
  int dimension = -1; ///< of what all points span
  Arithmetic arithmetic;
  CoordinateRange range{};         ///< of all points, scaled
  std::vector<BlockSite> sample;   ///< of all blocks, scaled, ascending by id
  std::vector<BlockPatch> patches; ///< of all blocks' other points, scaled
};

}

#endif
