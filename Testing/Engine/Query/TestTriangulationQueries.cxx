// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cell of a place and its nearest site are those of the definitions, on every kind of input;
/// linear values are those of the exact shares.
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

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

std::vector<std::int64_t> cellsAt(const TriangulationQueries& queries, const Cloud& places)
{
  std::vector<std::int64_t> cells(places.size(), -2);
  queries.locate(viewOf(places), cells.data());
  return cells;
}

std::vector<std::int64_t> nearestTo(const TriangulationQueries& queries, const Cloud& places)
{
  std::vector<std::int64_t> ids(places.size(), -2);
  queries.nearest(viewOf(places), ids.data());
  return ids;
}

/// The exact linear value of f at a place, from the corners of its cell's fans.
Rational linearByForce(const Cloud& sites, const Cell& cell, int dimension,
  const std::vector<double>& values, const Point& place)
{
  const auto at = [&](std::size_t i) -> const Point&
  { return sites[static_cast<std::size_t>(cell[i])]; };
  const auto value = [&](std::size_t i)
  { return Rational(values[static_cast<std::size_t>(cell[i])]); };
  if (dimension == 0)
  {
    return value(0);
  }
  if (dimension == 1)
  {
    const std::size_t k = at(0)[0] != at(1)[0] ? 0 : 1;
    const Rational t = (Rational(place[k]) - at(0)[k]) / (Rational(at(1)[k]) - Rational(at(0)[k]));
    return value(0) + t * (value(1) - value(0));
  }
  for (std::size_t i = 1; i + 1 < cell.size(); ++i)
  {
    const Rational a = orientation(at(i), at(i + 1), place);
    const Rational b = orientation(at(i + 1), at(0), place);
    const Rational c = orientation(at(0), at(i), place);
    if (a >= 0 && b >= 0 && c >= 0)
    {
      return (a * value(0) + b * value(i) + c * value(i + 1)) / (a + b + c);
    }
  }
  ADD_FAILURE() << "not in the cell";
  return 0;
}

void expectAnswers(const Cloud& sites, int places, std::uint64_t seed)
{
  Random random(seed);
  const Cloud asked = placesAmong(sites, places, random);
  std::vector<double> values;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    values.push_back(random.uniform(-1, 1));
  }
  std::vector<double> linear[2];
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    SCOPED_TRACE(facets == FacetMode::Polygons ? "polygons" : "triangles");
    const Triangulation triangulation = triangulationOf(sites, facets);
    const TriangulationQueries queries(viewOf(sites), weightsOf(sites), triangulation);
    const std::vector<Cell> cells = cellsOf(triangulation);
    const std::vector<std::int64_t> found = cellsAt(queries, asked);
    const std::vector<std::int64_t> nearest = nearestTo(queries, asked);
    std::vector<double>& result = linear[facets == FacetMode::Polygons];
    result.resize(asked.size());
    queries.interpolateLinear(values.data(), 1, viewOf(asked), result.data());
    for (std::size_t i = 0; i < asked.size(); ++i)
    {
      const std::int64_t cell = cellByForce(sites, cells, triangulation.dimension, asked[i]);
      ASSERT_EQ(found[i], cell) << placeText(asked[i]);
      ASSERT_EQ(nearest[i], nearestByForce(sites, triangulation.pointIds, asked[i]))
        << placeText(asked[i]);
      ASSERT_EQ(std::isnan(result[i]), cell < 0) << placeText(asked[i]);
      if (cell >= 0)
      {
        const Rational exact = linearByForce(
          sites, cells[static_cast<std::size_t>(cell)], triangulation.dimension, values, asked[i]);
        ASSERT_NEAR(result[i], exact.get_d(), 4e-16) << placeText(asked[i]);
      }
    }
    // At a site its own value.
    for (const std::int64_t id : triangulation.pointIds)
    {
      const Cloud one = { sites[static_cast<std::size_t>(id)] };
      double value = 0;
      queries.interpolateLinear(values.data(), 1, viewOf(one), &value);
      EXPECT_EQ(value, values[static_cast<std::size_t>(id)]);
    }
  }
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    EXPECT_TRUE(linear[0][i] == linear[1][i] || std::isnan(linear[0][i])) << placeText(asked[i]);
  }
}

class OnSpecialSites : public testing::TestWithParam<Input>
{
};

TEST_P(OnSpecialSites, AreThoseOfTheDefinitions)
{
  const Cloud sites = GetParam().make();
  expectAnswers(sites, sites.size() > 100 ? 10 : 20, 1 + GetParam().seed);
}

