// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Intersections of half-spaces, compared with all triples of borders, in rationals.
#include "Testing/Engine/Calls/Bits.h"
#include "Testing/Engine/Conformance/RandomCases.h"

#include <flipflop/Error.h>
#include <flipflop/HalfSpaces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

namespace
{

using Row = std::array<double, 4>; ///< normal . x + offset <= 0; in the plane the third is 0
using Exact = std::array<mpq_class, 3>;
using Ids = std::set<std::int64_t>;

/// Half-spaces of space, or of the plane.
struct Case
{
  int dimension = 3;
  std::vector<Row> rows;
};

struct Expected
{
  Intersection kind = Intersection::Empty;
  std::map<Exact, Ids> vertices; ///< of each the half-spaces with a facet there
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

mpq_class excess(const Row& row, const Exact& x)
{
  mpq_class sum(row[3]);
  for (std::size_t i = 0; i < 3; ++i)
  {
    sum += mpq_class(row[i]) * x[i];
  }
  return sum;
}

mpq_class determinant(const Exact& a, const Exact& b, const Exact& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Exact difference(const Exact& a, const Exact& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Exact cross(const Exact& a, const Exact& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

bool isZero(const Exact& a)
{
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

/// Of the affine hull; -1: there is no position.
int dimensionOf(const std::vector<Exact>& positions)
{
  int dimension = positions.empty() ? -1 : 0;
  Exact first, normal;
  for (const Exact& position : positions)
  {
    const Exact d = difference(position, positions.front());
    if (dimension == 0 && !isZero(d))
    {
      first = d;
      dimension = 1;
    }
    if (dimension == 1 && !isZero(cross(first, d)))
    {
      normal = cross(first, d);
      dimension = 2;
    }
    if (dimension == 2 && normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2] != 0)
    {
      return 3;
    }
  }
  return dimension;
}

/// All positions where three borders or more meet in the intersection, with the half-spaces there.
std::map<Exact, Ids> meetings(const std::vector<Row>& rows)
{
  std::map<Exact, Ids> result;
  const auto columnsOf = [&rows](std::size_t i, std::size_t replaced)
  {
    Exact row;
    for (std::size_t k = 0; k < 3; ++k)
    {
      row[k] = k == replaced ? -rows[i][3] : rows[i][k];
    }
    return row;
  };
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      for (std::size_t k = 0; k < j; ++k)
      {
        const auto minor = [&](std::size_t replaced) {
          return determinant(
            columnsOf(i, replaced), columnsOf(j, replaced), columnsOf(k, replaced));
        };
        const mpq_class whole = minor(3);
        if (whole == 0)
        {
          continue;
        }
        const Exact x{ minor(0) / whole, minor(1) / whole, minor(2) / whole };
        Ids tight;
        bool isInside = true;
        for (std::size_t id = 0; id < rows.size() && isInside; ++id)
        {
          const int side = sgn(excess(rows[id], x));
          isInside = side <= 0;
          if (side == 0 && !(rows[id][0] == 0 && rows[id][1] == 0 && rows[id][2] == 0))
          {
            tight.insert(static_cast<std::int64_t>(id));
          }
        }
        if (isInside)
        {
          result[x] = tight;
        }
      }
    }
  }
  return result;
}

/// The reference of half-spaces of small numbers: what is inside of a large box decides the kind.
Expected expected(std::vector<Row> rows, int dimension)
{
  const auto own = static_cast<std::int64_t>(rows.size());
  if (dimension == 2)
  {
    rows.push_back({ 0, 0, 1, -1 });
    rows.push_back({ 0, 0, -1, -1 });
  }
  const auto boxed = static_cast<std::int64_t>(rows.size());
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      Row wall{ 0, 0, 0, -0x1p40 };
      wall[i] = sign;
      rows.push_back(wall);
    }
  }
  Expected result;
  const std::map<Exact, Ids> all = meetings(rows);
  std::vector<Exact> positions;
  std::map<std::int64_t, std::vector<Exact>> touched;
  bool isBounded = true;
  for (const auto& [x, tight] : all)
  {
    positions.push_back(x);
    isBounded = isBounded && *tight.rbegin() < boxed;
    for (const std::int64_t id : tight)
    {
      touched[id].push_back(x);
    }
  }
  const int spanned = dimensionOf(positions);
  result.kind = spanned < 0 ? Intersection::Empty
    : spanned < 3           ? Intersection::Flat
    : isBounded             ? Intersection::Bounded
                            : Intersection::Unbounded;
  if (result.kind != Intersection::Bounded)
  {
    return result;
  }
  Ids facets;
  std::set<std::vector<Exact>> known;
  for (const auto& [id, there] : touched)
  {
    if (dimensionOf(there) == 2 && known.insert(there).second)
    {
      facets.insert(id);
    }
  }
  for (const auto& [x, tight] : all)
  {
    Ids there;
    for (const std::int64_t id : tight)
    {
      if (id < own && facets.count(id))
      {
        there.insert(id);
      }
    }
    if (dimension == 3 || tight.count(own))
    {
      result.vertices[dimension == 3 ? x : Exact{ x[0], x[1], 0 }] = there;
    }
  }
  return result;
}

/// The nearest double, checked by its neighbours.
bool isNearest(double found, const mpq_class& exact)
{
  const mpq_class off = abs(mpq_class(found) - exact);
  const double next[2] = { std::nextafter(found, HUGE_VAL), std::nextafter(found, -HUGE_VAL) };
  return off <= abs(mpq_class(next[0]) - exact) && off <= abs(mpq_class(next[1]) - exact);
}

/// What is wrong; empty: nothing.
std::string faultOf(const std::vector<Row>& rows, int dimension, const HalfSpaceIntersection& found)
{
  const Expected wanted = expected(rows, dimension);
  if (found.kind != wanted.kind)
  {
    return "the kind is " + std::to_string(static_cast<int>(found.kind)) + ", not " +
      std::to_string(static_cast<int>(wanted.kind));
  }
  if (found.cellCount() != static_cast<std::int64_t>(wanted.vertices.size()))
  {
    return std::to_string(found.cellCount()) + " vertices, not " +
      std::to_string(wanted.vertices.size());
  }
  const bool hasInside =
    found.kind == Intersection::Bounded || found.kind == Intersection::Unbounded;
  for (const Row& row : rows)
  {
    const bool isTrivial = row[0] == 0 && row[1] == 0 && row[2] == 0;
    if (hasInside && !isTrivial &&
      excess(row, { found.interior[0], found.interior[1], found.interior[2] }) >= 0)
    {
      return "the interior is not inside";
    }
  }
  std::map<Ids, Exact> remaining;
  for (const auto& [x, ids] : wanted.vertices)
  {
    remaining[ids] = x;
  }
  for (std::int64_t cell = 0; cell < found.cellCount(); ++cell)
  {
    Ids ids;
    for (std::int64_t i = found.cellBegin(cell); i < found.cellBegin(cell + 1); ++i)
    {
      const std::int64_t corner = found.connectivity[static_cast<std::size_t>(i)];
      ids.insert(found.pointIds[static_cast<std::size_t>(corner)]);
    }
    const auto at = remaining.find(ids);
    if (at == remaining.end())
    {
      return "vertex " + std::to_string(cell) + " is of other half-spaces";
    }
    for (int i = 0; i < dimension; ++i)
    {
      const double x = found.vertices[static_cast<std::size_t>(cell * dimension + i)];
      if (!isNearest(x, at->second[static_cast<std::size_t>(i)]))
      {
        return "vertex " + std::to_string(cell) + " is not the nearest double";
      }
    }
    remaining.erase(at);
  }
  return "";
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
