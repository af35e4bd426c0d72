// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A polyhedron's triangles along a curve: any run of consecutive ones has a short border. So
/// patches of them share few edges (Patches.h), and what is near in space is near in memory.
#ifndef flipflop_TriangleOrder_h
#define flipflop_TriangleOrder_h

#include "Geometry/OctahedralMap.h"
#include "Mesh/Polyhedron.h"
#include "Support/Monitor.h"

namespace flipflop
{

/// @param polyhedron without gaps
void sortAlongCurve(Polyhedron& polyhedron, const OctahedralMap& octahedral, Monitor& monitor);

}

#endif
