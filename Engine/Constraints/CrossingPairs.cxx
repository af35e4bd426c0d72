// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constraints/CrossingPairs.h"

#include "Constraints/Crossing.h"
#include "Constraints/SegmentBundle.h"
#include "Predicates/ErrorBounds.h"
#include "Support/BoxTree.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace flipflop
{

namespace
{

using Pair = std::pair<std::uint32_t, std::uint32_t>;

class SelfJoin
{
public:
  SelfJoin(const std::vector<Position>& at, const std::vector<PositionSegment>& given,
    Monitor& monitorToUse)
    : positions(at)
    , segments(given)
    , monitor(monitorToUse)
    , parts(partsOf(at, given, monitorToUse))
    , bundle(at, given)
    , tree(
        static_cast<std::uint32_t>(this->parts.size()),
        [this](std::uint32_t part) { return this->boxOf(part); }, monitorToUse,
        BoxTree::Lengths::AsShares)
    , boxes(this->parts.size())
  {
    eachChunk(this->boxes.size(), std::size_t(1) << 12,
      [this](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t slot = begin; slot < end; ++slot)
        {
          this->boxes[slot] = this->boxOf(this->tree.item(static_cast<std::uint32_t>(slot)));
        }
      });
  }

  std::vector<Pair> pairs(std::int64_t* comparisons)
  {
    // Pairs of nodes on one level that meet: enough of them for all threads.
    constexpr std::size_t WorthTasks = 512;
    std::vector<NodePair> tasks = { { 0, 0 } };
    while (tasks.size() < WorthTasks && !this->tree.isLeaf(tasks.front().first))
    {
      std::vector<NodePair> below;
      for (const NodePair& pair : tasks)
      {
        this->eachBelow(pair, [&](const NodePair& next) { below.push_back(next); });
      }
      tasks = std::move(below);
    }
    std::vector<Found> found(tasks.size());
    threads::eachAlone(tasks.size(),
      [&](std::size_t i)
      {
        StepPoll poll(this->monitor);
        this->join(tasks[i], poll, found[i]);
      });
    std::size_t count = 0;
    std::int64_t compared = 0;
    for (const Found& some : found)
    {
      count += some.pairs.size();
      compared += some.comparisons;
    }
    if (comparisons)
    {
      *comparisons = compared;
    }
    std::vector<Pair> all;
    all.reserve(count);
    for (Found& some : found)
    {
      all.insert(all.end(), some.pairs.begin(), some.pairs.end());
      some.pairs = {};
    }
    threads::sort(all.begin(), all.end(), std::less<Pair>());
    all.erase(std::unique(all.begin(), all.end()), all.end()); // by several parts
    return all;
  }

private:
  using NodePair = std::pair<std::size_t, std::size_t>; ///< of one level

  struct Found
  {
    std::vector<Pair> pairs;
    std::int64_t comparisons = 0; ///< of boxes
  };

  /// Part @p number of @p count that are equally long.
  struct Part
  {
    std::uint32_t segment, number, count;
  };

  static std::vector<Part> partsOf(const std::vector<Position>& positions,
    const std::vector<PositionSegment>& segments, Monitor& monitor)
  {
    if (segments.size() >= NoIndex / 2)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(segments.size()));
    }
    double most = 0;
    for (const PositionSegment& segment : segments)
    {
      const Position &a = positions[segment.from], &b = positions[segment.to];
      most = std::max(
        { most, std::fabs(a.x[0]), std::fabs(a.x[1]), std::fabs(b.x[0]), std::fabs(b.x[1]) });
    }
    // In shares of the largest coordinate, so that nothing overflows.
    std::vector<double> length;
    double sum = 0;
    for (const PositionSegment& segment : segments)
    {
      const Position &a = positions[segment.from], &b = positions[segment.to];
      double own = 0;
      for (int i = 0; i < 2; ++i)
      {
        own += most > 0 ? std::fabs(a.x[i] / most - b.x[i] / most) : 0.0;
      }
      length.push_back(own);
      sum += own;
    }
    const double mean = sum / static_cast<double>(segments.size());
    std::vector<Part> result;
    StepPoll poll(monitor);
    for (std::uint32_t s = 0; s < segments.size(); ++s)
    {
      const std::uint32_t count =
        mean > 0 ? 1 + static_cast<std::uint32_t>(length[s] / (1.0001 * mean)) : 1;
      for (std::uint32_t number = 0; number < count; ++number)
      {
        poll.step();
        result.push_back({ s, number, count });
      }
    }
    return result;
  }

  /// A box that the part is in: x, y, and the offset.
  Box boxOf(std::uint32_t item) const
  {
    const Part& part = this->parts[item];
    const PositionSegment& segment = this->segments[part.segment];
    const Position &a = this->positions[segment.from], &b = this->positions[segment.to];
    const double from[3] = { a.x[0], a.x[1], this->bundle.offsetOf(segment.from) };
    const double to[3] = { b.x[0], b.x[1], this->bundle.offsetOf(segment.to) };
    Box box;
    for (int i = 0; i < 3; ++i)
    {
      const double most = std::max(std::fabs(from[i]), std::fabs(to[i]));
      const double error = i < 2 ? 0.0 : OffsetError * most + OffsetUnit;
      box.low[i] = std::min(from[i], to[i]) - error;
      box.high[i] = std::max(from[i], to[i]) + error;
      if (part.count > 1)
      {
        const auto at = [&](std::uint32_t number)
        {
          const double t = static_cast<double>(number) / part.count;
          return (1 - t) * from[i] + t * to[i];
        };
        const double p = at(part.number), q = at(part.number + 1);
        const double off = PartError * most + PartUnderflow + error;
        box.low[i] = std::max(box.low[i], std::min(p, q) - off);
        box.high[i] = std::min(box.high[i], std::max(p, q) + off);
      }
    }
    return box;
  }

  static bool meet(const Box& a, const Box& b)
  {
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] &&
      b.low[1] <= a.high[1] && a.low[2] <= b.high[2] && b.low[2] <= a.high[2];
  }

  /// use (NodePair) for each pair of their halves that meet.
  template <class Use>
  void eachBelow(const NodePair& pair, const Use& use) const
  {
    for (std::size_t a = 2 * pair.first + 1; a <= 2 * pair.first + 2; ++a)
    {
      for (std::size_t b = pair.first == pair.second ? a : 2 * pair.second + 1;
           b <= 2 * pair.second + 2; ++b)
      {
        if (meet(this->tree.box(a), this->tree.box(b)))
        {
          use(NodePair(a, b));
        }
      }
    }
  }

  void join(const NodePair& pair, StepPoll& poll, Found& found) const
  {
    poll.step();
    ++found.comparisons;
    if (!this->tree.isLeaf(pair.first))
    {
      this->eachBelow(pair, [&](const NodePair& next) { this->join(next, poll, found); });
      return;
    }
    const std::uint32_t end = this->tree.end(pair.second);
    for (std::uint32_t p = this->tree.begin(pair.first); p < this->tree.end(pair.first); ++p)
    {
      for (std::uint32_t q = pair.first == pair.second ? p + 1 : this->tree.begin(pair.second);
           q < end; ++q)
      {
        ++found.comparisons;
        if (meet(this->boxes[p], this->boxes[q]))
        {
          this->test(this->tree.item(p), this->tree.item(q), found.pairs);
        }
      }
    }
  }

  void test(std::uint32_t p, std::uint32_t q, std::vector<Pair>& found) const
  {
    const std::uint32_t s = this->parts[p].segment, t = this->parts[q].segment;
    const PositionSegment &a = this->segments[s], &b = this->segments[t];
    if (a.from != b.from && a.from != b.to && a.to != b.from && a.to != b.to &&
      doCross(this->positions[a.from], this->positions[a.to], this->positions[b.from],
        this->positions[b.to]))
    {
      found.push_back(std::minmax(s, t));
    }
  }

  const std::vector<Position>& positions;
  const std::vector<PositionSegment>& segments;
  Monitor& monitor;
  const std::vector<Part> parts;
  const SegmentBundle bundle;
  const BoxTree tree;
  Buffer<Box> boxes; ///< of parts, by their slot in the tree
};

}

std::vector<Pair> crossingPairs(const std::vector<Position>& positions,
  const std::vector<PositionSegment>& segments, Monitor& monitor, std::int64_t* comparisons)
{
  return segments.size() < 2 ? std::vector<Pair>()
                             : SelfJoin(positions, segments, monitor).pairs(comparisons);
}

}
