// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From CGAL's triangles to true facets, which are one polygon each.
#ifndef flipflop_test_MergedFacets_h
#define flipflop_test_MergedFacets_h

#include "Testing/Engine/References/ReferenceDetail.h"

#include <map>
#include <stdexcept>
#include <unordered_map>

namespace flipflop
{
namespace test
{

using Triangle = std::array<int, 3>;

/// The triangle on the left of each directed edge.
using Owners = std::unordered_map<std::uint64_t, int>;

inline std::uint64_t edgeKey(int a, int b)
{
  return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
}

inline Owners ownersOf(const std::vector<Triangle>& triangles)
{
  Owners owners;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    const Triangle& a = triangles[t];
    for (int e = 0; e < 3; ++e)
    {
      if (!owners.emplace(edgeKey(a[e], a[(e + 1) % 3]), t).second)
      {
        throw std::runtime_error("CGAL's triangles use an edge twice");
      }
    }
  }
  return owners;
}

/// Triangles, merged step by step into facets.
class MergedFacets
{
public:
  explicit MergedFacets(const std::vector<Triangle>& triangles)
    : Triangles(triangles)
    , Parents(triangles.size())
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  void merge(int s, int t) { this->Parents[this->root(s)] = this->root(t); }

  /// The strictly extreme corners of each facet, in its plane in @p space.
  template <class Space>
  std::vector<Cell> polygons(const Space& space)
  {
    std::map<int, std::pair<int, std::vector<int>>> facets;
    for (int t = 0; t < static_cast<int>(this->Triangles.size()); ++t)
    {
      const Triangle& corners = this->Triangles[t];
      auto& facet = facets[this->root(t)];
      facet.first = t;
      facet.second.insert(facet.second.end(), corners.begin(), corners.end());
    }
    std::vector<Cell> cells;
    for (auto& item : facets)
    {
      std::vector<int>& corners = item.second.second;
      const Triangle& t = this->Triangles[item.second.first];
      std::sort(corners.begin(), corners.end());
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
      const std::vector<int> polygon = corners.size() == 3
        ? std::vector<int>(t.begin(), t.end())
        : planarHull(space, corners, t[0], t[1], t[2]);
      cells.emplace_back(polygon.begin(), polygon.end());
    }
    return cells;
  }

private:
  int root(int t)
  {
    while (this->Parents[t] != t)
    {
      t = this->Parents[t] = this->Parents[this->Parents[t]];
    }
    return t;
  }

  const std::vector<Triangle>& Triangles;
  std::vector<int> Parents;
};

/// Triangles, merged across edges whose four corners are in one plane.
/// @param side    int (const Triangle&, int v): negative if v is where a facet's neighbour may not
/// be
/// @param isFixed bool (std::uint64_t edge): not across this
/// @throw std::runtime_error with @p fault for such a neighbour
template <class Side, class IsFixed>
MergedFacets mergedFlat(const std::vector<Triangle>& triangles, const Owners& owners,
  const Side& side, const IsFixed& isFixed, const char* fault)
{
  MergedFacets facets(triangles);
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    const Triangle& a = triangles[t];
    for (int e = 0; e < 3; ++e)
    {
      const std::uint64_t back = edgeKey(a[(e + 1) % 3], a[e]);
      const auto twin = owners.find(back);
      if (twin == owners.end() || isFixed(back))
      {
        continue;
      }
      for (const int v : triangles[twin->second])
      {
        const int at = v == a[e] || v == a[(e + 1) % 3] ? 1 : side(a, v);
        if (at < 0)
        {
          throw std::runtime_error(fault);
        }
        if (at == 0)
        {
          facets.merge(t, twin->second);
        }
      }
    }
  }
  return facets;
}

/// Merged facets must still be a sphere, or a disk: each edge once either way, or at most once.
inline void checkSurface(const ReferenceHull& result, bool isClosed)
{
  std::unordered_map<std::uint64_t, int> edges;
  for (const Cell& cell : result.cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const int a = static_cast<int>(cell[i]);
      const int b = static_cast<int>(cell[(i + 1) % cell.size()]);
      edges[edgeKey(std::min(a, b), std::max(a, b))] += a < b ? 1 : 1 << 16;
    }
  }
  for (const auto& edge : edges)
  {
    const int there = edge.second & 0xffff, back = edge.second >> 16;
    if (there > 1 || back > 1 || (isClosed && there + back != 2))
    {
      throw std::runtime_error("the merged facets overlap, or do not close up");
    }
  }
  if (result.ids.size() + result.cells.size() != edges.size() + (isClosed ? 2 : 1))
  {
    throw std::runtime_error("the merged facets are no sphere, or no disk");
  }
}

}
}

#endif
