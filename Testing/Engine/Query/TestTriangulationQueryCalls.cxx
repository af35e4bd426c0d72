// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Queries to a triangulation: what they keep, what they refuse, and what they ignore on request.
#include "Testing/Engine/Query/PlaneQueries.h"
#include "Testing/Engine/Validate/TriangulationClaims.h"

#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

#include <functional>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();

TEST(TriangulationQueryCalls, OfNoPoint)
{
  const Cloud places = { { 0, 0, 0 }, { 1, 2, 0 } };
  const TriangulationQueries queries{ PointView(), WeightView(), Triangulation() };
  std::vector<std::int64_t> cells(2), ids(2);
  std::vector<double> values(2);
  queries.locate(viewOf(places), cells.data());
  queries.nearest(viewOf(places), ids.data());
  queries.interpolateLinear(nullptr, 1, viewOf(places), values.data());
  EXPECT_EQ(cells, (std::vector<std::int64_t>{ -1, -1 }));
  EXPECT_EQ(ids, cells);
  EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[1]));
  queries.locate(PointView(), nullptr);
}

/// The arguments may go, also where they were floats, strides apart; and the queries may be moved.
TEST(TriangulationQueryCalls, KeepNoViewOfTheirArguments)
{
  const Cloud sites = roundedToFloat(randomSites(50, 0.02, 3));
  const auto count = static_cast<std::int64_t>(sites.size());
  const auto make = [&]
  {
    // x and y side by side; the weight elsewhere.
    std::vector<float> pairs, weights;
    for (const Point& site : sites)
    {
      pairs.insert(pairs.end(), { static_cast<float>(site[0]), static_cast<float>(site[1]) });
      weights.insert(weights.end(), 7, static_cast<float>(site[2]));
    }
    return TriangulationQueries(PointView(pairs.data(), count, 2),
      WeightView(weights.data(), count, 7), triangulationOf(sites, FacetMode::Triangles));
  };
  TriangulationQueries made = make();
  const TriangulationQueries moved = std::move(made);
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const std::vector<Cell> cells = cellsOf(triangulation);
  Random random(4);
  for (int i = 0; i < 100; ++i)
  {
    const Point place = { random.uniform(), random.uniform(), nan };
    std::int64_t cell = -2, id = -2;
    moved.locate(viewOf({ place }), &cell);
    moved.nearest(viewOf({ place }), &id);
    EXPECT_EQ(cell, cellByForce(sites, cells, 2, place));
    EXPECT_EQ(id, nearestByForce(sites, triangulation.pointIds, place));
  }
}

TEST(TriangulationQueryCalls, ValuesOfSeveralComponents)
{
  const Cloud sites = randomSites(200, 0, 5);
  const TriangulationQueries queries(
    viewOf(sites), WeightView(), triangulationOf(sites, FacetMode::Triangles));
  Random random(6);
  const Cloud places = placesAmong(sites, 20, random);
  std::vector<double> values;
  for (const Point& site : sites)
  {
    values.insert(values.end(), { 1.0, site[0], 3 * site[0] - 2 * site[1] + 0.5 });
  }
  std::vector<double> found(3 * places.size());
  queries.interpolateLinear(values.data(), 3, viewOf(places), found.data());
  int inside = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (!std::isnan(found[3 * i]))
    {
      ++inside;
      EXPECT_NEAR(found[3 * i], 1.0, 4e-16);
      EXPECT_NEAR(found[3 * i + 1], places[i][0], 4e-16);
      EXPECT_NEAR(found[3 * i + 2], 3 * places[i][0] - 2 * places[i][1] + 0.5, 4e-15);
    }
  }
  EXPECT_GT(inside, 50);
}

