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

/// The regular triangulation of all points, whatever their number and position: see Triangulation.h
/// for the form, and for what is visible.
///
/// @param points  any number of them up to 2^32 - 2; about 5e8 where nearly all are visible, for
///                cells are 32-bit half-edges. Only x and y are read: a stride of 2 is enough.
/// @param weights one for each point, in units of squared length: the power distance of x from a
///                point p is |x - p|^2 - w. Any finite values, negative ones too. Without data: the
///                Delaunay triangulation.
/// @param options see Options
/// @return the triangulation in its canonical form, which is the same for any number of threads
/// @throw Error   NonFinite (the first point whose coordinate or weight is not finite),
///                WeightCount, TooManyPoints, OutOfMemory, Aborted, BadArgument
Triangulation regularTriangulation(const PointView& points,
  const WeightView& weights = WeightView(), const Options& options = Options());

}

#endif
