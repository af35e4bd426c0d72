// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Areas and centroids are the exact ones, rounded, at every range.
#include "Testing/Engine/Conformance/ProgressWatch.h"
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/Measures.h>

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

struct ExactMeasures
{
  Rational area;
  Rational centroid[2];
};

ExactMeasures measuresByForce(const std::vector<Point>& corners)
{
  ExactMeasures result;
  const Point& a = corners[0];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const Rational twice = orientation(a, corners[i], corners[i + 1]);
    result.area += twice / 2;
    for (std::size_t k = 0; k < 2; ++k)
    {
      result.centroid[k] +=
        twice * (Rational(a[k]) + corners[i][k] + Rational(corners[i + 1][k])) / 6;
    }
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    result.centroid[k] = result.area != 0 ? Rational(result.centroid[k] / result.area)
                                          : Rational((Rational(a[k]) + corners.back()[k]) / 2);
  }
  return result;
}

void expectMeasures(const std::vector<Point>& corners, double area, const double* centroid)
{
  const ExactMeasures exact = measuresByForce(corners);
  if (exact.area > std::numeric_limits<double>::max())
  {
    EXPECT_EQ(area, std::numeric_limits<double>::infinity());
  }
  else
  {
    const Rational error = abs(Rational(Rational(area) - exact.area));
    EXPECT_LE(error, Rational(exact.area * 0x1p-50 + 0x1p-1074));
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    double most = 0;
    for (const Point& corner : corners)
    {
      most = std::max(most, std::fabs(corner[k]));
    }
    const Rational error = abs(Rational(Rational(centroid[k]) - exact.centroid[k]));
    EXPECT_LE(error, Rational(Rational(most) * 0x1p-50 + 0x1p-1074));
  }
}

void expectCells(const Cloud& sites, FacetMode facets)
{
  const Triangulation triangulation = triangulationOf(sites, facets);
  const auto count = static_cast<std::size_t>(triangulation.cellCount());
  std::vector<double> areas(count, -1);
  std::vector<double> centroids(2 * count, -1);
  cellMeasures(viewOf(sites), triangulation, areas.data(), centroids.data());
  const std::vector<Cell> cells = cellsOf(triangulation);
  for (std::size_t c = 0; c < count; ++c)
  {
    std::vector<Point> corners;
    for (const std::int64_t id : cells[c])
    {
      corners.push_back(sites[static_cast<std::size_t>(id)]);
    }
    expectMeasures(corners, areas[c], &centroids[2 * c]);
  }
}

class Measures : public testing::TestWithParam<Input>
{
};

TEST_P(Measures, OfCells)
{
  const Cloud sites = GetParam().make();
  expectCells(sites, FacetMode::Triangles);
  expectCells(sites, FacetMode::Polygons);
}

INSTANTIATE_TEST_SUITE_P(OfSites, Measures, testing::ValuesIn(smallWeightedInputs()));

TEST(Measures, OfPowerCells)
{
  for (const double weight : { 0.0, 0.01 })
  {
    const Cloud sites = randomSites(300, weight, 8);
    const Triangulation triangulation = triangulationOf(sites, FacetMode::Polygons);
    const double box[] = { 0.25, 1, -0.5, 1.25 };
    const PowerDiagram diagram = powerDiagram(viewOf(sites), weightsOf(sites), triangulation, box);
    const std::size_t count = diagram.siteIds.size();
    std::vector<double> areas(count);
    std::vector<double> centroids(2 * count);
    cellMeasures(diagram, areas.data(), centroids.data());
    double sum = 0;
    for (std::size_t c = 0; c < count; ++c)
    {
      std::vector<Point> corners;
      for (std::int64_t i = diagram.offsets[c]; i < diagram.offsets[c + 1]; ++i)
      {
        const std::int64_t corner = diagram.connectivity[static_cast<std::size_t>(i)];
        corners.push_back({ diagram.corners[static_cast<std::size_t>(2 * corner)],
          diagram.corners[static_cast<std::size_t>(2 * corner + 1)], 0 });
      }
      expectMeasures(corners, areas[c], &centroids[2 * c]);
      sum += areas[c];
    }
    EXPECT_NEAR(sum, 0.75 * 1.75, 1e-14);
  }
}

TEST(Measures, OneAlone)
{
  const Cloud sites = randomSites(20, 0, 9);
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const auto count = static_cast<std::size_t>(triangulation.cellCount());
  std::vector<double> areas(count), centroids(2 * count), alone(count), others(2 * count);
  cellMeasures(viewOf(sites), triangulation, areas.data(), centroids.data());
  cellMeasures(viewOf(sites), triangulation, alone.data(), nullptr);
  cellMeasures(viewOf(sites), triangulation, nullptr, others.data());
  EXPECT_EQ(areas, alone);
  EXPECT_EQ(centroids, others);
  cellMeasures(viewOf(sites), triangulation, nullptr, nullptr);
  cellMeasures(PowerDiagram(), nullptr, nullptr);
}

TEST(Measures, Errors)
{
  const Cloud sites = randomSites(20, 0, 11);
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const auto expectBadDiagram = [&](const std::function<void(PowerDiagram&)>& change)
  {
    const double box[] = { 0, 1, 0, 1 };
    PowerDiagram diagram = powerDiagram(viewOf(sites), WeightView(), triangulation, box);
    change(diagram);
    expectError([&] { cellMeasures(diagram, nullptr, nullptr); }, ErrorCode::BadArgument);
  };
  expectBadDiagram([](PowerDiagram& d) { d.offsets[0] = 1; });
  expectBadDiagram([](PowerDiagram& d) { d.offsets[1] = 0; });
  expectBadDiagram([](PowerDiagram& d) { d.offsets.truncate(3); });
  expectBadDiagram([](PowerDiagram& d) { d.offsets[2] = 1000000; });
  expectBadDiagram([](PowerDiagram& d) { d.connectivity[2] = -1; });
  expectBadDiagram(
    [](PowerDiagram& d) { d.connectivity[2] = static_cast<std::int64_t>(d.corners.size()) / 2; });
  expectBadDiagram(
    [](PowerDiagram& d) { d.corners[1] = std::numeric_limits<double>::quiet_NaN(); });
}

}
}
}
