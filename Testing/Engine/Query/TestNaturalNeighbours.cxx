// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Natural neighbour coordinates are shares that reproduce linear functions, at every range; they
/// are the areas that power diagrams with and without the query differ by; and they are continuous.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/Measures.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// The share of each site at each place: row by row.
class Coordinates
{
public:
  Coordinates(const Cloud& sites, FacetMode facets)
    : count(sites.size())
    , triangulation(triangulationOf(sites, facets))
    , queries(viewOf(sites), weightsOf(sites), this->triangulation)
  {
    this->unit.assign(this->count * this->count, 0.0);
    for (std::size_t i = 0; i < this->count; ++i)
    {
      this->unit[i * this->count + i] = 1.0;
    }
  }

  std::vector<double> at(const Point& place, Interpolation method = Interpolation::Natural) const
  {
    const Cloud one = { place };
    std::vector<double> shares(this->count);
    const auto components = static_cast<std::int64_t>(this->count);
    if (method == Interpolation::Laplace)
    {
      this->queries.interpolateLaplace(this->unit.data(), components, viewOf(one), shares.data());
    }
    else
    {
      this->queries.interpolateNatural(this->unit.data(), components, viewOf(one), shares.data());
    }
    return shares;
  }

  const std::size_t count;
  const Triangulation triangulation;
  const TriangulationQueries queries;

private:
  std::vector<double> unit;
};

/// Positive, of sum 1, and with the place for their mean: to what is mostly so of shares that are
/// taken in double, but for shares that are too small to be doubles.
void expectShares(const Cloud& sites, const Point& place, const std::vector<double>& shares)
{
  Rational sum = 0;
  Rational mean[2] = { 0, 0 };
  double most[2] = { 0, 0 };
  double widest = 0;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    ASSERT_GE(shares[i], 0.0) << placeText(place);
    sum += shares[i];
    for (std::size_t k = 0; k < 2; ++k)
    {
      mean[k] += Rational(shares[i]) * sites[i][k];
      widest = std::max(widest, std::fabs(sites[i][k]));
      most[k] = shares[i] > 0 ? std::max(most[k], std::fabs(sites[i][k])) : most[k];
    }
  }
  ASSERT_LE(abs(Rational(sum - 1)), 1e-15 * 3) << placeText(place);
  for (std::size_t k = 0; k < 2; ++k)
  {
    const Rational lost =
      Rational(0x1p-1074) * (Rational(widest) * static_cast<int>(sites.size()) + 1);
    ASSERT_LE(abs(Rational(mean[k] - place[k])), Rational(Rational(most[k]) * 1e-13 + lost))
      << placeText(place);
  }
}

class NaturalNeighbours : public testing::TestWithParam<Rung>
{
};

