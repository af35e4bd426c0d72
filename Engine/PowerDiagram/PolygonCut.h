// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A finished diagram, cut at the sides of a convex polygon.
#ifndef flipflop_PolygonCut_h
#define flipflop_PolygonCut_h

#include "PowerDiagram/CellRepair.h"
#include "Support/Monitor.h"
#include <flipflop/PowerDiagram.h>

#include <vector>

namespace flipflop
{

/// What the polygon leaves of the cells, as rounded; corners are numbered by first use, and no
/// position is there twice.
/// @param diagram of a box around the polygon
/// @param polygon from domainCorners()
RoundedCells cutAtPolygon(
  const PowerDiagram& diagram, const std::vector<double>& polygon, Monitor& monitor);

}

#endif
