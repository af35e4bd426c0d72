// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Areas and centroids of the cells of the plane: of a triangulation, and of a power diagram.
#ifndef flipflop_Measures_h
#define flipflop_Measures_h

#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/PowerDiagram.h>

namespace flipflop
{

/// The area and the centroid of each cell of a triangulation, in triangles or polygons.
///
/// Both are taken of the true corners and rounded last. An area is off by at most 2^-50 of itself,
/// however flat the cell is (below the normal doubles: by as much as those numbers are apart;
/// beyond the greatest double it is infinite). A centroid's coordinate is off by at most 2^-50 of
/// the largest magnitude of that coordinate among the cell's corners. A cell of dimension 1 or 0
/// has area 0, and its middle for a centroid. The same bits for any number of threads.
/// @param points        as they were triangulated; x and y are read
/// @param triangulation of these points; dimension -1 to 2, cells convex and counter-clockwise
/// @param areas         receives one number a cell; null: they are not wanted
/// @param centroids     receives x and y for each cell; null: they are not wanted
/// @param options       only the threads and the progress function are used
/// @throw Error         BadArgument (a null array, a dimension of 3, an index or id out of range, a
///                      corner that is not finite), TooManyPoints, OutOfMemory, Aborted
void cellMeasures(const PointView& points, const CellComplex& triangulation, double* areas,
  double* centroids, const Options& options = Options());

/// The same of the cells of a power diagram: of their corners as they are, so the areas of all
/// cells sum to the box but for the rounding of each. The errors are as above where a cell is
/// convex. Rounding may have turned a corner in: then they are against the sum of the magnitudes of
/// the triangles of the cell's fan.
/// @param diagram   from powerDiagram()
/// @param areas     receives one number a cell; null: they are not wanted
/// @param centroids receives x and y for each cell; null: they are not wanted
/// @param options   only the threads and the progress function are used
/// @throw Error     BadArgument (an index out of range, a corner that is not finite),
///                  OutOfMemory, Aborted
void cellMeasures(const PowerDiagram& diagram, double* areas, double* centroids,
  const Options& options = Options());

}

#endif
