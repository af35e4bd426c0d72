// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Intersections of half-spaces, compared with all triples of borders, in rationals.
#include "Testing/Engine/Calls/Bits.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/HalfSpaces/HalfSpacesByForce.h"

#include <flipflop/Error.h>
#include <flipflop/HalfSpaces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// Half-spaces of space, or of the plane.
struct Case
{
  int dimension = 3;
  std::vector<Row> rows;
};

HalfSpaceIntersection intersectionOf(
  const std::vector<Row>& rows, int dimension, const double* interior = nullptr, int threads = 1)
{
  std::vector<double> numbers;
  for (const Row& row : rows)
  {
    numbers.insert(numbers.end(), row.begin(), row.begin() + dimension);
    numbers.push_back(row[3]);
  }
  Options options;
  options.threads = threads;
  return halfSpaceIntersection(
    { numbers.data(), static_cast<std::int64_t>(rows.size()), dimension }, interior, options);
}

/// Small integers, with the origin inside or not: many are redundant, parallel, the same, or meet
/// at one position.
Case drawCase(Random& random)
{
  Case drawn;
  drawn.dimension = 2 + random.integer(0, 1);
  const int reach = 1 + random.integer(0, 3);
  const int offsets = 1 + random.integer(0, 5);
  const bool isAroundOrigin = random.integer(0, 3) > 0;
  drawn.rows.resize(static_cast<std::size_t>(drawn.dimension + 1 + random.integer(0, 8)));
  for (Row& row : drawn.rows)
  {
    for (int i = 0; i < 3; ++i)
    {
      row[static_cast<std::size_t>(i)] = i < drawn.dimension ? random.integer(-reach, reach) : 0;
    }
    row[3] =
      isAroundOrigin ? -1 - random.integer(0, offsets - 1) : random.integer(-offsets, offsets);
    const double scale = random.integer(0, 3) == 0 ? 3 : random.integer(0, 7) == 0 ? 0x1p-200 : 1;
    for (double& number : row)
    {
      number *= scale;
    }
  }
  return drawn;
}

std::string describe(const Case& drawn)
{
  std::string text = std::to_string(drawn.dimension) + " dimensions:";
  for (const Row& row : drawn.rows)
  {
    text += " (";
    for (const double number : row)
    {
      text += std::to_string(number) + " ";
    }
    text += ")";
  }
  return text;
}

TEST(HalfSpaces, AreThoseOfAllTriplesOfBorders)
{
  runSeeds(
    200, drawCase,
    [](const Case& drawn)
    { return faultOf(drawn.rows, drawn.dimension, intersectionOf(drawn.rows, drawn.dimension)); },
    describe);
}

/// Of any length, along any direction: each has a facet.
std::vector<Row> tangentPlanes(std::size_t count, const Exact& center, int dimension)
{
  Random random(17);
  std::vector<Row> rows(count);
  for (Row& row : rows)
  {
    const double scale = random.uniform(0.1, 10);
    double square = 0;
    for (int i = 0; i < dimension; ++i)
    {
      row[static_cast<std::size_t>(i)] = random.uniform(-1, 1);
      square += row[static_cast<std::size_t>(i)] * row[static_cast<std::size_t>(i)];
    }
    row[3] = -std::sqrt(square);
    for (std::size_t i = 0; i < 3; ++i)
    {
      row[3] -= row[i] * center[i].get_d();
    }
    std::transform(row.begin(), row.end(), row.begin(), [&](double x) { return x * scale; });
  }
  return rows;
}

TEST(HalfSpaces, OfTangentPlanes)
{
  for (const int dimension : { 2, 3 })
  {
    for (const double shift : { 0.0, 1e6 })
    {
      SCOPED_TRACE(std::to_string(dimension) + " " + std::to_string(shift));
      const Exact center{ shift, -shift, dimension == 3 ? 2 * shift : 0 };
      const std::vector<Row> rows = tangentPlanes(25, center, dimension);
      const HalfSpaceIntersection found = intersectionOf(rows, dimension);
      EXPECT_EQ(faultOf(rows, dimension, found), "");
      EXPECT_EQ(found.pointIds.size(), 25u);
      const double interior[] = { shift, -shift, 2 * shift };
      EXPECT_EQ(faultOf(rows, dimension, intersectionOf(rows, dimension, interior)), "");
    }
  }
}

TEST(HalfSpaces, OfManyTangentPlanes)
{
  const std::vector<Row> rows = tangentPlanes(3000, { 0, 0, 0 }, 3);
  const HalfSpaceIntersection found = intersectionOf(rows, 3);
  EXPECT_EQ(found.pointIds.size(), 3000u);
  EXPECT_EQ(found.cellCount(), 5996);
  for (std::size_t i = 0; i < found.vertices.size(); i += 3)
  {
    for (std::size_t id = i % 7; id < rows.size(); id += 7)
    {
      double sum = rows[id][3];
      for (std::size_t k = 0; k < 3; ++k)
      {
        sum += rows[id][k] * found.vertices[i + k];
      }
      ASSERT_LT(sum, 1e-12);
    }
  }
}

