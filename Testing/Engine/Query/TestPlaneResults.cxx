// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Answers about positions in a triangulation, and about its cells, are those of the definitions:
/// on every kind of sites, in triangles and in polygons, with constraints and without, and with
/// cells left out.
#include "Testing/Engine/Constraints/ConstrainedCases.h"
#include "Testing/Engine/Inputs/InputsConstrained.h"
#include "Testing/Engine/Query/HullReference.h"
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/Measures.h>
#include <flipflop/Neighbors.h>
#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<double> randomValues(const Cloud& sites, std::uint64_t seed)
{
  Random random(seed);
  std::vector<double> values(sites.size());
  std::generate(values.begin(), values.end(), [&] { return random.uniform(-1, 1); });
  return values;
}

/// The cell of each place, and the linear value there.
void expectLocated(const TriangulationQueries& queries, const Cloud& sites,
  const std::vector<Cell>& cells, int dimension, const Cloud& places,
  const std::vector<double>& values)
{
  std::vector<std::int64_t> found(places.size(), -2);
  std::vector<double> linear(places.size());
  queries.locate(viewOf(places), found.data());
  queries.interpolateLinear(values.data(), 1, viewOf(places), linear.data());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const std::int64_t cell = cellByForce(sites, cells, dimension, places[i]);
    ASSERT_EQ(found[i], cell) << placeText(places[i]);
    ASSERT_EQ(std::isnan(linear[i]), cell < 0) << placeText(places[i]);
    if (cell >= 0)
    {
      const Rational exact =
        linearByForce(sites, cells[static_cast<std::size_t>(cell)], dimension, values, places[i]);
      ASSERT_NEAR(linear[i], exact.get_d(), 4e-16) << placeText(places[i]);
    }
  }
}

CellComplex cellsThatRemain(const CellComplex& whole, const std::vector<std::uint8_t>& inside)
{
  CellComplex rest;
  copyCells(whole, rest);
  keepCells(rest, inside.data());
  return rest;
}

/// Values by all methods, shares and nearest sites: where a cell holds the place, those of the
/// whole triangulation bit for bit, outside none.
void expectThoseOfTheWhole(const TriangulationQueries& some, const TriangulationQueries& whole,
  const Cloud& places, const std::vector<double>& values)
{
  const PointView at = viewOf(places);
  std::vector<std::int64_t> cells(places.size()), ids(places.size()), wholeIds(places.size());
  some.locate(at, cells.data());
  some.nearest(at, ids.data());
  whole.nearest(at, wholeIds.data());
  EXPECT_EQ(ids, wholeIds);
  std::vector<double> found(places.size()), wanted(places.size());
  for (const auto interpolate :
    { &TriangulationQueries::interpolateLinear, &TriangulationQueries::interpolateNatural,
      &TriangulationQueries::interpolateLaplace, &TriangulationQueries::interpolateCloughTocher })
  {
    (some.*interpolate)(values.data(), 1, at, found.data(), Options());
    (whole.*interpolate)(values.data(), 1, at, wanted.data(), Options());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      ASSERT_TRUE(cells[i] < 0 ? std::isnan(found[i]) : found[i] == wanted[i])
        << placeText(places[i]);
    }
  }
  for (const Interpolation method :
    { Interpolation::Linear, Interpolation::Natural, Interpolation::Laplace })
  {
    const SiteShares few = some.shares(method, at);
    const SiteShares all = whole.shares(method, at);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const std::int64_t from = few.offsets[i], to = few.offsets[i + 1];
      const std::int64_t count = cells[i] < 0 ? 0 : all.offsets[i + 1] - all.offsets[i];
      ASSERT_EQ(to - from, count) << placeText(places[i]);
      ASSERT_TRUE(
        std::equal(few.ids.begin() + from, few.ids.begin() + to, all.ids.begin() + all.offsets[i]));
      ASSERT_TRUE(std::equal(
        few.shares.begin() + from, few.shares.begin() + to, all.shares.begin() + all.offsets[i]));
    }
  }
}

