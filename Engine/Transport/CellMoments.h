// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Areas and centroids of power cells in a convex polygon, and how long the edges are in which they
/// meet. The exact triangulation shows which may meet; the rest is in doubles, relative to each
/// site.
#ifndef flipflop_CellMoments_h
#define flipflop_CellMoments_h

#include "Support/Monitor.h"
#include <flipflop/ConvexDomain.h>
#include <flipflop/Options.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Two sites whose cells meet, by their ids, the lower first.
struct CellLink
{
  std::uint32_t low;
  std::uint32_t high;
  double length;   ///< of the edge in which they meet
  double distance; ///< of the sites
};

struct CellMoments
{
  std::vector<double> areas;     ///< by site; 0: no cell
  std::vector<double> centroids; ///< x and y; without a cell: the site
  /// By the lower site, in no order among those of one; edges of some length only. Parts follow
  /// each other.
  std::vector<std::vector<CellLink>> links;
};

/// @param sites    x and y of each
/// @param weights  one for each; null: none
/// @param triangulation of all of them: triangles
/// @param polygon  of a MeasuredDomain
/// @param moments  becomes the cells' measures
/// @param options  the threads and the progress function are used
/// @throw Error    Aborted, OutOfMemory
void measureCells(const std::vector<double>& sites, const double* weights,
  const Triangulation& triangulation, const std::vector<double>& polygon, CellMoments& moments,
  const Options& options);

/// Rounded, at any range.
double distanceBetween(const double* a, const double* b);

/// A domain, looked over.
struct MeasuredDomain
{
  std::vector<double> polygon; ///< from domainCorners()
  std::array<double, 2> centroid;
  double area;

  /// @throw Error NotConvex, BadArgument (also for an area that is no normal double)
  explicit MeasuredDomain(const ConvexDomain& given);
};

}

#endif
