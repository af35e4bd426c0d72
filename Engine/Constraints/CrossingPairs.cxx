// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constraints/CrossingPairs.h"

#include "Constraints/Crossing.h"
#include "Constraints/SegmentTree.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace flipflop
{

namespace
{

class SelfJoin
{
public:
  SelfJoin(const std::vector<Position>& at, const std::vector<PositionSegment>& given,
    Monitor& monitorToUse)
    : positions(at)
    , segments(given)
    , monitor(monitorToUse)
    , boxes(at, given, given.size(), monitorToUse)
    , tree(this->boxes.tree())
  {
  }

  std::vector<CrossingPair> pairs(std::int64_t* comparisons)
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
    std::vector<CrossingPair> all;
    all.reserve(count);
    for (Found& some : found)
    {
      all.insert(all.end(), some.pairs.begin(), some.pairs.end());
      some.pairs = {};
    }
    threads::sort(all.begin(), all.end(), std::less<CrossingPair>());
    all.erase(std::unique(all.begin(), all.end()), all.end()); // by several parts
    return all;
  }

private:
  using NodePair = std::pair<std::size_t, std::size_t>; ///< of one level

  struct Found
  {
    std::vector<CrossingPair> pairs;
    std::int64_t comparisons = 0; ///< of boxes
  };

  /// use (NodePair) for each pair of their halves that meet.
  template <class Use>
  void eachBelow(const NodePair& pair, const Use& use) const
  {
    for (std::size_t a = 2 * pair.first + 1; a <= 2 * pair.first + 2; ++a)
    {
      for (std::size_t b = pair.first == pair.second ? a : 2 * pair.second + 1;
           b <= 2 * pair.second + 2; ++b)
      {
        if (SegmentTree::meet(this->tree.box(a), this->tree.box(b)))
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
        if (SegmentTree::meet(this->boxes.box(p), this->boxes.box(q)))
        {
          this->test(this->boxes.segment(p), this->boxes.segment(q), found.pairs);
        }
      }
    }
  }

  void test(std::uint32_t s, std::uint32_t t, std::vector<CrossingPair>& found) const
  {
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
  const SegmentTree boxes;
  const BoxTree& tree;
};

}

std::vector<CrossingPair> crossingPairs(const std::vector<Position>& positions,
  const std::vector<PositionSegment>& segments, Monitor& monitor, std::int64_t* comparisons)
{
  return segments.size() < 2 ? std::vector<CrossingPair>()
                             : SelfJoin(positions, segments, monitor).pairs(comparisons);
}

}
