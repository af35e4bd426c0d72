// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What builds triangulations in the plane. Points are x, y and a weight each; weights that are all
/// zero are not given to those who can do without.
#ifndef flipflop_TriangulationContenders_h
#define flipflop_TriangulationContenders_h

#include "Contender.h"

namespace flipflop
{

/// This engine: the one canonical regular triangulation.
std::unique_ptr<Contender> makeFlipFlopTriangulation(int threads);

/// CGAL's Regular_triangulation_2 with exact predicates (Epick), its points inserted as a range, so
/// in spatial order. Single-threaded.
std::unique_ptr<Contender> makeCgalRegular();

/// CGAL's Delaunay_triangulation_2, likewise; it knows no weights.
std::unique_ptr<Contender> makeCgalDelaunay();

std::string cgalTriangulationVersion();

}

#endif
