// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What builds hulls.
#ifndef flipflop_HullContenders_h
#define flipflop_HullContenders_h

#include "Contender.h"

namespace flipflop
{

/// This engine: one canonical hull of true facets, triangulated.
std::unique_ptr<Contender> makeFlipFlop(int threads);

/// Qhull's reentrant library, option "Qt" (triangulated output). Single-threaded.
std::unique_ptr<Contender> makeQhull();

/// CGAL's convex_hull_3 with exact predicates (Epick). Single-threaded.
std::unique_ptr<Contender> makeCgal();

/// The libraries' versions, for the report.
std::string qhullVersion();
std::string cgalVersion();

}

#endif
