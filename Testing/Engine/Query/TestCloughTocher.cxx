// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The smooth surface through values: it reproduces quadratic functions, has one value and one
/// gradient on each edge, and errs much less on smooth functions than a linear one does.
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

#include <functional>

namespace flipflop
{
namespace test
{

namespace
{

using Function = std::function<double(double, double)>;

std::vector<double> valuesOf(const Cloud& sites, const Function& function)
{
  std::vector<double> values;
  for (const Point& site : sites)
  {
    values.push_back(function(site[0], site[1]));
  }
  return values;
}

TriangulationQueries queriesOf(const Cloud& sites)
{
  return { viewOf(sites), weightsOf(sites), triangulationOf(sites, FacetMode::Triangles) };
}

std::vector<double> smoothAt(
  const TriangulationQueries& queries, const std::vector<double>& values, const Cloud& places)
{
  std::vector<double> found(places.size());
  queries.interpolateCloughTocher(values.data(), 1, viewOf(places), found.data());
  return found;
}

TEST(CloughTocher, ReproducesQuadraticFunctions)
{
  int inside = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    Random random(seed);
    const Cloud sites = seed % 3 == 0 ? scaled(squareGrid(7), 0.125, 0.125, 0)
                                      : randomSites(12 * static_cast<int>(seed), 0, seed);
    const Cloud places = placesAmong(sites, 40, random);
    const TriangulationQueries queries = queriesOf(sites);
    const Function functions[] = { [](double, double) { return 1.0 / 3; },
      [](double x, double y) { return 3 * x - 2 * y + 0.5; },
      [](double x, double y) { return x * x - 3 * x * y + 2 * y * y + x - 1; } };
    for (const Function& function : functions)
    {
      const std::vector<double> values = valuesOf(sites, function);
      const std::vector<double> found = smoothAt(queries, values, places);
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        if (!std::isnan(found[i]))
        {
          ++inside;
          ASSERT_NEAR(found[i], function(places[i][0], places[i][1]), 2e-11)
            << placeText(places[i]) << ", seed " << seed;
        }
      }
      EXPECT_EQ(smoothAt(queries, values, sites), values);
    }
  }
  EXPECT_GT(inside, 5000);
}

/// On both sides of an edge values and slopes are the same, but for the step.
TEST(CloughTocher, HasContinuousGradients)
{
  constexpr double step = 1e-6;
  const Cloud sites = randomSites(30, 0, 7);
  const TriangulationQueries queries = queriesOf(sites);
  Random random(8);
  std::vector<double> values(sites.size());
  std::generate(values.begin(), values.end(), [&] { return random.uniform(-1, 1); });
  int compared = 0;
  for (const Cell& cell : cellsOf(triangulationOf(sites, FacetMode::Triangles)))
  {
    for (std::size_t e = 0; e < 3; ++e)
    {
      const Point& a = sites[static_cast<std::size_t>(cell[e])];
      const Point& b = sites[static_cast<std::size_t>(cell[(e + 1) % 3])];
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      const double across[] = { -(b[1] - a[1]) / length, (b[0] - a[0]) / length };
      for (const double t : { 0.2, 0.5, 0.7 })
      {
        // Differences of the second order from the edge, to each side.
        Cloud places;
        for (const double k : { -2.0, -1.0, 0.0, 1.0, 2.0 })
        {
          places.push_back({ a[0] + t * (b[0] - a[0]) + k * step * length * across[0],
            a[1] + t * (b[1] - a[1]) + k * step * length * across[1], 0 });
        }
        const std::vector<double> f = smoothAt(queries, values, places);
        const double left = -3 * f[2] + 4 * f[3] - f[4];
        const double right = 3 * f[2] - 4 * f[1] + f[0];
        if (std::isfinite(left) && std::isfinite(right))
        {
          ++compared;
          const double size = std::fabs(f[3] - f[1]) + 2 * step;
          EXPECT_NEAR(left / 2, right / 2, 0.02 * size) << t << " of " << toString({ a, b });
        }
      }
    }
  }
  EXPECT_GT(compared, 300);
}

std::vector<double> gradientsAt(
  const TriangulationQueries& queries, const std::vector<double>& values, std::size_t sites)
{
  const std::size_t components = values.size() / sites;
  std::vector<double> found(2 * values.size(), 7.0);
  queries.siteGradients(values.data(), static_cast<std::int64_t>(components), found.data());
  return found;
}

/// They are those of quadratic functions, at any range; hidden points have none.
TEST(CloughTocher, HasTheGradientsAtSites)
{
  const Cloud unit = randomSites(200, 0.002, 3);
  std::vector<double> values;
  for (const Point& site : unit)
  {
    const double x = site[0], y = site[1];
    values.insert(values.end(), { x * x - 3 * x * y + 2 * y * y + x - 1, 3 * x - 2 * y });
  }
  for (const double factor : { 1.0, 0x1p-500, 0x1p500 })
  {
    const Cloud sites = magnified(unit, factor);
    const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
    ASSERT_FALSE(triangulation.hiddenIds.empty());
    const std::vector<double> found = gradientsAt(queriesOf(sites), values, sites.size());
    for (const std::int64_t id : triangulation.pointIds)
    {
      const Point& at = unit[static_cast<std::size_t>(id)];
      const double expected[] = { 2 * at[0] - 3 * at[1] + 1, -3 * at[0] + 4 * at[1], 3, -2 };
      for (std::size_t k = 0; k < 4; ++k)
      {
        ASSERT_NEAR(found[static_cast<std::size_t>(4 * id) + k] * factor, expected[k], 1e-9) << id;
      }
    }
    for (const std::int64_t id : triangulation.hiddenIds)
    {
      EXPECT_EQ(found[static_cast<std::size_t>(4 * id)], 7.0);
    }
  }
}

/// Those of any values are the slopes of the surface, in every direction. Triangles at the border
/// may be so flat that the slopes end within a step.
TEST(CloughTocher, HasTheSlopesOfItsGradientsAtSites)
{
  constexpr double step = 1e-7;
  constexpr std::size_t side = 8;
  Random random(6);
  Cloud sites = squareGrid(side);
  for (Point& site : sites)
  {
    site[0] += random.uniform(0, 0.6);
    site[1] += random.uniform(0, 0.6);
  }
  const TriangulationQueries queries = queriesOf(sites);
  std::vector<double> values(sites.size());
  std::generate(values.begin(), values.end(), [&] { return random.uniform(-1, 1); });
  const std::vector<double> gradients = gradientsAt(queries, values, sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const std::size_t row = i / side, column = i % side;
    if (std::min(row, column) == 0 || std::max(row, column) == side - 1)
    {
      continue;
    }
    for (int k = 0; k < 7; ++k)
    {
      const double x = std::cos(0.9 * k), y = std::sin(0.9 * k);
      const double there =
        smoothAt(queries, values, { { sites[i][0] + step * x, sites[i][1] + step * y, 0 } })[0];
      const double slope = gradients[2 * i] * x + gradients[2 * i + 1] * y;
      EXPECT_NEAR((there - values[i]) / step, slope, 1e-3) << i;
    }
  }
}

TEST(CloughTocher, HasNoGradientsOnALine)
{
  const Cloud line = { { 0, 0, 0 }, { 2, 4, 0 } };
  const TriangulationQueries queries = queriesOf(line);
  for (const double x : gradientsAt(queries, { 3, 5 }, 2))
  {
    EXPECT_TRUE(std::isnan(x));
  }
  double number = 0;
  EXPECT_THROW(queries.siteGradients(nullptr, 1, &number), Error);
  EXPECT_THROW(queries.siteGradients(&number, 0, &number), Error);
  EXPECT_THROW(queries.siteGradients(&number, 1, nullptr), Error);
  TriangulationQueries({}, {}, Triangulation()).siteGradients(nullptr, 1, nullptr);
}

TEST(CloughTocher, ErrsLessOnSmoothFunctions)
{
  const Function terrain = [](double x, double y)
  { return std::sin(6 * x) * std::cos(5 * y) + 0.3 * std::sin(20 * x + 3 * y); };
  const Cloud sites = randomSites(3000, 0, 4);
  const std::vector<double> values = valuesOf(sites, terrain);
  const TriangulationQueries queries = queriesOf(sites);
  Cloud places;
  Random random(5);
  for (int i = 0; i < 5000; ++i)
  {
    places.push_back({ random.uniform(0.03, 0.97), random.uniform(0.03, 0.97), 0 });
  }
  std::vector<double> linear(places.size());
  queries.interpolateLinear(values.data(), 1, viewOf(places), linear.data());
  const std::vector<double> smooth = smoothAt(queries, values, places);
  double ofLinear = 0, ofSmooth = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double exact = terrain(places[i][0], places[i][1]);
    ofLinear += (linear[i] - exact) * (linear[i] - exact);
    ofSmooth += (smooth[i] - exact) * (smooth[i] - exact);
  }
  EXPECT_LT(std::sqrt(ofSmooth), std::sqrt(ofLinear) / 8);
}

