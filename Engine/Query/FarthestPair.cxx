// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/FarthestPair.h"

#include "Points/Vector3.h"
#include "Predicates/ErrorBounds.h"
#include "Predicates/WideSigns.h"
#include "Query/UnitFrame.h"
#include "Support/BoxTree.h"

#include <atomic>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

class PairSearch
{
public:
  PairSearch(const Vertex* corners, std::uint32_t count, bool isWide, Monitor& monitor)
    : corners(corners)
    , count(count)
    , wide(isWide)
    , monitor(monitor)
    , frame(corners, count)
  {
    this->tree.emplace(
      count,
      [&](std::uint32_t item)
      {
        Box box;
        box.add(this->at(item));
        return box;
      },
      monitor);
    this->reach.allocate(this->tree->size());
    for (std::size_t node = this->tree->size(); node-- > 0;)
    {
      double most = 0;
      if (!this->tree->isLeaf(node))
      {
        most = std::max(this->reach[2 * node + 1], this->reach[2 * node + 2]);
      }
      else
      {
        for (std::uint32_t i = this->tree->begin(node); i < this->tree->end(node); ++i)
        {
          const double* const x = this->at(this->tree->item(i));
          most = std::max(most, dot(x, x));
        }
      }
      this->reach[node] = most;
    }
  }

  CornerPair search()
  {
    Found first;
    this->sweep(first);
    std::vector<NodePair> pairs = { { 0, 0 } };
    constexpr std::size_t Enough = 256; // tasks
    for (std::size_t done = 0; done < pairs.size() && pairs.size() < Enough;)
    {
      // Taken apart in place: which pairs there are does not depend on the threads.
      if (this->tree->isLeaf(pairs[done].a) && this->tree->isLeaf(pairs[done].b))
      {
        ++done;
        continue;
      }
      const NodePair pair = pairs[done];
      pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(done));
      this->eachPart(pair, [&](const NodePair& part) { pairs.push_back(part); });
    }
    std::vector<Found> found(pairs.size());
    this->monitor.stage(0.3, 1.0, static_cast<std::int64_t>(pairs.size()));
    eachTask(pairs.size(),
      [&](std::size_t i)
      {
        this->search(pairs[i], found[i]);
        this->monitor.advance(1);
      });
    for (const Found& other : found)
    {
      if (other.any)
      {
        this->consider(other.pair, other.square, first);
      }
    }
    return first.pair;
  }

private:
  struct NodePair
  {
    std::size_t a, b;
  };
  struct Found
  {
    bool any = false;
    double square = 0;
    CornerPair pair;
    std::uint32_t leaves = 0; ///< pairs of them that were examined
  };

  const double* at(std::uint32_t corner) const { return this->frame.at(corner); }

  double squareOf(const CornerPair& pair) const
  {
    const Vector3 way = subtract(this->at(pair.first), this->at(pair.second));
    return dot(way, way);
  }

  /// No pair of corners from two boxes is farther apart; the square.
  double boundOf(const NodePair& pair) const
  {
    const Box& a = this->tree->box(pair.a);
    const Box& b = this->tree->box(pair.b);
    double apart = 0;
    double mirrored = 0; // from a to the mirror image of b
    for (int k = 0; k < 3; ++k)
    {
      const double far = std::max(a.high[k] - b.low[k], b.high[k] - a.low[k]);
      const double gap = std::max(0.0, std::max(a.low[k] + b.low[k], -a.high[k] - b.high[k]));
      apart += far * far;
      mirrored += gap * gap;
    }
    return std::min(apart, 2 * this->reach[pair.a] + 2 * this->reach[pair.b] - mirrored);
  }

  /// Some pairs far apart: from a corner to the farthest, and from there on.
  void sweep(Found& found)
  {
    std::uint32_t from = 0;
    for (int step = 0; step < 4; ++step)
    {
      std::uint32_t farthest = from;
      double most = -1;
      for (std::uint32_t i = 0; i < this->count; ++i)
      {
        const double square = this->squareOf({ from, i });
        farthest = square > most ? i : farthest;
        most = std::max(most, square);
      }
      this->consider({ std::min(from, farthest), std::max(from, farthest) }, most, found);
      from = farthest;
    }
  }

  /// use (NodePair) for the parts of a pair that are not both leaves.
  template <class Use>
  void eachPart(const NodePair& pair, const Use& use) const
  {
    const std::size_t a = pair.a;
    const std::size_t b = pair.b;
    if (a == b)
    {
      use(NodePair{ 2 * a + 1, 2 * a + 2 });
      use(NodePair{ 2 * a + 1, 2 * a + 1 });
      use(NodePair{ 2 * a + 2, 2 * a + 2 });
    }
    else if (a < b) // the larger one: it is higher up, or next to the other
    {
      use(NodePair{ 2 * a + 1, b });
      use(NodePair{ 2 * a + 2, b });
    }
    else
    {
      use(NodePair{ a, 2 * b + 1 });
      use(NodePair{ a, 2 * b + 2 });
    }
  }

  void search(const NodePair& pair, Found& found)
  {
    if (this->boundOf(pair) < this->longest.load(std::memory_order_relaxed) - FarthestPairMargin)
    {
      return;
    }
    if (!this->tree->isLeaf(pair.a) || !this->tree->isLeaf(pair.b))
    {
      this->eachPart(pair, [&](const NodePair& part) { this->search(part, found); });
      return;
    }
    for (std::uint32_t i = this->tree->begin(pair.a); i < this->tree->end(pair.a); ++i)
    {
      for (std::uint32_t j = this->tree->begin(pair.b); j < this->tree->end(pair.b); ++j)
      {
        const std::uint32_t a = this->tree->item(i);
        const std::uint32_t b = this->tree->item(j);
        const CornerPair candidate = { std::min(a, b), std::max(a, b) };
        this->consider(candidate, this->squareOf(candidate), found);
      }
    }
    if (++found.leaves % StepPoll::Every == 0)
    {
      this->monitor.poll();
    }
  }

  /// Keep the longer pair; of two that are as long, the lexicographically lesser one.
  void consider(const CornerPair& pair, double square, Found& found)
  {
    double known = this->longest.load(std::memory_order_relaxed);
    if (square < known - FarthestPairMargin ||
      (found.any && square < found.square - FarthestPairMargin))
    {
      return;
    }
    while (square > known && !this->longest.compare_exchange_weak(known, square))
    {
    }
    if (found.any && square <= found.square + FarthestPairMargin)
    {
      const int sign = this->compare(pair, found.pair);
      const bool before = pair.first != found.pair.first ? pair.first < found.pair.first
                                                         : pair.second < found.pair.second;
      if (sign < 0 || (sign == 0 && !before))
      {
        return;
      }
    }
    found.any = true;
    found.square = square;
    found.pair = pair;
  }

  int compare(const CornerPair& a, const CornerPair& b) const
  {
    return inArithmetic<ExpansionSigns, WideSigns>(this->wide,
      [&](auto signs)
      {
        return signs.compareDistances(this->corners[a.first].x, this->corners[a.second].x,
          this->corners[b.first].x, this->corners[b.second].x);
      });
  }

  const Vertex* corners;
  std::uint32_t count;
  bool wide;
  Monitor& monitor;
  UnitFrame frame;
  std::optional<BoxTree> tree;
  Buffer<double> reach;             ///< by node: the greatest square of a distance from the origin
  std::atomic<double> longest{ 0 }; ///< the square of a distance between two corners
};

}

CornerPair farthestPair(const Vertex* corners, std::uint32_t count, bool isWide, Monitor& monitor)
{
  return PairSearch(corners, count, isWide, monitor).search();
}

}
