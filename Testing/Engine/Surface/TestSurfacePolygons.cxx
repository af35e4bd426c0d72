// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Polygons become triangles that cover them once, by rationals: convex, concave, with straight
/// corners, in any plane, at any range. Others are named.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/InputMaking.h"

#include <flipflop/SurfacePolygons.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

using Ids = std::vector<std::int64_t>;
using Rational = mpq_class;
using Vector = std::array<Rational, 3>;

PolygonTriangles triangulated(
  const Cloud& points, const std::vector<Ids>& polygons, const Options& options = Options())
{
  Ids corners;
  Ids offsets = { 0 };
  for (const Ids& polygon : polygons)
  {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    offsets.push_back(static_cast<std::int64_t>(corners.size()));
  }
  PolygonView view;
  view.corners = corners.data();
  view.offsets = offsets.data();
  view.count = static_cast<std::int64_t>(polygons.size());
  return triangulatePolygons(viewOf(points), view, options);
}

/// Twice the area, as a vector along the normal.
Vector areaOf(const Cloud& points, const std::int64_t* corners, std::size_t count)
{
  Vector sum;
  const Point& a = points[static_cast<std::size_t>(corners[0])];
  for (std::size_t i = 1; i + 1 < count; ++i)
  {
    const Point& b = points[static_cast<std::size_t>(corners[i])];
    const Point& c = points[static_cast<std::size_t>(corners[i + 1])];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t u = (k + 1) % 3;
      const std::size_t v = (k + 2) % 3;
      sum[k] += (Rational(b[u]) - a[u]) * (Rational(c[v]) - a[v]) -
        (Rational(b[v]) - a[v]) * (Rational(c[u]) - a[u]);
    }
  }
  return sum;
}

/// The triangles of a flat polygon all face its way, and sum to it: so none overlap.
void expectCut(const Cloud& points, const Ids& polygon)
{
  const PolygonTriangles found = triangulated(points, { polygon });
  ASSERT_EQ(found.polygonIds.size(), polygon.size() - 2);
  ASSERT_EQ(found.corners.size(), 3 * (polygon.size() - 2));
  const Vector whole = areaOf(points, polygon.data(), polygon.size());
  Vector sum;
  std::set<std::int64_t> used;
  for (std::size_t t = 0; t < found.polygonIds.size(); ++t)
  {
    EXPECT_EQ(found.polygonIds[t], 0);
    const std::int64_t* const corners = &found.corners[3 * t];
    used.insert(corners, corners + 3);
    const Vector part = areaOf(points, corners, 3);
    Rational along;
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum[k] += part[k];
      along += part[k] * whole[k];
    }
    EXPECT_GT(along, 0);
  }
  EXPECT_EQ(sum, whole);
  EXPECT_EQ(used, std::set<std::int64_t>(polygon.begin(), polygon.end()));
}

Ids idsOf(const Cloud& points)
{
  Ids ids(points.size());
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

/// In each coordinate plane, both ways round, from each first corner, at several scales, and on a
/// slope.
void expectCutEverywhere(const Cloud& flat)
{
  for (const double scale : { 1.0, 0x1p-1000, 0x1p900, 1.0 / 3 })
  {
    for (std::size_t axis = 0; axis < 4; ++axis)
    {
      Cloud points;
      for (const Point& p : flat)
      {
        const double x = scale * p[0];
        const double y = scale * p[1];
        Point q = { { x, y, axis == 3 ? 4 * x - y / 2 : scale } };
        std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(axis % 3), q.end());
        points.push_back(q);
      }
      if (axis == 3 && scale == 1.0 / 3)
      {
        continue; // rounding bends it
      }
      Ids ids = idsOf(points);
      for (std::size_t first = 0; first < ids.size(); ++first)
      {
        expectCut(points, ids);
        expectCut(points, Ids(ids.rbegin(), ids.rend()));
        std::rotate(ids.begin(), ids.begin() + 1, ids.end());
      }
    }
  }
}

const Cloud square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
const Cloud arrow = { { 0, 0, 0 }, { 4, 4, 0 }, { 0, 1, 0 }, { -4, 4, 0 } };
const Cloud withStraightCorners = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 4, 0, 0 }, { 2, 2, 0 },
  { 1, 3, 0 }, { 0, 4, 0 }, { 0, 2, 0 } };
