// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Weights that give power cells prescribed areas: semi-discrete optimal transport.
#ifndef flipflop_PrescribedAreas_h
#define flipflop_PrescribedAreas_h

#include <flipflop/Buffer.h>
#include <flipflop/ConvexDomain.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Statistics.h>

#include <cstdint>

namespace flipflop
{

/// Weights, and what they give.
struct PrescribedAreas
{
  /// One for each site, the least of them 0, for regularTriangulation() and powerDiagram().
  Buffer<double> weights;
  Buffer<double> areas;     ///< of each site's cell in the domain with these weights
  Buffer<double> centroids; ///< x and y of each cell's centroid

  std::int64_t iterations = 0;     ///< steps of Newton's method
  double error = 0;                ///< greatest |area - prescribed area| / prescribed area
  bool converged = false;          ///< is the error within the tolerance?
  double secondsTriangulating = 0; ///< wall time: the triangulations
  double secondsMeasuring = 0;     ///< wall time: areas, centroids, lengths of common edges
  double secondsSolving = 0;       ///< wall time: the linear systems
  Statistics statistics;           ///< of all triangulations; secondsTotal: of the whole call
};

/// The weights with which each site's power cell in the domain has its prescribed area. They are
/// unique but for a constant. The cells are the optimal transport of the domain to the sites for
/// the squared distance: no other parts of these areas are nearer to their sites.
///
/// The method is the damped Newton method of J. Kitagawa, Q. Merigot, B. Thibert, "Convergence of a
/// Newton algorithm for semi-discrete optimal transport", JEMS 21 (2019): a step is halved until no
/// cell is smaller than half the least area at the start or prescribed, and the error's norm falls
/// by the share that the paper requires. Voronoi cells are the start, if all sites are in the
/// domain; else the Voronoi cells of the sites' image in it, which are power cells of the sites.
///
/// Which cells meet is exact in each step. Areas are rounded, and so are weights: a unit in the
/// last place of a weight moves the edge between two cells by half of it over the sites' distance.
/// Where sites are so near to each other, or so far from the domain, that this is more than the
/// tolerance of an area, the method ends before it converges. The bits are the same for any number
/// of threads.
///
/// @param points     the sites, at any positions, no two at the same; x and y are read
/// @param areas      one for each site, positive: shares, which are scaled such that they sum to
///                   the domain's area. What each becomes must be a normal double, else it is a
///                   BadArea. Without (no data): all equal.
/// @param domain     where cells end. Its area must be a normal double, its width and
///                   its height no infinite ones.
/// @param tolerance  0 or more: it ends when each area is met to that, relative to itself
/// @param iterations at most so many steps; 0 or more
/// @param options    the threads, the progress function and the step function are used
/// @return weights, and what is reached; if it did not converge, the last step that was taken. Of
///         no sites: nothing, converged.
/// @throw Error      NonFinite (a coordinate), DuplicateSites, BadArea, NotConvex (the domain),
///                   WeightCount (not as many areas as sites), BadArgument (a box that is empty or
///                   not finite, an area of the domain that is no normal double, negative
///                   iterations, a tolerance that is negative or NaN), TooManyPoints, OutOfMemory,
///                   Aborted
PrescribedAreas prescribedAreas(const PointView& points, const WeightView& areas,
  const ConvexDomain& domain, double tolerance = 1e-6, std::int64_t iterations = 100,
  const Options& options = Options());

}

#endif
