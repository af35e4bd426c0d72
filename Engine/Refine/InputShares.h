// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Of which points of the input the values at new points of a mesh are made.
#ifndef flipflop_InputShares_h
#define flipflop_InputShares_h

#include "Refine/Refinement.h"
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/PointView.h>
#include <flipflop/TriangulationQueries.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// RefinedMesh::shares.
/// @param start     of the points, with the constraints
/// @param slots     of the new points
/// @param positions x and y of each of these, in the caller's unit
SiteShares sharesInInput(const PointView& points, const ConstrainedTriangulation& start,
  const Refinement& refinement, const Refinement::Mesh& mesh,
  const std::vector<std::uint32_t>& slots, const double* positions, int threads);

}

#endif
