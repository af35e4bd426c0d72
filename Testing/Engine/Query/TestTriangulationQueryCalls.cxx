// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Queries to a triangulation on threads and from threads, their errors, progress and abort.
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <thread>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// All that can be asked, as bits.
struct Answers
{
  std::vector<std::int64_t> numbers;
  std::vector<double> values;

  bool operator==(const Answers& other) const
  {
    return this->numbers == other.numbers && this->values.size() == other.values.size() &&
      std::memcmp(this->values.data(), other.values.data(), this->values.size() * sizeof(double)) ==
      0;
  }
};

Answers answersOf(const TriangulationQueries& queries, const Cloud& sites, const Cloud& places,
  const Options& options)
{
  Answers result;
  const std::size_t count = places.size();
  result.numbers.resize(2 * count);
  result.values.resize(2 * count);
  queries.locate(viewOf(places), result.numbers.data(), options);
  queries.nearest(viewOf(places), result.numbers.data() + count, options);
  queries.interpolateLinear(sites.data()->data(), 1, viewOf(places), result.values.data(), options);
  queries.interpolateNatural(
    sites.data()->data(), 1, viewOf(places), result.values.data() + count, options);
  return result;
}

const int Count = isSanitized() ? 9000 : 20000;

TEST(TriangulationQueryCalls, AreTheSameOnAnyThreads)
{
  Random random(7);
  for (const double weight : { 0.0, 1.0 / Count })
  {
    const Cloud sites = weight > 0 ? randomSites(Count, weight, 71) : squareGrid(100);
    const Cloud places = placesAmong(sites, Count / 10, random);
    const Triangulation triangulation = triangulationOf(sites, FacetMode::Polygons);
    Answers first;
    for (const int threads : { 1, 2, 4 })
    {
      Options options;
      options.threads = threads;
      const TriangulationQueries queries(viewOf(sites), weightsOf(sites), triangulation, options);
      const Answers found = answersOf(queries, sites, places, options);
      first = threads == 1 ? found : first;
      EXPECT_TRUE(found == first) << threads;
    }
    // And in any order.
    const TriangulationQueries queries(viewOf(sites), weightsOf(sites), triangulation);
    for (std::size_t i = 0; i < places.size(); i += 97)
    {
      std::int64_t cell = -2;
      const Cloud one = { places[i] };
      queries.locate(viewOf(one), &cell);
      EXPECT_EQ(cell, first.numbers[i]);
    }
  }
}

TEST(TriangulationQueryCalls, FromSeveralThreadsAtOnce)
{
  const Cloud sites = randomSites(3000, 1e-4, 72);
  Random random(8);
  const Cloud places = placesAmong(sites, 600, random);
  const TriangulationQueries queries(
    viewOf(sites), weightsOf(sites), triangulationOf(sites, FacetMode::Triangles));
  const Answers expected = answersOf(queries, sites, places, Options());
  std::vector<Answers> found(4);
  std::vector<std::thread> callers;
  for (Answers& answers : found)
  {
    callers.emplace_back([&] { answers = answersOf(queries, sites, places, Options()); });
  }
  for (std::thread& caller : callers)
  {
    caller.join();
  }
  for (const Answers& answers : found)
  {
    EXPECT_TRUE(answers == expected);
  }
}

TEST(TriangulationQueryCalls, NonFinitePlaces)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Cloud sites = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const TriangulationQueries queries(
    viewOf(sites), WeightView(), triangulationOf(sites, FacetMode::Triangles));
  // Many: these would be sorted.
  Cloud places(10000, { 0.25, 0.25, nan });
  places[5000][0] = nan;
  places[7000][1] = -infinity;
  std::vector<std::int64_t> numbers(places.size());
  std::vector<double> values(places.size());
  const double given[] = { 0, 1, 1 };
  Options options;
  const std::vector<std::function<void()>> calls = { [&]
    { queries.locate(viewOf(places), numbers.data(), options); },
    [&] { queries.nearest(viewOf(places), numbers.data(), options); },
    [&] { queries.interpolateLinear(given, 1, viewOf(places), values.data(), options); },
    [&] { queries.interpolateNatural(given, 1, viewOf(places), values.data(), options); } };
  for (const auto& call : calls)
  {
    expectError(call, ErrorCode::NonFinite, 5000, 2);
  }
  options.nonFinite = NonFinitePolicy::Ignore;
  for (const auto& call : calls)
  {
    std::fill(numbers.begin(), numbers.end(), -2);
    std::fill(values.begin(), values.end(), -2.0);
    call();
    for (const std::size_t i : { 5000, 7000 })
    {
      EXPECT_TRUE(numbers[i] == -1 || (numbers[i] == -2 && std::isnan(values[i])));
      EXPECT_TRUE(numbers[i - 1] == 0 || (numbers[i - 1] == -2 && values[i - 1] == 0.5));
    }
  }
}

