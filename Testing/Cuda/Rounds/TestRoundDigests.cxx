// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Kernels mean the same in any order of their items: every order leaves the same mesh after every
/// round, counts the same work, and ends in the CPU engine's result.
#include "Testing/Cuda/Rounds/RoundsOnHost.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <algorithm>
#include <set>

namespace flipflop
{
namespace test
{

namespace
{

/// In order and in two ways more, by turns: for inputs in bulk.
std::vector<HostOrder> someOrders(std::size_t turn)
{
  const std::vector<HostOrder> all = allOrders();
  const std::size_t others = all.size() - 1;
  return { all[0], all[1 + turn % others], all[1 + (turn + 3) % others] };
}

/// Run in all orders, V-biased in some, and compare.
/// @param runCpu    Result (const Options&)
/// @param runRounds Result (const Options&, const HostOrder&, RoundsSeen*)
/// @param check     bool (const Result&): validate
template <class RunCpu, class RunRounds, class Check>
void expectSameRounds(const std::vector<HostOrder>& orders, const RunCpu& runCpu,
  const RunRounds& runRounds, const Check& check)
{
  Options options;
  options.threads = 1;
  options.nonFinite = NonFinitePolicy::Ignore;
  const auto wanted = runCpu(options);
  EXPECT_TRUE(check(wanted));
  for (bool vBiased : { false, true })
  {
    options.vBiased = vBiased;
    std::vector<RoundReport> first;
    Statistics counts;
    for (std::size_t i = 0; i < orders.size(); ++i)
    {
      if (vBiased && i % 3 == 1)
      {
        continue;
      }
      SCOPED_TRACE(orders[i].toString() + (vBiased ? ", V-biased" : ""));
      RoundsSeen seen;
      const auto found = runRounds(options, orders[i], &seen);
      EXPECT_EQ(bitDifference(found, wanted), "");
      if (i == 0)
      {
        first = seen.reports;
        counts = found.statistics;
      }
      EXPECT_EQ(reportDifference(seen.reports, first), "");
      EXPECT_EQ(countDifference(found.statistics, counts), "");
    }
  }
}

void expectSameHullRounds(const Cloud& cloud, const std::vector<HostOrder>& orders = allOrders())
{
  const PointView points = viewOf(cloud);
  expectSameRounds(
    orders, [&](const Options& options) { return convexHull(points, options); },
    [&](const Options& options, const HostOrder& how, RoundsSeen* seen)
    { return hullByRounds(points, options, how, seen); },
    [&](const Hull& hull) { return static_cast<bool>(validate(points, hull, 1)); });
}

void expectSameTriangulationRounds(
  const Cloud& weighted, bool weightless, const std::vector<HostOrder>& orders = allOrders())
{
  const PointView points = viewOf(weighted);
  const WeightView weights = weightless ? WeightView() : weightsOf(weighted);
  expectSameRounds(
    orders, [&](const Options& options) { return regularTriangulation(points, weights, options); },
    [&](const Options& options, const HostOrder& how, RoundsSeen* seen)
    { return triangulationByRounds(points, weights, options, how, seen); },
    [&](const Triangulation& found)
    { return static_cast<bool>(validate(points, weights, found, 1)); });
}

std::vector<int> sizes()
{
  return isSanitized() ? std::vector<int>{ 60, 150 } : std::vector<int>{ 9, 60, 700 };
}

std::vector<const char*> namesOf(const std::vector<Family>& list)
{
  std::vector<const char*> names;
  std::transform(list.begin(), list.end(), std::back_inserter(names),
    [](const Family& family) { return family.name; });
  return names;
}

class HullRounds : public ::testing::TestWithParam<const char*>
{
};

TEST_P(HullRounds, AreTheSameInAnyOrder)
{
  for (int size : sizes())
  {
    const Input input = fromFamily(this->GetParam(), size, 71);
    SCOPED_TRACE(input.name + ", seed 71");
    expectSameHullRounds(input.make());
  }
}

INSTANTIATE_TEST_SUITE_P(RoundDigests, HullRounds, ::testing::ValuesIn(namesOf(families())),
  [](const auto& given) { return std::string(given.param); });

class TriangulationRounds : public ::testing::TestWithParam<const char*>
{
};

TEST_P(TriangulationRounds, AreTheSameInAnyOrder)
{
  for (int size : sizes())
  {
    const Input input = fromWeightedFamily(this->GetParam(), size, 72);
    SCOPED_TRACE(input.name + ", seed 72");
    expectSameTriangulationRounds(input.make(), false);
    expectSameTriangulationRounds(input.make(), true);
  }
}

INSTANTIATE_TEST_SUITE_P(RoundDigests, TriangulationRounds,
  ::testing::ValuesIn(namesOf(weightedFamilies())),
  [](const auto& given) { return std::string(given.param); });

TEST(RoundDigests, SpecialHullInputs)
{
  std::vector<Input> inputs = smallSpecialInputs();
  const std::vector<Input> large = largeSpecialInputs();
  inputs.insert(inputs.end(), large.begin(), large.end());
  const std::size_t step = isSanitized() ? 9 : 1;
  for (std::size_t i = 0; i < inputs.size(); i += step)
  {
    SCOPED_TRACE(inputs[i].name + ", seed " + std::to_string(inputs[i].seed));
    expectSameHullRounds(inputs[i].make(), someOrders(i));
  }
}

TEST(RoundDigests, SpecialWeightedInputs)
{
  std::vector<Input> inputs = smallWeightedInputs();
  const std::vector<Input> large = largeWeightedInputs();
  inputs.insert(inputs.end(), large.begin(), large.end());
  const std::size_t step = isSanitized() ? 9 : 1;
  for (std::size_t i = 0; i < inputs.size(); i += step)
  {
    const Cloud cloud = inputs[i].make();
    if (cloud.size() > 5000)
    {
      continue; // Determinism has them
    }
    SCOPED_TRACE(inputs[i].name + ", seed " + std::to_string(inputs[i].seed));
    expectSameTriangulationRounds(cloud, false, someOrders(i));
  }
}

TEST(RoundDigests, DuplicatesGridsAndCospherical)
{
  Random random(73);
  for (const Cloud& cloud :
    { integerGrid(6), cubeSurfaceGrid(7), repeated(integerGrid(3), 4, random),
      repeated(rotated(integerGrid(3)), 3, random), cosphericalIntegers(101),
      repeated(cosphericalIntegers(29), 3, random), prism(12, 5, random), bipyramid(24) })
  {
    expectSameHullRounds(cloud);
  }
  for (const Cloud& cloud : { squareGrid(12), repeated(squareGrid(5), 4, random),
         cocircularIntegers(5 * 5 * 13 * 17), repeated(cocircularIntegers(325), 3, random) })
  {
    expectSameTriangulationRounds(cloud, false);
    expectSameTriangulationRounds(cloud, true);
  }
}

TEST(RoundDigests, VeryLargeBesideVerySmall)
{
  // No scaling brings these together: all signs are by integers of any size.
  Random random(74);
  Cloud cloud;
  for (int i = 0; i < 24; ++i)
  {
    const double scale = i % 3 == 0 ? 1e300 : i % 3 == 1 ? 1e-300 : 1;
    const Point p = random.direction();
    cloud.push_back({ scale * p[0], scale * p[1], scale * p[2] });
  }
  expectSameHullRounds(cloud);
  for (Point& p : cloud)
  {
    p = { p[0] > 1e200 ? 1e150 : p[0], p[1], 0 };
  }
  expectSameTriangulationRounds(cloud, true);
}

TEST(RoundDigests, NonFinitePointsAreLeftOut)
{
  Random random(75);
  std::vector<std::int64_t> places;
  expectSameHullRounds(withNonFinite(fromFamily("shell1e2", 400, 75).make(), random, places));
  expectSameTriangulationRounds(
    withNonFinite(fromWeightedFamily("uniformHeavy", 400, 75).make(), random, places), false);
}

TEST(RoundDigests, TellInputsApart)
{
  // The mesh's hash is no constant: rounds with a change have hashes of their own, and so have
  // inputs.
  std::set<std::uint64_t> ends;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const Cloud cloud = fromFamily("ball", 100, seed).make();
    RoundsSeen seen;
    hullByRounds(viewOf(cloud), Options(), HostOrder(), &seen);
    ASSERT_FALSE(seen.reports.empty());
    ends.insert(seen.reports.back().mesh);
    std::set<std::uint64_t> meshes;
    std::size_t changed = 0;
    std::uint64_t labelled = 0;
    for (const RoundReport& report : seen.reports)
    {
      changed += report.changes != 0 || report.labelled != labelled ? 1 : 0;
      labelled = report.labelled;
      meshes.insert(report.mesh);
    }
    EXPECT_EQ(meshes.size(), changed + 1) << "seed " << seed;
  }
  EXPECT_EQ(ends.size(), 20u);
}

}
}
}
