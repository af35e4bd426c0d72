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

}
}

#endif
