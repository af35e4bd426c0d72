// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The edges of a surface, each with the number of times it is used either way.
#ifndef flipflop_SurfaceEdges_h
#define flipflop_SurfaceEdges_h

#include "Support/Parallel.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace flipflop
{

using SurfaceTriangle = std::array<std::uint32_t, 3>;

struct SurfaceEdge
{
  std::uint32_t low;
  std::uint32_t high;
  bool forwards; ///< from low to high

  static SurfaceEdge from(std::uint32_t a, std::uint32_t b)
  {
    return { std::min(a, b), std::max(a, b), a < b };
  }
};

inline std::vector<SurfaceEdge> edgesOf(const std::vector<SurfaceTriangle>& triangles)
{
  std::vector<SurfaceEdge> edges;
  edges.reserve(3 * triangles.size());
  for (const SurfaceTriangle& t : triangles)
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      edges.push_back(SurfaceEdge::from(t[e], t[(e + 1) % 3]));
    }
  }
  return edges;
}

/// @p visit (edge, times used from low to high, times the other way) each.
template <class Visit>
void forEachEdge(std::vector<SurfaceEdge> edges, Visit&& visit)
{
  const auto ends = [](const SurfaceEdge& edge) { return std::tie(edge.low, edge.high); };
  threads::sort(edges.begin(), edges.end(),
    [&](const SurfaceEdge& a, const SurfaceEdge& b) { return ends(a) < ends(b); });
  for (std::size_t i = 0; i < edges.size();)
  {
    int uses[2] = { 0, 0 };
    const SurfaceEdge edge = edges[i];
    for (; i < edges.size() && ends(edges[i]) == ends(edge); ++i)
    {
      ++uses[edges[i].forwards ? 1 : 0];
    }
    visit(edge, uses[1], uses[0]);
  }
}

}

#endif
