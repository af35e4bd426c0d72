// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the rounds compute: hulls, regular and Delaunay triangulations, each beside the CPU engine.
#ifndef flipflop_test_RoundsKinds_h
#define flipflop_test_RoundsKinds_h

#include "Testing/Cuda/Rounds/RoundsOnHost.h"
#include "Testing/Engine/Conformance/Kind.h"

namespace flipflop
{
namespace test
{

struct RoundsKind
{
  const char* name;
  const Kind* kind; ///< the inputs
  Result (*cpu)(const Cloud&, const Options&);
  Result (*rounds)(WatchedExecutor&, const Cloud&, const Options&, RunSeen*);
};

inline const RoundsKind roundsKinds[] = {
  { "hull", &convexHulls,
    [](const Cloud& cloud, const Options& options) { return convexHulls.run(cloud, options); },
    [](WatchedExecutor& executor, const Cloud& cloud, const Options& options,
      RunSeen* seen) -> Result { return hullByRounds(executor, viewOf(cloud), options, seen); } },
  { "regular", &regularTriangulations,
    [](const Cloud& cloud, const Options& options)
    { return regularTriangulations.run(cloud, options); },
    [](WatchedExecutor& executor, const Cloud& cloud, const Options& options,
      RunSeen* seen) -> Result
    { return triangulationByRounds(executor, viewOf(cloud), weightsOf(cloud), options, seen); } },
  { "delaunay", &regularTriangulations,
    [](const Cloud& cloud, const Options& options) -> Result
    { return regularTriangulation(viewOf(cloud), WeightView(), options); },
    [](WatchedExecutor& executor, const Cloud& cloud, const Options& options,
      RunSeen* seen) -> Result
    { return triangulationByRounds(executor, viewOf(cloud), WeightView(), options, seen); } },
};

}
}

#endif
