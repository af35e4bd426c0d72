// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The CUDA engine's rounds on host threads, as an engine under test.
#ifndef flipflop_test_RoundsOnHost_h
#define flipflop_test_RoundsOnHost_h

#include "Rounds/RoundReport.h"
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

/// What one run showed beside its result.
struct RoundsSeen
{
  std::vector<RoundReport> reports; ///< of every round
  std::uint32_t growthRounds = 0;
  std::uint32_t flipRounds = 0;
  Statistics counts; ///< of the rounds alone: the result's include the finish
};

/// The hull by the rounds.
/// @param seen null: nobody watches, so no round waits for the host
Hull hullByRounds(WatchedExecutor& executor, const PointView& points, const Options& options,
  RoundsSeen* seen = nullptr);
Hull hullByRounds(const PointView& points, const Options& options, const HostOrder& how = {},
  RoundsSeen* seen = nullptr);

/// The triangulation by the rounds.
/// @param weights without data: there are none
Triangulation triangulationByRounds(WatchedExecutor& executor, const PointView& points,
  const WeightView& weights, const Options& options, RoundsSeen* seen = nullptr);
Triangulation triangulationByRounds(const PointView& points, const WeightView& weights,
  const Options& options, const HostOrder& how = {}, RoundsSeen* seen = nullptr);

/// All four orders: forwards, backwards, shuffled by several seeds, on several numbers of threads.
/// Under ThreadSanitizer forwards and on threads.
std::vector<HostOrder> allOrders();

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

/// Where two sequences of rounds part, in words; empty where they are the same.
std::string reportDifference(const std::vector<RoundReport>& a, const std::vector<RoundReport>& b);

/// What differs between two runs' counts; empty where they did the same. Times and the number of
/// threads are no counts.
std::string countDifference(const Statistics& a, const Statistics& b);

}
}

#endif
