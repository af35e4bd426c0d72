// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Renumber a polyhedron without gaps.
#ifndef flipflop_Compact_h
#define flipflop_Compact_h

#include "Mesh/Polyhedron.h"

namespace flipflop
{

/// The same polyhedron, its triangles and vertices in their order, without gaps.
Polyhedron compact(Polyhedron&& polyhedron);

}

#endif