/// Many: these would be sorted.
TEST(TriangulationQueryCalls, IgnoreNonFinitePlaces)
{
  const Cloud sites = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const TriangulationQueries queries(
    viewOf(sites), WeightView(), triangulationOf(sites, FacetMode::Triangles));
  Cloud places(10000, { 0.25, 0.25, nan });
  places[5000][0] = nan;
  places[7000][1] = -HUGE_VAL;
  std::vector<std::int64_t> cells(places.size()), ids(places.size());
  std::vector<double> linear(places.size()), natural(places.size());
  const double given[] = { 0, 1, 1 };
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  queries.locate(viewOf(places), cells.data(), options);
  queries.nearest(viewOf(places), ids.data(), options);
  queries.interpolateLinear(given, 1, viewOf(places), linear.data(), options);
  queries.interpolateNatural(given, 1, viewOf(places), natural.data(), options);
  for (const std::size_t i : { 5000, 7000 })
  {
    EXPECT_TRUE(cells[i] == -1 && ids[i] == -1 && std::isnan(linear[i]) && std::isnan(natural[i]));
    EXPECT_TRUE(cells[i - 1] == 0 && ids[i - 1] == 0);
    EXPECT_TRUE(linear[i - 1] == 0.5 && natural[i - 1] == 0.5);
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
  WeightView few = weightsOf(sites);
  --few.count;
  expectError(
    [&] { TriangulationQueries(viewOf(sites), few, triangulation); }, ErrorCode::WeightCount);
  expectError([&] { TriangulationQueries(PointView(), WeightView(), triangulation); }, bad);
}

void expectRefused(const Cloud& sites, const Triangulation& triangulation, std::int64_t index = -2)
{
  expectError([&] { TriangulationQueries(viewOf(sites), weightsOf(sites), triangulation); },
    ErrorCode::BadArgument, index);
}

TEST(TriangulationQueryCalls, BrokenTriangulations)
{
  const Cloud sites = randomSites(30, 0.01, 73);
  const auto spoilt = [&](auto change)
  {
    Triangulation result = triangulationOf(sites, FacetMode::Triangles);
    change(result);
    return result;
  };
  expectRefused(sites, spoilt([](Triangulation& t) { t.dimension = 1; }));
  expectRefused(sites, spoilt([](Triangulation& t) { t.pointIds[2] = t.pointIds[1]; }));
  expectRefused(
    sites, spoilt([](Triangulation& t) { t.pointIds[t.pointIds.size() - 1] = 30; }), 30);
  expectRefused(
    sites, spoilt([](Triangulation& t) { t.connectivity.truncate(t.connectivity.size() - 3); }));
  const Triangulation good = spoilt([](Triangulation&) {});
  Cloud broken = sites;
  broken[static_cast<std::size_t>(good.pointIds[4])][1] = HUGE_VAL;
  expectRefused(broken, good, good.pointIds[4]);
  // Of other weights: no edge is regular any more.
  Random random(74);
  expectRefused(withWeights(sites, 0, 1, random), good);
}

TEST(TriangulationQueryCalls, WhatIsNotRegular)
{
  const Cloud square = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 3, 0 }, { 0, 3, 0 }, { 1, 1, 0 },
    { 9, 0, 0 }, { 9, 9, 0 }, { 6, 9, 0 }, { 3, 2, 0 } };
  const Cloud kite = { { 0, 0, 0 }, { 4, -1, 0 }, { 8, 0, 0 }, { 4, 1, 0 } };
  const Cloud line = { { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 }, { 3, 3, 0 }, { 3, 4, 0 } };
  Cloud light = line;
  light[1][2] = -10;
  struct Claim
  {
    const Cloud& cloud;
    int dimension;
    std::vector<Cell> cells;
  };
  // Turned around, not convex, in two parts, twice, with a hole, not regular, not one circle's; and
  // chains with a wrong end, off the line, with a gap, over a hidden point, and of other cells.
  const Claim claims[] = { { square, 2, { { 0, 2, 1 } } },
    { square, 2, { { 0, 1, 8 }, { 1, 2, 8 } } }, { square, 2, { { 0, 1, 2 }, { 5, 6, 7 } } },
    { square, 2, { { 0, 1, 2 }, { 0, 1, 2 } } },
    { square, 2, { { 0, 1, 8 }, { 0, 8, 3 }, { 1, 2, 8 } } },
    { kite, 2, { { 0, 1, 2 }, { 0, 2, 3 } } }, { kite, 2, { { 0, 1, 2, 3 } } },
    { line, 1, { { 0, 1 }, { 0, 2 } } }, { line, 1, { { 0, 1 }, { 1, 2 }, { 2, 4 } } },
    { line, 1, { { 0, 1 }, { 2, 3 } } }, { light, 1, { { 0, 1 }, { 1, 2 } } },
    { line, 1, { { 0, 1, 2 } } }, { line, 0, { { 0 }, { 1 } } }, { line, -1, { { 0 } } } };
  for (const Claim& one : claims)
  {
    expectRefused(one.cloud, claim(one.cloud, one.dimension, one.cells));
  }
}

/// All triangles turn left, all edges are regular, and the border is one loop that turns left: but
/// twice around. The second time it is a little further out, or at the same positions.
TEST(TriangulationQueryCalls, WhatWindsTwice)
{
  for (const double further : { 0x1p-30, 0.0 })
  {
    Cloud cloud = { { 0, 0, 10 } };
    std::vector<Cell> cells;
    for (int i = 0; i < 10; ++i)
    {
      const double angle = 6.283185307179586 * (i % 5) / 5;
      const double r = i < 5 ? 1 : 1 + further;
      cloud.push_back({ r * std::cos(angle), r * std::sin(angle), 0 });
      cells.push_back({ 0, 1 + i, 1 + (i + 1) % 10 });
    }
    expectRefused(cloud, claim(cloud, 2, cells, FacetMode::Triangles));
  }
}

/// An error names a point where something is wrong, by its id.
TEST(TriangulationQueryCalls, WhereItIsNotOne)
{
  const Cloud cloud = { { 0, 0, 0 }, { 9, 9, 0 }, { 4, 0, 0 }, { 0, 3, 0 }, { 4, 3, 0 } };
  const auto claimed = [&](const std::vector<Cell>& cells)
  { return claim(cloud, 2, cells, FacetMode::Triangles); };
  expectRefused(cloud, claimed({ { 0, 2, 3 }, { 2, 3, 4 } }), 0);              // no ring
  expectRefused(cloud, claimed({ { 0, 3, 2 } }), 0);                           // turned
  expectRefused(cloud, claimed({ { 0, 2, 3 }, { 1, 3, 4 }, { 2, 4, 3 } }), 2); // not convex
  Triangulation none = claimed({ { 0, 2, 3 } });
  none.connectivity.truncate(0);
  expectRefused(cloud, none, 0); // a point in no cell
  none.pointIds.truncate(0);
  expectRefused(cloud, none, -1);
  none.cellSize = 0;
  expectRefused(cloud, none, -1);
}

}
}
}