/// Limits at which something happens: edges' lengths, rounded, and their neighbours.
std::vector<double> limitsAmong(const Cloud& sites, const std::vector<Cell>& cells)
{
  std::vector<double> limits = { 0, std::numeric_limits<double>::denorm_min(), 1e-200, 1, 1e200,
    std::numeric_limits<double>::max() };
  const std::size_t step = std::max<std::size_t>(1, cells.size() / 20);
  for (std::size_t c = 0; c < cells.size(); c += step)
  {
    const Point& a = sites[static_cast<std::size_t>(cells[c].front())];
    const Point& b = sites[static_cast<std::size_t>(cells[c].back())];
    const double length = std::hypot(a[0] - b[0], a[1] - b[1]);
    if (std::isfinite(std::nextafter(length, infinite)))
    {
      limits.insert(
        limits.end(), { std::nextafter(length, 0), length, std::nextafter(length, infinite) });
    }
  }
  return limits;
}

class PlaneResults : public testing::TestWithParam<Rung>
{
protected:
  /// expect (sites, triangulation, its cells, seed)
  template <class Expect>
  void onEach(const Expect& expect) const
  {
    for (const Input& input : this->GetParam().inputs)
    {
      const Cloud sites = input.make();
      for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
      {
        SCOPED_TRACE(std::to_string(sites.size()) + " sites, seed " + std::to_string(input.seed) +
          (facets == FacetMode::Polygons ? ", polygons" : ", triangles"));
        const Triangulation triangulation = triangulationOf(sites, facets);
        expect(sites, triangulation, cellsOf(triangulation), 1 + input.seed);
      }
    }
  }
};

TEST_P(PlaneResults, CellsSitesAndLinearValues)
{
  this->onEach(
    [](const Cloud& sites, const Triangulation& triangulation, const std::vector<Cell>& cells,
      std::uint64_t seed)
    {
      Random random(seed);
      const Cloud places = placesAmong(sites, sites.size() > 100 ? 10 : 15, random);
      const std::vector<double> values = randomValues(sites, seed);
      const TriangulationQueries queries(viewOf(sites), weightsOf(sites), triangulation);
      expectLocated(queries, sites, cells, triangulation.dimension, places, values);
      std::vector<std::int64_t> nearest(places.size(), -2);
      queries.nearest(viewOf(places), nearest.data());
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        ASSERT_EQ(nearest[i], nearestByForce(sites, triangulation.pointIds, places[i]))
          << placeText(places[i]);
      }
      // At a site its own value.
      for (const std::int64_t id : triangulation.pointIds)
      {
        double value = 0;
        queries.interpolateLinear(
          values.data(), 1, viewOf({ sites[static_cast<std::size_t>(id)] }), &value);
        EXPECT_EQ(value, values[static_cast<std::size_t>(id)]);
      }
    });
}

TEST_P(PlaneResults, OfSomeCellsAreThoseOfTheCellsThatRemain)
{
  this->onEach(
    [](const Cloud& sites, const Triangulation& triangulation, const std::vector<Cell>&,
      std::uint64_t seed)
    {
      Random random(seed);
      const std::vector<std::uint8_t> inside =
        someOf(triangulation.cellCount(), random.integer(1, 5), random);
      const Cloud places = placesAmong(sites, sites.size() > 100 ? 4 : 8, random);
      const std::vector<double> values = randomValues(sites, seed);
      const TriangulationQueries queries(
        viewOf(sites), weightsOf(sites), triangulation, inside.data());
      expectLocated(queries, sites, cellsOf(cellsThatRemain(triangulation, inside)),
        triangulation.dimension, places, values);
      expectThoseOfTheWhole(queries,
        TriangulationQueries(viewOf(sites), weightsOf(sites), triangulation), places, values);
    });
}

