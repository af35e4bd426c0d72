// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lines as links between positions: where exactly two of their ends are, a walk goes on. First the
/// walks from all other ends, then those that only come back.
#include <flipflop/ClosedLines.h>

#include "Constraints/OddItems.h"
#include "Constraints/PositionNumbers.h"
#include "Run/QueryRun.h"
#include "Support/EngineCall.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace flipflop
{

namespace
{

class RingFinder
{
public:
  RingFinder(const LineView& given, int dimension, Monitor& monitor)
    : view(given)
    , lines(static_cast<std::size_t>(given.lines))
    , poll(monitor)
  {
    const PointSource source =
      dimension == 2 ? PointSource(given.points, WeightView()) : PointSource(given.points);
    PositionNumbers inPlane, all;
    std::uint64_t positions = source.count();
    for (std::uint32_t i = 0; i < source.count(); ++i)
    {
      this->poll.step();
      const Vertex vertex = source.vertex(i);
      if (!std::all_of(vertex.x, vertex.x + dimension, [](double x) { return std::isfinite(x); }))
      {
        if (positions >= NoIndex)
        {
          throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(positions));
        }
        this->at.push_back(static_cast<std::uint32_t>(positions++)); // which no other point has
        continue;
      }
      const std::uint32_t flat = inPlane.add(positionOf(vertex));
      this->at.push_back(
        dimension == 2 ? flat : all.add({ { static_cast<double>(flat), vertex.x[2] } }));
    }
    this->endsAt.resize(positions);
  }

  Buffer<std::int8_t> find()
  {
    Buffer<std::int8_t> sides(this->lines);
    std::fill(sides.begin(), sides.end(), std::int8_t(0));
    for (std::size_t polygon = 0; polygon < static_cast<std::size_t>(this->view.polygons);
         ++polygon)
    {
      std::vector<std::uint64_t> edges;
      const Range range = this->rangeOf(this->lines + polygon);
      this->appendEdges(range, edges);
      if (range.begin < range.end)
      {
        appendEdge(this->at[range.end - 1], this->at[range.begin], edges);
      }
      this->toggle(edges);
    }
    for (std::vector<std::size_t>& ring : this->findRings())
    {
      std::vector<std::uint64_t> edges;
      for (const std::size_t end : ring)
      {
        this->appendEdges(this->rangeOf(end / 2), edges);
      }
      keepOdd(edges);
      if (edges.empty() ||
        std::all_of(edges.begin(), edges.end(),
          [&](std::uint64_t edge) { return this->outline.count(edge) > 0; }))
      {
        continue;
      }
      this->toggle(edges);
      for (const std::size_t end : ring)
      {
        sides[end / 2] = end % 2 == ring[0] % 2 ? 1 : -1;
      }
    }
    return sides;
  }

private:
  struct Range
  {
    std::size_t begin, end; ///< of points
  };

  /// At a position, how many ends of lines there are, and the sum of their numbers.
  struct Ends
  {
    std::uint64_t count = 0, sum = 0;
  };

  Range rangeOf(std::size_t chain) const
  {
    return { static_cast<std::size_t>(this->view.offsets[chain]),
      static_cast<std::size_t>(this->view.offsets[chain + 1]) };
  }

  /// End 2 * i is where line i begins, 2 * i + 1 where it ends.
  std::uint32_t positionAt(std::size_t end) const
  {
    const Range range = this->rangeOf(end / 2);
    return this->at[end % 2 == 0 ? range.begin : range.end - 1];
  }

  /// Is it at more than one position?
  bool isLine(std::size_t line) const
  {
    const Range range = this->rangeOf(line);
    const auto first = this->at.begin() + static_cast<std::ptrdiff_t>(range.begin);
    const auto last = this->at.begin() + static_cast<std::ptrdiff_t>(range.end);
    return std::any_of(first, last, [first](std::uint32_t position) { return position != *first; });
  }

  /// The lines of each ring, by the ends at which a walk enters them, from the first line on; by
  /// ascending first lines.
  std::vector<std::vector<std::size_t>> findRings()
  {
    for (std::size_t end = 0; end < 2 * this->lines; ++end)
    {
      this->poll.step();
      if (this->isLine(end / 2))
      {
        Ends& ends = this->endsAt[this->positionAt(end)];
        ++ends.count;
        ends.sum += end;
      }
    }
    std::vector<char> isMet(this->lines, 0);
    std::vector<std::vector<std::size_t>> rings;
    for (const bool isAnywhere : { false, true })
    {
      for (std::size_t end = 0; end < 2 * this->lines; ++end)
      {
        this->poll.step();
        if (this->isLine(end / 2) && !isMet[end / 2] &&
          (isAnywhere || this->endsAt[this->positionAt(end)].count != 2))
        {
          std::vector<std::size_t> walk = this->walkFrom(end, isMet);
          if (this->positionAt(walk.back() ^ 1) == this->positionAt(end))
          {
            std::rotate(walk.begin(),
              std::min_element(walk.begin(), walk.end(),
                [](std::size_t a, std::size_t b) { return a / 2 < b / 2; }),
              walk.end());
            rings.push_back(std::move(walk));
          }
        }
      }
    }
    std::sort(
      rings.begin(), rings.end(), [](const auto& a, const auto& b) { return a[0] / 2 < b[0] / 2; });
    return rings;
  }

  std::vector<std::size_t> walkFrom(std::size_t end, std::vector<char>& isMet) const
  {
    std::vector<std::size_t> walk;
    while (!isMet[end / 2])
    {
      isMet[end / 2] = 1;
      walk.push_back(end);
      const Ends& ends = this->endsAt[this->positionAt(end ^ 1)];
      end = ends.count == 2 ? static_cast<std::size_t>(ends.sum) - (end ^ 1) : end;
    }
    return walk;
  }

  static void appendEdge(std::uint32_t a, std::uint32_t b, std::vector<std::uint64_t>& edges)
  {
    if (a != b)
    {
      edges.push_back(std::uint64_t(std::min(a, b)) << 32 | std::max(a, b));
    }
  }

  void appendEdges(const Range& range, std::vector<std::uint64_t>& edges) const
  {
    for (std::size_t i = range.begin + 1; i < range.end; ++i)
    {
      appendEdge(this->at[i - 1], this->at[i], edges);
    }
  }

  void toggle(const std::vector<std::uint64_t>& edges)
  {
    for (const std::uint64_t edge : edges)
    {
      this->poll.step();
      if (!this->outline.insert(edge).second)
      {
        this->outline.erase(edge);
      }
    }
  }

  const LineView view;
  const std::size_t lines;
  StepPoll poll;
  std::vector<std::uint32_t> at; ///< the position of each point
  std::vector<Ends> endsAt;      ///< by position
  std::unordered_set<std::uint64_t> outline;
};

void requireValid(const LineView& lines, int dimension)
{
  if (dimension != 2 && dimension != 3)
  {
    throw badArgument("lines are compared in 2 dimensions or 3");
  }
  requireValid(lines.points, dimension);
  const bool areCounts = lines.lines >= 0 && lines.polygons >= 0;
  const std::int64_t count = areCounts ? lines.lines + lines.polygons : 0;
  const std::int64_t* const offsets = lines.offsets;
  if (!areCounts || (count > 0 && !offsets) ||
    (count > 0 &&
      (offsets[0] != 0 || offsets[count] != lines.points.count ||
        !std::is_sorted(offsets, offsets + count + 1))))
  {
    throw badArgument("the offsets of lines must ascend from 0 to the number of their points");
  }
}

}

Buffer<std::int8_t> closedLines(const LineView& lines, int dimension, const Options& options)
{
  return engineCall(
    [&]
    {
      requireValid(lines, dimension);
      Buffer<std::int8_t> sides;
      runOver(1, options,
        [&](Monitor& monitor) { sides = RingFinder(lines, dimension, monitor).find(); });
      return sides;
    });
}

}
