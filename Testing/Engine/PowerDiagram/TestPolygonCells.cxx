// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells in convex polygons of any size are the true ones, each corner rounded to nearest: as
/// brute force in rationals has them. Corners of polygons may bend by nearly nothing, or not at
/// all.
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/PowerDiagram/ExactPolygons.h"
#include "Testing/Engine/PowerDiagram/PolygonCells.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"
#include "Testing/Engine/Transport/TransportCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace
{

using namespace flipflop;
using namespace flipflop::test;

ConvexDomain domainOf(const Numbers& polygon)
{
  return ConvexDomain(polygon.data(), static_cast<std::int64_t>(polygon.size() / 2));
}

Numbers scaled(Numbers numbers, double factor)
{
  for (double& x : numbers)
  {
    x *= factor;
  }
  return numbers;
}

const Numbers pentagon = { 0, 0, 2, 0, 3, 1, 1, 3, -0.5, 1 };

/// Some corners on a circle, stretched and moved.
Numbers randomPolygon(std::size_t corners, unsigned seed)
{
  Numbers angles = randomNumbers(corners, 0, 6.28, seed);
  std::sort(angles.begin(), angles.end());
  const Numbers frame = randomNumbers(4, 0.2, 3, seed + 1);
  Numbers polygon;
  for (const double angle : angles)
  {
    polygon.push_back(frame[0] * std::cos(angle) + frame[2]);
    polygon.push_back(frame[1] * std::sin(angle) - frame[3]);
  }
  return polygon;
}

/// In the polygon's bounding box.
Numbers randomSites(std::size_t count, const Numbers& polygon, unsigned seed)
{
  Numbers sites = randomNumbers(2 * count, 0, 1, seed);
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    double least = polygon[i % 2];
    double most = least;
    for (std::size_t v = i % 2; v < polygon.size(); v += 2)
    {
      least = std::min(least, polygon[v]);
      most = std::max(most, polygon[v]);
    }
    sites[i] = least + sites[i] * (most - least);
  }
  return sites;
}

/// The cells are those of brute force, each corner rounded to nearest; the polygon's corners are
/// corners of cells.
void expectExact(const Numbers& sites, const Numbers& weights, const Numbers& polygon)
{
  const PowerDiagram diagram = cellsOf(sites, numbersView(weights), domainOf(polygon));
  std::map<std::int64_t, Polygon> wanted;
  std::set<std::array<double, 2>> positions;
  for (std::size_t i = 0; 2 * i < sites.size(); ++i)
  {
    const Polygon cell = roundingOf(exactCell(sites, weights, polygon, i));
    if (cell.size() > 2)
    {
      wanted[static_cast<std::int64_t>(i)] = cell;
      positions.insert(cell.begin(), cell.end());
    }
  }
  EXPECT_EQ(polygonsOf(diagram), wanted);
  EXPECT_EQ(diagram.corners.size(), 2 * positions.size());
  for (std::size_t v = 0; v < polygon.size(); v += 2)
  {
    EXPECT_EQ(positions.count({ polygon[v] + 0.0, polygon[v + 1] + 0.0 }), 1u);
  }
}

void expectFilled(const Numbers& sites, const Numbers& polygon)
{
  expectFills(cellsOf(sites, WeightView(), domainOf(polygon)), polygon);
}

/// A cell that is all of the polygon has its corners, bit for bit.
void expectWhole(const Numbers& polygon)
{
  const PowerDiagram diagram = cellsOf({ polygon[0], polygon[1] }, WeightView(), domainOf(polygon));
  EXPECT_EQ(Numbers(diagram.corners.begin(), diagram.corners.end()), polygon);
  EXPECT_EQ(diagram.connectivity.size(), polygon.size() / 2);
}

TEST(PolygonCells, OneSiteHasAllOfThePolygon)
{
  expectWhole(scaled(pentagon, 1.134364244112401));
  const Numbers factors = randomNumbers(2000, -5, 5, 3);
  for (const double factor : factors)
  {
    expectWhole(scaled(pentagon, std::exp(factor)));
  }
  for (unsigned seed = 1; seed <= 2000; ++seed)
  {
    expectWhole(randomPolygon(3 + seed % 12, seed));
  }
}

TEST(PolygonCells, CornersAreTheTrueOnesRounded)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Numbers polygon =
      seed % 2 ? scaled(pentagon, 0.37 * seed) : randomPolygon(3 + seed % 9, seed);
    const std::size_t count = seed % 10 == 0 ? 60 : 2 + seed % 7;
    expectExact(randomSites(count, polygon, seed), {}, polygon);
    const Numbers sites = randomSites(count, polygon, seed + 1);
    Numbers weights = randomNumbers(count, 0, 0.1 * (polygon[2] - polygon[0]), seed);
    expectExact(sites, weights, polygon);
  }
}