TEST_P(NaturalNeighbours, AreSharesWithThePlaceForTheirMean)
{
  for (const Input& input : this->GetParam().inputs)
  {
    const Cloud sites = input.make();
    Random random(1 + input.seed);
    const Cloud places = placesAmong(sites, sites.size() > 100 ? 2 : 6, random);
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      SCOPED_TRACE(std::to_string(sites.size()) + " sites, seed " + std::to_string(input.seed));
      const Coordinates coordinates(sites, facets);
      std::vector<std::int64_t> cells(places.size());
      coordinates.queries.locate(viewOf(places), cells.data());
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        for (const Interpolation method : { Interpolation::Natural, Interpolation::Laplace })
        {
          const std::vector<double> shares = coordinates.at(places[i], method);
          if (cells[i] < 0)
          {
            ASSERT_TRUE(std::all_of(
              shares.begin(), shares.end(), [](double share) { return std::isnan(share); }));
            continue;
          }
          ASSERT_NO_FATAL_FAILURE(expectShares(sites, places[i], shares));
        }
      }
      for (const std::int64_t id : coordinates.triangulation.pointIds)
      {
        const auto site = static_cast<std::size_t>(id);
        EXPECT_EQ(coordinates.at(sites[site])[site], 1.0);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sites, NaturalNeighbours, testing::ValuesIn(rungs()));

/// By the id of the site; and is the cell of one site within the box?
std::map<std::int64_t, double> areasOf(
  const Cloud& sites, const double* box, std::int64_t site, bool& isWithin)
{
  const PowerDiagram diagram =
    powerDiagram(viewOf(sites), weightsOf(sites), triangulationOf(sites, FacetMode::Polygons), box);
  std::vector<double> areas(diagram.siteIds.size());
  cellMeasures(diagram, areas.data(), nullptr);
  std::map<std::int64_t, double> result;
  for (std::size_t c = 0; c < areas.size(); ++c)
  {
    result[diagram.siteIds[c]] = areas[c];
    for (std::int64_t i = diagram.offsets[c];
         diagram.siteIds[c] == site && i < diagram.offsets[c + 1]; ++i)
    {
      const double* corner =
        diagram.corners.data() + 2 * diagram.connectivity[static_cast<std::size_t>(i)];
      isWithin = isWithin && corner[0] > box[0] && corner[0] < box[1] && corner[1] > box[2] &&
        corner[1] < box[3];
    }
  }
  return result;
}

TEST(NaturalNeighbour, AreWhatPowerDiagramsDifferBy)
{
  const double box[] = { -3, 4, -3, 4 };
  int compared = 0;
  int hiding = 0;
  for (const double weight : { 0.0, 0.01, 0.3 })
  {
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
    {
      Random random(seed);
      const Cloud grid = scaled(squareGrid(5), 0.25, 0.25, 1);
      const Cloud sites =
        seed <= 4 ? withWeights(grid, 0, weight / 5, random) : randomSites(25, weight, seed);
      const Coordinates coordinates(sites, FacetMode::Triangles);
      std::vector<double> weights;
      for (const Point& site : sites)
      {
        weights.push_back(site[2]);
      }
      bool ignored = true;
      const std::map<std::int64_t, double> before = areasOf(sites, box, -1, ignored);
      for (const Point& place : placesAmong(sites, 3, random))
      {
        Cloud one = { place };
        double ofPlace = 0;
        coordinates.queries.interpolateLinear(weights.data(), 1, viewOf(one), &ofPlace);
        const std::vector<double> shares = coordinates.at(place);
        const auto id = static_cast<std::int64_t>(sites.size());
        Cloud with = sites;
        with.push_back({ place[0], place[1], ofPlace });
        if (std::isnan(ofPlace))
        {
          continue;
        }
        bool isWithin = true;
        std::map<std::int64_t, double> after = areasOf(with, box, id, isWithin);
        if (!isWithin || after.count(id) == 0)
        {
          continue; // at the border, or at a site
        }
        const double whole = after[id];
        for (const auto& cell : before)
        {
          const double share = (cell.second - after[cell.first]) / whole;
          EXPECT_NEAR(shares[static_cast<std::size_t>(cell.first)], share, 1e-13 / whole)
            << placeText(place);
          hiding += after[cell.first] == 0 ? 1 : 0;
        }
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 300);
  EXPECT_GT(hiding, 5);
}

/// Laplace's shares, by the centers of the triangles around the place once it is a site.
std::map<std::int64_t, double> laplaceShares(const Cloud& sites, const Point& place)
{
  Cloud with = sites;
  with.push_back(place);
  const auto id = static_cast<std::int64_t>(sites.size());
  std::map<std::int64_t, std::vector<Point>> centers; // by neighbour
  for (const Cell& cell : cellsOf(triangulationOf(with, FacetMode::Triangles)))
  {
    if (std::find(cell.begin(), cell.end(), id) == cell.end())
    {
      continue;
    }
    const Point& a = with[static_cast<std::size_t>(cell[0])];
    double u[2][2], height[2];
    for (std::size_t k = 0; k < 2; ++k)
    {
      const Point& b = with[static_cast<std::size_t>(cell[k + 1])];
      u[k][0] = b[0] - a[0];
      u[k][1] = b[1] - a[1];
      height[k] = (u[k][0] * u[k][0] + u[k][1] * u[k][1] + a[2] - b[2]) / 2;
    }
    const double det = u[0][0] * u[1][1] - u[0][1] * u[1][0];
    const Point center = { (height[0] * u[1][1] - height[1] * u[0][1]) / det,
      (height[1] * u[0][0] - height[0] * u[1][0]) / det, 0 };
    for (const std::int64_t corner : cell)
    {
      centers[corner].push_back({ a[0] + center[0], a[1] + center[1], 0 });
    }
  }
  centers.erase(id);
  std::map<std::int64_t, double> shares;
  double all = 0;
  for (const auto& [neighbour, two] : centers)
  {
    if (two.size() != 2)
    {
      return {}; // the place is on the border
    }
    const Point& site = sites[static_cast<std::size_t>(neighbour)];
    shares[neighbour] = std::hypot(two[0][0] - two[1][0], two[0][1] - two[1][1]) /
      std::hypot(site[0] - place[0], site[1] - place[1]);
    all += shares[neighbour];
  }
  for (auto& share : shares)
  {
    share.second /= all;
  }
  return shares;
}

TEST(NaturalNeighbour, LaplacesAreSidesOverDistances)
{
  int compared = 0;
  for (const double weight : { 0.0, 0.01 })
  {
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
    {
      const Cloud sites = randomSites(40, weight, seed);
      const Coordinates coordinates(sites, FacetMode::Triangles);
      std::vector<double> weights;
      for (const Point& site : sites)
      {
        weights.push_back(site[2]);
      }
      Random random(seed);
      for (int i = 0; i < 30; ++i)
      {
        Point place = { random.uniform(), random.uniform(), 0 };
        const std::vector<double> shares = coordinates.at(place, Interpolation::Laplace);
        const Cloud one = { place };
        coordinates.queries.interpolateLinear(weights.data(), 1, viewOf(one), &place[2]);
        const std::map<std::int64_t, double> wanted =
          std::isnan(place[2]) ? std::map<std::int64_t, double>() : laplaceShares(sites, place);
        for (const auto& share : wanted)
        {
          EXPECT_NEAR(shares[static_cast<std::size_t>(share.first)], share.second, 1e-6)
            << placeText(place);
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 1500);
}

TEST(NaturalNeighbour, SharesAreThoseOfTheValues)
{
  Random random(21);
  for (const double weight : { 0.0, 0.02 })
  {
    const Cloud sites = randomSites(60, weight, 4);
    const Coordinates coordinates(sites, FacetMode::Triangles);
    Cloud places = placesAmong(sites, 5, random);
    places.push_back({ 100, 100, 0 });
    for (const Interpolation method : { Interpolation::Natural, Interpolation::Laplace })
    {
      Options options;
      const SiteShares found = coordinates.queries.shares(method, viewOf(places), options);
      ASSERT_EQ(found.offsets.size(), places.size() + 1);
      ASSERT_EQ(found.ids.size(), static_cast<std::size_t>(found.offsets[places.size()]));
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        std::vector<double> wanted = coordinates.at(places[i], method);
        std::int64_t last = -1;
        for (std::int64_t k = found.offsets[i]; k < found.offsets[i + 1]; ++k)
        {
          const std::int64_t id = found.ids[static_cast<std::size_t>(k)];
          ASSERT_LT(std::exchange(last, id), id);
          ASSERT_EQ(
            wanted[static_cast<std::size_t>(id)], found.shares[static_cast<std::size_t>(k)]);
          wanted[static_cast<std::size_t>(id)] = 0;
        }
        // The others have none; outside there are no neighbours.
        for (const double other : wanted)
        {
          ASSERT_TRUE(other == 0 || (std::isnan(other) && last < 0));
        }
      }
    }
    expectError([&] { coordinates.queries.shares(Interpolation::CloughTocher, viewOf(places)); },
      ErrorCode::BadArgument);
  }
}

/// On an edge a place is in two triangles, and a step away in one.
TEST(NaturalNeighbour, AreContinuous)
{
  for (const double weight : { 0.0, 0.02 })
  {
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
    {
      const Cloud sites = seed == 1 ? squareGrid(4) : randomSites(20, weight, seed);
      const Coordinates coordinates(sites, FacetMode::Triangles);
      for (const Cell& cell : cellsOf(coordinates.triangulation))
      {
        for (std::size_t e = 0; e < 3; ++e)
        {
          const Point& a = sites[static_cast<std::size_t>(cell[e])];
          const Point& b = sites[static_cast<std::size_t>(cell[(e + 1) % 3])];
          for (const double t : { 0.25, 0.5 })
          {
            const Interpolation method =
              t == 0.25 ? Interpolation::Natural : Interpolation::Laplace;
            const std::vector<double> here =
              coordinates.at({ a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0 }, method);
            for (const double step : { 1e-9, -1e-9 })
            {
              const std::vector<double> beside =
                coordinates.at({ a[0] + t * (b[0] - a[0]) - step * (b[1] - a[1]),
                                 a[1] + t * (b[1] - a[1]) + step * (b[0] - a[0]), 0 },
                  method);
              for (std::size_t i = 0; i < sites.size(); ++i)
              {
                // Beyond the border there is nothing.
                EXPECT_TRUE(std::isnan(here[i]) || std::isnan(beside[i]) ||
                  std::fabs(here[i] - beside[i]) < 1e-5)
                  << beside[i] - here[i];
              }
            }
          }
        }
      }
    }
  }
}

/// Shares sum to one but for rounding: values stay within those that are blended all the same.
TEST(NaturalNeighbour, StaysWithinTheValues)
{
  Random random(5);
  for (const double weight : { 0.0, 0.01 })
  {
    const Cloud sites = randomSites(100, weight, 8);
    const TriangulationQueries queries(
      viewOf(sites), weightsOf(sites), triangulationOf(sites, FacetMode::Triangles));
    const Cloud places = placesAmong(sites, 100, random);
    for (const double value :
      { std::numeric_limits<double>::max(), -1.7e308, 0.1, 1.0 / 3, 5e-324 })
    {
      const std::vector<double> values(sites.size(), value);
      for (const bool isNatural : { false, true })
      {
        std::vector<double> found(places.size());
        isNatural ? queries.interpolateNatural(values.data(), 1, viewOf(places), found.data())
                  : queries.interpolateLinear(values.data(), 1, viewOf(places), found.data());
        for (const double x : found)
        {
          EXPECT_TRUE(x == value || std::isnan(x)) << x;
        }
      }
    }
  }
}

/// In every arithmetic: scaled, and in integers of any size.
TEST(NaturalNeighbour, AreTheSameAtEveryScale)
{
  for (const double weight : { 0.0, 0.01 })
  {
    Cloud sites = randomSites(24, weight, 21);
    sites[0] = { 0, 0, 0 };
    const Coordinates coordinates(sites, FacetMode::Triangles);
    Cloud beside = sites;
    beside[0][0] = 1e-200; // takes a range that no expansions carry
    const Coordinates wide(beside, FacetMode::Triangles);
    Random random(22);
    int shared = 0;
    for (int i = 0; i < 20; ++i)
    {
      const Point place = { random.uniform(0.2, 0.8), random.uniform(0.2, 0.8), 0 };
      const std::vector<double> expected = coordinates.at(place);
      if (std::isnan(expected[0]))
      {
        continue; // outside
      }
      shared += static_cast<int>(
        std::count_if(expected.begin(), expected.end(), [](double share) { return share > 0; }));
      const auto expectSame = [&](const std::vector<double>& found)
      {
        for (std::size_t k = 0; k < sites.size(); ++k)
        {
          EXPECT_NEAR(found[k], expected[k], 1e-14);
        }
      };
      expectSame(wide.at(place));
      for (const double factor : { 0x1p-300, 0x1p-60, 0x1p100, 0x1p400 })
      {
        expectSame(Coordinates(magnified(sites, factor), FacetMode::Triangles)
                     .at({ place[0] * factor, place[1] * factor, 0 }));
      }
    }
    EXPECT_GT(shared, 15 * 4);
  }
}

/// At the circle of a triangle's corners, off it by about so much of its radius.
Point nearCircle(const Cloud& sites, const Cell& cell, double off, Random& random)
{
  const Point& a = sites[static_cast<std::size_t>(cell[0])];
  const Point& b = sites[static_cast<std::size_t>(cell[1])];
  const Point& c = sites[static_cast<std::size_t>(cell[2])];
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - a[0], vy = c[1] - a[1];
  const double u = ux * ux + uy * uy, v = vx * vx + vy * vy, twice = 2 * (ux * vy - uy * vx);
  const double x = (vy * u - uy * v) / twice, y = (ux * v - vx * u) / twice;
  const double part = (1 + off * random.uniform(-1, 1)) * std::hypot(x, y);
  const double angle = random.uniform(0, 6.28);
  return { a[0] + x + part * std::cos(angle), a[1] + y + part * std::sin(angle), 0 };
}

/// Doubles take part where they are right enough alone: sites nearly on lines and on circles, and
/// places nearly on the circles of triangles. Sites as small as 2^-300 have longer numbers.
TEST(NaturalNeighbour, AreRightTo30Bits)
{
  int compared = 0;
  for (const double jitter : { 1.0, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15 })
  {
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
    {
      Random random(seed);
      Cloud sites = squareGrid(4);
      for (Point& site : sites)
      {
        site[0] += jitter * random.uniform();
        site[1] += jitter * random.uniform();
        site[2] = seed % 2 == 0 ? 1e-2 * jitter * random.uniform() : 0.0;
      }
      sites[0][0] = 0;
      Cloud beside = magnified(sites, 0x1p-300);
      beside[0][0] = 0x1p-960; // so that sites are not scaled back
      const Coordinates coordinates(sites, FacetMode::Triangles);
      const Coordinates longer(beside, FacetMode::Triangles);
      const std::vector<Cell> cells = cellsOf(coordinates.triangulation);
      const int last = static_cast<int>(cells.size()) - 1;
      for (int i = 0; i < 20; ++i)
      {
        const Cell& cell = cells[static_cast<std::size_t>(random.integer(0, last))];
        const Point place =
          nearCircle(sites, cell, std::ldexp(1.0, -random.integer(0, 45)), random);
        const std::vector<double> found = coordinates.at(place);
        const std::vector<double> expected =
          longer.at({ place[0] * 0x1p-300, place[1] * 0x1p-300, 0 });
        for (std::size_t k = 0; k < sites.size() && !std::isnan(expected[k]); ++k)
        {
          EXPECT_LE(std::fabs(found[k] - expected[k]), 0x1p-30 * expected[k])
            << "jitter " << jitter << ", seed " << seed << ", " << placeText(place);
          compared += expected[k] > 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(compared, 2000);
}

/// In one triangle the shares are those of the corners, however thin it is.
TEST(NaturalNeighbour, InThinTriangles)
{
  for (const double height : { 1e-30, 1e-44, 1e-50, 1e-52, 1e-100, 1e-300, 5e-324 })
  {
    for (const double length : { 0.55, 1e-200, 1e200, 1.5e308 })
    {
      const Cloud sites = { { length, length, 0 }, { 0, height, 0 }, { 0, -height, 0 } };
      const Coordinates coordinates(sites, FacetMode::Triangles);
      for (const Point& place : { Point{ length / 2, length / 2, 0 },
             Point{ length / 4, length / 4, 0 }, Point{ 0, 0, 0 } })
      {
        const Rational ofFirst = Rational(place[0]) / Rational(length);
        const std::vector<double> shares = coordinates.at(place);
        EXPECT_LE(abs(Rational(Rational(shares[0]) - ofFirst)), Rational(ofFirst * 1e-15))
          << height << ", " << length << ": " << shares[0];
        EXPECT_NEAR(shares[1], (1 - ofFirst.get_d()) / 2, 1e-15) << height << ", " << length;
        EXPECT_NEAR(shares[2], (1 - ofFirst.get_d()) / 2, 1e-15) << height << ", " << length;
      }
    }
  }
}

/// The shares of thin fans, from rationals: Sibson's areas by clipping no diagram, but by the
/// linear functions that they reproduce.
TEST(NaturalNeighbour, AtAHubOfManyNeighbours)
{
  constexpr int Count = 3000;
  Cloud sites = { { 0, 0, 0 } };
  for (int i = 0; i < Count; ++i)
  {
    const double t = 2.0 * i / Count - 1; // the rational circle, of both halves
    const double s = std::fabs(t) < 0.5 ? 2 * t : 2 * (std::fabs(t) - 1) * (t < 0 ? -1 : 1);
    const double side = std::fabs(t) < 0.5 ? 1 : -1;
    sites.push_back({ side * (1 - s * s) / (1 + s * s), 2 * s / (1 + s * s), 0 });
  }
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const TriangulationQueries queries(viewOf(sites), weightsOf(sites), triangulation);
  std::vector<double> values;
  for (const Point& site : sites)
  {
    values.push_back(site[0]);
    values.push_back(1.0);
  }
  for (const Point& place : { Point{ 1e-5, 2e-6, 0 }, Point{ -1e-9, 1e-7, 0 } })
  {
    const Cloud one = { place };
    double found[2];
    queries.interpolateNatural(values.data(), 2, viewOf(one), found);
    EXPECT_NEAR(found[0], place[0], 1e-15);
    EXPECT_EQ(found[1], 1.0);
  }
}

/// Between the ends of a border's edge, these alone have a share.
TEST(NaturalNeighbour, AreLinearAlongTheBorder)
{
  const Cloud sites = squareGrid(4);
  const Coordinates coordinates(sites, FacetMode::Polygons);
  const std::vector<double> shares = coordinates.at({ 1.25, 0, 0 });
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const bool first = sites[i][0] == 1 && sites[i][1] == 0;
    const bool second = sites[i][0] == 2 && sites[i][1] == 0;
    EXPECT_EQ(shares[i], first ? 0.75 : (second ? 0.25 : 0.0));
  }
  // In the middle of a square by symmetry.
  const std::vector<double> middle = coordinates.at({ 1.5, 1.5, 0 });
  EXPECT_EQ(std::count(middle.begin(), middle.end(), 0.25), 4);
}

}
}
}
