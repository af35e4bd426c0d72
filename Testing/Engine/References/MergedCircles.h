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
  MergedFacets facets = mergedFlat(
    triangles, ownersOf(triangles),
    [&](const Triangle& t, int v) { return space.orient(t[0], t[1], t[2], v); },
    [&](std::uint64_t edge) { return fixed.count(edge) != 0; },
    "an edge is neither fixed nor Delaunay");
  ReferenceTriangulation result;
  result.dimension = 2;
  result.cells = facets.polygons(FilteredSpace(cloud));
  finish(result);
  return result;
}

}
}

#endif
