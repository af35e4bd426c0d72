// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constraints between points on one line: parts of the chain.
#ifndef flipflop_ChainConstraints_h
#define flipflop_ChainConstraints_h

#include "Constraints/FixedEdge.h"
#include "Constraints/Position.h"
#include "Points/PointSource.h"
#include "Support/Monitor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// Tell the edges of a chain that constraints run along. Polygons have no inside there: they run
/// each edge as often forth as back.
/// @param constraints whose ends are points
inline void fixChainEdges(const PointSource& source, const ConstraintView& constraints,
  Monitor& monitor, ConstrainedTriangulation& result)
{
  const auto positionAt = [&source](std::int64_t id)
  { return positionOf(source.vertex(static_cast<std::uint32_t>(id))); };
  std::vector<std::pair<Position, std::uint32_t>> along;
  for (std::size_t i = 0; i < result.pointIds.size(); ++i)
  {
    along.emplace_back(positionAt(result.pointIds[i]), static_cast<std::uint32_t>(i));
  }
  std::sort(along.begin(), along.end());
  const auto positionOf = [&](std::int64_t id)
  {
    const auto found = std::lower_bound(
      along.begin(), along.end(), std::make_pair(positionAt(id), std::uint32_t(0)));
    return static_cast<std::uint32_t>(found - along.begin());
  };

  // Of each link the next one, from it on, that no constraint has taken yet.
  std::vector<std::uint32_t> next(along.size());
  for (std::size_t i = 0; i < next.size(); ++i)
  {
    next[i] = static_cast<std::uint32_t>(i);
  }
  const auto firstFree = [&next](std::uint32_t i)
  {
    for (; next[i] != i; i = next[i])
    {
      next[i] = next[next[i]];
    }
    return i;
  };
  StepPoll poll(monitor);
  std::vector<FixedEdge> edges;
  for (std::int64_t c = 0; c < constraints.count; ++c)
  {
    poll.step();
    const std::uint32_t a = positionOf(constraints.ends[2 * c]);
    const std::uint32_t b = positionOf(constraints.ends[2 * c + 1]);
    for (std::uint32_t i = firstFree(std::min(a, b)); i < std::max(a, b); i = firstFree(i))
    {
      poll.step();
      edges.emplace_back(along[i].second, along[i + 1].second, static_cast<std::uint32_t>(c));
      next[i] = i + 1;
    }
  }
  writeFixedEdges(edges, result);
}

}

#endif
