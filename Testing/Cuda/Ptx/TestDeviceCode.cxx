// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The device's code, run on the host, leaves the same behind after every round as the host's code
/// does.
#include "PtxExecutor.h"
#include "Rounds/RoundsBuilder.h"
#include "Run/HullRun.h"
#include "Run/TriangulationRun.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

struct Seen
{
  std::vector<RoundReport> reports;
  Statistics statistics;
  bool built = false; ///< there was something to grow
};

template <class Executor>
Seen hullBy(Executor& executor, const Cloud& cloud, const Options& options)
{
  Seen seen;
  const RoundObserver observer = [&seen](const RoundReport& r) { seen.reports.push_back(r); };
  HullRun run(viewOf(cloud), options);
  RoundsBuilder<Executor, HullGeometry> rounds(executor, &observer);
  const Hull hull = run.compute(rounds);
  seen.statistics = hull.statistics;
  seen.built = !run.arithmetic.wide;
  return seen;
}

template <bool Weighted, class Executor>
Seen triangulationBy(Executor& executor, const Cloud& cloud, const Options& options)
{
  Seen seen;
  const RoundObserver observer = [&seen](const RoundReport& r) { seen.reports.push_back(r); };
  const WeightView weights = Weighted ? weightsOf(cloud) : WeightView();
  TriangulationRun<Weighted> run(viewOf(cloud), weights, options);
  RoundsBuilder<Executor, LiftedGeometry<Weighted>> rounds(executor, &observer);
  const Triangulation result = run.compute(rounds);
  seen.statistics = result.statistics;
  seen.built = !run.arithmetic.wide;
  return seen;
}

/// @param by Seen (executor, cloud, options)
template <class By>
void expectSame(const Input& input, By&& by)
{
  SCOPED_TRACE(input.name + ", seed " + std::to_string(input.seed));
  const Cloud cloud = input.make();
  for (const bool vBiased : { false, true })
  {
    Options options;
    options.threads = 1;
    options.vBiased = vBiased;
    HostExecutor host;
    const Seen expected = by(host, cloud, options);
    if (!expected.built)
    {
      return; // integers of any size are the host's alone
    }
    // Shapes of a launch: the last leaves most threads without an item, or many items to one.
    for (const unsigned threads : { 32u, 5u })
    {
      PtxExecutor device(3, threads);
      const Seen found = by(device, cloud, options);
      ASSERT_EQ(found.reports.size(), expected.reports.size());
      for (std::size_t i = 0; i < found.reports.size(); ++i)
      {
        ASSERT_EQ(found.reports[i], expected.reports[i]) << "round " << i;
      }
      EXPECT_EQ(found.statistics.exactCalls, expected.statistics.exactCalls);
      EXPECT_EQ(found.statistics.edgeChecks, expected.statistics.edgeChecks);
      EXPECT_EQ(found.statistics.flipsD, expected.statistics.flipsD);
    }
  }
}

constexpr std::uint64_t Seed = 41;

}

TEST(DeviceCode, MakesTheSameRoundsOfHulls)
{
  const auto by = [](auto& executor, const Cloud& cloud, const Options& options)
  { return hullBy(executor, cloud, options); };
  for (const Family& family : families())
  {
    expectSame(fromFamily(family.name, 250, Seed), by);
    expectSame(fromFamily(family.name, 3000, Seed), by);
  }
  for (const Input& input : smallSpecialInputs())
  {
    expectSame(input, by);
  }
  for (const Input& input : largeSpecialInputs())
  {
    expectSame(input, by);
  }
}

TEST(DeviceCode, MakesTheSameRoundsOfRegularTriangulations)
{
  const auto by = [](auto& executor, const Cloud& cloud, const Options& options)
  { return triangulationBy<true>(executor, cloud, options); };
  for (const Family& family : weightedFamilies())
  {
    expectSame(fromWeightedFamily(family.name, 250, Seed), by);
    expectSame(fromWeightedFamily(family.name, 3000, Seed), by);
  }
  for (const Input& input : smallWeightedInputs())
  {
    expectSame(input, by);
  }
  for (const Input& input : largeWeightedInputs())
  {
    expectSame(input, by);
  }
}

TEST(DeviceCode, MakesTheSameRoundsOfDelaunayTriangulations)
{
  const auto by = [](auto& executor, const Cloud& cloud, const Options& options)
  { return triangulationBy<false>(executor, cloud, options); };
  for (const Family& family : weightedFamilies())
  {
    expectSame(fromWeightedFamily(family.name, 250, Seed), by);
    expectSame(fromWeightedFamily(family.name, 3000, Seed), by);
  }
}

}
}
