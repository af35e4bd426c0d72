// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The CUDA engine's rounds on host threads, as an engine under test.
#ifndef flipflop_test_RoundsOnHost_h
#define flipflop_test_RoundsOnHost_h

#include "Testing/Cuda/Device/RoundsRunner.h"
#include "Testing/Cuda/Rounds/EngineRuns.h"
#include "Testing/Cuda/Rounds/HostOrder.h"
#include "Testing/Cuda/Rounds/WatchedExecutor.h"
#include "Testing/Engine/References/Exact.h"

#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

/// The hull by the rounds.
/// @param seen null: nobody watches, so no round waits for the host
Hull hullByRounds(WatchedExecutor& executor, const PointView& points, const Options& options,
  RunSeen* seen = nullptr);
Hull hullByRounds(const PointView& points, const Options& options, const HostOrder& how = {});

/// The triangulation by the rounds.
/// @param weights without data: there are none
Triangulation triangulationByRounds(WatchedExecutor& executor, const PointView& points,
  const WeightView& weights, const Options& options, RunSeen* seen = nullptr);
Triangulation triangulationByRounds(const PointView& points, const WeightView& weights,
  const Options& options, const HostOrder& how = {});

/// How a conformance test runs the rounds beside the CPU engine.
struct RoundsVariant
{
  HostOrder how;
  bool vBiased;
};
/// All orders for small clouds, one for large ones. One way of giving facets is V-biased where the
/// other is not.
std::vector<RoundsVariant> roundsVariants(std::int64_t points, FacetMode facets);

/// For loops over very many clouds: does this one, of every eight, go by the rounds too, and how?
/// The cloud's bits alone tell.
bool drawOrder(const Cloud& cloud, HostOrder& how);

}
}

#endif
