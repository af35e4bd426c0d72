// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The former name of convexify().
#ifndef flipflop_FlipFlop_h
#define flipflop_FlipFlop_h

#include <flipflop/Convexify.h>

namespace flipflop
{

/// See convexify().
[[deprecated("flipFlop() is now convexify(), in <flipflop/Convexify.h>")]] inline Hull flipFlop(
  const PointView& points, const TriangleView& triangles, const double* kernel,
  const Options& options = Options())
{
  return convexify(points, triangles, kernel, options);
}

}

#endif
