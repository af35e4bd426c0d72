// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs the rounds on a fixed set of inputs and tells whether anything is wrong with them: 0, or 1
/// and a line that says what. mutants.py builds it from kernels that have been broken on purpose,
/// and it has to notice.
#include "Geometry/HullGeometry.h"
#include "Rounds/RoundsBuilder.h"
#include "Testing/Cuda/Rounds/EngineRuns.h"
#include "Testing/Cuda/Rounds/HostOrder.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>
#include <flipflop/Validate.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace flipflop
{
namespace test
{

namespace
{

/// The rounds go on without an end, or nearly so.
struct TooManyRounds : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

const HostOrder orders[] = { { HostExecutor::Order::Forwards }, { HostExecutor::Order::Backwards },
  { HostExecutor::Order::Shuffled, 1 }, { HostExecutor::Order::Shuffled, 2 },
  { HostExecutor::Order::Threads, 1, 3 } };

template <class T>
bool same(const Buffer<T>& a, const Buffer<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
bool same(const CellComplex& a, const CellComplex& b)
{
  return same(a.pointIds, b.pointIds) && same(a.connectivity, b.connectivity);
}
bool same(const Hull& a, const Hull& b)
{
  return same(static_cast<const CellComplex&>(a), static_cast<const CellComplex&>(b)) &&
    a.volume == b.volume && a.area == b.area;
}

std::string describe(const RoundReport& report)
{
  return (report.stage == RoundReport::Stage::Flip ? "flip round " : "growth round ") +
    std::to_string(report.round);
}

/// What is wrong with one input; empty where nothing is.
/// @param run   Result (PolyhedronBuilder<Geometry>&, const Options&)
/// @param valid bool (const Result&)
template <class Geometry, class Result, class Run, class Valid>
std::string faultOf(const Result& wanted, const Run& run, const Valid& valid)
{
  for (bool vBiased : { false, true })
  {
    Options options;
    options.threads = 1;
    options.vBiased = vBiased;
    std::vector<RoundReport> first;
    for (const HostOrder& how : orders)
    {
      const std::string where = how.toString() + (vBiased ? ", V-biased" : "") + ": ";
      std::vector<RoundReport> reports;
      const RoundObserver observer = [&](const RoundReport& report)
      {
        reports.push_back(report);
        // Told at once: what comes after may never end.
        const std::size_t i = reports.size() - 1;
        if (!first.empty() && (i >= first.size() || !(report == first[i])))
        {
          throw std::runtime_error("another mesh than forwards after " + describe(report));
        }
        if (reports.size() > 3000)
        {
          throw TooManyRounds("rounds without an end, " + describe(report));
        }
      };
      HostExecutor executor(how.order, how.seed, how.threads);
      RoundsBuilder<HostExecutor, Geometry> rounds(executor, &observer);
      try
      {
        const Result found = run(rounds, options);
        if (!same(found, wanted))
        {
          return where + "not the CPU engine's result";
        }
        if (!valid(found))
        {
          return where + "not valid";
        }
      }
      catch (const std::exception& error)
      {
        return where + error.what();
      }
      if (first.empty())
      {
        first = reports;
      }
    }
  }
  return "";
}

std::string faultOfHull(const Cloud& cloud)
{
  const PointView points(cloud[0].data(), static_cast<std::int64_t>(cloud.size()));
  Options options;
  options.threads = 1;
  return faultOf<HullGeometry>(
    convexHull(points, options),
    [&](PolyhedronBuilder<HullGeometry>& engine, const Options& chosen)
    { return hullBy(engine, points, chosen); },
    [&](const Hull& hull) { return static_cast<bool>(validate(points, hull, 1)); });
}

std::string faultOfTriangulation(const Cloud& weighted)
{
  const auto count = static_cast<std::int64_t>(weighted.size());
  const PointView points(weighted[0].data(), count);
  const WeightView weights(&weighted[0][2], count, 3);
  Options options;
  options.threads = 1;
  return faultOf<LiftedGeometry<true>>(
    regularTriangulation(points, weights, options),
    [&](PolyhedronBuilder<LiftedGeometry<true>>& engine, const Options& chosen)
    { return triangulationBy(engine, points, weights, chosen); },
    [&](const Triangulation& found)
    { return static_cast<bool>(validate(points, weights, found, 1)); });
}

int probe()
{
  std::vector<Input> hulls;
  std::vector<Input> triangulations;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    for (const char* family : { "ball", "shell0", "shell1e2", "smallIntegers", "doubled",
           "paraboloid", "boxFaces", "far15" })
    {
      for (int size : { 12, 40, 300 })
      {
        hulls.push_back(fromFamily(family, size, seed));
      }
    }
    for (const char* family : { "uniform", "uniformHeavy", "grid", "gridOfManyWeights", "doubled" })
    {
      for (int size : { 12, 40, 300 })
      {
        triangulations.push_back(fromWeightedFamily(family, size, seed));
      }
    }
  }
  hulls.push_back(fromFamily("ball", 3000, 4));
  hulls.push_back({ "grid of duplicates", 5,
    []
    {
      Random random(5);
      return repeated(integerGrid(4), 3, random);
    } });
  // So many that the run starts from a sample, which has not the lowest id of every position.
  hulls.push_back({ "cube of many duplicates", 6,
    []
    {
      Random random(6);
      return repeated(integerGrid(3), 100, random);
    } });
  // So few that filters leave them open in the middle of growing.
  for (const std::size_t step : { 10, 15, 25 })
  {
    hulls.push_back({ "few duplicates of points of a sphere", step,
      [step]
      {
        Cloud cloud = fromFamily("shell0", 4000, step).make();
        for (std::size_t i = 0; i < 4000; i += step)
        {
          cloud.push_back(cloud[i]);
        }
        return cloud;
      } });
  }
  // The same without ties.
  hulls.push_back({ "many duplicates of points of a sphere", 7,
    []
    {
      Random random(7);
      return repeated(fromFamily("shell0", 30, 7).make(), 100, random);
    } });
  for (const Input& input : hulls)
  {
    const std::string fault = faultOfHull(input.make());
    if (!fault.empty())
    {
      std::printf("hull of %s, seed %d, %s\n", input.name.c_str(), static_cast<int>(input.seed),
        fault.c_str());
      return 1;
    }
  }
  for (const Input& input : triangulations)
  {
    const std::string fault = faultOfTriangulation(input.make());
    if (!fault.empty())
    {
      std::printf("triangulation of %s, seed %d, %s\n", input.name.c_str(),
        static_cast<int>(input.seed), fault.c_str());
      return 1;
    }
  }
  return 0;
}

}
}
}

int main()
{
  return flipflop::test::probe();
}