const Cloud comb = { { 0, 0, 0 }, { 7, 0, 0 }, { 7, 5, 0 }, { 6, 5, 0 }, { 6, 1, 0 }, { 5, 1, 0 },
  { 5, 5, 0 }, { 4, 5, 0 }, { 4, 1, 0 }, { 3, 1, 0 }, { 3, 5, 0 }, { 2, 5, 0 }, { 2, 1, 0 },
  { 1, 1, 0 }, { 1, 5, 0 }, { 0, 5, 0 } };

const Cloud spiral = { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 10, 0 }, { 0, 10, 0 }, { 0, 3, 0 },
  { 7, 3, 0 }, { 7, 7, 0 }, { 3, 7, 0 }, { 3, 6, 0 }, { 6, 6, 0 }, { 6, 4, 0 }, { 1, 4, 0 },
  { 1, 9, 0 }, { 9, 9, 0 }, { 9, 1, 0 }, { 5, 1, 0 }, { 0, 1, 0 } };

TEST(SurfacePolygons, Shapes)
{
  for (const Cloud& shape : { square, arrow, withStraightCorners, comb, spiral })
  {
    expectCutEverywhere(shape);
  }
}

/// A convex polygon is the fan from its first corner.
TEST(SurfacePolygons, Fans)
{
  const PolygonTriangles found = triangulated(square, { { 2, 3, 0, 1 }, { 0, 1, 2 } });
  EXPECT_EQ(Ids(found.corners.begin(), found.corners.end()), (Ids{ 2, 3, 0, 2, 0, 1, 0, 1, 2 }));
  EXPECT_EQ(Ids(found.polygonIds.begin(), found.polygonIds.end()), (Ids{ 0, 0, 1 }));
  // A triangle is taken as it is, and so is a polygon that has no place.
  Cloud bad = square;
  bad[1][2] = std::nan("");
  EXPECT_EQ(triangulated(bad, { { 0, 1, 2, 3 } }).polygonIds.size(), 2U);
  EXPECT_EQ(
    triangulated({ { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, { { 0, 1, 2 } }).polygonIds[0], 0);
  EXPECT_EQ(triangulated(square, {}).polygonIds.size(), 0U);
}

/// A polygon that is not flat is cut as it is seen from somewhere, without a fold.
TEST(SurfacePolygons, NotFlat)
{
  Cloud bent = comb;
  Random random(92);
  for (Point& p : bent)
  {
    p[2] = random.uniform(-3, 3);
  }
  const PolygonTriangles found = triangulated(bent, { idsOf(bent) });
  ASSERT_EQ(found.polygonIds.size(), bent.size() - 2);
  Rational sum;
  for (std::size_t t = 0; t < found.polygonIds.size(); ++t)
  {
    const Vector part = areaOf(bent, &found.corners[3 * t], 3);
    EXPECT_GT(part[2], 0);
    sum += part[2];
  }
  EXPECT_EQ(sum, 2 * (7 + 4 * 4));
}

TEST(SurfacePolygons, NotSimple)
{
  const Cloud bowTie = { { 0, 0, 0 }, { 2, 2, 0 }, { 2, 0, 0 }, { 0, 2, 0 } };
  const auto expectNotSimple = [](const Cloud& points, const std::vector<Ids>& polygons,
                                 std::int64_t index, std::int64_t count)
  { expectError([&] { triangulated(points, polygons); }, ErrorCode::NotSimple, index, count); };
  expectNotSimple(bowTie, { { 0, 2, 1, 3 }, { 0, 1, 2, 3 }, { 1, 2, 3, 0 } }, 1, 2);
  // On a line; two corners at one position; a corner on an edge; back on itself.
  expectNotSimple({ { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 } }, { { 0, 1, 2, 3 } }, 0, 1);
  expectNotSimple({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 0, 0 } }, { { 0, 1, 2, 3 } }, 0, 1);
  expectNotSimple({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 2, 0, 0 }, { 0, 4, 0 } },
    { { 0, 1, 2, 3, 4 } }, 0, 1);
  expectNotSimple({ { 0, 0, 0 }, { 4, 0, 0 }, { 2, 0, 0 }, { 2, 4, 0 } }, { { 0, 1, 2, 3 } }, 0, 1);
  // It winds over itself: cutting ears would end with triangles that overlap.
  expectNotSimple({ { 2, 2, 0 }, { 0, 3, 0 }, { 3, 2, 0 }, { 0, 0, 0 }, { 2, 3, 0 }, { 1, 1, 0 } },
    { { 0, 1, 2, 3, 4, 5 } }, 0, 1);
}

