// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The furthest-site Delaunay triangulation: the dual of the diagram of furthest points.
#ifndef flipflop_FurthestSite_h
#define flipflop_FurthestSite_h

#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

namespace flipflop
{

/// The exact furthest-site Delaunay triangulation of points in the plane: no point is outside of a
/// cell's circle. Its vertices are the corners of the convex hull; all others are hidden.
///
/// It is the regular triangulation with twice the squared norm for weights, which no double holds:
/// the lower hull of the points at the heights -x^2 - y^2.
/// @param points  z is not read
/// @param options see Options; it runs on the CPU, on one thread for the most part
/// @return the triangulation in its canonical form, facets by Options::facets: all corners of one
///         circle are one polygon. Of collinear points, the edge between the ends.
/// @throw Error BadArgument, NonFinite, TooManyPoints, OutOfMemory, Aborted
Triangulation furthestSiteTriangulation(
  const PointView& points, const Options& options = Options());

}

#endif
