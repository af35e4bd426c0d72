// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From the triangles of a constrained triangulation to its true cells: all points of one circle
/// that no constraint parts.
#ifndef flipflop_test_MergedCircles_h
#define flipflop_test_MergedCircles_h

#include "Testing/Engine/References/Lift.h"
#include "Testing/Engine/References/MergedFacets.h"
#include "Testing/Engine/References/ReferenceConstrained.h"

#include <set>

namespace flipflop
{
namespace test
{

/// @param fixed both directions of each fixed edge
/// @throw std::runtime_error when an edge is neither fixed nor locally Delaunay
inline ReferenceTriangulation mergeCircles(
  const Cloud& cloud, const std::vector<Triangle>& triangles, const std::set<std::uint64_t>& fixed)
{
  const LiftedSpace space(cloud);
  const Owners owners = ownersOf(triangles);
  MergedFacets facets(triangles);
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    const Triangle& a = triangles[t];
    for (int e = 0; e < 3; ++e)
    {
      const std::uint64_t back = edgeKey(a[(e + 1) % 3], a[e]);
      const auto twin = owners.find(back);
      if (twin == owners.end() || fixed.count(back) != 0)
      {
        continue;
      }
      for (const int v : triangles[twin->second])
      {
        const int side = v == a[e] || v == a[(e + 1) % 3] ? 1 : space.orient(a[0], a[1], a[2], v);
        if (side < 0)
        {
          throw std::runtime_error("an edge is neither fixed nor Delaunay");
        }
        if (side == 0)
        {
          facets.merge(t, twin->second);
        }
      }
    }
  }
  ReferenceTriangulation result;
  result.dimension = 2;
  result.cells = facets.polygons(FilteredSpace(cloud));
  finish(result);
  return result;
}

}
}

#endif
