// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Flip-Flop: turns a star-shaped polyhedron into its convex hull.
#ifndef flipflop_Convexify_h
#define flipflop_Convexify_h

#include <flipflop/Hull.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>

namespace flipflop
{

/// A read-only view of a surface's triangles.
struct TriangleView
{
  /// Three for each triangle: corners[3 * i + 0, 1, 2] are indices of points.
  const std::int64_t* corners = nullptr;
  std::int64_t count = 0; ///< triangles
};

/// The exact convex hull of a star-shaped polyhedron by flips (paper, Algorithm 1).
///
/// @param points    the polyhedron's points; points that no triangle uses are ignored.
/// @param triangles a closed, consistently oriented manifold. It may be oriented outward or inward.
/// @param kernel    the coordinates of a kernel point, which strictly sees the inside of every
///                  triangle; null: the engine searches for one. An exact test decides whether the
///                  polyhedron is star-shaped.
/// @param options   see Options; NonFinitePolicy::Ignore has no effect on points that are used
/// @return the hull in its canonical form, as convexHull gives it for the points that are used
/// @throw Error BadTriangle, NotClosed, NotManifold, NotOriented, NotStarShaped, NoKernel, and
///        the errors of convexHull.
Hull convexify(const PointView& points, const TriangleView& triangles, const double* kernel,
  const Options& options = Options());

}

#endif
