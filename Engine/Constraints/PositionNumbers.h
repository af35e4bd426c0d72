// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Numbers for positions, and which points are at them.
#ifndef flipflop_PositionNumbers_h
#define flipflop_PositionNumbers_h

#include "Constraints/Position.h"
#include "Points/PointSource.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include <flipflop/Error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flipflop
{

/// Numbers for positions, in the order in which they come.
class PositionNumbers
{
public:
  std::uint32_t add(const Position& position)
  {
    const auto found =
      this->numbers.emplace(position, static_cast<std::uint32_t>(this->all.size()));
    if (found.second)
    {
      if (this->all.size() >= NoIndex)
      {
        throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(this->all.size()));
      }
      this->all.push_back(position);
    }
    return found.first->second;
  }

  /// NoIndex: it has none.
  std::uint32_t find(const Position& position) const
  {
    const auto found = this->numbers.find(position);
    return found == this->numbers.end() ? NoIndex : found->second;
  }

  const std::vector<Position>& positions() const { return this->all; }

private:
  std::unordered_map<Position, std::uint32_t, PositionHash> numbers;
  std::vector<Position> all;
};

/// For each position that is requested the lowest point there; -1: there is none, or it is not
/// requested.
inline std::vector<std::int64_t> lowestPointsAt(const PositionNumbers& numbers,
  const std::vector<char>& isWanted, const PointSource& source, Monitor& monitor)
{
  constexpr std::size_t ItemsPerTask = 1 << 12;
  std::vector<std::int64_t> result(isWanted.size(), -1);
  Position low = { { HUGE_VAL, HUGE_VAL } }, high = { { -HUGE_VAL, -HUGE_VAL } };
  for (std::size_t index = 0; index < isWanted.size(); ++index)
  {
    for (int i = 0; isWanted[index] && i < 2; ++i)
    {
      low.x[i] = std::min(low.x[i], numbers.positions()[index].x[i]);
      high.x[i] = std::max(high.x[i], numbers.positions()[index].x[i]);
    }
  }
  if (low.x[0] > high.x[0])
  {
    return result;
  }
  using Found = std::pair<std::uint32_t, std::uint32_t>; // a position, and the point there
  const std::uint32_t count = source.count();
  std::vector<std::vector<Found>> found(chunkCount(count, ItemsPerTask));
  eachChunk(count, ItemsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t number)
    {
      monitor.poll();
      for (auto id = static_cast<std::uint32_t>(begin); id < end; ++id)
      {
        const Position position = positionOf(source.vertex(id));
        if (low.x[0] <= position.x[0] && position.x[0] <= high.x[0] && low.x[1] <= position.x[1] &&
          position.x[1] <= high.x[1])
        {
          const std::uint32_t known = numbers.find(position);
          if (known != NoIndex && isWanted[known])
          {
            found[number].emplace_back(known, id);
          }
        }
      }
    });
  for (const std::vector<Found>& some : found)
  {
    for (const Found& point : some)
    {
      std::int64_t& id = result[point.first];
      id = id < 0 ? point.second : id;
    }
  }
  return result;
}

}

#endif
