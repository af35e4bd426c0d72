// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Alpha complexes are those that rationals tell, at every range and at every tie; and the sweep
/// has for each cell the least double for which it is in.
#include "Testing/Engine/Alpha/AlphaByForce.h"

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/EdgeLengths.h>

#include <gtest/gtest.h>

namespace flipflop
{
namespace test
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double most = std::numeric_limits<double>::max();

std::vector<double> alphasOf(const Cloud& sites, const CellComplex& cells)
{
  std::vector<double> alphas(static_cast<std::size_t>(cells.cellCount()), -1e9);
  cellAlphas(viewOf(sites), weightsOf(sites), cells, alphas.data());
  return alphas;
}

/// Each cell's alpha is the least; and the complexes at some of them, just below, and at others.
void expectComplexes(const Cloud& sites, const Triangulation& triangulation)
{
  const std::vector<Cell> cells = cellsOf(triangulation);
  const std::vector<double> alphas = alphasOf(sites, triangulation);
  std::set<double> limits = { 0, -1, 1, 1e-200, -1e200, 1e200,
    std::numeric_limits<double>::denorm_min(), most };
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    std::vector<Point> corners;
    for (std::size_t i = 0; i < std::min<std::size_t>(cells[c].size(), 3); ++i)
    {
      corners.push_back(sites[static_cast<std::size_t>(cells[c][i])]);
    }
    ASSERT_TRUE(isLeastAlpha(circleByForce(corners).square, alphas[c])) << c << ": " << alphas[c];
    if (c % (1 + cells.size() / 6) == 0 && std::isfinite(alphas[c]))
    {
      limits.insert({ alphas[c], std::nextafter(alphas[c], -infinite) });
    }
  }
  const auto complexAt = [&](double alpha, bool singular)
  { return alphaComplex(viewOf(sites), weightsOf(sites), triangulation, alpha, singular); };
  for (const double limit : limits)
  {
    const AlphaComplex complex = complexAt(limit, true);
    ASSERT_EQ(alphaFault(complex, sites, triangulation, limit), "") << limit;
    const AlphaComplex alone = complexAt(limit, false);
    EXPECT_TRUE(sameBits(alone.cells, complex.cells));
    EXPECT_TRUE(alone.edges.empty() && alone.vertices.empty());
  }
  EXPECT_EQ(complexAt(infinite, true).cellCount, triangulation.cellCount());
  const AlphaComplex none = complexAt(-infinite, true);
  EXPECT_TRUE(none.cellCount == 0 && none.edges.empty() && none.vertices.empty());
}

class Alphas : public testing::TestWithParam<Input>
{
};

TEST_P(Alphas, AreThoseOfRationals)
{
  const Cloud sites = GetParam().make();
  for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    expectComplexes(sites, triangulationOf(sites, facets));
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
    EXPECT_EQ(alphasOf(sites, triangulation), std::vector<double>{ 5 * unit }) << exponent;
    expectComplexes(sites, triangulation);
  }
}

/// Products of six lengths underflow: what is lost exceeds the error that their factors have.
TEST(Alpha, ProductsBelowTheDoubles)
{
  const std::pair<Cloud, double> cases[] = {
    { { { 0, 0, 0 }, { 7.0064923216558041e-46, 7.0064923216547337e-46, 9.818186930682848e-91 },
        { 7.0064923216558056e-46, 7.0064923216547353e-46, 9.8181869306828523e-91 } },
      5.2197696687703701e-44 },
    { { { 0, 0, 0 }, { 7.0064923216625311e-46, 7.006492321661299e-46, 9.8181869307014745e-91 },
        { 7.0064923216625327e-46, 7.0064923216613005e-46, 9.8181869307014789e-91 } },
      6.4056127877276576e-44 },
  };
  for (const auto& [sites, alpha] : cases)
  {
    const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
    ASSERT_EQ(triangulation.cellCount(), 1);
    const AlphaComplex complex =
      alphaComplex(viewOf(sites), weightsOf(sites), triangulation, alpha, true);
    EXPECT_EQ(alphaFault(complex, sites, triangulation, alpha), "");
    expectComplexes(sites, triangulation);
  }
}

/// The radius of a needle's circle may be no double, and numbers of a triangulation may have
/// thousands of bits. A first guess of 0 may be half of all doubles away from the least alpha.
TEST(Alpha, BeyondDoubles)
{
  const double half = 0x1p1023;
  for (const Cloud& sites : { Cloud{ { 0, 0, 0 }, { 1e300, 0, 0 }, { 5e299, 1e-300, 0 } },
         Cloud{ { -half, 0, 0 }, { half, 0, 0 }, { 0, 0x1p-1070, 0 } },
         Cloud{ { -half, 0, 0 }, { half, 0, 0 }, { 0, 0x1p-1070, half } },
         Cloud{ { -half, 0, 0 }, { half, 0, 0 }, { 0, 0x1p-1070, -half } } })
  {
    const Triangulation triangulation = triangulationOf(sites, FacetMode::Triangles);
    EXPECT_EQ(alphasOf(sites, triangulation), std::vector<double>{ infinite });
    expectComplexes(sites, triangulation);
  }
  const Cloud ends = { { most, most, 0 }, { -most, most, 0 }, { most, -most, 0 },
    { -most, -most, 0 }, { most / 2, 0.1, 0 }, { 0, most, 0 }, { -most, 0.3, 0 },
    { 1e-300, most / 3, 0 } };
  const Triangulation triangulation = triangulationOf(ends, FacetMode::Triangles);
  const std::vector<double> alphas = alphasOf(ends, triangulation);
  EXPECT_EQ(std::count(alphas.begin(), alphas.end(), infinite), 2);
  expectComplexes(ends, triangulation);
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
      SCOPED_TRACE(exponent);
      expectComplexes(sites, triangulationOf(sites, FacetMode::Triangles));
    }
  }
}

/// Disks that overlap: with alpha 0 the complex is the nerve of their union.
TEST(Alpha, NerveOfDisks)
{
  // Two disks that meet, one beside them, and one inside the first, whose cell is not in it.
  const Cloud disks = { { 0, 0, 4 }, { 3, 0, 4 }, { 0, 9, 1 }, { 1.5, 0.25, 0.01 } };
  const Triangulation triangulation = triangulationOf(disks, FacetMode::Triangles);
  const AlphaComplex nerve = alphaComplex(viewOf(disks), weightsOf(disks), triangulation, 0, true);
  EXPECT_EQ(alphaFault(nerve, disks, triangulation, 0), "");
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
  EXPECT_EQ(alphasOf(sites, triangulation), (std::vector<double>{ 13, 13 }));
  // The long edge has both others in its circle: it is there with the cells alone.
  const AlphaComplex short4 = alphaComplex(viewOf(sites), WeightView(), triangulation, 6, true);
  EXPECT_EQ(short4.edgeAlphas.size(), 4u);
  const std::uint8_t kept[2] = { 1, 0 };
  keepCells(triangulation, kept);
  const AlphaComplex rest = alphaComplex(viewOf(sites), WeightView(), triangulation, 6, true);
  EXPECT_EQ(rest.edgeAlphas.size(), 2u);
  EXPECT_EQ(rest.vertices.size(), 1u);
}

TEST(Alpha, BadArguments)
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
