// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An edge that constraints run along.
#ifndef flipflop_FixedEdge_h
#define flipflop_FixedEdge_h

#include <flipflop/ConstrainedTriangulation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

struct FixedEdge
{
  std::uint32_t low, high;  ///< ends, the lower one first
  std::uint32_t constraint; ///< that runs along it

  FixedEdge(std::uint32_t from, std::uint32_t to, std::uint32_t constraint)
    : low(std::min(from, to))
    , high(std::max(from, to))
    , constraint(constraint)
  {
  }

  static bool isSameEdge(const FixedEdge& a, const FixedEdge& b)
  {
    return a.low == b.low && a.high == b.high;
  }
  static bool isBefore(const FixedEdge& a, const FixedEdge& b)
  {
    return a.low != b.low ? a.low < b.low
      : a.high != b.high  ? a.high < b.high
                          : a.constraint < b.constraint;
  }
};

/// Of the records of an edge, that of the first constraint alone; edges in their order.
inline void keepFirstConstraints(std::vector<FixedEdge>& edges)
{
  std::sort(edges.begin(), edges.end(), FixedEdge::isBefore);
  edges.erase(std::unique(edges.begin(), edges.end(), FixedEdge::isSameEdge), edges.end());
}

/// @param edges of indices into the result's points; are sorted
inline void writeFixedEdges(std::vector<FixedEdge>& edges, ConstrainedTriangulation& result)
{
  keepFirstConstraints(edges);
  result.fixedEdges.allocate(2 * edges.size());
  result.constraintOf.allocate(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    result.fixedEdges[2 * i] = edges[i].low;
    result.fixedEdges[2 * i + 1] = edges[i].high;
    result.constraintOf[i] = edges[i].constraint;
  }
}

}

#endif
