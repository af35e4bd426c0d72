// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The power diagram (weighted Voronoi diagram) in a box: the dual of the regular triangulation.
#ifndef flipflop_PowerDiagram_h
#define flipflop_PowerDiagram_h

#include "Buffer.h"
#include "Options.h"
#include "PointView.h"
#include "Triangulation.h"

#include <cstdint>

namespace flipflop
{

/// Convex polygons, counter-clockwise, one for each visible site whose power cell meets the inside
/// of the box. Every corner is the true one, each coordinate rounded to the nearest double; the
/// diagram has no gap and no overlap but for that. Corners that round to one position are one, so
/// no edge has no length; a cell that rounding leaves no inside is left out.
///
/// A cell starts at the corner of its site's lowest facet (at the border of the triangulation: of
/// the first facet counter-clockwise), or at the first corner after it that is in the box. Corners
/// come in the order in which the cells first use them.
struct PowerDiagram
{
  /// Two for each corner: its x and y. Neighbours share their corners: no position is listed
  /// twice.
  Buffer<double> corners;

  /// Corners of every cell, one after another: indices into corners (pairs).
  Buffer<std::int64_t> connectivity;

  /// One for each cell and one more: where the cell begins in connectivity, ascending from 0.
  Buffer<std::int64_t> offsets;

  /// One for each cell: the id (position in the input) of its site, ascending.
  Buffer<std::int64_t> siteIds;
};

/// The power diagram of the sites that @p triangulation shows. Which cells meet where is taken from
/// the exact triangulation (cocircular sites meet in one corner, without edges of no length); only
/// the corners' coordinates are rounded. Takes time and memory in proportion to the triangulation,
/// on one thread.
///
/// @param points          as they were triangulated
/// @param weights         as they were triangulated
/// @param triangulation   of them: with FacetMode::Polygons. Fans of triangles cannot be told from
///                        polygons; as equal centers round alike, they give the same cells, which
///                        may start elsewhere.
/// @param box             x least, x greatest, y least, y greatest; finite, least below greatest
/// @param options         only the progress function counts
/// @return the cells, by ascending id of their sites
/// @throw Error           BadArgument (also for a complex that is no triangulation of these points,
///                        where that shows: an index or id out of range, a facet that is not
///                        counter-clockwise, facets that form no ring), WeightCount, TooManyPoints,
///                        OutOfMemory, Aborted. Whether its power circles are empty is not looked
///                        at.
PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const double* box, const Options& options = Options());

}

#endif
