// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constraints/SegmentLinks.h"

#include "Constraints/CollinearUnions.h"
#include "Constraints/PointsOnSegments.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace flipflop
{

namespace
{

/// Makes chains, one link after another.
class ChainBuilder
{
public:
  ChainBuilder(const PositionNumbers& toUse, SegmentLinks& toFill)
    : numbers(toUse)
    , result(toFill)
  {
    this->result = SegmentLinks();
    this->result.firstOfChain.push_back(0);
  }

  void addLink(std::uint32_t from, std::uint32_t to)
  {
    const auto found = this->known.emplace(
      std::uint64_t(from) << 32 | to, static_cast<std::uint32_t>(this->result.ends.size()));
    if (found.second)
    {
      this->result.ends.push_back({ from, to });
    }
    this->result.chains.push_back(found.first->second);
  }

  void endChain() { this->result.firstOfChain.push_back(this->result.chains.size()); }

  /// The links of a chain from one position on it to another.
  SegmentLinks::Range between(std::uint32_t chain, const PositionSegment& segment) const
  {
    return { this->slotOf(chain, segment.from), this->slotOf(chain, segment.to) };
  }

private:
  /// The link that begins there, or the end of the chain.
  std::size_t slotOf(std::uint32_t chain, std::uint32_t index) const
  {
    const std::vector<Position>& at = this->numbers.positions();
    const auto begin = this->result.chains.begin();
    const auto linkAt = [&](std::uint32_t c)
    { return begin + static_cast<std::ptrdiff_t>(this->result.firstOfChain[c]); };
    const auto found = std::lower_bound(linkAt(chain), linkAt(chain + 1), at[index],
      [&](std::uint32_t link, const Position& position)
      { return at[this->result.ends[link].from] < position; });
    return static_cast<std::size_t>(found - begin);
  }

  const PositionNumbers& numbers;
  SegmentLinks& result;
  std::unordered_map<std::uint64_t, std::uint32_t> known;
};

}

SegmentLinks SegmentLinks::undivided(const std::vector<PositionSegment>& segments)
{
  SegmentLinks result;
  result.ends = segments;
  result.isDivided.assign(segments.size(), 0);
  result.chains.resize(segments.size());
  std::iota(result.chains.begin(), result.chains.end(), 0u);
  result.firstOfChain.resize(segments.size() + 1);
  std::iota(result.firstOfChain.begin(), result.firstOfChain.end(), std::size_t(0));
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    result.ofSegment.push_back({ s, s + 1 });
  }
  return result;
}

bool divideSegments(PositionNumbers& numbers, const std::vector<PositionSegment>& segments,
  const std::vector<char>& isChosen, const PointSource& source, Monitor& monitor,
  SegmentLinks& result)
{
  std::vector<PositionSegment> chosen;
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    if (isChosen[s])
    {
      chosen.push_back(segments[s]);
    }
  }
  const CollinearUnions lines = collinearUnions(numbers.positions(), chosen, monitor);
  const std::vector<PositionOnSegment> points =
    pointsOnSegments(numbers.positions(), lines.unions, source, monitor);
  if (points.empty())
  {
    return false;
  }
  ChainBuilder builder(numbers, result);
  StepPoll poll(monitor);
  auto next = points.begin();
  for (std::uint32_t line = 0; line < lines.unions.size(); ++line)
  {
    std::uint32_t from = lines.unions[line].from;
    for (; next != points.end() && next->segment == line; ++next)
    {
      poll.step();
      const std::uint32_t index = numbers.add(next->position);
      builder.addLink(from, index);
      from = index;
    }
    builder.addLink(from, lines.unions[line].to);
    builder.endChain();
  }
  result.isDivided.assign(result.ends.size(), 1);
  auto line = lines.unionOf.begin(); // of the next chosen one
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    poll.step();
    if (isChosen[s])
    {
      result.ofSegment.push_back(builder.between(*line++, segments[s]));
    }
    else
    {
      // It may be a link of those that are divided.
      result.ofSegment.push_back({ result.chains.size(), result.chains.size() + 1 });
      builder.addLink(segments[s].from, segments[s].to);
      builder.endChain();
    }
  }
  result.isDivided.resize(result.ends.size(), 0);
  return true;
}

}
