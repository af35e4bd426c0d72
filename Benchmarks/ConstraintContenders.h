// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What constrained triangulations are measured on, and what a contender has done with it.
#ifndef flipflop_ConstraintContenders_h
#define flipflop_ConstraintContenders_h

#include <cstdint>
#include <vector>

namespace flipflop
{

struct ConstrainedPoints
{
  std::vector<double> places;     ///< x, y of each point; no two are the same
  std::vector<std::int64_t> ends; ///< two ids of each constraint
  bool cross = false;             ///< some cross between points: to be split there
};

struct ConstrainedOutcome
{
  double seconds = 0;
  std::int64_t triangles = 0;
  std::int64_t fixedEdges = 0;
};

/// CGAL's Constrained_Delaunay_triangulation_2: all points, along its curve, and then the
/// constraints between their vertices. Where these cross, it adds points, rounded somehow.
ConstrainedOutcome runCgalConstrained(const ConstrainedPoints& points);

}

#endif
