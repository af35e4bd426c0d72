// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which other blocks might have a point in conflict with a facet?
#ifndef flipflop_BlockReach_h
#define flipflop_BlockReach_h

#include "Blocks/BlockPatch.h"
#include "Blocks/ConflictBound.h"
#include "Support/BoxTree.h"
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

class BlockReach
{
public:
  /// @param all      patches of all blocks' points
  /// @param self     the block whose facets are queried
  /// @param isLifted the third coordinate is a weight
  BlockReach(const std::vector<BlockPatch>& all, int self, bool isLifted, Monitor& monitor)
  {
    for (const BlockPatch& patch : all)
    {
      if (patch.block == self)
      {
        this->rectangle.add(patch.box);
      }
      else
      {
        this->patches.push_back(patch);
        this->heaviest = std::max(this->heaviest, patch.box.high[2]);
      }
    }
    if (this->patches.empty())
    {
      return;
    }
    this->tree.emplace(
      static_cast<std::uint32_t>(this->patches.size()),
      [this](std::uint32_t i) { return this->patches[i].box; }, monitor);
    // Blocks of a k-d tree lie side by side: what stays within its own rectangle needs no search.
    this->liesApart = isLifted && this->patches.size() < all.size() &&
      std::none_of(this->patches.begin(), this->patches.end(),
        [this](const BlockPatch& other) { return this->entersRectangle(other.box); });
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
  bool entersRectangle(const Box& box) const
  {
    bool enters = true;
    for (int i = 0; i < 2; ++i)
    {
      enters =
        enters && box.low[i] < this->rectangle.high[i] && box.high[i] > this->rectangle.low[i];
    }
    return enters;
  }

  /// use (block, most) for each box that is reached, until it returns that this is enough.
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
        const BlockPatch& patch = this->patches[this->tree->item(i)];
        const double most = bound.most(patch);
        constexpr double unknown = std::numeric_limits<double>::infinity();
        if (!(most < 0) && use(static_cast<int>(patch.block), most == most ? most : unknown))
        {
          return true;
        }
      }
    }
    return false;
  }

  std::vector<BlockPatch> patches;
  std::optional<BoxTree> tree;
  Box rectangle;
  double heaviest = -std::numeric_limits<double>::infinity();
  bool liesApart = false;
};

}

#endif
