// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Is a closed surface star-shaped from a kernel point, and from which point could it be?
#ifndef flipflop_StarShape_h
#define flipflop_StarShape_h

#include "HullGeometry.h"
#include "Polyhedron.h"

#include <cstdint>

namespace flipflop
{

/// Triangles that keep a polyhedron from being star-shaped; count 0: it is.
struct StarFault
{
  std::int64_t triangle = -1; ///< the first
  std::int64_t count = 0;
};

/// Triangles that the geometry's kernel point does not see strictly from inside; where it sees all,
/// those that cover one direction beyond the first: the surface then winds around the kernel more
/// than once. Exact.
/// @param polyhedron closed, oriented, manifold
StarFault findStarFault(const HullGeometry& geometry, const Polyhedron& polyhedron);

/// Is the surface turned inside out, by the sign of its (rounded) volume?
bool isInsideOut(const Polyhedron& polyhedron);

/// Turn all triangles over.
void turnOver(Polyhedron& polyhedron);

/// Seek a point that sees all triangles of an outward surface from inside, with the greatest
/// margin: rounded linear programming. What it finds is for findStarFault to judge.
/// @return false when the surface has no such point, as far as rounding can tell
bool seekKernel(const Polyhedron& polyhedron, double* kernel);

}

#endif
