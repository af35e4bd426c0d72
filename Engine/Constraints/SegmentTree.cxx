// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constraints/SegmentTree.h"

#include "Predicates/ErrorBounds.h"
#include "Support/Parallel.h"
#include <flipflop/Error.h>

#include <algorithm>
#include <cmath>

namespace flipflop
{

SegmentTree::SegmentTree(const std::vector<Position>& at, const std::vector<PositionSegment>& given,
  std::size_t partCount, Monitor& monitor)
  : positions(at)
  , segments(given)
  , parts(this->partsOf(partCount, monitor))
  , bundle(at, given)
  , boxTree(
      static_cast<std::uint32_t>(this->parts.size()),
      [this](std::uint32_t part) { return this->boxOf(part); }, monitor, BoxTree::Lengths::AsShares)
  , boxes(this->parts.size())
{
  eachChunk(this->boxes.size(), std::size_t(1) << 12,
    [this](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t slot = begin; slot < end; ++slot)
      {
        this->boxes[slot] = this->boxOf(this->boxTree.item(static_cast<std::uint32_t>(slot)));
      }
    });
}

std::vector<SegmentTree::Part> SegmentTree::partsOf(std::size_t partCount, Monitor& monitor) const
{
  if (this->segments.size() + partCount >= NoIndex)
  {
    throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(this->segments.size()));
  }
  double most = 0;
  for (const PositionSegment& segment : this->segments)
  {
    const Position &a = this->positions[segment.from], &b = this->positions[segment.to];
    most = std::max(
      { most, std::fabs(a.x[0]), std::fabs(a.x[1]), std::fabs(b.x[0]), std::fabs(b.x[1]) });
  }
  // In shares of the largest coordinate, so that nothing overflows.
  std::vector<double> length;
  double sum = 0;
  for (const PositionSegment& segment : this->segments)
  {
    const Position &a = this->positions[segment.from], &b = this->positions[segment.to];
    double own = 0;
    for (int i = 0; i < 2; ++i)
    {
      own += most > 0 ? std::fabs(a.x[i] / most - b.x[i] / most) : 0.0;
    }
    length.push_back(own);
    sum += own;
  }
  const double mean = sum / static_cast<double>(partCount);
  std::vector<Part> result;
  StepPoll poll(monitor);
  for (std::uint32_t s = 0; s < this->segments.size(); ++s)
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

Box SegmentTree::boxOf(std::uint32_t item) const
{
  const Part& part = this->parts[item];
  const PositionSegment& segment = this->segments[part.segment];
  return this->boxBetween(this->positions[segment.from], this->positions[segment.to], part);
}

/// A box that the part is in: x, y, and the offset.
Box SegmentTree::boxBetween(const Position& a, const Position& b, const Part& part) const
{
  const double from[3] = { a.x[0], a.x[1], this->bundle.offsetOf(a) };
  const double to[3] = { b.x[0], b.x[1], this->bundle.offsetOf(b) };
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

}