INSTANTIATE_TEST_SUITE_P(
  TriangulationQueries, OnSpecialSites, testing::ValuesIn(smallWeightedInputs()));

class OnFamilies : public testing::TestWithParam<std::string>
{
};

TEST_P(OnFamilies, AreThoseOfTheDefinitions)
{
  for (const int count : { 3, 7, 30 })
  {
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      SCOPED_TRACE(std::to_string(count) + " sites, seed " + std::to_string(seed));
      expectAnswers(fromWeightedFamily(GetParam(), count, seed).make(), 12, seed);
    }
  }
}

std::vector<std::string> familyNames()
{
  std::vector<std::string> names;
  for (const Family& family : weightedFamilies())
  {
    names.push_back(family.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(TriangulationQueries, OnFamilies, testing::ValuesIn(familyNames()));

TEST(TriangulationQueries, OfNoPoint)
{
  const Cloud sites;
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const TriangulationQueries queries(viewOf(sites), WeightView(), triangulation);
  const Cloud places = { { 0, 0, 0 }, { 1, 2, 0 } };
  EXPECT_EQ(cellsAt(queries, places), (std::vector<std::int64_t>{ -1, -1 }));
  EXPECT_EQ(nearestTo(queries, places), (std::vector<std::int64_t>{ -1, -1 }));
  double values[2] = { 0, 0 };
  queries.interpolateLinear(nullptr, 1, viewOf(places), values);
  EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[1]));
  queries.locate(PointView(), nullptr);
}

/// The same through memory as floats.
Cloud throughFloats(const Cloud& cloud)
{
  const std::vector<float> floats = floatsOf(cloud);
  Cloud result(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    result[i] = { floats[3 * i], floats[3 * i + 1], floats[3 * i + 2] };
  }
  return result;
}

/// The arguments may go, also where they were floats, strides apart; and the queries may be moved.
TEST(TriangulationQueries, KeepNoViewOfTheirArguments)
{
  const Cloud sites = throughFloats(randomSites(50, 0.02, 3));
  Random random(4);
  Cloud places = placesAmong(sites, 10, random);
  const auto isFar = [](const Point& place)
  { return std::fabs(place[0]) > 1e30 || std::fabs(place[1]) > 1e30; };
  places.erase(std::remove_if(places.begin(), places.end(), isFar), places.end());
  places = throughFloats(places);
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const TriangulationQueries expected(viewOf(sites), weightsOf(sites), triangulation);
  const auto make = [&]
  {
    std::vector<float> scalars(7 * sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        scalars[7 * i + 2 * k] = static_cast<float>(sites[i][k]);
      }
    }
    // x and y side by side; the weight elsewhere.
    std::vector<float> pairs(2 * sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      pairs[2 * i] = scalars[7 * i];
      pairs[2 * i + 1] = scalars[7 * i + 2];
    }
    const auto count = static_cast<std::int64_t>(sites.size());
    return TriangulationQueries(PointView(pairs.data(), count, 2),
      WeightView(scalars.data() + 4, count, 7), clone(triangulation));
  };
  TriangulationQueries made = make();
  const TriangulationQueries moved = std::move(made);
  EXPECT_EQ(cellsAt(moved, places), cellsAt(expected, places));
  EXPECT_EQ(nearestTo(moved, places), nearestTo(expected, places));

  std::vector<float> narrow;
  for (const Point& place : places)
  {
    narrow.push_back(static_cast<float>(place[0]));
    narrow.push_back(static_cast<float>(place[1]));
  }
  std::vector<std::int64_t> cells(places.size());
  moved.locate(PointView(narrow.data(), static_cast<std::int64_t>(places.size()), 2), cells.data());
  EXPECT_EQ(cells, cellsAt(expected, places));
}

TEST(TriangulationQueries, ValuesOfSeveralComponents)
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
  std::vector<double> result(3 * places.size());
  queries.interpolateLinear(values.data(), 3, viewOf(places), result.data());
  int inside = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (!std::isnan(result[3 * i]))
    {
      ++inside;
      EXPECT_NEAR(result[3 * i], 1.0, 4e-16);
      EXPECT_NEAR(result[3 * i + 1], places[i][0], 4e-16);
      EXPECT_NEAR(result[3 * i + 2], 3 * places[i][0] - 2 * places[i][1] + 0.5, 4e-15);
    }
  }
  EXPECT_GT(inside, 50);
}

}
}
}
