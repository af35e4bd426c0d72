// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Queries to a triangulation: what they refuse, and what they ignore on request.
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

TEST(TriangulationQueryCalls, IgnoreNonFinitePlaces)
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
  PointView many = places;
  many.count = std::int64_t(1) << 32;
  expectError([&] { queries.nearest(many, numbers.data()); }, ErrorCode::TooManyPoints);
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

}
}
}