TEST_P(PlaneResults, LinearValuesAreThoseOfTrianglesBitForBit)
{
  for (const Input& input : this->GetParam().inputs)
  {
    const Cloud sites = input.make();
    Random random(input.seed);
    const Cloud places = placesAmong(sites, 10, random);
    const std::vector<double> values = randomValues(sites, input.seed);
    std::vector<double> found[2];
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      std::vector<double>& linear = found[facets == FacetMode::Polygons];
      linear.resize(places.size());
      const Triangulation triangulation = triangulationOf(sites, facets);
      TriangulationQueries(viewOf(sites), weightsOf(sites), triangulation)
        .interpolateLinear(values.data(), 1, viewOf(places), linear.data());
    }
    EXPECT_TRUE(std::equal(found[0].begin(), found[0].end(), found[1].begin(),
      [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
  }
}

TEST_P(PlaneResults, CellsWithinEdgeLengths)
{
  this->onEach(
    [](const Cloud& sites, const Triangulation& triangulation, const std::vector<Cell>& cells,
      std::uint64_t)
    {
      std::vector<std::uint8_t> within(cells.size(), 7);
      const auto count = [&](double limit)
      { return cellsWithinEdgeLength(viewOf(sites), triangulation, limit, within.data()); };
      for (const double limit : limitsAmong(sites, cells))
      {
        const std::int64_t found = count(limit);
        ASSERT_EQ(within, withinByForce(sites, cells, limit)) << limit;
        EXPECT_EQ(found, std::count(within.begin(), within.end(), 1));
      }
      EXPECT_EQ(count(infinite), triangulation.cellCount());
    });
}

TEST_P(PlaneResults, MeasuresBordersAndNeighbors)
{
  this->onEach(
    [](const Cloud& sites, const Triangulation& triangulation, const std::vector<Cell>& cells,
      std::uint64_t)
    {
      std::vector<double> areas(cells.size(), -1);
      std::vector<double> centroids(2 * cells.size(), -1);
      cellMeasures(viewOf(sites), triangulation, areas.data(), centroids.data());
      for (std::size_t c = 0; c < cells.size(); ++c)
      {
        std::vector<Point> corners;
        for (const std::int64_t id : cells[c])
        {
          corners.push_back(sites[static_cast<std::size_t>(id)]);
        }
        EXPECT_EQ(measuresFault(corners, areas[c], &centroids[2 * c]), "") << c;
      }
      EXPECT_EQ(ringsFault(cellBoundary(triangulation), triangulation), "");
      const Buffer<std::int64_t> neighbors = cellNeighbors(triangulation);
      EXPECT_EQ(std::vector<std::int64_t>(neighbors.begin(), neighbors.end()),
        neighborsByMap(triangulation));
    });
}

INSTANTIATE_TEST_SUITE_P(Sites, PlaneResults, testing::ValuesIn(rungs()));

// ---- With constraints, and cells left out ------------------------------------------------------

/// The edges of the triangulation of the first points: they do not cross, and further points make
/// most of them irregular.
ConstrainedInput edgesOfFirst(const Cloud& sites, std::size_t count)
{
  ConstrainedInput input = { sites, {}, 0 };
  const Cloud first(sites.begin(), sites.begin() + static_cast<std::ptrdiff_t>(count));
  for (const Cell& cell : cellsOf(regularTriangulation(viewOf(first))))
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      input.segments.push_back({ cell[i], cell[(i + 1) % cell.size()] });
    }
  }
  return input;
}

/// Three rings of corners, the outermost first, with spokes that all pass the middle on one side:
/// on its way to the middle a visibility walk goes round.
ConstrainedInput pinwheel(int corners)
{
  ConstrainedInput input;
  for (int ring = 0; ring < 3; ++ring)
  {
    const int outward = 2 - ring;
    for (int i = 0; i < corners; ++i)
    {
      const double angle = 2 * std::acos(-1.0) * (i + 0.45 * outward) / corners;
      const double radius = std::ldexp(1.0, 3 * outward);
      input.cloud.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0 });
      const std::int64_t id = ring * corners + i;
      const std::int64_t next = ring * corners + (i + 1) % corners;
      input.segments.push_back({ id, next });
      if (ring > 0)
      {
        input.segments.push_back({ id, id - corners });
        input.segments.push_back({ id, next - corners });
      }
    }
  }
  return input;
}

/// Ways that run along edges and through sites.
ConstrainedInput linesOnAGrid(Random& random)
{
  ConstrainedInput input = { squareGrid(7), {}, 0 };
  for (std::int64_t row = 0; row < 6; ++row)
  {
    input.segments.push_back(
      { 7 * row + random.integer(0, 1), 7 * (row + 1) + random.integer(3, 6) });
  }
  return input;
}

