// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Alpha complexes are those that rationals tell, at every range and at every tie; and the sweep
/// has for each cell the least double for which it is in.
#include "Testing/Engine/Alpha/AlphaByForce.h"
#include "Testing/Engine/Conformance/ProgressWatch.h"

#include <flipflop/AlphaComplex.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/EdgeLengths.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<double> alphasOf(
  const Cloud& sites, const CellComplex& cells, const Options& options = Options())
{
  std::vector<double> alphas(static_cast<std::size_t>(cells.cellCount()), -1e9);
  cellAlphas(viewOf(sites), weightsOf(sites), cells, alphas.data(), options);
  return alphas;
}

void expectComplex(const Cloud& sites, const Triangulation& triangulation, double alpha)
{
  const AlphaByForce expected = alphaByForce(sites, triangulation, alpha);
  const AlphaComplex found =
    alphaComplex(viewOf(sites), weightsOf(sites), triangulation, alpha, true);
  ASSERT_EQ(std::vector<std::uint8_t>(found.cells.begin(), found.cells.end()), expected.cells)
    << alpha;
  EXPECT_EQ(found.cellCount, std::count(expected.cells.begin(), expected.cells.end(), 1));
  std::vector<std::pair<std::int64_t, std::int64_t>> edges;
  for (std::size_t i = 0; i < found.edges.size(); i += 2)
  {
    edges.emplace_back(
      triangulation.pointIds[found.edges[i]], triangulation.pointIds[found.edges[i + 1]]);
  }
  ASSERT_EQ(edges, expected.edges) << alpha;
  ASSERT_EQ(found.edgeAlphas.size(), edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const double least = found.edgeAlphas[i];
    EXPECT_TRUE(isWithin(expected.edgeSquares[i], least));
    EXPECT_FALSE(isWithin(expected.edgeSquares[i], std::nextafter(least, -infinite)));
  }
  Cell vertices;
  for (const std::int64_t v : found.vertices)
  {
    vertices.push_back(triangulation.pointIds[v]);
  }
  ASSERT_EQ(vertices, expected.vertices) << alpha;
  ASSERT_EQ(found.vertexAlphas.size(), vertices.size());

  const AlphaComplex alone = alphaComplex(viewOf(sites), weightsOf(sites), triangulation, alpha);
  EXPECT_TRUE(std::equal(alone.cells.begin(), alone.cells.end(), found.cells.begin()));
  EXPECT_TRUE(alone.edges.empty() && alone.vertices.empty());
}

class Alphas : public testing::TestWithParam<Input>
{
};