/// Few queries have the gradients that many have; images, too, on any number of threads.
TEST(CloughTocher, HasTheSameBitsInEachWay)
{
  const Cloud sites = randomSites(400, 1e-4, 9);
  const TriangulationQueries queries = queriesOf(sites);
  Random random(10);
  std::vector<double> values(2 * sites.size());
  std::generate(values.begin(), values.end(), [&] { return random.uniform(-1, 1); });
  const ImageGrid grid{ { 0, 1 }, { 1.0 / 32, -1.0 / 32 }, { 33, 33 }, { 0, 0 } };
  Cloud places;
  for (int i = 0; i < 33 * 33; ++i)
  {
    places.push_back({ i % 33 / 32.0, 1 - i / 33 / 32.0, 0 });
  }
  std::vector<double> all(2 * places.size());
  queries.interpolateCloughTocher(values.data(), 2, viewOf(places), all.data());
  for (double& x : all)
  {
    x = std::isnan(x) ? -9 : x;
  }
  for (const int threads : { 1, 2, 4 })
  {
    Options options;
    options.threads = threads;
    std::vector<double> image(all.size());
    queries.interpolateImage(
      Interpolation::CloughTocher, values.data(), 2, grid, ImageView(image.data()), -9, options);
    EXPECT_EQ(image, all);
  }
  for (std::size_t i = 0; i < places.size(); i += 50)
  {
    double few[2];
    queries.interpolateCloughTocher(values.data(), 2, viewOf({ places[i] }), few);
    EXPECT_EQ(std::isnan(few[0]) ? -9 : few[0], all[2 * i]);
  }
}

