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

  /// use (segment) for each that may be at a position, perhaps several times.
  template <class Use>
  void eachAt(const Position& position, const Use& use) const
  {
    const Box& whole = this->boxTree.box(0);
    for (int i = 0; i < 2; ++i)
    {
      if (!(whole.low[i] <= position.x[i] && position.x[i] <= whole.high[i])) // or NaN
      {
        return;
      }
    }
    const Box box = this->boxBetween(position, position);
    std::size_t stack[64];
    int waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0)
    {
      const std::size_t node = stack[--waiting];
      if (!this->boxTree.isLeaf(node))
      {
        for (const std::size_t child : { 2 * node + 2, 2 * node + 1 })
        {
          stack[waiting] = child;
          waiting += meet(this->boxTree.box(child), box) ? 1 : 0;
        }
        continue;
      }
      for (std::uint32_t slot = this->boxTree.begin(node); slot < this->boxTree.end(node); ++slot)
      {
        if (meet(this->boxes[slot], box))
        {
          use(this->segment(slot));
        }
      }
    }
  }

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
