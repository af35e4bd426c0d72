// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs by an engine of the caller's, in place of the CPU's, and how two runs by rounds differ.
#ifndef flipflop_test_EngineRuns_h
#define flipflop_test_EngineRuns_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Geometry/LiftedGeometry.h"
#include "Rounds/RoundReport.h"
#include <flipflop/Hull.h>
#include <flipflop/Triangulation.h>

#include <functional>
#include <string>
#include <vector>

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

/// The code of the error that work throws; -1: none.
int codeOf(const std::function<void()>& work);

/// Where two sequences of rounds part, in words; empty where they are the same.
std::string reportDifference(const std::vector<RoundReport>& a, const std::vector<RoundReport>& b);

/// What differs between two runs' counts; empty where they did the same. Times are no counts.
std::string countDifference(const Statistics& a, const Statistics& b);

}
}

#endif
