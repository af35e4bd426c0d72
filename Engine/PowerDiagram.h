// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The power diagram (weighted Voronoi diagram) in a box: the dual of the regular triangulation.
#ifndef flipflop_PowerDiagram_h
#define flipflop_PowerDiagram_h

#include "Buffer.h"
#include "PointView.h"
#include "Triangulation.h"

#include <cstdint>

namespace flipflop
{

/// Convex polygons, counter-clockwise, one for each visible site whose power cell meets the inside
/// of the box. Neighbours share their corners: the diagram has no gap and no overlap but for the
/// rounding of coordinates.
struct PowerDiagram
{
  /// #corners by 2: x, y of every corner. Corners are shared.
  Buffer<double> corners;

  /// Corners of every cell, one after another: indices into corners (pairs).
  Buffer<std::int64_t> connectivity;

  /// #cells + 1 starts into connectivity.
  Buffer<std::int64_t> offsets;

  /// #cells: the id (position in the input) of each cell's site, ascending.
  Buffer<std::int64_t> siteIds;
};

/// The power diagram of the sites that @p triangulation shows. Which cells meet where is taken from
/// the exact triangulation (cocircular sites meet in one corner, without edges of no length); only
/// the corners' coordinates are rounded.
///
/// @param points, weights as they were triangulated
/// @param triangulation   of them: with FacetMode::Polygons
/// @param box             x least, x greatest, y least, y greatest; finite, least below greatest
/// @throw Error           BadArgument, OutOfMemory
PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const double* box);

}

#endif
