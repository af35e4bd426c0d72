// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The CPU's engine for the plane without weights: the points are cut into parts (PartTree.h), each
/// part is triangulated alone (PartTriangulation.h), and parts are merged in pairs, up the tree
/// (PartMerge.h). Parts share nothing, so threads take any of them; which, changes nothing.
#ifndef flipflop_PartsBuilder_h
#define flipflop_PartsBuilder_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Geometry/LiftedGeometry.h"

namespace flipflop
{

class PartsBuilder
{
public:
  /// As PolyhedronBuilder. Of the start, nothing is used; the result is in *task.plane.
  static Polyhedron build(const BuildTask<LiftedGeometry<false>>& task, Polyhedron&& start,
    Tally& tally, Statistics& statistics);
};

}

#endif
