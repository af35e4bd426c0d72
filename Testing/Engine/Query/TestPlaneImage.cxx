// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An image has the values that interpolation gives at its pixels' positions, bit for bit: where
/// pixels are on edges and at sites, with constraints and cells left out, on any number of threads.
#include "Testing/Engine/Constraints/ConstrainedCases.h"
#include "Testing/Engine/Inputs/InputsConstrained.h"
#include "Testing/Engine/Query/PlaneQueries.h"

#include <flipflop/TriangulationQueries.h>

#include <gtest/gtest.h>

#include <cstring>
#include <ostream>
#include <utility>

namespace flipflop
{

std::ostream& operator<<(std::ostream& out, const ImageGrid& grid)
{
  for (int i = 0; i < 2; ++i)
  {
    out << grid.size[i] << " from " << grid.origin[i] << " + " << grid.firstIndex[i] << " * "
        << grid.spacing[i] << "; ";
  }
  return out;
}

namespace test
{

namespace
{

constexpr double fill = -7.25;
constexpr std::int64_t components = 2;

std::vector<double> positionsOf(const ImageGrid& grid)
{
  std::vector<double> positions;
  for (std::int64_t row = 0; row < grid.size[1]; ++row)
  {
    for (std::int64_t column = 0; column < grid.size[0]; ++column)
    {
      const std::int64_t index[] = { column, row };
      for (int i = 0; i < 2; ++i)
      {
        const double offset = static_cast<double>(grid.firstIndex[i] + index[i]) * grid.spacing[i];
        positions.push_back(grid.origin[i] + offset);
      }
    }
  }
  return positions;
}

std::vector<double> valuesFor(const Cloud& sites, std::uint64_t seed)
{
  Random random(seed);
  std::vector<double> values(components * sites.size());
  std::generate(values.begin(), values.end(), [&] { return random.uniform(-1, 1); });
  return values;
}

/// @return how many numbers are not the fill
std::int64_t expectImage(const TriangulationQueries& queries, Interpolation method,
  const std::vector<double>& values, const ImageGrid& grid)
{
  const std::vector<double> positions = positionsOf(grid);
  const std::size_t pixels = positions.size() / 2;
  std::vector<double> expected(components * pixels);
  const PointView view(positions.data(), static_cast<std::int64_t>(pixels), 2);
  method == Interpolation::Linear
    ? queries.interpolateLinear(values.data(), components, view, expected.data())
    : queries.interpolateNatural(values.data(), components, view, expected.data());
  std::int64_t inside = 0;
  for (double& x : expected)
  {
    inside += std::isnan(x) ? 0 : 1;
    x = std::isnan(x) ? fill : x;
  }
  for (const int threads : { 1, 2, 4 })
  {
    Options options;
    options.threads = threads;
    std::vector<double> found(expected.size());
    queries.interpolateImage(
      method, values.data(), components, grid, ImageView(found.data()), fill, options);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_EQ(std::memcmp(&found[i], &expected[i], sizeof(double)), 0)
        << i << ": " << found[i] << ", not " << expected[i] << "; " << grid;
      if (testing::Test::HasFailure())
      {
        return inside;
      }
    }
    std::vector<float> floats(expected.size());
    queries.interpolateImage(
      method, values.data(), components, grid, ImageView(floats.data()), fill, options);
    EXPECT_TRUE(std::equal(floats.begin(), floats.end(), expected.begin(),
      [](float x, double exact) { return x == static_cast<float>(exact); }))
      << grid;
  }
  return inside;
}

/// Around the sites, on multiples of their differences, and far beyond; rows and columns of either
/// direction.
std::vector<ImageGrid> gridsAmong(const Cloud& sites, Random& random)
{
  std::vector<ImageGrid> grids;
  const auto any = [&]() -> const Point& {
    return sites[static_cast<std::size_t>(random.integer(0, static_cast<int>(sites.size()) - 1))];
  };
  const auto add = [&](const double* origin, const double* spacing, int most)
  {
    ImageGrid grid;
    bool isFinite = true;
    for (int i = 0; i < 2; ++i)
    {
      grid.origin[i] = origin[i];
      grid.spacing[i] = spacing[i];
      grid.size[i] = random.integer(1, most);
      grid.firstIndex[i] = random.integer(-5, 2);
      isFinite = isFinite && std::isfinite(100 * spacing[i]) && std::fabs(origin[i]) < 1e308;
    }
    if (isFinite)
    {
      grids.push_back(grid);
    }
  };
  for (int i = 0; i < 3; ++i)
  {
    const Point& a = any();
    const Point& b = any();
    const double step[] = { (b[0] - a[0]) / 2, (a[1] - b[1]) / 4 };
    add(a.data(), step, 12);
    const double few[] = { (b[0] - a[0]) / random.uniform(3, 30), (a[1] - b[1]) / 8 };
    add(a.data(), few, 40);
    const double tiny[] = { std::ldexp(1.0, random.integer(-1074, 900)),
      -std::ldexp(1.0, random.integer(-60, 60)) };
    add(b.data(), tiny, 9);
  }
  return grids;
}

class PlaneImages : public testing::TestWithParam<Rung>
{
};

TEST_P(PlaneImages, AreTheInterpolatedValues)
{
  for (const Input& input : this->GetParam().inputs)
  {
    const Cloud sites = input.make();
    SCOPED_TRACE(std::to_string(sites.size()) + " sites, seed " + std::to_string(input.seed));
    Random random(3 + input.seed);
    const std::vector<double> values = valuesFor(sites, input.seed);
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      const Triangulation triangulation = triangulationOf(sites, facets);
      for (const bool areAll : { true, false })
      {
        const std::vector<std::uint8_t> inside = someOf(triangulation.cellCount(), 2, random);
        const TriangulationQueries queries(
          viewOf(sites), weightsOf(sites), triangulation, areAll ? nullptr : inside.data());
        bool isFirst = true;
        for (const ImageGrid& grid : gridsAmong(sites, random))
        {
          expectImage(queries, Interpolation::Linear, values, grid);
          if (std::exchange(isFirst, false))
          {
            expectImage(queries, Interpolation::Natural, values, grid);
          }
          ASSERT_FALSE(HasFailure());
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sites, PlaneImages, testing::ValuesIn(rungs()));

/// Triangles of many pixels, whose rows are shared out; few of them, and many.
TEST(PlaneImage, OfLargeTriangles)
{
  for (const int spokes : { 5, 300 })
  {
    Cloud sites = { { 0, 0, 0 } };
    for (int i = 0; i < spokes; ++i)
    {
      const double angle = 2 * std::acos(-1.0) * i / spokes;
      sites.push_back({ std::cos(angle), std::sin(angle), 0 });
    }
    const TriangulationQueries queries(
      viewOf(sites), WeightView(), triangulationOf(sites, FacetMode::Triangles));
    const ImageGrid grid{ { -1, 1 }, { 1.0 / 256, -1.0 / 512 }, { 513, 1025 }, { 0, 0 } };
    EXPECT_GT(expectImage(queries, Interpolation::Linear, valuesFor(sites, 1), grid), 600000);
  }
}

TEST(PlaneImage, OfConstraintsAndCellsLeftOut)
{
  Random random(5);
  for (int round = 0; round < 6; ++round)
  {
    const ConstrainedInput input = coast(80, random);
    ConstraintView view = viewOf(input.segments);
    view.sides = input.sides;
    const ConstrainedTriangulation whole = constrainedTriangulation(viewOf(input.cloud), view);
    std::vector<std::uint8_t> inside(static_cast<std::size_t>(whole.cellCount()), 1);
    cellsInside(whole, inside.data());
    const TriangulationQueries queries(
      viewOf(input.cloud), whole, round % 2 ? inside.data() : nullptr);
    const std::vector<double> values = valuesFor(input.cloud, 7);
    for (const ImageGrid& grid : gridsAmong(input.cloud, random))
    {
      expectImage(queries, Interpolation::Linear, values, grid);
    }
  }
}

TEST(PlaneImage, BadArguments)
{
  const Cloud sites = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const TriangulationQueries queries(
    viewOf(sites), WeightView(), triangulationOf(sites, FacetMode::Triangles));
  const double values[] = { 1, 2, 3 };
  double result[4];
  const ImageGrid good{ { 0, 0 }, { 0.5, 0.5 }, { 2, 2 }, { 0, 0 } };
  const auto expectBad = [&](const ImageGrid& grid, double* numbers = nullptr, int count = 1)
  {
    expectError(
      [&]
      {
        queries.interpolateImage(
          Interpolation::Linear, values, count, grid, ImageView(numbers ? numbers : result), fill);
      },
      ErrorCode::BadArgument);
  };
  queries.interpolateImage(Interpolation::Linear, values, 1, good, ImageView(result), fill);
  EXPECT_EQ(std::vector<double>(result, result + 4), (std::vector<double>{ 1, 1.5, 2, 2.5 }));
  for (int i = 0; i < 2; ++i)
  {
    for (const double bad : { std::nan(""), HUGE_VAL, -HUGE_VAL })
    {
      ImageGrid grid = good;
      grid.origin[i] = bad;
      expectBad(grid);
      grid = good;
      grid.spacing[i] = bad;
      expectBad(grid);
    }
    ImageGrid grid = good;
    grid.spacing[i] = 1e308;
    grid.firstIndex[i] = 2;
    expectBad(grid);
    grid = good;
    grid.firstIndex[i] = std::numeric_limits<std::int64_t>::max();
    expectBad(grid);
    for (const std::int64_t size : { std::int64_t(0), std::int64_t(-1), std::int64_t(1) << 60 })
    {
      grid = good;
      grid.size[i] = size;
      expectBad(grid);
    }
  }
  expectBad(good, nullptr, 0);
  expectBad(good, nullptr, -1);
  expectError(
    [&]
    {
      queries.interpolateImage(
        Interpolation::Linear, values, 1, good, ImageView(static_cast<float*>(nullptr)), fill);
    },
    ErrorCode::BadArgument);
  expectError([&]
    { queries.interpolateImage(Interpolation::Linear, nullptr, 1, good, ImageView(result), fill); },
    ErrorCode::BadArgument);
}

}
}
}