/// Where sites determine no quadratic function; where numbers overflow; and in no plane.
TEST(CloughTocher, OfFewSitesAndOfAnyRange)
{
  const Function plane = [](double x, double y) { return 3 * x - 2 * y; };
  const Cloud triangle = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 4, 0 } };
  const Cloud places = { { 0.5, 1, 0 }, { 1, 2, 0 } };
  EXPECT_NEAR(smoothAt(queriesOf(triangle), valuesOf(triangle, plane), places)[0], -0.5, 1e-14);
  const Cloud line = { { 0, 0, 0 }, { 2, 4, 0 } };
  EXPECT_EQ(smoothAt(queriesOf(line), { 3, 5 }, places)[1], 4.0);
  const std::vector<double> huge = { 1.7e308, -1.7e308, 1.7e308 };
  for (const double factor : { 1.0, 0x1p-1000, 0x1p1000 })
  {
    const Cloud sites = scaled(triangle, factor, factor, 1);
    EXPECT_TRUE(
      std::isfinite(smoothAt(queriesOf(sites), huge, { { 0.5 * factor, 1 * factor, 0 } })[0]));
    EXPECT_NEAR(
      smoothAt(queriesOf(sites), { 0, 6, -8 }, { { 0.5 * factor, factor, 0 } })[0], -0.5, 1e-14);
  }
}

}
}
}
