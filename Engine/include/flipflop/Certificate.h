// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What makes a result easy to check for a program that shares nothing with the engine: for each
/// point the cell that shows it to be in its place.
#ifndef flipflop_Certificate_h
#define flipflop_Certificate_h

#include <flipflop/Buffer.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Hull.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <cstdint>

namespace flipflop
{

/// A cell for each point. With it, a check takes a few signs a point, and nothing is searched for:
/// Checker/check_result.py.
struct Certificate
{
  /// For each point of the input an index of a cell; -1 for a point that is not finite and ignored,
  /// or that no cell holds.
  Buffer<std::int64_t> cells;

  /// Of a hull of dimension 3: x, y and z of one position, or of four. The apex of the cones is
  /// their exact mean, which is strictly inside the hull. Else empty.
  Buffer<double> apex;
};

/// Of a hull of dimension 3, the cell whose cone from the apex holds the point, its border
/// included; a point in the hull is on that cell or beneath it. Of a hull of lower dimension, the
/// cell that holds the point.
/// @param points  of the hull
/// @param hull    as convexHull() or convexify() give it, in triangles or polygons. That it is
///                convex is not checked: see validate()
/// @param options the threads, the policy for what is not finite, and the progress function. The
///                result has the same bits for any number of threads
/// @throw Error   NonFinite, BadArgument (also for a hull that has not the form which Hull
///                promises, or is not one of these points), TooManyPoints, OutOfMemory, Aborted
Certificate certificate(
  const PointView& points, const Hull& hull, const Options& options = Options());

/// The cell that holds the point in the plane, its border included: of several the lowest, as
/// TriangulationQueries::locate() has it. A hidden point is hidden by that cell: its lift is on the
/// plane of the cell's lift or above it.
/// @param points        as they were triangulated
/// @param weights       as they were triangulated
/// @param triangulation of these points, in triangles or polygons
/// @param options       as for a hull
/// @throw Error         NonFinite, WeightCount, TooManyPoints, OutOfMemory, Aborted, BadArgument
///                      (as TriangulationQueries)
Certificate certificate(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, const Options& options = Options());

/// The same of a constrained triangulation: of all its cells.
/// @param points        as they were triangulated
/// @param triangulation as constrainedTriangulation() gave it
/// @param options       as for a hull
/// @throw Error         as for a regular triangulation
Certificate certificate(const PointView& points, const ConstrainedTriangulation& triangulation,
  const Options& options = Options());

}

#endif