TEST(PolygonCells, EdgesThroughCornersOfTheDomain)
{
  // Sites on a grid: edges along sides, and through corners of the polygon.
  Numbers sites;
  for (int i = 0; i < 36; ++i)
  {
    sites.insert(sites.end(), { 1.0 * (i % 6), 1.0 * (i / 6) });
  }
  expectExact(sites, {}, { 0.5, 0.5, 4.5, 0.5, 4.5, 4.5, 2.5, 5.5 });
  expectExact(sites, {}, { 0, 2.5, 2.5, 0, 5, 2.5, 2.5, 5 });
  expectExact(sites, {}, { 0.5, 0.5, 3.5, 0.5, 4.5, 1.5, 4.5, 4.5, 2.5, 4.5, 0.5, 2.5 });
  // Of decimals, where some of that is so but for rounding.
  expectFilled(scaled(sites, 0.1), { 0.05, 0.05, 0.45, 0.05, 0.45, 0.45, 0.25, 0.55 });
  expectFilled(scaled(sites, 0.1), { 0, 0.25, 0.25, 0, 0.5, 0.25, 0.25, 0.5 });
  expectExact({ 0, 0, 1, 0, 2, 0, 5, 0 }, {}, { 0.5, -1, 2.5, -0.5, 3.5, 0, 2, 3, 1.5, 3 });
  // Mirrored at the axis, on which two corners are.
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    Numbers mirrored = randomNumbers(20, 0.1, 1, seed);
    for (std::size_t i = 0; i < 20; i += 2)
    {
      mirrored.insert(mirrored.end(), { -mirrored[i], mirrored[i + 1] });
    }
    expectExact(mirrored, {}, { 0, -0.1, 0.7, 0.3, 0.5, 0.9, 0, 1.1, -0.5, 0.9, -0.7, 0.3 });
  }
}

TEST(PolygonCells, AnySize)
{
  const Numbers sites = { 0.1, 0.2, 1, 1, 0.3, 0.9 };
  // Far from the origin.
  Numbers far = pentagon;
  Numbers there = sites;
  for (Numbers* numbers : { &far, &there })
  {
    for (std::size_t i = 0; i < numbers->size(); ++i)
    {
      (*numbers)[i] += i % 2 ? 5e6 : 1e6;
    }
  }
  expectExact(there, {}, far);
  for (const double size :
    { 5e-322, 1e-300, 1e-200, 1e-162, 1e-154, 1e-77, 1e77, 1e154, 1e200, 1e300, 5e307 })
  {
    SCOPED_TRACE(size);
    expectWhole(scaled(pentagon, size));
    expectExact(scaled(sites, size), {}, scaled(pentagon, size));
    EXPECT_EQ(
      cellsOf(scaled(sites, size), WeightView(), domainOf(scaled(pentagon, size))).siteIds.size(),
      3u);
  }
  // Weights have the square of the size.
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    const Numbers polygon = randomPolygon(3 + seed, seed);
    const Numbers many = randomSites(40, polygon, seed);
    const Numbers weights = randomNumbers(40, 0, 0.1, seed);
    const PowerDiagram one = cellsOf(many, numbersView(weights), domainOf(polygon));
    const PowerDiagram plain = cellsOf(many, WeightView(), domainOf(polygon));
    for (const int exponent : { -990, -500, -400, 100, 480, 500, 990 })
    {
      const double size = std::ldexp(1, exponent);
      const Numbers here = scaled(polygon, size);
      PowerDiagram other = cellsOf(scaled(many, size), WeightView(), domainOf(here));
      const auto back = [&]
      {
        for (double& x : other.corners)
        {
          x /= size;
        }
      };
      back();
      EXPECT_EQ(bitDifference(plain, other), "") << exponent;
      if (std::abs(exponent) <= 500)
      {
        other = cellsOf(
          scaled(many, size), numbersView(scaled(scaled(weights, size), size)), domainOf(here));
        back();
        EXPECT_EQ(bitDifference(one, other), "") << exponent;
      }
    }
  }
}

