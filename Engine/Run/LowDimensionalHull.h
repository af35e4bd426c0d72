// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hulls of inputs that span fewer than three dimensions: nothing, a point, a line, a polygon.
#ifndef flipflop_LowDimensionalHull_h
#define flipflop_LowDimensionalHull_h

#include "Geometry/HullGeometry.h"
#include "Points/PointSource.h"
#include "Run/Span.h"
#include "Support/Monitor.h"
#include <flipflop/Hull.h>
#include <flipflop/Options.h>

namespace flipflop
{

/// Fill in all of @p hull but its statistics.
/// @param span of dimension below 3
void lowDimensionalHull(const HullGeometry& geometry, const PointSource& source, const Span& span,
  bool checkFinite, const CoordinateRange& range, int exponent, FacetMode facets, Monitor& monitor,
  Hull& hull);

}

#endif