/// Most of many are left out at once: the others have the same vertices.
TEST(HalfSpaces, OfWhichFewHaveAFacet)
{
  Random random(5);
  for (const int dimension : { 2, 3 })
  {
    for (const double thinness : { 1.0, 1e-3 })
    {
      SCOPED_TRACE(std::to_string(dimension) + " " + std::to_string(thinness));
      std::vector<Row> rows = tangentPlanes(6000, { 0, 0, 0 }, dimension);
      for (Row& row : rows)
      {
        row[0] *= thinness;
        row[3] *= random.uniform(1, 1.5);
      }
      const HalfSpaceIntersection found = intersectionOf(rows, dimension);
      ASSERT_EQ(found.kind, Intersection::Bounded);
      std::vector<Row> facets;
      for (const std::int64_t id : found.pointIds)
      {
        facets.push_back(rows[static_cast<std::size_t>(id)]);
      }
      ASSERT_LT(facets.size(), 3000u);
      const HalfSpaceIntersection same = intersectionOf(facets, dimension, found.interior);
      EXPECT_EQ(bitsOf(same.connectivity), bitsOf(found.connectivity));
      EXPECT_EQ(bitsOf(same.vertices), bitsOf(found.vertices));
      const auto axes = static_cast<std::size_t>(dimension);
      for (std::size_t i = 0; i < found.vertices.size(); i += axes)
      {
        for (const Row& row : rows)
        {
          double sum = row[3];
          double most = -row[3];
          for (std::size_t k = 0; k < axes; ++k)
          {
            sum += row[k] * found.vertices[i + k];
            most += std::fabs(row[k] * found.vertices[i + k]);
          }
          ASSERT_LT(sum, 1e-14 * most);
        }
      }
    }
  }
}

/// Dual points that round to one position are of different half-spaces all the same.
TEST(HalfSpaces, AreDistinguishedWhereDualPointsAreNot)
{
  const double small = 0x1p-53;
  const std::vector<Row> rows{ { 1, 0, 0, -1 }, { -1, 0, 0, -1 }, { 0, 1, 0, -1 }, { 0, -1, 0, -1 },
    { 0, 0, 1, -1 }, { 0, 0, -1, -1 }, { 1, 0, 0, -1 + small }, { 1 + 2 * small, 0, 0, -1 },
    { 3, 0, 0, -3 }, { 1, small * small, 0, -1 } };
  EXPECT_EQ(faultOf(rows, 3, intersectionOf(rows, 3)), "");
  const std::vector<Row> same{ rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[0],
    rows[8], rows[9] };
  const HalfSpaceIntersection found = intersectionOf(same, 3);
  EXPECT_EQ(faultOf(same, 3, found), "");
  EXPECT_EQ(found.pointIds.size(), 7u);
}

/// Numbers that no double arithmetic carries.
TEST(HalfSpaces, OfAnyMagnitude)
{
  for (const double unit : { 0x1p-300, 0x1p300 })
  {
    for (const int dimension : { 2, 3 })
    {
      std::vector<Row> rows = tangentPlanes(12, { 0, 0, 0 }, dimension);
      for (std::size_t id = 0; id < rows.size(); ++id)
      {
        rows[id][3] *= unit;
        std::transform(rows[id].begin(), rows[id].end(), rows[id].begin(),
          [&](double x) { return x * (id % 2 ? 0x1p-400 : 1); });
      }
      const HalfSpaceIntersection found = intersectionOf(rows, dimension);
      EXPECT_EQ(found.kind, Intersection::Bounded);
      const HalfSpaceIntersection plain =
        intersectionOf(tangentPlanes(12, { 0, 0, 0 }, dimension), dimension);
      ASSERT_EQ(bitsOf(found.connectivity), bitsOf(plain.connectivity));
      for (std::size_t i = 0; i < found.vertices.size(); ++i)
      {
        EXPECT_EQ(found.vertices[i], unit * plain.vertices[i]);
      }
    }
  }
}

/// Positions that satisfy a half-space are beyond doubles.
TEST(HalfSpaces, OfBordersBeyondDoubles)
{
  std::vector<Row> rows = tangentPlanes(10, { 0, 0, 0 }, 3);
  rows.push_back({ 0x1p-1000, 0, 0, 0x1p1000 });
  EXPECT_EQ(intersectionOf(rows, 3).kind, Intersection::Empty);
  rows.back() = { 0x1p-1000, 0, 0, -0x1p1000 };
  const HalfSpaceIntersection found = intersectionOf(rows, 3);
  EXPECT_EQ(found.pointIds.size(), 10u);
  EXPECT_EQ(intersectionOf({ rows.back() }, 3).kind, Intersection::Unbounded);
}

