// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The weights give what was prescribed: areas are taken anew from the power diagram of the result.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/PowerDiagram/PolygonCells.h"
#include "Testing/Engine/Transport/TransportCases.h"
#include <flipflop/PrescribedAreas.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

const double unitBox[] = { 0, 1, 0, 1 };

/// @param areas empty: all equal
PrescribedAreas expectMet(const Numbers& sites, const Numbers& areas, const ConvexDomain& domain,
  const Numbers& corners, double tolerance = 1e-6)
{
  const std::size_t count = sites.size() / 2;
  PrescribedAreas result =
    prescribedAreas(sitesView(sites), numbersView(areas), domain, tolerance, 100, onThreads(1));
  EXPECT_TRUE(result.converged);
  EXPECT_LE(result.error, tolerance);
  EXPECT_EQ(*std::min_element(result.weights.begin(), result.weights.end()), 0.0);

  const PrescribedAreas again =
    prescribedAreas(sitesView(sites), numbersView(areas), domain, tolerance, 100, onThreads(2));
  EXPECT_TRUE(sameBits(result.weights, again.weights));
  EXPECT_TRUE(sameBits(result.areas, again.areas));
  EXPECT_TRUE(sameBits(result.centroids, again.centroids));
  EXPECT_EQ(result.iterations, again.iterations);

  const WeightView weights(result.weights.data(), static_cast<std::int64_t>(count));
  const PowerDiagram cells = cellsOf(sites, weights, domain);
  EXPECT_EQ(cells.siteIds.size(), count);
  expectFills(cells, corners);
  Numbers found(cells.siteIds.size());
  Numbers centroids(2 * found.size());
  cellMeasures(cells, found.data(), centroids.data());
  const double sum =
    areas.empty() ? static_cast<double>(count) : std::accumulate(areas.begin(), areas.end(), 0.0);
  const double size = std::sqrt(polygonArea(corners));
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const double wanted = (areas.empty() ? 1.0 : areas[i]) / sum * polygonArea(corners);
    EXPECT_NEAR(found[i], wanted, 1.01 * tolerance * wanted);
    EXPECT_NEAR(found[i], result.areas[i], 1e-9 * wanted);
    EXPECT_NEAR(centroids[2 * i], result.centroids[2 * i], 1e-9 * size);
    EXPECT_NEAR(centroids[2 * i + 1], result.centroids[2 * i + 1], 1e-9 * size);
  }
  return result;
}

PrescribedAreas expectMetInBox(const Numbers& sites, const Numbers& areas = {})
{
  return expectMet(sites, areas, unitBox, { 0, 0, 1, 0, 1, 1, 0, 1 });
}

Numbers joined(Numbers a, const Numbers& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// From 1 to 10,000.
Numbers veryDifferentAreas()
{
  Numbers areas;
  for (int i = 0; i < 100; ++i)
  {
    areas.push_back(std::pow(10.0, 4.0 * i / 99));
  }
  return areas;
}

Numbers sitesOnALine()
{
  Numbers sites;
  for (int i = 0; i < 20; ++i)
  {
    sites.insert(sites.end(), { 0.3 + 0.01 * i * i / 20, 0.2 + 0.02 * i * i / 20 });
  }
  return sites;
}

struct AreaCase
{
  const char* name;
  Numbers sites;
  Numbers areas; ///< none: all equal
};

TEST(PrescribedAreas, AreMetInTheBox)
{
  const AreaCase cases[] = {
    { "at random", randomNumbers(600, 0, 1, 1), {} },
    { "at random, any areas", randomNumbers(600, 0, 1, 2), randomNumbers(300, 0.5, 1.5, 2) },
    { "enough for several tasks", randomNumbers(20000, 0, 1, 9), {} },
    { "very different areas", randomNumbers(200, 0, 1, 3), veryDifferentAreas() },
    { "clusters", joined(randomNumbers(200, 0.2, 0.2 + 1e-4, 4), randomNumbers(100, 0.7, 0.8, 5)),
      {} },
    { "a grid", grid(12), randomNumbers(144, 0.2, 2, 6) },
    { "a line", sitesOnALine(), {} },
    { "a line outside", { 5, 5, 7, 7, 6, 6, 10, 10 }, { 1, 2, 3, 4 } },
    { "all outside", randomNumbers(400, 3, 5, 7), {} },
    { "far outside", randomNumbers(120, 100.5, 100.9, 9), randomNumbers(60, 1, 3, 9) },
    { "some outside", randomNumbers(400, -2, 3, 8), {} },
    { "three", { 0.1, 0.1, 0.8, 0.2, 0.3, 0.9 }, { 1, 2, 5 } },
  };
  for (const AreaCase& one : cases)
  {
    SCOPED_TRACE(one.name);
    expectMetInBox(one.sites, one.areas);
  }
}

TEST(PrescribedAreas, KnownWeights)
{
  EXPECT_EQ(expectMetInBox(grid(12)).iterations, 0); // they are so without weights
  EXPECT_EQ(expectMetInBox({ 0.2, 0.4 }).weights[0], 0.0);
  EXPECT_EQ(expectMetInBox({ 9, 9 }).areas[0], 1.0);
  // The edge between two is where the areas say: x is 0.75.
  const PrescribedAreas two = expectMetInBox({ 0.25, 0.5, 0.5, 0.5 }, { 3, 1 });
  EXPECT_NEAR(two.weights[0] - two.weights[1], 0.5 * 0.5 - 0.25 * 0.25, 1e-6);
  const PrescribedAreas none = prescribedAreas(PointView(), WeightView(), unitBox);
  EXPECT_TRUE(none.converged);
  EXPECT_TRUE(none.weights.empty());
}

TEST(PrescribedAreas, AreMetInOtherDomains)
{
  for (int corners = 3; corners < 9; ++corners)
  {
    const Numbers polygon = regularPolygon(corners, 0.4);
    const ConvexDomain domain(polygon.data(), corners);
    expectMet(randomNumbers(160, -0.3, 0.3, 11), {}, domain, polygon);
    expectMet(
      randomNumbers(160, -2, 2, 12), randomNumbers(80, 0.5, 1.5, 13), domain, polygon, 1e-9);
  }
  // Metres of a country far from the origin.
  const double box[] = { 4e5, 5e5, 5.1e6, 5.2e6 };
  Numbers sites = randomNumbers(200, 0, 1e5, 14);
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    sites[i] += i % 2 ? 5.1e6 : 4e5;
  }
  expectMet(sites, {}, box, { 4e5, 5.1e6, 5e5, 5.1e6, 5e5, 5.2e6, 4e5, 5.2e6 });
}

