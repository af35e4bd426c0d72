// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact regular triangulation in the plane (ffRT; paper, section 4).
#ifndef flipflop_RegularTriangulation_h
#define flipflop_RegularTriangulation_h

#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

namespace flipflop
{

/// The regular triangulation of all points, whatever their number and position. Triangulation.h
/// describes its form, and which points are visible.
///
/// @param points  any number up to 2^32 - 2; about 5e8 if nearly all are visible, since half-edges
///                are 32-bit. Only x and y are read: a stride of 2 is enough.
/// @param weights one for each point, in units of squared length: the power distance of x from a
///                point p is |x - p|^2 - w. Any finite values, also negative ones. Without weights:
///                the Delaunay triangulation.
/// @param options see Options
/// @return the triangulation in its canonical form, which is the same for any number of threads
/// @throw Error   NonFinite (the first point whose coordinate or weight is not finite),
///                WeightCount, TooManyPoints, OutOfMemory, Aborted, BadArgument
Triangulation regularTriangulation(const PointView& points,
  const WeightView& weights = WeightView(), const Options& options = Options());

}

#endif
