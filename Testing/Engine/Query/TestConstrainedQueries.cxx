// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Places in constrained triangulations, of which some cells are left out, are those that brute
/// force finds among the cells that are left.
#include "Testing/Engine/Constraints/ConstrainedCases.h"
#include "Testing/Engine/Inputs/InputsConstrained.h"
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// The edges of the triangulation of the first points: they do not cross, and further points make
/// most of them irregular.
std::vector<Segment> edgesOfFirst(const Cloud& sites, std::size_t count)
{
  const Cloud first(sites.begin(), sites.begin() + static_cast<std::ptrdiff_t>(count));
  std::vector<Segment> edges;
  for (const Cell& cell : cellsOf(regularTriangulation(viewOf(first))))
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      edges.push_back({ cell[i], cell[(i + 1) % cell.size()] });
    }
  }
  return edges;
}

/// Three rings of corners, the outermost first, with spokes that all pass the middle on one side:
/// on its way to the middle a visibility walk goes round.
std::vector<Segment> pinwheel(Cloud& sites, int corners)
{
  const double pi = std::acos(-1.0);
  std::vector<Segment> edges;
  for (int ring = 0; ring < 3; ++ring)
  {
    const int outward = 2 - ring;
    for (int i = 0; i < corners; ++i)
    {
      const double angle = 2 * pi * (i + 0.45 * outward) / corners;
      const double radius = std::ldexp(1.0, 3 * outward);
      sites.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0 });
      const std::int64_t id = ring * corners + i;
      const std::int64_t next = ring * corners + (i + 1) % corners;
      edges.push_back({ id, next });
      if (ring > 0)
      {
        edges.push_back({ id, id - corners });
        edges.push_back({ id, next - corners });
      }
    }
  }
  return edges;
}

/// @param keep of so many cells one is left out; 0: none
void expectAnswers(
  const Cloud& sites, const std::vector<Segment>& edges, int places, int keep, std::uint64_t seed)
{
  Random random(seed);
  const Cloud asked = placesAmong(sites, places, random);
  std::vector<double> values;
  for (const Point& site : sites)
  {
    values.push_back(2 * site[0] - 3 * site[1]);
  }
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Options options;
    options.facets = facets;
    const ConstrainedTriangulation whole =
      constrainedTriangulation(viewOf(sites), viewOf(edges), options);
    std::vector<std::uint8_t> inside(static_cast<std::size_t>(whole.cellCount()), 1);
    for (std::uint8_t& one : inside)
    {
      one = whole.dimension == 2 && keep > 0 && random.integer(1, keep) == 1 ? 0 : 1;
    }
    std::vector<Cell> cells;
    const std::vector<Cell> all = cellsOf(whole);
    for (std::size_t c = 0; c < all.size(); ++c)
    {
      if (inside[c])
      {
        cells.push_back(all[c]);
      }
    }
    const TriangulationQueries queries(viewOf(sites), whole, keep ? inside.data() : nullptr);
    std::vector<std::int64_t> found(asked.size(), -2);
    std::vector<double> linear(asked.size());
    queries.locate(viewOf(asked), found.data());
    queries.interpolateLinear(values.data(), 1, viewOf(asked), linear.data());
    for (std::size_t i = 0; i < asked.size(); ++i)
    {
      const std::int64_t cell = cellByForce(sites, cells, whole.dimension, asked[i]);
      ASSERT_EQ(found[i], cell) << placeText(asked[i]);
      ASSERT_EQ(std::isnan(linear[i]), cell < 0) << placeText(asked[i]);
      if (cell >= 0)
      {
        const double exact = 2 * asked[i][0] - 3 * asked[i][1];
        ASSERT_NEAR(linear[i], exact, 1e-11) << placeText(asked[i]);
      }
    }
  }
}

TEST(ConstrainedQueries, AreThoseOfBruteForce)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Cloud sites = randomSites(60, 0, seed);
    const std::vector<Segment> edges = edgesOfFirst(sites, 6 + seed % 7);
    for (const int keep : { 0, 2, 5 })
    {
      expectAnswers(sites, edges, 12, keep, seed);
    }
  }
}

