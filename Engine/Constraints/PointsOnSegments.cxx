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

}

std::vector<PositionOnSegment> pointsOnSegments(const std::vector<Position>& positions,
  const std::vector<PositionSegment>& segments, const PointSource& source, Monitor& monitor)
{
  constexpr std::size_t PointsPerTask = 1 << 12;
  const std::size_t count = source.count();
  const SegmentTree tree(positions, segments, partCountOf(segments.size(), count), monitor);
  std::vector<std::vector<PositionOnSegment>> found(chunkCount(count, PointsPerTask));
  eachChunk(count, PointsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      monitor.poll();
      StepPoll poll(monitor);
      for (std::size_t id = begin; id < end; ++id)
      {
        const Position position = positionOf(source.vertex(static_cast<std::uint32_t>(id)));
        tree.eachAt(position,
          [&](std::uint32_t segment)
          {
            poll.step();
            const Position &a = positions[segments[segment].from],
                           &b = positions[segments[segment].to];
            if (a < position && position < b && planeOrientation(a.x, b.x, position.x) == 0)
            {
              found[number].push_back({ segment, position });
            }
          });
      }
    });
  std::vector<PositionOnSegment> all;
  for (std::vector<PositionOnSegment>& some : found)
  {
    all.insert(all.end(), some.begin(), some.end());
    some = {};
  }
  threads::sort(all.begin(), all.end(),
    [](const PositionOnSegment& a, const PositionOnSegment& b)
    { return a.segment != b.segment ? a.segment < b.segment : a.position < b.position; });
  all.erase(std::unique(all.begin(), all.end(),
              [](const PositionOnSegment& a, const PositionOnSegment& b)
              { return a.segment == b.segment && a.position == b.position; }),
    all.end());
  return all;
}

}
