// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The CPU's engine for the plane, and for hulls that most points are vertices of: the points are
/// cut into parts (PartTree.h), each part is triangulated alone (PartTriangulation.h,
/// PerturbedPart.h), and parts are merged in pairs, up the tree (PartMerge.h). In space, the last
/// two are the two sides of a plane through the kernel point, and meet all around it (PartBelt.h).
/// Parts share nothing, so threads take any of them; which, changes nothing.
#ifndef flipflop_PartsBuilder_h
#define flipflop_PartsBuilder_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"
#include "Geometry/OctahedralMap.h"
#include "Points/PointSubset.h"

#include <cstdint>
#include <type_traits>
#include <vector>

namespace flipflop
{

/// Are so many points worth parts, and has the geometry a kernel point that can be a vertex?
bool partsPay(const HullGeometry& geometry, std::uint32_t count);

/// The hull of a subset's points.
/// @param around ids of points, ascending, whose hull the kernel point is inside of
/// @param map    directions from the geometry's kernel point
/// @param from, to which part of the run's progress this is
/// @param out    ids of points that are still to be inserted, ascending
/// @return empty: the kernel point need not be inside of what parts have
Polyhedron hullByParts(const BuildTask<HullGeometry>& task, const PointSubset& subset,
  const std::vector<std::uint32_t>& around, const OctahedralMap& map, double from, double to,
  std::vector<std::uint32_t>& out, Tally& tally, Statistics& statistics);

/// As PolyhedronBuilder, from the points alone.
/// @tparam Weighted false: all weights are zero
template <bool Weighted>
std::conditional_t<Weighted, Polyhedron, PlanePolyhedron> triangulateByParts(
  const BuildTask<LiftedGeometry<Weighted>>& task, Tally& tally, Statistics& statistics);

}

#endif
