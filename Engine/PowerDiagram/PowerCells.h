// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cells of a power diagram in a convex polygon: the one maker of them, also in a box.
#ifndef flipflop_PowerCells_h
#define flipflop_PowerCells_h

#include "PowerDiagram/CellRepair.h"
#include "PowerDiagram/PowerSite.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// The cells as rounded; corners are numbered by first use, and no position is there twice.
/// @param t       checked by requireCells()
/// @param wanted  by site: is its cell wanted? null: all are
/// @param polygon from domainCorners()
/// @param isBox   is it given as a box? Its cells start elsewhere (StartInBox.h)
/// @param monitor is in a stage of one for each facet and each site
/// @throw Error   BadArgument (what is no triangulation), TooManyPoints, Aborted
RoundedCells roundedCells(const CellComplex& t, const std::uint8_t* wanted,
  const Buffer<PowerSite>& sites, const std::vector<double>& polygon, bool isBox, Monitor& monitor);

/// The center of each facet, each coordinate rounded to nearest.
/// @param t       checked by requireCells(), of dimension 2
/// @param centers receives x and y of each
/// @param monitor is in a stage of one for each facet
/// @throw Error   BadArgument (what is no triangulation), Aborted
void writeCenters(
  const CellComplex& t, const Buffer<PowerSite>& sites, double* centers, Monitor& monitor);

}

#endif