/// Thin, wide, or open along an axis: an interior is found, in doubles.
TEST(HalfSpaces, FindInteriorsOfThinAndOpenSets)
{
  const double far = 1e8;
  for (const std::vector<Row>& rows :
    { std::vector<Row>{ { 1, 0, 0, -1e-17 }, { -1, 0, 0, -1e-17 }, { 0, 1, 0, -1 },
        { 0, -1, 0, -1 }, { 0, 0, 1, -1 }, { 0, 0, -1, -1 } },
      { { 1, 1, 1, -(far + 0x1p-24) }, { -1, -1, -1, far } },
      { { 0x1p-1000, 0, 0, -0x1p1000 }, { -1, 0, 0, 1 } }, { { 1, 0, 0, 1.7e308 } } })
  {
    const HalfSpaceIntersection found = intersectionOf(rows, 3);
    for (const Row& row : rows)
    {
      EXPECT_LT(excess(row, { found.interior[0], found.interior[1], found.interior[2] }), 0);
    }
  }
  // Flat, of small and of great numbers.
  for (const double unit : { 1e-300, 1e-30, 1e30, 1e300 })
  {
    EXPECT_EQ(
      intersectionOf({ { 1, 0, 0, -unit }, { -1, 0, 0, unit } }, 3).kind, Intersection::Flat);
    EXPECT_EQ(
      intersectionOf({ { 1, 0, 0, unit }, { -1, 0, 0, unit } }, 3).kind, Intersection::Empty);
  }
  const double least = 0x1p-1074;
  EXPECT_EQ(intersectionOf({ { least, 0, 0, 1e308 }, { -least, 0, 0, 1e308 } }, 3).kind,
    Intersection::Empty);
  EXPECT_EQ(intersectionOf({ { least, 0, 0, 1e308 }, { -least, 0, 0, -1e308 } }, 3).kind,
    Intersection::Flat);
}

/// Sorted, and open along an axis: the work grows with their number alone.
TEST(HalfSpaces, OfManyThatAreEmpty)
{
  std::vector<Row> rows;
  for (int i = 0; i < 3000; ++i)
  {
    rows.push_back({ 1, 0, 0, double(i) });
  }
  rows.push_back({ -1, 0, 0, 0 });
  EXPECT_EQ(intersectionOf(rows, 3).kind, Intersection::Empty);
  rows.pop_back();
  rows.push_back({ -1, 0, 0, -2999 });
  EXPECT_EQ(intersectionOf(rows, 3).kind, Intersection::Flat);
}

/// Multiples of one half-space, rounded: their dual points are one, rounded.
TEST(HalfSpaces, OfManyNearlyTheSame)
{
  Random random(9);
  std::vector<Row> rows{ { 1, 0, 0, -1 }, { -1, 0, 0, -1 }, { 0, 1, 0, -1 }, { 0, -1, 0, -1 },
    { 0, 0, 1, -1 }, { 0, 0, -1, -1 } };
  for (int i = 0; i < 3000; ++i)
  {
    const double scale = i % 3 ? random.uniform(1, 2) : 1.5;
    rows.push_back({ 0.6 * scale, 0.8 * scale, 0.3 * scale, -0.9 * scale });
  }
  const HalfSpaceIntersection found = intersectionOf(rows, 3);
  std::vector<Row> few;
  for (const std::int64_t id : found.pointIds)
  {
    few.push_back(rows[static_cast<std::size_t>(id)]);
  }
  ASSERT_LT(few.size(), 40u);
  EXPECT_EQ(faultOf(few, 3, intersectionOf(few, 3)), "");
}

ErrorCode codeOf(const std::vector<Row>& rows, const double* interior, std::int64_t* index)
{
  try
  {
    intersectionOf(rows, 3, interior);
  }
  catch (const Error& error)
  {
    *index = error.index();
    return error.code();
  }
  return ErrorCode::Internal;
}

TEST(HalfSpaces, ErrorsNameTheHalfSpace)
{
  std::vector<Row> rows = tangentPlanes(20, { 0, 0, 0 }, 3);
  std::int64_t index = -1;
  const double onBorder[] = { 0, 0, 0 };
  rows[7][3] = 0;
  EXPECT_EQ(codeOf(rows, onBorder, &index), ErrorCode::BadArgument);
  EXPECT_EQ(index, 7);
  rows[5][1] = NAN;
  EXPECT_EQ(codeOf(rows, nullptr, &index), ErrorCode::NonFinite);
  EXPECT_EQ(index, 5);
  EXPECT_EQ(halfSpaceIntersection({}).kind, Intersection::Unbounded);
}

}
}
}
