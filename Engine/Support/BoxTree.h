// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A balanced binary tree of boxes over items in space: halves of the items, by halves of those,
/// and so on, each cut across its longest side.
///
/// The tree is complete and lies level by level: the children of node k are 2k + 1 and 2k + 2.
/// Which items a node has follows from its number. (A library's R-tree finds neighbours, but lets
/// nobody go down two of its branches at once, as the search for the farthest pair does.)
#ifndef flipflop_BoxTree_h
#define flipflop_BoxTree_h

#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace flipflop
{

struct Box
{
  double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
  double high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };

  void add(const double* x)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->low[i] = std::min(this->low[i], x[i]);
      this->high[i] = std::max(this->high[i], x[i]);
    }
  }
  void add(const Box& other)
  {
    this->add(other.low);
    this->add(other.high);
  }
};

class BoxTree
{
public:
  /// Items near each other are near each other in their order, so halves of that serve: nothing has
  /// to be sorted.
  struct InOrder
  {
  };

  /// The lengths of sides are measured in space, or as shares of the whole tree's: then axes may
  /// have units of their own.
  enum class Lengths
  {
    InSpace,
    AsShares
  };

  /// @param count 1 or more
  /// @param boxOf Box (std::uint32_t): of an item
  template <class BoxOf>
  BoxTree(std::uint32_t count, const BoxOf& boxOf, Monitor& monitor, InOrder)
    : count(count)
    , order(count)
  {
    this->allocateBoxes();
    std::iota(this->order.begin(), this->order.end(), 0u);
    this->addBoxes(0, 0, boxOf, monitor, [](std::size_t, int) {});
  }

  /// @param count 1 or more
  /// @param boxOf Box (std::uint32_t): of an item
  template <class BoxOf>
  BoxTree(
    std::uint32_t count, const BoxOf& boxOf, Monitor& monitor, Lengths lengths = Lengths::InSpace)
    : count(count)
    , order(count)
  {
    this->allocateBoxes();
    Buffer<double> middle(std::size_t(3) * count);
    Box whole;
    for (std::uint32_t item = 0; item < count; ++item)
    {
      const Box box = boxOf(item);
      for (std::size_t i = 0; i < 3; ++i)
      {
        middle[3 * std::size_t(item) + i] = 0.5 * box.low[i] + 0.5 * box.high[i];
      }
      whole.add(middle.data() + 3 * std::size_t(item));
      this->order[item] = item;
    }
    double units[3] = { 1, 1, 1 };
    for (int i = 0; lengths == Lengths::AsShares && i < 3; ++i)
    {
      const double side = halfSide(whole, i);
      units[i] = side > 0 ? side : 1;
    }
    this->addBoxes(0, 0, boxOf, monitor,
      [&](std::size_t node, int level) { this->split(node, level, middle, units); });
  }

  /// Nodes.
  std::size_t size() const { return this->boxes.size(); }
  bool isLeaf(std::size_t node) const { return 2 * node + 1 >= this->boxes.size(); }
  const Box& box(std::size_t node) const { return this->boxes[node]; }

  ///@{
  /// Slots of a leaf's items.
  std::uint32_t begin(std::size_t leaf) const { return this->beginOf(leaf, this->levels); }
  std::uint32_t end(std::size_t leaf) const { return this->beginOf(leaf + 1, this->levels); }
  ///@}

