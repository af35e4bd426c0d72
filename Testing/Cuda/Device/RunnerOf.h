// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A run by the rounds on any executor.
#ifndef flipflop_RunnerOf_h
#define flipflop_RunnerOf_h

#include "Geometry/HullGeometry.h"
#include "Rounds/RoundsBuilder.h"
#include "RoundsRunner.h"
#include "Testing/Cuda/Rounds/EngineRuns.h"

#include <stdexcept>

namespace flipflop
{

/// Keeps what the rounds count.
template <class Executor, class Geometry>
class CountedRounds : public RoundsBuilder<Executor, Geometry>
{
public:
  using RoundsBuilder<Executor, Geometry>::RoundsBuilder;

  BuildResult build(const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override
  {
    BuildResult result =
      RoundsBuilder<Executor, Geometry>::build(task, std::move(start), tally, statistics);
    this->counts = tally.statistics;
    return result;
  }

  Statistics counts;
};

/// @param work Result (PolyhedronBuilder<Geometry>&)
template <class Geometry, class Executor, class Work>
auto byRounds(Executor& executor, bool reports, RunSeen& seen, const Work& work)
{
  const RoundObserver observer = [&seen](const RoundReport& report)
  {
    seen.reports.push_back(report);
    if (seen.reports.size() > 10000)
    {
      throw std::runtime_error("rounds without an end"); // of kernels that are broken
    }
  };
  CountedRounds<Executor, Geometry> rounds(executor, reports ? &observer : nullptr);
  auto result = work(rounds);
  seen.growthRounds = rounds.growthRounds;
  seen.flipRounds = rounds.flipRounds;
  seen.counts = rounds.counts;
  return result;
}

template <class Executor>
RunResult runRounds(
  Executor& executor, const RunInput& input, const Options& options, bool reports, RunSeen& seen)
{
  RunResult result;
  result.plane = input.plane;
  if (!input.plane)
  {
    result.hull = byRounds<HullGeometry>(executor, reports, seen,
      [&](PolyhedronBuilder<HullGeometry>& engine)
      { return test::hullBy(engine, input.points, options); });
  }
  else if (input.weights.data)
  {
    result.triangulation = byRounds<LiftedGeometry<true>>(executor, reports, seen,
      [&](PolyhedronBuilder<LiftedGeometry<true>>& engine)
      { return test::triangulationBy(engine, input.points, input.weights, options); });
  }
  else
  {
    result.triangulation = byRounds<LiftedGeometry<false>>(executor, reports, seen,
      [&](PolyhedronBuilder<LiftedGeometry<false>>& engine)
      { return test::triangulationBy(engine, input.points, options); });
  }
  seen.mostBytes = executor.mostBytes();
  return result;
}

/// From a view's first scalar to its last, in bytes.
/// @param width scalars that are read of each
template <class View>
std::size_t bytesOf(const View& view, std::int64_t width)
{
  const std::size_t scalar = view.type == ScalarType::Float32 ? sizeof(float) : sizeof(double);
  return view.count > 0 ? static_cast<std::size_t>((view.count - 1) * view.stride + width) * scalar
                        : 0;
}

}

#endif