TEST_P(Alphas, AreThoseOfRationals)
{
  const Cloud sites = GetParam().make();
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    const Triangulation triangulation = triangulationOf(sites, facets);
    const std::vector<Cell> cells = cellsOf(triangulation);
    const std::vector<double> alphas = alphasOf(sites, triangulation);
    std::set<double> limits = { 0, -1, 1, 1e-200, -1e200, 1e200,
      std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max() };
    for (std::size_t c = 0; c < cells.size(); ++c)
    {
      std::vector<Point> corners;
      for (std::size_t i = 0; i < std::min<std::size_t>(cells[c].size(), 3); ++i)
      {
        corners.push_back(sites[static_cast<std::size_t>(cells[c][i])]);
      }
      const Rational square = circleByForce(corners).square;
      const double below = std::nextafter(alphas[c], -infinite);
      ASSERT_TRUE(std::isinf(alphas[c]) || isWithin(square, alphas[c])) << c;
      ASSERT_TRUE(std::isinf(below) || !isWithin(square, below)) << c;
      if (c % (1 + cells.size() / 6) == 0 && std::isfinite(alphas[c]))
      {
        limits.insert({ alphas[c], below });
      }
    }
    for (const double limit : limits)
    {
      expectComplex(sites, triangulation, limit);
    }
    const AlphaComplex all =
      alphaComplex(viewOf(sites), weightsOf(sites), triangulation, infinite, true);
    EXPECT_EQ(all.cellCount, triangulation.cellCount());
    const AlphaComplex none =
      alphaComplex(viewOf(sites), weightsOf(sites), triangulation, -infinite, true);
    EXPECT_EQ(none.cellCount, 0);
    EXPECT_TRUE(none.edges.empty() && none.vertices.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(OfSites, Alphas, testing::ValuesIn(smallWeightedInputs()));

/// A circle as large as alpha, to the last bit, is in.
TEST(Alpha, TieIsIn)
{
  for (const int exponent : { -1070, -600, -300, 0, 300, 600, 1018 })
  {
    const double unit = std::ldexp(1.0, exponent);
    const Cloud sites = { { 0, 0, 0 }, { 6 * unit, 0, 0 }, { 0, 8 * unit, 0 } };
    const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
    ASSERT_EQ(triangulation.cellCount(), 1);
    EXPECT_EQ(alphasOf(sites, triangulation)[0], 5 * unit) << exponent;
    expectComplex(sites, triangulation, 5 * unit);
    expectComplex(sites, triangulation, std::nextafter(5 * unit, 0));
    expectComplex(sites, triangulation, 4 * unit);
  }
}

/// Products of six lengths underflow: what is lost exceeds the error that their factors have.
TEST(Alpha, ProductsBelowTheDoubles)
{
  struct Case
  {
    double b[3], c[3], alpha;
  };
  const Case cases[] = {
    { { 7.0064923216558041e-46, 7.0064923216547337e-46, 9.818186930682848e-91 },
      { 7.0064923216558056e-46, 7.0064923216547353e-46, 9.8181869306828523e-91 },
      5.2197696687703701e-44 },
    { { 7.0064923216625311e-46, 7.006492321661299e-46, 9.8181869307014745e-91 },
      { 7.0064923216625327e-46, 7.0064923216613005e-46, 9.8181869307014789e-91 },
      6.4056127877276576e-44 },
  };
  for (const Case& of : cases)
  {
    const Cloud sites = { { 0, 0, 0 }, { of.b[0], of.b[1], of.b[2] },
      { of.c[0], of.c[1], of.c[2] } };
    const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
    ASSERT_EQ(triangulation.cellCount(), 1);
    expectComplex(sites, triangulation, of.alpha);
  }
}

/// The radius of a needle's circle may be no double.
TEST(Alpha, BeyondDoubles)
{
  const Cloud sites = { { 0, 0, 0 }, { 1e300, 0, 0 }, { 5e299, 1e-300, 0 } };
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  ASSERT_EQ(triangulation.cellCount(), 1);
  EXPECT_EQ(alphasOf(sites, triangulation)[0], infinite);
  expectComplex(sites, triangulation, std::numeric_limits<double>::max());
}

/// A first guess of 0 may be half of all doubles away from the least alpha.
TEST(Alpha, FarFromTheFirstGuess)
{
  const double most = 0x1p1023;
  for (const double weight : { 0.0, most, -most })
  {
    const Cloud sites = { { -most, 0, 0 }, { most, 0, 0 }, { 0, 0x1p-1070, weight } };
    const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
    ASSERT_EQ(triangulation.cellCount(), 1);
    EXPECT_EQ(alphasOf(sites, triangulation)[0], infinite);
  }
}

/// At the ends of the doubles numbers of a triangulation have thousands of bits. Each cell's is
/// found without a search among the doubles.
TEST(Alpha, PointsAtTheEndsOfTheDoubles)
{
  const double most = std::numeric_limits<double>::max();
  const Cloud sites = { { most, most, 0 }, { -most, most, 0 }, { most, -most, 0 },
    { -most, -most, 0 }, { most / 2, 0.1, 0 }, { 0, most, 0 }, { -most, 0.3, 0 },
    { 1e-300, most / 3, 0 } };
  const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
  const auto begin = std::chrono::steady_clock::now();
  std::vector<double> alphas;
  const int times = effort(50);
  for (int i = 0; i < times; ++i)
  {
    alphas = alphasOf(sites, triangulation);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(seconds.count(), 0.03 * times); // with a search: 0.1 s each
  EXPECT_EQ(std::count(alphas.begin(), alphas.end(), infinite), 2);
  for (std::size_t cell = 0; cell < alphas.size(); ++cell)
  {
    const double alpha = alphas[cell];
    const auto isIn = [&](double limit)
    { return alphaComplex(viewOf(sites), WeightView(), triangulation, limit).cells[cell] != 0; };
    EXPECT_TRUE(isIn(alpha));
    EXPECT_FALSE(isIn(std::nextafter(alpha, -infinite)));
  }
}

/// Of every size of the square, the least number whose square is not less.
TEST(Alpha, RootsAreRoundedUp)
{
  Random random(9);
  for (int exponent = -1080; exponent < 1000; exponent += 40)
  {
    // Without weights positive; of one site with a weight, any sign; of few bits, exact.
    const double x = std::ldexp(1 + random.uniform(), exponent);
    const double weight = std::ldexp(random.uniform() - 0.5, std::max(-1070, exponent));
    for (const Cloud& sites : { Cloud{ { 0, 0, 0 }, { x, 0, 0 } },
           Cloud{ { 0, 0, 0 }, { std::ldexp(3.0, exponent), std::ldexp(4.0, exponent), 0 } },
           Cloud{ { 0, 0, weight } } })
    {
      const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
      const double alpha = alphasOf(sites, triangulation)[0];
      const auto isIn = [&](double limit) {
        return alphaComplex(viewOf(sites), weightsOf(sites), triangulation, limit).cellCount == 1;
      };
      EXPECT_TRUE(isIn(alpha)) << exponent;
      EXPECT_FALSE(isIn(std::nextafter(alpha, -infinite))) << exponent;
    }
  }
}

/// Disks that overlap: with alpha 0 the complex is the nerve of their union.
TEST(Alpha, NerveOfDisks)
{
  // Two disks that meet, one beside them, and one inside the first, whose cell is not in it.
  const Cloud disks = { { 0, 0, 4 }, { 3, 0, 4 }, { 0, 9, 1 }, { 1.5, 0.25, 0.01 } };
  const Triangulation triangulation = triangulationOf(disks, FacetMode::Triangles);
  expectComplex(disks, triangulation, 0);
  const AlphaComplex nerve = alphaComplex(viewOf(disks), weightsOf(disks), triangulation, 0, true);
  EXPECT_EQ(nerve.cellCount, 0);
  EXPECT_EQ(nerve.edgeAlphas.size(), 1u);
  EXPECT_EQ(nerve.vertices.size(), 1u);
  EXPECT_EQ(nerve.vertexAlphas[0], -1.0);
}

TEST(Alpha, OfConstrainedAndMissingCells)
{
  const Cloud sites = { { 0, 0, 0 }, { 10, 0, 0 }, { 5, 1, 0 }, { 5, -1, 0 } };
  const std::int64_t ends[2] = { 0, 1 };
  ConstrainedTriangulation triangulation =
    constrainedTriangulation(viewOf(sites), ConstraintView(ends, 1));
  ASSERT_EQ(triangulation.cellCount(), 2);
  const std::vector<double> alphas = alphasOf(sites, triangulation);
  EXPECT_EQ(alphas[0], 13.0);
  EXPECT_EQ(alphas[1], 13.0);
  // The long edge has both others in its circle: it is there with the cells alone.
  const AlphaComplex short4 = alphaComplex(viewOf(sites), WeightView(), triangulation, 6, true);
  EXPECT_EQ(short4.edgeAlphas.size(), 4u);
  const std::uint8_t kept[2] = { 1, 0 };
  keepCells(triangulation, kept);
  const AlphaComplex rest = alphaComplex(viewOf(sites), WeightView(), triangulation, 6, true);
  EXPECT_EQ(rest.edgeAlphas.size(), 2u);
  EXPECT_EQ(rest.vertices.size(), 1u);
}

TEST(Alpha, Errors)
{
  const Cloud sites = randomSites(20, 0, 11);
  const Triangulation right = triangulationOf(sites, FacetMode::Triangles);
  std::vector<double> alphas(static_cast<std::size_t>(right.cellCount()));
  expectError([&] { alphaComplex(viewOf(sites), WeightView(), right, std::nan("")); },
    ErrorCode::BadArgument);
  expectError(
    [&] { cellAlphas(viewOf(sites), WeightView(), right, nullptr); }, ErrorCode::BadArgument);
  for (const std::size_t other : { 0, 2 })
  {
    Triangulation broken = triangulationOf(sites, FacetMode::Triangles);
    broken.connectivity[1] = broken.connectivity[other]; // a corner twice, or turned over
    broken.connectivity[2] = right.connectivity[1];
    expectError(
      [&] { alphaComplex(viewOf(sites), WeightView(), broken, 1, true); }, ErrorCode::BadArgument);
    expectError([&] { cellAlphas(viewOf(sites), WeightView(), broken, alphas.data()); },
      ErrorCode::BadArgument);
  }
}

}
}
}
