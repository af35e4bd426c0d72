// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What every call promises: the same bits on any number of threads and from any layout in memory,
/// progress and abort, and an error that names what is wrong.
#include "Testing/Engine/Calls/EveryCall.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <limits>
#include <system_error>
#include <thread>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

Options onThreads(int threads)
{
  Options options;
  options.threads = threads;
  return options;
}

class EveryCall : public ::testing::TestWithParam<Call>
{
protected:
  const Call& call() const { return this->GetParam(); }

  void expectErrorOf(
    const PointView& points, const WeightView& weights, ErrorCode code, std::int64_t count = -2)
  {
    expectError([&] { this->call().run(points, weights, Options()); }, code, -2, count);
  }
};

TEST_P(EveryCall, HasTheSameBitsOnAnyThreads)
{
  const Bits one = this->call()(onThreads(1));
  for (const int threads : { 0, 2, 4 })
  {
    EXPECT_TRUE(this->call()(onThreads(threads)) == one) << threads << " threads";
  }
}

TEST_P(EveryCall, HasTheSameBitsFromAnyLayout)
{
  // Rows of six and of five, the last of which end with their last number; between them is what no
  // call reads: z, too, where the call is of the plane.
  const Call& call = this->call();
  const std::size_t count = call.cloud.size();
  const std::size_t columns = call.planar ? 2 : 3;
  std::vector<double> doubles(6 * (count - 1) + columns, nan);
  std::vector<double> weights(5 * (count - 1) + 1, nan);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::copy_n(
      call.cloud[i].begin(), columns, doubles.begin() + static_cast<std::ptrdiff_t>(6 * i));
    weights[5 * i] = call.cloud[i][2];
  }
  const std::vector<float> floats(doubles.begin(), doubles.end());
  const std::vector<float> floatWeights(weights.begin(), weights.end());
  const auto n = static_cast<std::int64_t>(count);
  const Bits wanted = call(Options());
  const auto expectSame = [&](const PointView& points, const WeightView& of)
  { EXPECT_TRUE(call.run(points, call.weighted ? of : WeightView(), Options()) == wanted); };
  expectSame(PointView(doubles.data(), n, 6), WeightView(weights.data(), n, 5));
  expectSame(PointView(floats.data(), n, 6), WeightView(floatWeights.data(), n, 5));
}

TEST_P(EveryCall, MayRunOnSeveralThreadsAtOnce)
{
  const Bits wanted = this->call()(onThreads(1));
  std::vector<Bits> found(4);
  std::vector<std::thread> callers;
  for (int i = 0; i < 4; ++i)
  {
    callers.emplace_back(
      [&, i] { found[static_cast<std::size_t>(i)] = this->call()(onThreads(1 + i)); });
  }
  for (std::thread& caller : callers)
  {
    caller.join();
  }
  for (const Bits& bits : found)
  {
    EXPECT_TRUE(bits == wanted);
  }
}

TEST_P(EveryCall, ReportsProgressAndStops)
{
  const Bits wanted = this->call()(Options());
  for (const int threads : { 1, 4 })
  {
    expectProgress([&](const Options& options)
      { EXPECT_TRUE(this->call()(options) == wanted) << "watching changed it"; },
      threads);
    EXPECT_TRUE(this->call()(onThreads(threads)) == wanted) << "something is left behind";
  }
}

TEST_P(EveryCall, AProgressFunctionThatThrowsIsAnError)
{
  for (const int threads : { 1, 2 })
  {
    Options options = onThreads(threads);
    options.progress = [](double, void*) -> bool
    { throw std::system_error(EAGAIN, std::generic_category()); };
    expectError([&] { this->call()(options); }, ErrorCode::Internal);
  }
}

/// The calls that read coordinates; the others are given results alone.
class EveryCallOnPoints : public EveryCall
{
public:
  static std::vector<Call> calls()
  {
    std::vector<Call> reading;
    for (const Call& call : everyCall())
    {
      if (call.nonFinite != NonFinitePoint::IsNotRead)
      {
        reading.push_back(call);
      }
    }
    return reading;
  }
};