/// In another unit, by a power of two, all is the same; also where squares of areas are no doubles.
TEST(PrescribedAreas, AnyUnit)
{
  const Numbers sites = randomNumbers(60, -1, 2, 18);
  const PrescribedAreas plain = expectMetInBox(sites);
  for (const int exponent : { -480, -400, 400, 480 })
  {
    const Numbers there = scaled(sites, exponent);
    const double side = std::ldexp(1.0, exponent);
    const double box[] = { 0, side, 0, side };
    const PrescribedAreas found = prescribedAreas(sitesView(there), WeightView(), box);
    EXPECT_TRUE(found.converged) << exponent;
    for (std::size_t i = 0; i < plain.weights.size(); ++i)
    {
      EXPECT_NEAR(std::ldexp(found.weights[i], -2 * exponent), plain.weights[i], 1e-6) << exponent;
    }
  }
}

/// Squares of distances that are no doubles cannot be weights.
TEST(PrescribedAreas, TooFarForWeights)
{
  const PrescribedAreas found =
    prescribedAreas(sitesView({ 1e200, 0, -1e200, 0, 0, 1e200 }), WeightView(), unitBox);
  EXPECT_FALSE(found.converged);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_TRUE(std::isfinite(found.weights[i]));
    EXPECT_TRUE(std::isfinite(found.areas[i]));
    EXPECT_TRUE(std::isfinite(found.centroids[2 * i]));
  }
}

TEST(PrescribedAreas, EndsAtTheLastIteration)
{
  const Numbers sites = randomNumbers(200, 0, 1, 15);
  const PrescribedAreas none = prescribedAreas(sitesView(sites), WeightView(), unitBox, 1e-6, 0);
  EXPECT_FALSE(none.converged);
  EXPECT_EQ(none.iterations, 0);
  EXPECT_GT(none.error, 0.1);
  const PrescribedAreas one = prescribedAreas(sitesView(sites), WeightView(), unitBox, 1e-6, 1);
  EXPECT_EQ(one.iterations, 1);
  EXPECT_LT(one.error, none.error);
  EXPECT_GT(one.statistics.secondsTotal, 0);
  EXPECT_EQ(one.statistics.points, 200); // of two triangulations
}

TEST(PrescribedAreas, Errors)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto expect = [](const Numbers& sites, const Numbers& areas, const ConvexDomain& domain,
                        ErrorCode code, std::int64_t index = -1, std::int64_t count = 0,
                        double tolerance = 1e-6, std::int64_t iterations = 10)
  {
    expectError([&]
      { prescribedAreas(sitesView(sites), numbersView(areas), domain, tolerance, iterations); },
      code, index, count);
  };
  const Numbers good{ 0.2, 0.2, 0.5, 0.7, 0.8, 0.3, 0.5, 0.7 };
  const Numbers three{ 0.2, 0.2, 0.5, 0.7, 0.8, 0.3 };
  expect(good, {}, unitBox, ErrorCode::DuplicateSites, 1, 3);
  expect(three, { 1, 0, -1 }, unitBox, ErrorCode::BadArea, 1, 2);
  expect(three, { 1, 2, nan }, unitBox, ErrorCode::BadArea, 2, 1);
  expect(three, { infinity, 2, 1 }, unitBox, ErrorCode::BadArea, 0, 1);
  expect(three, { 1, 1e-320, 1 }, unitBox, ErrorCode::BadArea, 1, 1);
  expect(three, {}, nullptr, ErrorCode::BadArgument);
  const double flat[] = { 0, 1, 1, 1 };
  expect(three, {}, flat, ErrorCode::BadArgument);
  const double huge[] = { 0, 1e200, 0, 1e200 };
  expect(three, {}, huge, ErrorCode::BadArgument);
  const double clockwise[] = { 0, 0, 0, 1, 1, 0 };
  expect(three, {}, ConvexDomain(clockwise, 3), ErrorCode::NotConvex, 0);
  expect(three, {}, unitBox, ErrorCode::BadArgument, -1, 0, -1);
  expect(three, {}, unitBox, ErrorCode::BadArgument, -1, 0, nan);
  expect(three, {}, unitBox, ErrorCode::BadArgument, -1, 0, 1e-6, -1);
}

}

}
}
