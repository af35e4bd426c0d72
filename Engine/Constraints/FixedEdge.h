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
  std::int32_t balance;     ///< sides of polygons from low to high, less those back

  /// @param sides of polygons that run from @p from to @p to, less those back
  FixedEdge(std::uint32_t from, std::uint32_t to, std::uint32_t constraint, std::int32_t sides = 0)
    : low(std::min(from, to))
    , high(std::max(from, to))
    , constraint(constraint)
    , balance(from < to ? sides : -sides)
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

/// All records of an edge as one, with the first constraint; edges in their order.
inline void joinRecords(std::vector<FixedEdge>& edges)
{
  std::sort(edges.begin(), edges.end(), FixedEdge::isBefore);
  std::size_t count = 0;
  for (const FixedEdge& edge : edges)
  {
    if (count > 0 && FixedEdge::isSameEdge(edges[count - 1], edge))
    {
      edges[count - 1].balance += edge.balance;
    }
    else
    {
      edges[count++] = edge;
    }
  }
  edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(count), edges.end());
}

/// @param edges of indices into the result's points; are sorted
inline void writeFixedEdges(std::vector<FixedEdge>& edges, ConstrainedTriangulation& result)
{
  joinRecords(edges);
  result.fixedEdges.allocate(2 * edges.size());
  result.constraintOf.allocate(edges.size());
  result.balance.allocate(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    result.fixedEdges[2 * i] = edges[i].low;
    result.fixedEdges[2 * i + 1] = edges[i].high;
    result.constraintOf[i] = edges[i].constraint;
    result.balance[i] = edges[i].balance;
  }
}

}

#endif
