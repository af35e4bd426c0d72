// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rounds of quickhull on few points: a start for those of which few are extreme.
///
/// A round compares all points that remain with all planes of a convex polyhedron. Those inside are
/// dropped; of those above a plane, the furthest is a vertex of the hull, and is inserted and
/// flipped in. So a polyhedron of some dozen vertices leaves few points for the ways that suit
/// many.
#ifndef flipflop_Quickhull_h
#define flipflop_Quickhull_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Geometry/HullGeometry.h"
#include "Points/PointSubset.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

/// @param[in,out] polyhedron convex, without gaps
/// @param         enough     triangles to stop at
/// @return the ids of the subset's points that may be outside, ascending
std::vector<std::uint32_t> quickhull(const BuildTask<HullGeometry>& task, Polyhedron& polyhedron,
  const PointSubset& subset, std::size_t enough, Tally& tally);

}

#endif
