// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The power diagram (weighted Voronoi diagram) in a box: the dual of the regular triangulation.
#ifndef flipflop_PowerDiagram_h
#define flipflop_PowerDiagram_h

#include <flipflop/Buffer.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstdint>

namespace flipflop
{

/// Polygons, counter-clockwise, one for each visible site whose power cell meets the inside of the
/// box. Every corner is a true one, each coordinate rounded to the nearest double.
///
/// What holds exactly, of the corners as they are: each cell is a simple polygon, which comes to no
/// corner twice. Cells fill the box without gap or overlap, and meet edge to edge: inside the box
/// each edge is in two cells, once in either direction, on its sides in one.
///
/// What rounding costs: true cells are convex; of these a corner may turn right by as much as its
/// rounding explains. Corners that round to one position are one. Where a corner that turns right
/// ends an edge of at most four units (in the last place of the greater coordinate), the two ends
/// are merged; a corner comes no further than that, and corners of the box stay. A cell that
/// crosses itself all the same, such as the tip of a needle thinner than a unit, loses a few
/// corners, or all of it, to a neighbour; a cell without an inside is left out. (No cell reached
/// further than 8 units beyond its true border in a million cells of nearly cocircular, collinear
/// and gridded sites; the tests allow 16.) Where all rounded cells are convex, nothing is merged,
/// cut or joined.
///
/// A cell starts at the corner of its site's lowest facet (at the border of the triangulation: of
/// the first facet counter-clockwise), or at the first corner after it that is in the box and was
/// not cut off. Corners come in the order in which the cells first use them.
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
/// the corners' coordinates are rounded, with what that costs (PowerDiagram). Takes time and memory
/// in proportion to the triangulation. Equal bits on any number of threads, whichever engine and
/// however many triangulated.
///
/// @param points          as they were triangulated
/// @param weights         as they were triangulated
/// @param triangulation   of them: with FacetMode::Polygons. Fans of triangles cannot be told from
///                        polygons; as equal centers round alike, they give the same cells, which
///                        may start elsewhere.
/// @param box             x least, x greatest, y least, y greatest; finite, least below greatest
/// @param options         only the threads and the progress function count
/// @return the cells, by ascending id of their sites
/// @throw Error           BadArgument (also for a complex that is no triangulation of these points,
///                        where that shows: an index or id out of range, a facet that is not
///                        counter-clockwise, facets that form no ring, a cell that turns over by
///                        more than rounding explains), WeightCount, TooManyPoints, OutOfMemory,
///                        Aborted. Whether its power circles are empty is not looked at.
PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const double* box, const Options& options = Options());

/// A box for powerDiagram(): that of the points that appear, which is that of all finite ones, for
/// a corner of their hull is never hidden. A range of one value becomes as wide as the other (1, if
/// that has one value, too), or wider, where that would round to nothing.
/// @param points        as they were triangulated
/// @param triangulation of them; with a point at least
/// @return x least, x greatest, y least, y greatest
/// @throw Error         BadArgument (an id out of range; no point)
std::array<double, 4> powerDiagramBox(const PointView& points, const Triangulation& triangulation);

}

#endif
