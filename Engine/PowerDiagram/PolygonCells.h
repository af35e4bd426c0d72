// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cells of a power diagram in a convex polygon.
#ifndef flipflop_PolygonCells_h
#define flipflop_PolygonCells_h

#include "PowerDiagram/CellRepair.h"
#include "PowerDiagram/CornerNumbers.h"
#include "PowerDiagram/PowerCorners.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>

#include <vector>

namespace flipflop
{

/// The cells as rounded; corners are numbered by first use, and no position is there twice.
/// @param t       checked by requireCells()
/// @param centers of its facets
/// @param polygon from domainCorners()
/// @param monitor is in a stage of one for each site
/// @throw Error   BadArgument (what is no triangulation), TooManyPoints, Aborted
RoundedCells cellsInPolygon(const CellComplex& t, const Buffer<PowerSite>& sites,
  const Buffer<Position>& centers, const std::vector<double>& polygon, Monitor& monitor);

}

#endif
