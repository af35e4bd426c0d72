// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which other blocks might have a point in conflict with a facet?
#ifndef flipflop_BlockReach_h
#define flipflop_BlockReach_h

#include "Blocks/ConflictBound.h"
#include "Query/BoxTree.h"
#include "Support/Monitor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace flipflop
{

/// A box of points that a block has; in the plane, the third axis has the heaviest weight.
struct BlockBox
{
  Box box;
  int block;
};

class BlockReach
{
public:
  /// @param others   boxes of all blocks but one
  /// @param own      boxes of that one
  /// @param isLifted the third coordinate is a weight
  BlockReach(
    std::vector<BlockBox> others, const std::vector<BlockBox>& own, bool isLifted, Monitor& monitor)
    : boxes(std::move(others))
  {
    if (this->boxes.empty())
    {
      return;
    }
    this->tree.emplace(
      static_cast<std::uint32_t>(this->boxes.size()),
      [this](std::uint32_t i) { return this->boxes[i].box; }, monitor);
    // Blocks of a k-d tree lie side by side: what stays within its own rectangle needs no search.
    for (const BlockBox& mine : own)
    {
      this->rectangle.add(mine.box);
    }
    this->liesApart = isLifted && !own.empty();
    for (const BlockBox& other : this->boxes)
    {
      const Box& box = other.box;
      this->heaviest = std::max(this->heaviest, box.high[2]);
      this->liesApart = this->liesApart &&
        (box.high[0] <= this->rectangle.low[0] || box.low[0] >= this->rectangle.high[0] ||
          box.high[1] <= this->rectangle.low[1] || box.low[1] >= this->rectangle.high[1]);
    }
  }

  /// Is there none?
  bool isFree(const ConflictBound& bound) const
  {
    return !this->tree || (this->liesApart && !bound.reachesOut(this->rectangle, this->heaviest)) ||
      !this->search(bound, [](int, double) { return true; });
  }

  /// All of them, those first that might have the furthest.
  std::vector<int> blocks(const ConflictBound& bound) const
  {
    std::map<int, double> furthest;
    if (this->tree)
    {
      this->search(bound,
        [&](int block, double most)
        {
          double& known =
            furthest.emplace(block, -std::numeric_limits<double>::infinity()).first->second;
          known = std::max(known, most);
          return false;
        });
    }
    std::vector<std::pair<double, int>> order;
    for (const auto& [block, most] : furthest)
    {
      order.emplace_back(-most, block);
    }
    std::sort(order.begin(), order.end());
    std::vector<int> found;
    for (const auto& [most, block] : order)
    {
      found.push_back(block);
    }
    return found;
  }

private:
  /// use (block, most) for each box that is reached, until it says that this is enough.
  template <class Use>
  bool search(const ConflictBound& bound, const Use& use) const
  {
    std::size_t stack[64];
    int waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0)
    {
      const std::size_t node = stack[--waiting];
      if (bound.most(this->tree->box(node)) < 0)
      {
        continue;
      }
      if (!this->tree->isLeaf(node))
      {
        stack[waiting++] = 2 * node + 2;
        stack[waiting++] = 2 * node + 1;
        continue;
      }
      for (std::uint32_t i = this->tree->begin(node); i < this->tree->end(node); ++i)
      {
        const BlockBox& box = this->boxes[this->tree->item(i)];
        const double most = bound.most(box.box);
        constexpr double unknown = std::numeric_limits<double>::infinity();
        if (!(most < 0) && use(box.block, most == most ? most : unknown))
        {
          return true;
        }
      }
    }
    return false;
  }

  std::vector<BlockBox> boxes;
  std::optional<BoxTree> tree;
  Box rectangle;
  double heaviest = -std::numeric_limits<double>::infinity();
  bool liesApart = false;
};

}

#endif
