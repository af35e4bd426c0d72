// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An edge that constraints run along.
#ifndef flipflop_FixedEdge_h
#define flipflop_FixedEdge_h

#include "Points/Vertex.h"
#include <flipflop/ConstrainedTriangulation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// The sides of polygons along an edge.
struct SidesAlong
{
  std::int64_t balance = 0;                      ///< those that run forth, less those back
  std::uint32_t first[2] = { NoIndex, NoIndex }; ///< constraint, of those forth, and back

  SidesAlong reversed() const
  {
    SidesAlong result;
    result.balance = -this->balance;
    result.first[0] = this->first[1];
    result.first[1] = this->first[0];
    return result;
  }

  void add(const SidesAlong& other)
  {
    this->balance += other.balance;
    this->first[0] = std::min(this->first[0], other.first[0]);
    this->first[1] = std::min(this->first[1], other.first[1]);
  }

  /// The first of those that run the way of which there are more; -1: as many run either way.
  std::int64_t decisive() const
  {
    return this->balance == 0 ? -1 : static_cast<std::int64_t>(this->first[this->balance < 0]);
  }
};

struct FixedEdge
{
  std::uint32_t low, high;  ///< ends, the lower one first
  std::uint32_t constraint; ///< that runs along it
  SidesAlong sides;         ///< from low to high

  /// @param sides from @p from to @p to
  FixedEdge(std::uint32_t from, std::uint32_t to, std::uint32_t constraint,
    const SidesAlong& sides = SidesAlong())
    : low(std::min(from, to))
    , high(std::max(from, to))
    , constraint(constraint)
    , sides(from < to ? sides : sides.reversed())
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
      edges[count - 1].sides.add(edge.sides);
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
  result.sideOf.allocate(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    result.fixedEdges[2 * i] = edges[i].low;
    result.fixedEdges[2 * i + 1] = edges[i].high;
    result.constraintOf[i] = edges[i].constraint;
    result.balance[i] = edges[i].sides.balance;
    result.sideOf[i] = edges[i].sides.decisive();
  }
}

}

#endif
