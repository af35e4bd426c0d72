// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What all blocks have of one: a sample of its points, and where the others are.
///
/// The sample makes the cells that a block finds first about as large as those of all points at
/// that position, so few reach far: extreme points in some directions, those of largest weight,
/// some between. It spans what the block's points span, and has the first of them, by id and by
/// position.
#ifndef flipflop_BlockSummary_h
#define flipflop_BlockSummary_h

#include "Blocks/BlockPatch.h"
#include "Blocks/BlockSite.h"
#include "Blocks/MessageArchive.h"
#include "Points/CoordinateRange.h"
#include <flipflop/BlockRun.h>
#include <flipflop/Options.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// How large a sample is. Tests take small ones, so that small blocks have queries.
struct SampleSizes
{
  int planeDirections = 16; ///< of extreme points
  int spaceDirections = 26;
  std::size_t heaviest = 8;
  std::size_t between = 16;
};
inline SampleSizes& sampleSizes()
{
  static SampleSizes sizes;
  return sizes;
}

struct BlockSummary
{
  std::vector<BlockSite> sample;   ///< ascending by id
  std::vector<BlockPatch> patches; ///< of all points but those
  CoordinateRange range = CoordinateRange::empty();

  BlockSummary() = default;

  /// @param sites of the block. Those near each other are near each other in their order, those of
  ///              one position are in the order of their ids.
  BlockSummary(BlockShape shape, const std::vector<BlockSite>& sites, const Options& options);

  explicit BlockSummary(const BlockMessage& message);
  BlockMessage message() const { return toBytes(*this); }

  template <class Self, class Archive>
  static void visit(Self& self, Archive& archive)
  {
    archive(self.range, self.sample, self.patches);
  }
};

}

#endif
