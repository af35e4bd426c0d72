// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The finish, second part: the one canonical form of a hull (see Hull.h).
#ifndef flipflop_Canonical_h
#define flipflop_Canonical_h

#include "CoordinateRange.h"
#include "Duplicate.h"
#include "Hull.h"
#include "Monitor.h"
#include "Options.h"
#include "Polyhedron.h"

#include <cstdint>
#include <vector>

namespace flipflop
{

/// @param polyhedron strictly extreme vertices only; bit e of a triangle's index tells that its
/// edge e is flat
/// @param anyFlat    whether there is a flat edge at all
/// @param duplicates pairs of ids at one position
/// @param pointCount ids are below this
/// @param range      of the scaled coordinates
/// @param exponent   coordinates are scaled by 2^exponent
/// Fills in all of @p hull but its statistics.
/// @throw Error Aborted, between its passes
void writeCanonical(const Polyhedron& polyhedron, bool anyFlat,
  const std::vector<Duplicate>& duplicates, std::uint32_t pointCount, const CoordinateRange& range,
  int exponent, FacetMode facets, Monitor& monitor, Hull& hull);

}

#endif