TEST(TriangulationQueryCalls, BadArguments)
{
  const ErrorCode bad = ErrorCode::BadArgument;
  const Cloud sites = randomSites(30, 0.01, 73);
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const TriangulationQueries queries(viewOf(sites), weightsOf(sites), triangulation);
  const PointView places = viewOf(sites);
  std::vector<std::int64_t> numbers(sites.size());
  std::vector<double> values(sites.size());
  expectError([&] { queries.locate(places, nullptr); }, bad);
  expectError([&] { queries.nearest(places, nullptr); }, bad);
  expectError([&] { queries.interpolateLinear(values.data(), 1, places, nullptr); }, bad);
  expectError([&] { queries.interpolateLinear(nullptr, 1, places, values.data()); }, bad);
  expectError([&] { queries.interpolateLinear(values.data(), 0, places, values.data()); }, bad);
  expectError([&] { queries.interpolateNatural(values.data(), 1, places, nullptr); }, bad);
  expectError([&] { queries.interpolateNatural(nullptr, 1, places, values.data()); }, bad);
  expectError([&] { queries.interpolateNatural(values.data(), -1, places, values.data()); }, bad);
  PointView wrong = places;
  wrong.stride = 1;
  expectError([&] { queries.locate(wrong, numbers.data()); }, bad);
  wrong = places;
  wrong.count = -1;
  expectError([&] { queries.nearest(wrong, numbers.data()); }, bad);
  wrong.count = std::int64_t(1) << 32;
  expectError([&] { queries.nearest(wrong, numbers.data()); }, ErrorCode::TooManyPoints);
  wrong = places;
  wrong.data = nullptr;
  expectError([&] { queries.interpolateLinear(values.data(), 1, wrong, values.data()); }, bad);
}

void expectRefused(const Cloud& sites, const Triangulation& triangulation, std::int64_t index = -2)
{
  expectError([&] { TriangulationQueries(viewOf(sites), weightsOf(sites), triangulation); },
    ErrorCode::BadArgument, index);
}

/// A claim of triangles, or of polygons where there are any.
void expectRefused(const Cloud& sites, int dimension, std::vector<Cell> cells)
{
  ReferenceTriangulation reference;
  reference.dimension = dimension;
  reference.ids = idsIn(cells);
  canonicalise(cells);
  reference.cells = std::move(cells);
  expectRefused(sites, makeTriangulation(reference, static_cast<std::int64_t>(sites.size())));
}

