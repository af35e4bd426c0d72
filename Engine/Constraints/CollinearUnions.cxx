// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constraints/CollinearUnions.h"

#include "Predicates/PlaneOrientation.h"
#include "Support/Parallel.h"

namespace flipflop
{

namespace
{

struct Item
{
  Position from, to;
  std::uint32_t segment;
};

/// Of their lines, first by direction, then from right to left; 0: they are on one. Segments run
/// from their lower positions, so their directions are within a half-turn, which has an order.
int compareLines(const Item& a, const Item& b)
{
  const int turn = planeTurn(a.from.x, a.to.x, b.from.x, b.to.x);
  return turn != 0 ? turn : planeTurn(a.from.x, a.to.x, a.from.x, b.from.x);
}

}

CollinearUnions collinearUnions(const std::vector<Position>& positions,
  const std::vector<PositionSegment>& segments, Monitor& monitor)
{
  StepPoll poll(monitor);
  std::vector<Item> items;
  items.reserve(segments.size());
  for (const PositionSegment& segment : segments)
  {
    poll.step();
    items.push_back(
      { positions[segment.from], positions[segment.to], static_cast<std::uint32_t>(items.size()) });
  }
  threads::sort(items.begin(), items.end(),
    [](const Item& a, const Item& b)
    {
      const int order = compareLines(a, b);
      return order != 0 ? order > 0 : a.from < b.from;
    });
  CollinearUnions result;
  result.unionOf.resize(segments.size());
  for (const Item& item : items)
  {
    poll.step();
    const PositionSegment& own = segments[item.segment];
    if (result.unions.empty() || !(item.from < positions[result.unions.back().to]) ||
      compareLines(*(&item - 1), item) != 0)
    {
      result.unions.push_back(own);
    }
    else if (positions[result.unions.back().to] < item.to)
    {
      result.unions.back().to = own.to;
    }
    result.unionOf[item.segment] = static_cast<std::uint32_t>(result.unions.size() - 1);
  }
  return result;
}

}
