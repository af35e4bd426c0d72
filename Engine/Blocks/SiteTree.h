// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points of a block that others may request: which of them are in conflict with a facet?
///
/// A tree of boxes, best first: a node waits with the furthest that a point of its box could be
/// above the facet. What is certainly beneath is never examined; for the rest, exact signs decide.
/// A search ends where it has examined too many points: those of facets near which all points are
/// (of one circle, of one line) would examine all.
#ifndef flipflop_SiteTree_h
#define flipflop_SiteTree_h

#include "Blocks/BlockPatch.h"
#include "Blocks/BlockSite.h"
#include "Blocks/ConflictBound.h"
#include "Support/BoxTree.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Geometry of the geometry
template <class Geometry>
class SiteTree
{
public:
  /// @param sites    1 or more, which live longer than the tree; near each other in their order
  ///                 are those near each other
  /// @param isLifted the third coordinate is a weight
  SiteTree(const std::vector<BlockSite>& sites, bool isLifted, Monitor& monitor)
    : sites(sites)
    , tree(
        static_cast<std::uint32_t>(this->sites.size()),
        [&](std::uint32_t i)
        {
          // Weights are no coordinates.
          const double* const x = this->sites[i].x;
          const double position[3] = { x[0], x[1], isLifted ? 0.0 : x[2] };
          Box box;
          box.add(position);
          return box;
        },
        monitor, BoxTree::InOrder())
  {
    if (!isLifted)
    {
      this->addSlabs();
      return;
    }
    this->heaviest.allocate(this->tree.size());
    this->tree.eachNode(
      [&](std::size_t node, std::uint32_t begin, std::uint32_t end)
      {
        double most = -std::numeric_limits<double>::infinity();
        for (std::uint32_t slot = begin; slot < end; ++slot)
        {
          most = std::max(most, this->at(slot).x[2]);
        }
        this->heaviest[node] = most;
      });
  }

  /// Emits points above the facet abc: about the furthest, up to @p limit; one at least, if there
  /// is one, and fewer than the limit where more would take long. If there is none, and if wanted,
  /// all points on it.
  /// @param examined so many points may be; becomes what remains of them
  /// @param emit     void (std::uint32_t item)
  /// @return         false, and nothing is emitted, if these were not enough
  template <class Emit>
  bool conflicts(const Geometry& geometry, const ConflictBound& bound, const Vertex& a,
    const Vertex& b, const Vertex& c, bool wantsTies, std::size_t limit, std::size_t& examined,
    const Emit& emit) const
  {
    // Among points that rounding alone distinguishes, the furthest are not searched for.
    constexpr std::size_t FewForHeights = 64;
    // The facet changes with one point, and is queried again; so others are not searched for long.
    constexpr std::size_t FewForOthers = 1 << 13;
    const std::size_t before = examined;
    using Node = std::pair<double, std::size_t>; // what is furthest first
    std::priority_queue<Node> waiting;
    const auto push = [&](std::size_t node)
    {
      const double most = this->most(bound, node);
      if (!(most < 0))
      {
        waiting.emplace(most == most ? most : std::numeric_limits<double>::infinity(), node);
      }
    };
    using Item = std::pair<double, std::uint32_t>;
    std::vector<Item> above; // the least first: a heap of the furthest
    std::vector<std::uint32_t> on;
    push(0);
    while (!waiting.empty())
    {
      const auto [most, node] = waiting.top();
      waiting.pop();
      const bool isEnough = above.size() == limit;
      if ((isEnough && (most <= above.front().first || before - examined >= FewForHeights)) ||
        (!above.empty() && before - examined >= FewForOthers))
      {
        break;
      }
      if (!this->tree.isLeaf(node))
      {
        push(2 * node + 1);
        push(2 * node + 2);
        continue;
      }
      const std::size_t size = this->tree.end(node) - this->tree.begin(node);
      if (examined < size)
      {
        return false;
      }
      examined -= size;
      for (std::uint32_t slot = this->tree.begin(node); slot < this->tree.end(node); ++slot)
      {
        const BlockSite& site = this->at(slot);
        Box box;
        box.add(site.x);
        const double height = bound.most(box);
        if (height < 0)
        {
          continue;
        }
        const int sign = geometry.above(a, b, c, asVertex(site.x));
        if (sign > 0)
        {
          keepFurthest(above, { height == height ? height : 0.0, this->tree.item(slot) }, limit);
        }
        else if (sign == 0 && wantsTies && above.empty())
        {
          on.push_back(this->tree.item(slot));
        }
      }
    }
    for (const Item& item : above)
    {
      emit(item.second);
    }
    for (std::size_t i = 0; above.empty() && i < on.size(); ++i)
    {
      emit(on[i]);
    }
    return true;
  }

private:
  template <class Item>
  static void keepFurthest(std::vector<Item>& heap, const Item& item, std::size_t limit)
  {
    const auto later = [](const Item& p, const Item& q) { return p > q; };
    if (heap.size() == limit)
    {
      if (item <= heap.front())
      {
        return;
      }
      std::pop_heap(heap.begin(), heap.end(), later);
      heap.pop_back();
    }
    heap.push_back(item);
    std::push_heap(heap.begin(), heap.end(), later);
  }

  const BlockSite& at(std::uint32_t slot) const { return this->sites[this->tree.item(slot)]; }

  /// For nodes small enough to be about flat, and large enough to be worth it.
  void addSlabs()
  {
    constexpr std::uint32_t Fewest = 12, Most = 1 << 14;
    this->slabs.resize(this->tree.size());
    this->tree.eachNode(
      [&](std::size_t node, std::uint32_t begin, std::uint32_t end)
      {
        if (end - begin >= Fewest && end - begin <= Most)
        {
          // Items are in order.
          this->slabs[node] =
            BlockPatch(this->sites.data() + begin, this->sites.data() + end, false);
        }
        else
        {
          this->slabs[node].box = this->tree.box(node);
        }
      });
  }

  double most(const ConflictBound& bound, std::size_t node) const
  {
    if (!this->slabs.empty())
    {
      return bound.most(this->slabs[node]);
    }
    Box box = this->tree.box(node);
    box.low[2] = box.high[2] = this->heaviest[node];
    return bound.most(box);
  }

  const std::vector<BlockSite>& sites;
  BoxTree tree;
  Buffer<double> heaviest;       ///< weight, by node
  std::vector<BlockPatch> slabs; ///< in space, by node
};

}

#endif