  /// use (node, begin, end) for each node: the slots of its items.
  template <class Use>
  void eachNode(const Use& use) const
  {
    for (int level = 0; level <= this->levels; ++level)
    {
      const std::size_t first = (std::size_t(1) << level) - 1;
      eachChunk(first + 1, std::size_t(1) << 10,
        [&](std::size_t begin, std::size_t end, std::size_t)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            const std::size_t node = first + i;
            use(node, this->beginOf(node, level), this->beginOf(node + 1, level));
          }
        });
    }
  }

  /// The item at a slot.
  std::uint32_t item(std::uint32_t slot) const { return this->order[slot]; }

  /// Lower @p best, the square of a distance, to the least of all items.
  /// @param boundOf         double (std::size_t node): below the least where that is in the node
  /// @param squaredDistance double (std::uint32_t slot): for no item less than the least of all
  template <class BoundOf, class SquaredDistance>
  void nearest(double& best, const BoundOf& boundOf, const SquaredDistance& squaredDistance) const
  {
    struct Later
    {
      std::size_t node;
      double bound;
    };
    Later stack[64];
    int waiting = 0;
    stack[waiting++] = { 0, boundOf(0) };
    while (waiting > 0)
    {
      const Later top = stack[--waiting];
      std::size_t node = top.node;
      bool near = top.bound < best;
      while (near && !this->isLeaf(node))
      {
        const double bound[2] = { boundOf(2 * node + 1), boundOf(2 * node + 2) };
        const std::size_t first = bound[1] < bound[0] ? 1 : 0;
        if (bound[1 - first] < best)
        {
          stack[waiting++] = { 2 * node + 2 - first, bound[1 - first] };
        }
        near = bound[first] < best;
        node = 2 * node + 1 + first;
      }
      for (std::uint32_t slot = near ? this->begin(node) : 0, last = near ? this->end(node) : 0;
           slot < last; ++slot)
      {
        best = std::min(best, squaredDistance(slot));
      }
    }
  }

private:
  static constexpr std::uint32_t LeafSize = 6;

  std::uint32_t beginOf(std::size_t node, int level) const
  {
    const std::size_t index = node + 1 - (std::size_t(1) << level);
    return static_cast<std::uint32_t>(std::uint64_t(this->count) * index >> level);
  }

  void allocateBoxes()
  {
    while ((this->count >> this->levels) > LeafSize)
    {
      ++this->levels;
    }
    this->boxes.allocate((std::size_t(2) << this->levels) - 1);
  }

  /// The boxes of a node and of all below.
  /// @param arrange void (std::size_t node, int level): before its halves are examined
  template <class BoxOf, class Arrange>
  void addBoxes(
    std::size_t node, int level, const BoxOf& boxOf, Monitor& monitor, const Arrange& arrange)
  {
    constexpr std::uint32_t WorthATask = 1 << 13;
    Box& box = this->boxes[node];
    box = Box();
    const std::uint32_t first = this->beginOf(node, level);
    const std::uint32_t last = this->beginOf(node + 1, level);
    if (level == this->levels)
    {
      std::for_each(this->order.data() + first, this->order.data() + last,
        [&](std::uint32_t item) { box.add(boxOf(item)); });
      return;
    }
    monitor.poll();
    arrange(node, level);
    const std::size_t children[2] = { 2 * node + 1, 2 * node + 2 };
    const auto addChild = [&](int i)
    { this->addBoxes(children[i], level + 1, boxOf, monitor, arrange); };
    if (last - first > WorthATask)
    {
      threads::invoke([&] { addChild(0); }, [&] { addChild(1); });
    }
    else
    {
      addChild(0);
      addChild(1);
    }
    box.add(this->boxes[children[0]]);
    box.add(this->boxes[children[1]]);
  }

  /// By halves, which do not overflow.
  static double halfSide(const Box& box, int axis)
  {
    return 0.5 * box.high[axis] - 0.5 * box.low[axis];
  }

  /// Cut the items across their longest side, in units of each axis.
  void split(std::size_t node, int level, const Buffer<double>& middle, const double* units)
  {
    std::uint32_t* const first = this->order.data() + this->beginOf(node, level);
    std::uint32_t* const last = this->order.data() + this->beginOf(node + 1, level);
    const auto middleOf = [&](std::uint32_t item) { return middle.data() + 3 * std::size_t(item); };
    Box spread;
    std::for_each(first, last, [&](std::uint32_t item) { spread.add(middleOf(item)); });
    int axis = 0;
    for (int i = 1; i < 3; ++i)
    {
      axis = halfSide(spread, i) / units[i] > halfSide(spread, axis) / units[axis] ? i : axis;
    }
    std::nth_element(first, this->order.data() + this->beginOf(2 * node + 2, level + 1), last,
      [&](std::uint32_t a, std::uint32_t b)
      {
        const double x = middleOf(a)[axis];
        const double y = middleOf(b)[axis];
        return x != y ? x < y : a < b;
      });
  }

  std::uint32_t count;
  int levels = 0; ///< below the root's
  Buffer<std::uint32_t> order;
  Buffer<Box> boxes;
};

}

#endif