TEST(TriangulationQueryCalls, BadTriangulations)
{
  const Cloud sites = randomSites(30, 0.01, 73);
  const auto spoilt = [&](auto change)
  {
    Triangulation result = triangulationOf(sites, FacetMode::Triangles);
    change(result);
    return result;
  };
  expectRefused(sites, spoilt([](Triangulation& t) { t.dimension = 3; }));
  expectRefused(sites, spoilt([](Triangulation& t) { t.dimension = 1; }));
  expectRefused(sites, spoilt([](Triangulation& t) { t.connectivity[5] = 30; }));
  expectRefused(sites, spoilt([](Triangulation& t) { t.connectivity[5] = -1; }));
  expectRefused(sites, spoilt([](Triangulation& t) { t.pointIds[2] = t.pointIds[1]; }));
  expectRefused(
    sites, spoilt([](Triangulation& t) { t.pointIds[t.pointIds.size() - 1] = 30; }), 30);
  expectRefused(
    sites, spoilt([](Triangulation& t) { t.connectivity.truncate(t.connectivity.size() - 3); }));
  Cloud broken = sites;
  const std::int64_t seen = spoilt([](Triangulation&) {}).pointIds[4];
  broken[static_cast<std::size_t>(seen)][1] = std::numeric_limits<double>::infinity();
  expectRefused(broken, spoilt([](Triangulation&) {}), seen);

  const Triangulation good = triangulationOf(sites, FacetMode::Triangles);
  WeightView few = weightsOf(sites);
  --few.count;
  expectError([&] { TriangulationQueries(viewOf(sites), few, good); }, ErrorCode::WeightCount);
  expectError(
    [&] { TriangulationQueries(PointView(), WeightView(), good); }, ErrorCode::BadArgument);

  // Of other weights: no edge is regular any more.
  Random random(74);
  expectRefused(withWeights(sites, 0, 1, random), good);
  // Turned around, not convex, with a hole, in two parts, not regular.
  const Cloud square = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 3, 0 }, { 0, 3, 0 }, { 1, 1, 0 },
    { 9, 0, 0 }, { 9, 9, 0 }, { 6, 9, 0 }, { 3, 2, 0 } };
  expectRefused(square, 2, { { 0, 2, 1 } });
  expectRefused(square, 2, { { 0, 1, 8 }, { 1, 2, 8 } });
  expectRefused(square, 2, { { 0, 1, 2 }, { 5, 6, 7 } });
  expectRefused(square, 2, { { 0, 1, 2 }, { 0, 1, 2 } });
  expectRefused(square, 2, { { 0, 1, 8 }, { 0, 8, 3 }, { 1, 2, 8 } });
  const Cloud kite = { { 0, 0, 0 }, { 4, -1, 0 }, { 8, 0, 0 }, { 4, 1, 0 } };
  expectRefused(kite, 2, { { 0, 1, 2 }, { 0, 2, 3 } });
  expectRefused(kite, 2, { { 0, 1, 2, 3 } });

  // Chains.
  const Cloud line = { { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 }, { 3, 3, 0 }, { 3, 4, 0 } };
  expectRefused(line, 1, { { 0, 1 }, { 0, 2 } });
  expectRefused(line, 1, { { 0, 1 }, { 1, 2 }, { 2, 4 } });
  expectRefused(line, 1, { { 0, 1 }, { 2, 3 } });
  Cloud light = line;
  light[1][2] = -10;
  expectRefused(light, 1, { { 0, 1 }, { 1, 2 } });
  expectRefused(line, 1, { { 0, 1, 2 } });
  expectRefused(line, 0, { { 0 }, { 1 } });
  expectRefused(line, -1, { { 0 } });
}

TEST(TriangulationQueryCalls, ProgressAndAbort)
{
  const Cloud sites = randomSites(5000, 0, 75);
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const TriangulationQueries queries(viewOf(sites), weightsOf(sites), triangulation);
  Random random(9);
  const Cloud places = placesAmong(sites, 2000, random);
  std::vector<std::int64_t> numbers(places.size());
  std::vector<double> values(places.size());
  const std::vector<std::function<void(const Options&)>> calls = { [&](const Options& options)
    { TriangulationQueries(viewOf(sites), weightsOf(sites), triangulation, options); },
    [&](const Options& options) { queries.locate(viewOf(places), numbers.data(), options); },
    [&](const Options& options) { queries.nearest(viewOf(places), numbers.data(), options); },
    [&](const Options& options) {
      queries.interpolateNatural(sites.data()->data(), 1, viewOf(places), values.data(), options);
    },
    [&](const Options& options) {
      queries.interpolateLinear(sites.data()->data(), 1, viewOf(places), values.data(), options);
    } };
  for (const auto& call : calls)
  {
    Watch watch;
    call(watch.options(2));
    ASSERT_GE(watch.fractions.size(), 2u);
    watch.expectOrder();
    EXPECT_EQ(watch.fractions.back(), 1.0);
    for (const int stopAt : { 1, 2 })
    {
      Watch stopping;
      stopping.stopAt = stopAt;
      expectError([&] { call(stopping.options(2)); }, ErrorCode::Aborted);
    }
  }
}

}
}
}