/// Ways that run along edges and through sites.
TEST(ConstrainedQueries, OnAGrid)
{
  Cloud sites = squareGrid(7);
  Random random(3);
  for (int round = 0; round < 5; ++round)
  {
    std::vector<Segment> edges;
    for (std::int64_t row = 0; row < 6; ++row)
    {
      edges.push_back({ 7 * row + random.integer(0, 1), 7 * (row + 1) + random.integer(3, 6) });
    }
    for (const int keep : { 0, 2, 4 })
    {
      expectAnswers(sites, edges, 15, keep, 30 + static_cast<std::uint64_t>(round));
    }
  }
}

TEST(ConstrainedQueries, WhereAVisibilityWalkGoesRound)
{
  for (const int corners : { 5, 6, 8, 12 })
  {
    SCOPED_TRACE(corners);
    Cloud sites;
    const std::vector<Segment> edges = pinwheel(sites, corners);
    for (const int keep : { 0, 3 })
    {
      expectAnswers(sites, edges, 30, keep, 40);
    }
  }
}

TEST(ConstrainedQueries, OnAMap)
{
  Random random(5);
  const ConstrainedInput map = coast(120, random);
  const ConstraintView view(
    map.segments.front().data(), static_cast<std::int64_t>(map.segments.size()), map.sides);
  const ConstrainedTriangulation whole = constrainedTriangulation(viewOf(map.cloud), view);
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(whole.cellCount()));
  cellsInside(whole, inside.data());
  const TriangulationQueries queries(viewOf(map.cloud), whole, inside.data());
  const Cloud asked = placesAmong(map.cloud, 20, random);
  std::vector<std::int64_t> found(asked.size());
  queries.locate(viewOf(asked), found.data());
  std::vector<Cell> cells;
  const std::vector<Cell> all = cellsOf(whole);
  for (std::size_t c = 0; c < all.size(); ++c)
  {
    if (inside[c])
    {
      cells.push_back(all[c]);
    }
  }
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    ASSERT_EQ(found[i], cellByForce(map.cloud, cells, 2, asked[i])) << placeText(asked[i]);
  }
}

TEST(ConstrainedQueries, OfLess)
{
  for (const Cloud& sites :
    { Cloud(), Cloud{ { 1, 2, 0 } }, Cloud{ { 0, 0, 0 }, { 1, 1, 0 }, { 3, 3, 0 } } })
  {
    std::vector<Segment> edges;
    if (sites.size() > 1)
    {
      edges.push_back({ 0, 2 });
    }
    const ConstrainedTriangulation whole = constrainedTriangulation(viewOf(sites), viewOf(edges));
    const std::vector<std::uint8_t> inside(static_cast<std::size_t>(whole.cellCount()), 1);
    const TriangulationQueries queries(viewOf(sites), whole, inside.data());
    const Cloud places = { { 2, 2, 0 }, { 1, 2, 0 }, { 5, 5, 0 } };
    std::vector<std::int64_t> found(places.size());
    queries.locate(viewOf(places), found.data());
    const std::vector<std::int64_t> expected = { sites.size() == 3 ? 1 : -1,
      sites.size() == 1 ? 0 : -1, -1 };
    EXPECT_EQ(found, expected);
  }
}

TEST(ConstrainedQueries, Errors)
{
  const Cloud sites = randomSites(40, 0, 6);
  const std::vector<Segment> edges = edgesOfFirst(sites, 6);
  ConstrainedTriangulation whole = constrainedTriangulation(viewOf(sites), viewOf(edges));
  {
    const TriangulationQueries queries(viewOf(sites), whole);
    std::vector<std::int64_t> ids(sites.size());
    std::vector<double> values(sites.size());
    expectError([&] { queries.nearest(viewOf(sites), ids.data()); }, ErrorCode::BadArgument);
    expectError([&] { queries.interpolateNatural(values.data(), 1, viewOf(sites), values.data()); },
      ErrorCode::BadArgument);
  }
  // Edges that are not regular, and not fixed any more.
  whole.fixedEdges.truncate(0);
  expectError([&] { TriangulationQueries(viewOf(sites), whole); }, ErrorCode::BadArgument);
}

}
}
}