TEST_P(EveryCallOnPoints, NamesTheFirstPointThatIsNotFinite)
{
  const Call& call = this->call();
  const NonFinitePoint what = call.nonFinite;
  const std::size_t axes = call.planar && !call.weighted ? 2 : 3;
  const std::size_t last = call.cloud.size() - 1;
  for (const double bad : { nan, -infinity })
  {
    for (std::size_t axis = 0; axis < axes; ++axis)
    {
      for (const std::size_t first : { std::size_t(0), last / 3, last })
      {
        Call other = call;
        other.cloud[first][axis] = bad;
        other.cloud[last] = { bad, bad, bad }; // one bad point, not three
        for (const int threads : { 1, 4 })
        {
          if (what == NonFinitePoint::IsLeftOut)
          {
            EXPECT_NO_THROW(other(onThreads(threads)));
          }
          else if (what == NonFinitePoint::IsBadArgument)
          {
            expectError([&] { other(onThreads(threads)); }, ErrorCode::BadArgument);
          }
          else
          {
            expectError([&] { other(onThreads(threads)); }, ErrorCode::NonFinite,
              static_cast<std::int64_t>(first), first == last ? 1 : 2);
          }
        }
      }
    }
  }
  EXPECT_TRUE(call(Options()) == this->call()(Options())) << "a run after an error";
}

TEST_P(EveryCallOnPoints, RefusesWhatIsNoArray)
{
  const Call& call = this->call();
  const PointView points = viewOf(call.cloud);
  const auto changed = [&](auto change)
  {
    PointView other = points;
    change(other);
    this->expectErrorOf(other, call.weights(), ErrorCode::BadArgument);
  };
  changed([](PointView& p) { p.data = nullptr; });
  changed([](PointView& p) { p.count = -1; });
  changed([](PointView& p) { p.count = std::numeric_limits<std::int64_t>::min(); });
  for (const std::int64_t stride : { 1, 0, -3, call.planar ? 1 : 2 })
  {
    changed([&](PointView& p) { p.stride = stride; });
  }
  if (call.weighted)
  {
    const double* const weights = &call.cloud[0][2];
    for (const std::int64_t off : { -1, 1, 20 })
    {
      this->expectErrorOf(
        points, WeightView(weights, points.count + off, 3), ErrorCode::WeightCount);
    }
    for (const std::int64_t stride : { 0, -1, -3 })
    {
      this->expectErrorOf(
        points, WeightView(weights, points.count, stride), ErrorCode::BadArgument);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Calls, EveryCall, ::testing::ValuesIn(everyCall()),
  [](const auto& given) { return given.param.name; });

INSTANTIATE_TEST_SUITE_P(Calls, EveryCallOnPoints, ::testing::ValuesIn(EveryCallOnPoints::calls()),
  [](const auto& given) { return given.param.name; });

class EveryCallOnCells : public ::testing::TestWithParam<CallOnCells>
{
};

TEST_P(EveryCallOnCells, RefusesWhatIsNoTriangulationOfThePoints)
{
  const Cloud sites = randomSites(20, 0, 11);
  const auto expectBad = [&](const char* what, auto change)
  {
    SCOPED_TRACE(what);
    Triangulation broken = regularTriangulation(viewOf(sites));
    this->GetParam().run(sites, broken);
    change(broken);
    expectError([&] { this->GetParam().run(sites, broken); }, ErrorCode::BadArgument);
  };
  expectBad("dimension", [](Triangulation& t) { t.dimension = 3; });
  expectBad("corner above", [](Triangulation& t) { t.connectivity[0] = 20; });
  expectBad("corner below", [](Triangulation& t) { t.connectivity[0] = -1; });
  expectBad("id", [](Triangulation& t) { t.pointIds[1] = 20; });
  expectBad("cell size", [](Triangulation& t) { t.cellSize = -1; });
}

INSTANTIATE_TEST_SUITE_P(Calls, EveryCallOnCells, ::testing::ValuesIn(everyCallOnCells()),
  [](const auto& given) { return given.param.name; });

}
}
}
