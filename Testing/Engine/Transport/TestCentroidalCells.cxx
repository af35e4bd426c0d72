// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lloyd's algorithm: its energy, taken from the cells by another formula, falls; where it ends,
/// sites are centroids of their cells.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/PowerDiagram/PolygonCells.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"
#include "Testing/Engine/Transport/TransportCases.h"
#include <flipflop/CentroidalCells.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

const double unitBox[] = { 0, 1, 0, 1 };
const Numbers boxCorners = { 0, 0, 1, 0, 1, 1, 0, 1 };

/// The sum over the cells of the squared distance from the site, less its weight. Of a triangle at
/// the site, the mean of a squared distance is that at the middles of its sides.
double energyOf(const CentroidalCells& found, const Numbers& weights)
{
  double energy = 0;
  const PowerDiagram& cells = found.cells;
  for (std::size_t c = 0; c < cells.siteIds.size(); ++c)
  {
    const auto id = static_cast<std::size_t>(cells.siteIds[c]);
    const double* const site = found.sites.data() + 2 * id;
    for (std::int64_t i = cells.offsets[c]; i < cells.offsets[c + 1]; ++i)
    {
      const std::int64_t j = i + 1 < cells.offsets[c + 1] ? i + 1 : cells.offsets[c];
      const double* const p = cells.corners.data() + 2 * cells.connectivity[i];
      const double* const q = cells.corners.data() + 2 * cells.connectivity[j];
      const double a[2] = { p[0] - site[0], p[1] - site[1] };
      const double b[2] = { q[0] - site[0], q[1] - site[1] };
      const auto square = [](double x, double y) { return x * x + y * y; };
      const double mean = (square(a[0] / 2, a[1] / 2) + square(b[0] / 2, b[1] / 2) +
                            square((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)) /
        3;
      energy += 0.5 * (a[0] * b[1] - a[1] * b[0]) * (mean - (weights.empty() ? 0 : weights[id]));
    }
  }
  return energy;
}

CentroidalCells lloyd(const Numbers& sites, const Numbers& weights, const ConvexDomain& domain,
  std::int64_t iterations, double tolerance = 0, int threads = 1)
{
  return centroidalCells(
    sitesView(sites), numbersView(weights), domain, iterations, tolerance, onThreads(threads));
}

void expectFalling(
  const Numbers& sites, const Numbers& weights, const ConvexDomain& domain, const Numbers& corners)
{
  double before = std::numeric_limits<double>::infinity();
  Numbers at = sites;
  for (int i = 0; i < 6; ++i)
  {
    const CentroidalCells found = lloyd(sites, weights, domain, i);
    EXPECT_EQ(found.iterations, i);
    expectFills(found.cells, corners);
    const double energy = energyOf(found, weights);
    EXPECT_LE(energy, before + 1e-12);
    before = energy;
    // One step more from where it was is where it is now.
    if (i > 0)
    {
      const CentroidalCells next = lloyd(at, weights, domain, 1);
      EXPECT_TRUE(sameBits(next.sites, found.sites));
      EXPECT_EQ(next.lastMove, found.lastMove);
    }
    at.assign(found.sites.begin(), found.sites.end());
  }
}

TEST(CentroidalCells, EnergyFalls)
{
  for (unsigned seed = 1; seed < 4; ++seed)
  {
    const Numbers sites = randomNumbers(200, 0, 1, seed);
    expectFalling(sites, {}, unitBox, boxCorners);
    expectFalling(sites, randomNumbers(100, 0, 0.01, seed), unitBox, boxCorners);
    const Numbers polygon = regularPolygon(3 + static_cast<int>(seed), 0.5);
    expectFalling(randomNumbers(100, -1.5, 1.5, seed), {},
      ConvexDomain(polygon.data(), static_cast<std::int64_t>(polygon.size() / 2)), polygon);
  }
}

TEST(CentroidalCells, EndsAtCentroids)
{
  const CentroidalCells found = lloyd(randomNumbers(40, 0, 1, 3), {}, unitBox, 10000, 1e-9);
  EXPECT_TRUE(found.converged);
  EXPECT_LT(found.iterations, 10000);
  EXPECT_LE(found.lastMove, 1e-9);
  EXPECT_EQ(found.withoutCell, 0);
  double whole = 0;
  for (std::size_t i = 0; i < found.areas.size(); ++i)
  {
    whole += found.areas[i];
    EXPECT_NEAR(found.sites[2 * i], found.centroids[2 * i], 1e-8);
    EXPECT_NEAR(found.sites[2 * i + 1], found.centroids[2 * i + 1], 1e-8);
  }
  EXPECT_NEAR(whole, 1, 1e-14);
}

TEST(CentroidalCells, AGridStays)
{
  const CentroidalCells found = lloyd(grid(8), {}, unitBox, 50, 1e-12);
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.iterations, 1);
  for (const double area : found.areas)
  {
    EXPECT_NEAR(area, 1.0 / 64, 1e-15);
  }
}

