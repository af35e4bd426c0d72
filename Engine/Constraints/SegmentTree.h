// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A tree of boxes over many segments.
///
/// A long segment would widen all boxes that it is in, so segments are taken in parts of a limited
/// length. Where most segments run nearly the same way, boxes have a third side, across it
/// (SegmentBundle.h): boxes along the axes alone would all meet. Boxes are rounded outwards.
#ifndef flipflop_SegmentTree_h
#define flipflop_SegmentTree_h

#include "Constraints/Position.h"
#include "Constraints/SegmentBundle.h"
#include "Support/BoxTree.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

class SegmentTree
{
public:
  /// @param segments  one or more; they and the positions have to last as long as the tree
  /// @param partCount parts are no longer than that share of the length of all
  /// @throw Error TooManyPoints, Aborted
  SegmentTree(const std::vector<Position>& positions, const std::vector<PositionSegment>& segments,
    std::size_t partCount, Monitor& monitor);

  /// Its items are parts of segments.
  const BoxTree& tree() const { return this->boxTree; }

  ///@{
  /// Of the part at a slot.
  const Box& box(std::uint32_t slot) const { return this->boxes[slot]; }
  std::uint32_t segment(std::uint32_t slot) const
  {
    return this->parts[this->boxTree.item(slot)].segment;
  }
  ///@}

  /// The offset of a position within the box of all: its third side.
  Box boxOf(const Position& position) const { return this->boxBetween(position, position); }

  static bool meet(const Box& a, const Box& b)
  {
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] &&
      b.low[1] <= a.high[1] && a.low[2] <= b.high[2] && b.low[2] <= a.high[2];
  }

private:
  /// Part @p number of @p count that are equally long.
  struct Part
  {
    std::uint32_t segment, number, count;
  };

  std::vector<Part> partsOf(std::size_t partCount, Monitor& monitor) const;
  Box boxOf(std::uint32_t item) const;
  Box boxBetween(const Position& a, const Position& b, const Part& part = { 0, 0, 1 }) const;

  const std::vector<Position>& positions;
  const std::vector<PositionSegment>& segments;
  const std::vector<Part> parts;
  const SegmentBundle bundle;
  const BoxTree boxTree;
  Buffer<Box> boxes; ///< of parts, by their slot
};

}

#endif
