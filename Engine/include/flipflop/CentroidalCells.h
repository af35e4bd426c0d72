// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Centroidal power cells: sites that are the centroids of their own cells.
#ifndef flipflop_CentroidalCells_h
#define flipflop_CentroidalCells_h

#include <flipflop/Buffer.h>
#include <flipflop/ConvexDomain.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/Statistics.h>

#include <cstdint>

namespace flipflop
{

/// Sites after some steps of Lloyd's algorithm, and their cells.
struct CentroidalCells
{
  Buffer<double> sites; ///< x and y of each site, where it is in the end
  PowerDiagram cells;   ///< of the sites there; its siteIds are those that have a cell
  Buffer<double> areas; ///< of each site's cell; 0: it has none
  /// x and y of the centroid of each site's cell; of a site without one, its position.
  Buffer<double> centroids;

  std::int64_t iterations = 0;  ///< how often the sites moved
  double lastMove = 0;          ///< how far a site moved at most in the last of these, a length
  bool converged = false;       ///< was that the tolerance at most?
  std::int64_t withoutCell = 0; ///< how many sites have no cell in the domain in the end
  Statistics statistics;        ///< of all triangulations; secondsTotal: of the whole call
};

/// Lloyd's algorithm (S. P. Lloyd, "Least squares quantization in PCM", 1982; Q. Du, V. Faber,
/// M. Gunzburger, "Centroidal Voronoi tessellations", 1999): in each iteration every site moves to
/// the centroid of its cell. The sum over the cells of the squared distances from the site, less
/// its weight, never rises but for rounding.
///
/// A site outside of the domain moves in if it has a cell there. A site without a cell stays where
/// it is, and is counted; it may get one when others move. Which cells meet is exact in each
/// iteration; centroids are rounded. They are measured from the sites: one that is further away
/// than about 1e15 times the domain's size seems to have no cell. The bits are the same for any
/// number of threads.
///
/// @param points     the sites at first, at any positions; x and y are read
/// @param weights    one for each site, as regularTriangulation() takes them; they stay. Without:
///                   Voronoi cells.
/// @param domain     where cells end. Its area must be a normal double, its width and
///                   its height no infinite ones.
/// @param iterations at most so many; 0 or more. With 0, the cells of the sites as given.
/// @param tolerance  a length, 0 or more: it ends when no site moved further in an iteration
/// @param options    the threads, the progress function and the step function are used
/// @return sites, cells and measures; of no sites: nothing, converged
/// @throw Error      NonFinite (a coordinate or weight), NotConvex (the domain), BadArgument (a box
///                   that is empty or not finite, an area that is no normal double, negative
///                   iterations, a tolerance that is negative or NaN), WeightCount, TooManyPoints,
///                   OutOfMemory, Aborted
CentroidalCells centroidalCells(const PointView& points, const WeightView& weights,
  const ConvexDomain& domain, std::int64_t iterations, double tolerance,
  const Options& options = Options());

}

#endif