TEST(CentroidalCells, SitesWithoutACellStay)
{
  // The second is at the first's place, until that moves; the third is far behind the fourth, which
  // moves in.
  const Numbers sites{ 0.2, 0.3, 0.2, 0.3, 9, 0.5, 1.2, 0.5 };
  const CentroidalCells before = lloyd(sites, {}, unitBox, 0);
  EXPECT_EQ(before.withoutCell, 2);
  EXPECT_EQ(before.areas[1], 0);
  EXPECT_EQ(before.centroids[2], 0.2);
  EXPECT_EQ(before.cells.siteIds.size(), 2u);
  EXPECT_FALSE(before.converged);
  const CentroidalCells found = lloyd(sites, {}, unitBox, 1);
  EXPECT_EQ(found.withoutCell, 1);
  EXPECT_EQ(found.sites[2], 0.2);
  EXPECT_EQ(found.sites[4], 9);
  EXPECT_EQ(found.areas[2], 0);
  EXPECT_EQ(found.centroids[4], 9);
  EXPECT_NEAR(found.areas[0] + found.areas[1] + found.areas[3], 1, 1e-14);
  EXPECT_LT(beyond(boxCorners, found.sites.data() + 6), 0);
}

TEST(CentroidalCells, FewSites)
{
  const CentroidalCells one = lloyd({ 7, 8 }, {}, unitBox, 5);
  EXPECT_TRUE(one.converged);
  EXPECT_EQ(one.iterations, 2);
  EXPECT_EQ(one.sites[0], 0.5);
  const CentroidalCells line = lloyd({ 0.1, 0.5, 0.2, 0.5, 0.3, 0.5 }, {}, unitBox, 1000, 1e-12);
  EXPECT_TRUE(line.converged);
  EXPECT_NEAR(line.sites[2], 0.5, 1e-9);
  const CentroidalCells none = centroidalCells(PointView(), WeightView(), unitBox, 5, 0);
  EXPECT_TRUE(none.converged);
  EXPECT_TRUE(none.sites.empty());
}

/// In another unit, by a power of two, sites are the same; also where cubes of lengths are no
/// doubles.
TEST(CentroidalCells, AnyUnit)
{
  const Numbers sites = randomNumbers(60, 0, 1, 17);
  const CentroidalCells plain = lloyd(sites, {}, unitBox, 3);
  for (const int exponent : { -500, -400, 400, 500 })
  {
    const double side = std::ldexp(1.0, exponent);
    const double box[] = { 0, side, 0, side };
    const CentroidalCells found = lloyd(scaled(sites, exponent), {}, box, 3);
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      EXPECT_EQ(found.sites[i], std::ldexp(plain.sites[i], exponent)) << exponent;
    }
  }
}

/// The least and the greatest domain whose area is a normal double.
TEST(CentroidalCells, ToTheEndsOfAreas)
{
  const Numbers polygon = { 0, 0, 2, 0, 3, 1, 1, 3, -0.5, 1 };
  const Numbers sites = { 0.1, 0.2, 1, 1, 0.3, 0.9 };
  const auto lloydAt = [&](int exponent)
  {
    const Numbers domain = scaled(polygon, exponent);
    return lloyd(scaled(sites, exponent), {}, ConvexDomain(domain.data(), 5), 10);
  };
  const CentroidalCells plain = lloydAt(0);
  for (const int exponent : { -512, -511, -200, 200, 509, 510 })
  {
    const CentroidalCells found = lloydAt(exponent);
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(std::ldexp(found.areas[i], -2 * exponent), plain.areas[i], 1e-9) << exponent;
      for (std::size_t k = 2 * i; k < 2 * i + 2; ++k)
      {
        EXPECT_NEAR(std::ldexp(found.sites[k], -exponent), plain.sites[k], 1e-9) << exponent;
      }
    }
  }
  expectError([&] { lloydAt(-513); }, ErrorCode::BadArgument);
  expectError([&] { lloydAt(511); }, ErrorCode::BadArgument);
}

TEST(CentroidalCells, Errors)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Numbers sites{ 0.2, 0.2, 0.5, 0.7, 0.8, 0.3 };
  expectError([&] { lloyd(sites, {}, nullptr, 3); }, ErrorCode::BadArgument);
  // An area that is no normal double, and one that is, of a width that is none.
  for (const double size : { 1e-200, 1e-162, 1e155, 1e200 })
  {
    const double box[] = { 0, size, 0, size };
    expectError([&] { lloyd(sites, {}, box, 3); }, ErrorCode::BadArgument);
  }
  const double wide[] = { -1e308, 1e308, 0, 1e-300 };
  expectError([&] { lloyd(sites, {}, wide, 3); }, ErrorCode::BadArgument);
  expectError([&] { lloyd(sites, {}, unitBox, -1); }, ErrorCode::BadArgument);
  expectError([&] { lloyd(sites, {}, unitBox, 3, -1); }, ErrorCode::BadArgument);
  expectError([&] { lloyd(sites, {}, unitBox, 3, nan); }, ErrorCode::BadArgument);
  const double clockwise[] = { 0, 0, 0, 1, 1, 0 };
  expectError([&] { lloyd(sites, {}, ConvexDomain(clockwise, 3), 3); }, ErrorCode::NotConvex, 0);
}

}

}
}