/// @param keep of so many cells one is left out; 0: none; -1: those outside of polygons are
void expectResults(const ConstrainedInput& input, int keep, std::uint64_t seed)
{
  SCOPED_TRACE("seed " + std::to_string(seed) + ", keep " + std::to_string(keep));
  Random random(seed);
  const Cloud places = placesAmong(input.cloud, 15, random);
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Options options;
    options.facets = facets;
    ConstraintView view = viewOf(input.segments);
    view.sides = input.sides;
    const ConstrainedTriangulation whole =
      constrainedTriangulation(viewOf(input.cloud), view, options);
    std::vector<std::uint8_t> inside(static_cast<std::size_t>(whole.cellCount()), 1);
    if (keep < 0)
    {
      cellsInside(whole, inside.data());
    }
    for (std::uint8_t& one : inside)
    {
      one = keep > 0 && random.integer(1, keep) == 1 ? 0 : one;
    }
    const TriangulationQueries queries(viewOf(input.cloud), whole, keep ? inside.data() : nullptr);
    const CellComplex rest = cellsThatRemain(whole, inside);
    expectLocated(queries, input.cloud, cellsOf(rest), whole.dimension, places,
      randomValues(input.cloud, seed));
    EXPECT_EQ(ringsFault(cellBoundary(rest), rest), "");
  }
}

TEST(ConstrainedResults, AreThoseOfTheCellsThatRemain)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    for (const int keep : { 0, 2, 5 })
    {
      expectResults(edgesOfFirst(randomSites(60, 0, seed), 6 + seed % 7), keep, seed);
    }
  }
  Random random(3);
  for (std::uint64_t round = 0; round < 5; ++round)
  {
    const ConstrainedInput lines = linesOnAGrid(random);
    for (const int keep : { 0, 2, 4 })
    {
      expectResults(lines, keep, 30 + round);
    }
  }
  for (const int corners : { 5, 6, 8, 12 })
  {
    expectResults(pinwheel(corners), 0, 40);
    expectResults(pinwheel(corners), 3, 40);
  }
  expectResults(coast(120, random), -1, 50);
}

TEST(ConstrainedResults, OfLowerDimensions)
{
  for (const Cloud& sites :
    { Cloud(), Cloud{ { 1, 2, 0 } }, Cloud{ { 0, 0, 0 }, { 1, 1, 0 }, { 3, 3, 0 } } })
  {
    ConstrainedInput input = { sites, {}, 0 };
    if (sites.size() > 1)
    {
      input.segments.push_back({ 0, 2 });
    }
    const ConstrainedTriangulation whole =
      constrainedTriangulation(viewOf(sites), viewOf(input.segments));
    const Cloud places = { { 2, 2, 0 }, { 1, 2, 0 }, { 5, 5, 0 } };
    std::vector<std::int64_t> found(places.size());
    TriangulationQueries(viewOf(sites), whole).locate(viewOf(places), found.data());
    EXPECT_EQ(found,
      (std::vector<std::int64_t>{ sites.size() == 3 ? 1 : -1, sites.size() == 1 ? 0 : -1, -1 }));
  }
}

TEST(ConstrainedResults, OnlyOfWhatIsRegularButForFixedEdges)
{
  const ConstrainedInput input = edgesOfFirst(randomSites(40, 0, 6), 6);
  const PointView sites = viewOf(input.cloud);
  ConstrainedTriangulation whole = constrainedTriangulation(sites, viewOf(input.segments));
  {
    const TriangulationQueries queries(sites, whole);
    std::vector<std::int64_t> ids(input.cloud.size());
    std::vector<double> values(input.cloud.size());
    expectError([&] { queries.nearest(sites, ids.data()); }, ErrorCode::BadArgument);
    expectError([&] { queries.interpolateNatural(values.data(), 1, sites, values.data()); },
      ErrorCode::BadArgument);
  }
  whole.fixedEdges.truncate(0);
  expectError([&] { TriangulationQueries(sites, whole); }, ErrorCode::BadArgument);
}

}
}
}