using Corner = std::array<std::int64_t, 2>;

std::int64_t turnOf(const Corner& a, const Corner& b, const Corner& c)
{
  const std::int64_t turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return (turn > 0) - (turn < 0);
}

bool isOn(const Corner& p, const Corner& a, const Corner& b)
{
  return turnOf(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
    std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}

/// By all pairs of sides: none has a place in common with another but the corner between them.
bool isSimple(const std::vector<Corner>& p)
{
  const std::size_t count = p.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Corner &a = p[i], &b = p[(i + 1) % count];
    for (std::size_t j = 0; j < count; ++j)
    {
      const Corner &c = p[j], &d = p[(j + 1) % count];
      const bool isNext = j == (i + 1) % count, isBefore = i == (j + 1) % count;
      const bool crosses =
        turnOf(a, b, c) * turnOf(a, b, d) < 0 && turnOf(c, d, a) * turnOf(c, d, b) < 0;
      if (i != j && (crosses || (!isNext && isOn(c, a, b)) || (!isBefore && isOn(d, a, b))))
      {
        return false;
      }
    }
  }
  return true;
}

/// Polygons of few places, and larger ones that are nearly stars, by all pairs of their sides.
TEST(SurfacePolygons, AllPairsOfSidesTellWhichAreSimple)
{
  Random random(93);
  int taken[2] = { 0, 0 };
  for (int run = 0; run < effort(20000); ++run)
  {
    const bool isLarge = run % 8 == 0;
    const int count = isLarge ? random.integer(17, 60) : random.integer(4, 9);
    std::vector<Corner> corners;
    for (int i = 0; i < count; ++i)
    {
      const Point p = onCircle(Turn * i / count, random.integer(20, 400));
      corners.push_back(isLarge
          ? Corner{ static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1]) }
          : Corner{ random.integer(0, 3), random.integer(0, 3) });
    }
    if (isLarge && run % 16 == 0)
    {
      const int first = random.integer(0, count - 3);
      std::swap(corners[static_cast<std::size_t>(first)],
        corners[static_cast<std::size_t>(first + random.integer(1, 2))]);
    }
    Cloud points;
    for (const Corner& corner : corners)
    {
      points.push_back({ { double(corner[0]), double(corner[1]), 0 } });
    }
    const bool isTaken = isSimple(corners);
    ++taken[isTaken];
    if (isTaken)
    {
      expectCut(points, idsOf(points));
    }
    else
    {
      expectError([&] { triangulated(points, { idsOf(points) }); }, ErrorCode::NotSimple, 0, 1);
    }
    ASSERT_FALSE(HasFailure()) << "run " << run;
  }
  EXPECT_GT(taken[0], taken[1]);
  EXPECT_GT(taken[1], effort(20000) / 20);
}

TEST(SurfacePolygons, Errors)
{
  for (const Ids& polygon :
    { Ids{ 0, 1 }, Ids{}, Ids{ 0, 1, 2, 4 }, Ids{ 0, -1, 2 }, Ids{ 0, 1, 2, 1 }, Ids{ 0, 0, 1 } })
  {
    expectError(
      [&] {
        triangulated(square, { { 0, 1, 2 }, polygon, { 0, 1, 2, 3 }, { 5, 6, 7 } });
      },
      ErrorCode::BadTriangle, 1, 2);
  }
  const std::int64_t corners[] = { 0, 1, 2 };
  const std::int64_t offsets[] = { 0, 3, 2 };
  PolygonView view;
  view.corners = corners;
  const auto expectBad = [&]
  { expectError([&] { triangulatePolygons(viewOf(square), view); }, ErrorCode::BadArgument); };
  view.count = 1;
  expectBad();
  view.offsets = offsets;
  view.count = -1;
  expectBad();
  view.count = 2;
  expectBad();
  view.count = 1;
  EXPECT_EQ(triangulatePolygons(viewOf(square), view).polygonIds.size(), 1U);
  view.corners = nullptr;
  expectBad();
}

}
}
}
