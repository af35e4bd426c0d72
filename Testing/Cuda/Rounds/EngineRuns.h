// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs by an engine of the caller's, in place of the CPU's.
#ifndef flipflop_test_EngineRuns_h
#define flipflop_test_EngineRuns_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Geometry/LiftedGeometry.h"
#include <flipflop/Hull.h>
#include <flipflop/Triangulation.h>

namespace flipflop
{

class HullGeometry;

namespace test
{

Hull hullBy(
  PolyhedronBuilder<HullGeometry>& engine, const PointView& points, const Options& options);
Triangulation triangulationBy(PolyhedronBuilder<LiftedGeometry<true>>& engine,
  const PointView& points, const WeightView& weights, const Options& options);
/// Without weights.
Triangulation triangulationBy(PolyhedronBuilder<LiftedGeometry<false>>& engine,
  const PointView& points, const Options& options);

}
}

#endif
