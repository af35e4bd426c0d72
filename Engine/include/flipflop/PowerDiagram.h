// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The power diagram (weighted Voronoi diagram) in a box: the dual of the regular triangulation.
#ifndef flipflop_PowerDiagram_h
#define flipflop_PowerDiagram_h

#include <flipflop/Buffer.h>
#include <flipflop/ConvexDomain.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstdint>

namespace flipflop
{

/// Polygons, counter-clockwise, one for each visible site whose power cell meets the inside of the
/// box. Every corner is a true corner with each coordinate rounded to the nearest double.
///
/// These hold exactly, for the rounded corners: Each cell is a simple polygon, which visits no
/// corner twice. Cells fill the box without gap or overlap, and meet edge to edge: an edge inside
/// the box is in two cells, once in either direction; an edge on a side of the box is in one.
///
/// These are effects of rounding: True cells are convex, but a corner of a rounded cell may turn
/// right by as much as rounding explains. Corners that round to one position are one. If an edge
/// meets a side of the box, and its other end rounds to that side, that end is its only corner
/// there. If a corner turns right, and ends an edge of at most four units (in the last place of the
/// greater coordinate), the two ends are merged. A corner moves no further than that, and corners
/// of the box stay. If a cell still crosses itself, such as the tip of a needle thinner than a
/// unit, a neighbour gets some of its corners, or the whole cell. A cell without an inside is
/// omitted. (No cell reached further than 8 units beyond its true border in a million cells of
/// nearly cocircular, collinear and gridded sites; the tests allow 16.) If all rounded cells are
/// convex, nothing is merged, cut or joined.
///
/// A cell starts at the corner of its site's lowest facet (at the border of the triangulation: of
/// the first facet counter-clockwise). If the box cuts that off, the start moves along the border
/// of the cell, counter-clockwise, to where that comes between the two sides of x, and from there
/// to where it comes between those of y. Corners come in the order in which the cells first use
/// them.
struct PowerDiagram
{
  /// The x and y of each corner. Neighbours share their corners: no position is listed twice.
  Buffer<double> corners;

  /// The corners of all cells, one cell after another: indices into corners (pairs).
  Buffer<std::int64_t> connectivity;

  /// Where each cell begins in connectivity, ascending from 0; then the size of connectivity.
  Buffer<std::int64_t> offsets;

  /// The id (index in the input) of each cell's site, ascending.
  Buffer<std::int64_t> siteIds;
};

/// The power diagram of the points that appear in @p triangulation (the sites). The exact
/// triangulation defines which cells meet, and where: cocircular sites meet in one corner, and no
/// edge has zero length. Only the corners' coordinates are rounded; PowerDiagram lists the effects.
/// Time and memory are proportional to the triangulation. The bits are the same for any number of
/// threads, also of the triangulation, and for either engine.
///
/// @param points          as they were triangulated
/// @param weights         as they were triangulated
/// @param triangulation   of these points, with FacetMode::Polygons. With FacetMode::Triangles the
///                        cells are the same, since equal centers round to equal corners; but they
///                        may start at another corner.
/// @param box             least x, greatest x, least y, greatest y; finite, least below greatest
/// @param options         only the threads and the progress function are used
/// @return the cells, by ascending id of their sites
/// @throw Error           WeightCount, TooManyPoints, OutOfMemory, Aborted, BadArgument. The last
///                        one also for a complex that is not a triangulation of these points, if
///                        that shows: an index or id out of range, a facet that is not
///                        counter-clockwise, facets that form no ring, a cell that turns over by
///                        more than rounding explains. Whether power circles are empty is not
///                        checked.
PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const double* box, const Options& options = Options());

/// The same in a convex polygon of any size. Every corner is a true corner with each coordinate
/// rounded to the nearest double, also where an edge between cells meets a side. So corners of the
/// polygon are corners of cells, bit for bit, and a cell that is all of the polygon has its corners
/// alone.
///
/// As in a box, cells are simple polygons that meet edge to edge, and an edge inside the polygon is
/// in two cells. Their outer edges are on the sides of the polygon but for the rounding of corners.
/// Corners of the polygon are not moved where cells have to be mended. A cell that has the lowest
/// facet's corner outside of the polygon starts at the first corner after it; one that no other
/// meets starts at the polygon's first corner.
///
/// @param points, weights, triangulation, options as above
/// @param domain   a polygon, or a box
/// @return the cells, by ascending id of their sites
/// @throw Error    as above; and NotConvex: the domain is no convex polygon, counter-clockwise, of
///                 finite corners
PowerDiagram powerDiagram(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const ConvexDomain& domain,
  const Options& options = Options());

/// The power cells of some of the sites, of facets that are whole around those: a block's share of
/// a diagram (BlockRun). These are the cells of the diagram of all, bit for bit, unless rounding
/// has broken one of them somewhere.
///
/// @param points, weights, box, options as for powerDiagram()
/// @param facets  the facets around the sites that are wanted, and any others, in canonical form
///                (FacetMode::Polygons); its dimension is that of all points together
/// @param wanted  for each of the facets' points: 1 if its cell is wanted, else 0
/// @param diagram becomes the cells; empty where they are none
/// @return false: a rounded cell is not convex. To mend it takes the diagram of all.
/// @throw Error   as powerDiagram()
bool powerCells(const PointView& points, const WeightView& weights, const CellComplex& facets,
  const std::uint8_t* wanted, const double* box, PowerDiagram& diagram,
  const Options& options = Options());

/// The corners of the unbounded diagram: for each facet, the point of equal power to its corners,
/// in other words the center of its circle. Two facets that share an edge share a side of the
/// diagram.
/// @param points, weights as they were triangulated
/// @param triangulation of these; of dimension 2, unless it has no cell
/// @param centers       receives x and y for each cell, each rounded to the nearest double,
/// infinite
///                      beyond these
/// @param options       the threads and the progress function
/// @throw Error         as powerDiagram()
void facetCenters(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, double* centers, const Options& options = Options());

/// A box for powerDiagram(): that of the points that appear, which is that of all finite ones, for
/// a corner of their hull is never hidden. A range of one value becomes as wide as the other (1, if
/// that has one value, too), or wider, where that would round to nothing.
/// @param points        as they were triangulated
/// @param triangulation of them; with a point at least
/// @return x least, x greatest, y least, y greatest
/// @throw Error         BadArgument (an id out of range; no point)
std::array<double, 4> powerDiagramBox(const PointView& points, const Triangulation& triangulation);

/// The same box without a triangulation: that of all points whose x and y are finite. Of none of
/// them it is the unit square.
/// @param points in the plane
/// @return x least, x greatest, y least, y greatest
/// @throw Error  BadArgument (no points in memory), TooManyPoints
std::array<double, 4> powerDiagramBox(const PointView& points);

}

#endif