/// Three sites whose numbers are small integers, full of ties; decimals, likewise; nearly on a
/// line; or of exponents from any range.
TEST(PolygonCells, SitesOfAnyExponents)
{
  Random random(12);
  for (const int range : { 0, -1, -2, 1, 10, 100, 140, 300, 480 })
  {
    const auto length = [&]() -> double
    {
      return range == 0 ? random.integer(-4, 4)
        : range == -1
        ? 0.1 * random.integer(-30, 30)
        : std::ldexp(random.uniform(-1, 1), random.integer(-std::abs(range), std::abs(range)));
    };
    for (int i = 0; i < 200; ++i)
    {
      SCOPED_TRACE("range " + std::to_string(range) + ", case " + std::to_string(i));
      Numbers sites(6);
      std::generate(sites.begin(), sites.end(), length);
      Numbers weights(3);
      for (double& weight : weights)
      {
        const double root = length();
        weight = random.integer(0, 3) ? root * std::fabs(length()) : 0;
      }
      if (range == -2)
      {
        const double t = random.uniform(-2, 2);
        sites[4] = sites[0] + t * (sites[2] - sites[0]);
        sites[5] = sites[1] + t * (sites[3] - sites[1]);
      }
      const std::set<std::pair<double, double>> positions = { { sites[0], sites[1] },
        { sites[2], sites[3] }, { sites[4], sites[5] } };
      if (positions.size() < 3)
      {
        continue;
      }
      const double size = std::ldexp(1.0, std::abs(range) / 2);
      expectExact(sites, weights, scaled(pentagon, size));
    }
  }
}

/// An edge ends at half of an odd number of smallest units and 2^-31 more: up, though 53 bits show
/// but the half.
TEST(PolygonCells, SubnormalsAreRoundedOnce)
{
  const double unit = std::numeric_limits<double>::denorm_min();
  expectExact(
    { 0, 0, unit, (0x1p30 + 1) * unit }, {}, scaled({ 0, 0, 1, 0, 1, 1, 0, 1 }, 0x1p40 * unit));
}

TEST(PolygonCells, TheWholeRangeOfDoubles)
{
  const double most = std::numeric_limits<double>::max();
  const Numbers polygon = { -most, -most, most, -most / 2, most, most, -most / 3, most };
  expectWhole(polygon);
  expectExact({ most, most, -most, most, most, -most, -most, -most }, {}, polygon);
  expectExact({ 0, 0, 5e-324, 5e-324, most, 1 }, {}, polygon);
  expectExact({ 0, 0, 1e-300, 0, 1e300, 1e-300 }, {}, pentagon);
}

TEST(PolygonCells, ManySidesAndManyNeighbours)
{
  // A site with many neighbours, all of whose edges are in a polygon of many sides, or few.
  Numbers sites = { 0, 0 };
  const Numbers circle = regularPolygon(3000, 0.1);
  sites.insert(sites.end(), circle.begin(), circle.end());
  for (const int corners : { 3, 7, 5000 })
  {
    const Numbers polygon = scaled(regularPolygon(corners, 0.3), 0.7);
    expectFilled(sites, polygon);
  }
}

TEST(PolygonCells, ABoxIsAPolygonOfFourCorners)
{
  const Numbers box = { 0.2, 0.7, 0.1, 0.9 };
  const Numbers corners = { 0.2, 0.1, 0.7, 0.1, 0.7, 0.9, 0.2, 0.9 };
  for (unsigned seed = 1; seed <= 30; ++seed)
  {
    const std::size_t count = 1 + seed * seed;
    const Numbers sites = randomNumbers(2 * count, 0, 1, seed);
    const Numbers weights = randomNumbers(seed % 2 ? count : 0, 0, 0.02, seed);
    // But for the corners at which the cells start.
    EXPECT_EQ(polygonsOf(cellsOf(sites, numbersView(weights), ConvexDomain(box.data()))),
      polygonsOf(cellsOf(sites, numbersView(weights), domainOf(corners))));
    if (count < 50)
    {
      expectExact(sites, weights, corners);
    }
  }
}

TEST(PolygonCells, StraightCornersAreDropped)
{
  const Numbers sites{ 0.2, 0.3, 0.7, 0.6, 0.4, 0.9 };
  const Numbers plain{ 0, 0, 1, 0, 1, 1, 0, 1 };
  const Numbers more{ 0, 0, 0.5, 0, 1, 0, 1, 1, 0, 1, 0, 0.5 };
  EXPECT_EQ(bitDifference(cellsOf(sites, WeightView(), domainOf(plain)),
              cellsOf(sites, WeightView(), domainOf(more))),
    "");
}

/// Sites on a circle, and sides through its center, where nearly all cells meet.
TEST(PolygonCells, ABendOfNearlyNone)
{
  for (int trial = 0; trial < 40; ++trial)
  {
    Numbers sites;
    for (const double angle :
      randomNumbers(10 + 4 * static_cast<std::size_t>(trial), 0, 6.3, unsigned(trial)))
    {
      sites.insert(sites.end(), { 0.5 * std::cos(angle) + 0.5, 0.5 * std::sin(angle) + 0.5 });
    }
    const double off = 0x1p-52 * trial;
    const PowerDiagram diagram =
      cellsOf(sites, WeightView(), domainOf({ 0.5 + off, 0.5 + off, -1, 2, -1, -1, 2, -1 }));
    Numbers areas(diagram.siteIds.size());
    cellMeasures(diagram, areas.data(), nullptr);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 4.5, 1e-12);
  }
}

}
