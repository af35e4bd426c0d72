// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constraints/PointsOnSegments.h"

#include "Constraints/SegmentTree.h"
#include "Predicates/PlaneOrientation.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstddef>

namespace flipflop
{

namespace
{

/// Long segments are cut the finer, the more points there are: a point is then in few boxes.
std::size_t partCountOf(std::size_t segments, std::size_t points)
{
  constexpr std::size_t MostOfASegment = 64, PointsPerPart = 16;
  return std::max(segments, std::min(MostOfASegment * segments, points / PointsPerPart));
}

/// Sort them from @p begin on, and keep each once.
void sortDistinct(std::vector<PositionOnSegment>& found, std::size_t begin)
{
  const auto first = found.begin() + static_cast<std::ptrdiff_t>(begin);
  threads::sort(first, found.end(),
    [](const PositionOnSegment& a, const PositionOnSegment& b)
    { return a.segment != b.segment ? a.segment < b.segment : a.position < b.position; });
  found.erase(std::unique(first, found.end(),
                [](const PositionOnSegment& a, const PositionOnSegment& b)
                { return a.segment == b.segment && a.position == b.position; }),
    found.end());
}

/// Many points go down the tree together: those in a node's box, one after another in memory.
class PointSearch
{
public:
  PointSearch(const std::vector<Position>& at, const std::vector<PositionSegment>& given,
    const SegmentTree& tree, Monitor& monitor, std::vector<PositionOnSegment>& result)
    : positions(at)
    , segments(given)
    , boxes(tree)
    , poll(monitor)
    , found(result)
    , levels(MostLevels)
  {
  }

  void add(const Position& position)
  {
    const Box& whole = this->boxes.tree().box(0);
    // Not of NaN: it is in no box.
    if (whole.low[0] <= position.x[0] && position.x[0] <= whole.high[0] &&
      whole.low[1] <= position.x[1] && position.x[1] <= whole.high[1])
    {
      const Box box = this->boxes.boxOf(position);
      this->levels[0].push_back({ position, box.low[2], box.high[2] });
    }
  }

  void run() { this->descend(0, 0, this->levels[0].size()); }

private:
  static constexpr std::size_t MostLevels = 40; ///< more than a tree of 32-bit numbers has

  /// A point, and between which offsets it is.
  struct Candidate
  {
    Position position;
    double low, high;
  };

  static bool isIn(const Candidate& point, const Box& box)
  {
    const double x = point.position.x[0], y = point.position.x[1];
    // No branches: none of them could be predicted.
    return (int(box.low[0] <= x) & int(x <= box.high[0]) & int(box.low[1] <= y) &
             int(y <= box.high[1]) & int(box.low[2] <= point.high) &
             int(point.low <= box.high[2])) != 0;
  }

  /// The first @p count points of a level are in a node's box.
  void descend(std::size_t node, std::size_t level, std::size_t count)
  {
    const BoxTree& tree = this->boxes.tree();
    const std::vector<Candidate>& points = this->levels[level];
    this->poll.step();
    if (tree.isLeaf(node))
    {
      for (std::uint32_t slot = tree.begin(node); slot < tree.end(node); ++slot)
      {
        const std::size_t begin = this->found.size();
        for (std::size_t k = 0; k < count; ++k)
        {
          if (isIn(points[k], this->boxes.box(slot)))
          {
            this->test(points[k].position, this->boxes.segment(slot));
          }
        }
        if (this->found.size() - begin > 1)
        {
          sortDistinct(this->found, begin); // duplicates of a point are in the same leaves
        }
      }
      return;
    }
    std::vector<Candidate>& inside = this->levels[level + 1];
    inside.resize(std::max(inside.size(), count));
    for (const std::size_t child : { 2 * node + 1, 2 * node + 2 })
    {
      const Box& box = tree.box(child);
      std::size_t kept = 0;
      for (std::size_t k = 0; k < count; ++k)
      {
        inside[kept] = points[k];
        kept += isIn(points[k], box) ? 1 : 0;
      }
      if (kept > 0)
      {
        this->descend(child, level + 1, kept);
      }
    }
  }

  void test(const Position& position, std::uint32_t segment)
  {
    const Position &a = this->positions[this->segments[segment].from],
                   &b = this->positions[this->segments[segment].to];
    this->poll.step();
    if (a < position && position < b && planeOrientation(a.x, b.x, position.x) == 0)
    {
      this->found.push_back({ segment, position });
    }
  }

  const std::vector<Position>& positions;
  const std::vector<PositionSegment>& segments;
  const SegmentTree& boxes;
  StepPoll poll;
  std::vector<PositionOnSegment>& found;
  std::vector<std::vector<Candidate>> levels;
};

}

std::vector<PositionOnSegment> pointsOnSegments(const std::vector<Position>& positions,
  const std::vector<PositionSegment>& segments, const PointSource& source, Monitor& monitor,
  std::size_t pointsPerTask)
{
  const std::size_t count = source.count();
  const SegmentTree tree(positions, segments, partCountOf(segments.size(), count), monitor);
  std::vector<std::vector<PositionOnSegment>> found(chunkCount(count, pointsPerTask));
  eachChunk(count, pointsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      monitor.poll();
      PointSearch search(positions, segments, tree, monitor, found[number]);
      for (std::size_t id = begin; id < end; ++id)
      {
        search.add(positionOf(source.vertex(static_cast<std::uint32_t>(id))));
      }
      search.run();
    });
  std::vector<PositionOnSegment> all;
  for (std::vector<PositionOnSegment>& some : found)
  {
    all.insert(all.end(), some.begin(), some.end());
    some = {};
  }
  sortDistinct(all, 0);
  return all;
}

}
