// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/References/ReferenceTriangulation.h"
#include "Testing/Engine/References/Lift.h"
#include "Testing/Engine/References/ReferenceDetail.h"

#include <set>

namespace flipflop
{
namespace test
{

namespace
{

/// What the positions span.
template <class Space>
int dimensionOf(const Space& space, const std::vector<int>& points)
{
  int dimension = points.empty() ? -1 : 0;
  int second = -1;
  for (int p : points)
  {
    if (dimension == 0 && (space.compare(0, points[0], p) || space.compare(1, points[0], p)))
    {
      dimension = 1;
      second = p;
    }
    else if (dimension == 1 && space.normal(2, points[0], second, p))
    {
      return 2;
    }
  }
  return dimension;
}

/// The visible ones of points on a line: each point against every pair around it.
template <class Space>
void chain(const Space& space, const std::vector<int>& points, ReferenceTriangulation& result)
{
  const int along = std::any_of(points.begin(), points.end(),
                      [&](int p) { return space.compare(0, points[0], p) != 0; })
    ? 0
    : 1;
  const auto before = [&](int i, int j) { return space.compare(along, i, j) < 0; };
  // Is k on or above the line from i to j, i before j?
  const auto above = [&](int i, int j, int k)
  { return (along == 0 ? -space.normal(1, i, j, k) : space.normal(0, i, j, k)) >= 0; };
  std::vector<int> visible;
  for (int p : points)
  {
    bool hidden = false;
    for (int i : points)
    {
      hidden = hidden || (!before(i, p) && !before(p, i) && space.compare(2, i, p) < 0);
      for (int j : points)
      {
        hidden = hidden || (before(i, p) && before(p, j) && above(i, j, p));
      }
    }
    if (!hidden)
    {
      visible.push_back(p);
    }
  }
  std::sort(visible.begin(), visible.end(), before);
  for (std::size_t i = 1; i < visible.size(); ++i)
  {
    result.cells.push_back({ visible[i - 1], visible[i] });
  }
}

/// @p space holds the lifts.
template <class Space>
ReferenceTriangulation bruteForce(const Space& space)
{
  const std::vector<int> points = distinct(space);
  ReferenceTriangulation result;
  result.dimension = dimensionOf(space, points);
  if (result.dimension == 0)
  {
    result.cells.push_back({ *std::min_element(
      points.begin(), points.end(), [&](int i, int j) { return space.compare(2, i, j) < 0; }) });
  }
  else if (result.dimension == 1)
  {
    chain(space, points, result);
  }
  const int n = result.dimension < 2 ? 0 : static_cast<int>(points.size());
  std::set<std::vector<int>> facets;
  for (int i = 0; i < n; ++i)
  {
    for (int j = i + 1; j < n; ++j)
    {
      for (int k = j + 1; k < n; ++k)
      {
        const int turn = space.normal(2, points[i], points[j], points[k]);
        if (turn == 0)
        {
          continue;
        }
        const int a = points[i];
        const int b = points[turn > 0 ? j : k];
        const int c = points[turn > 0 ? k : j];
        bool supporting = true;
        std::vector<int> on;
        for (int l = 0; l < n && supporting; ++l)
        {
          const int o = space.orient(a, b, c, points[l]);
          if (o == 0)
          {
            on.push_back(points[l]);
          }
          supporting = o >= 0;
        }
        if (supporting && facets.insert(on).second)
        {
          const std::vector<int> polygon = planarHull(space, on, a, b, c);
          result.cells.emplace_back(polygon.begin(), polygon.end());
        }
      }
    }
  }
  finish(result);
  return result;
}

template <class Int>
ReferenceTriangulation bruteForceAs(const Cloud& weighted, int exponent)
{
  std::vector<typename IntegerSpace<Int>::Vector> points;
  points.reserve(weighted.size());
  for (const Point& p : weighted)
  {
    const IntegerSpace<mpz_class>::Vector lift = liftOf(p, exponent);
    points.push_back({ narrow<Int>(lift[0]), narrow<Int>(lift[1]), narrow<Int>(lift[2]) });
  }
  return bruteForce(IntegerSpace<Int>(std::move(points)));
}

}

ReferenceTriangulation bruteForceTriangulation(const Cloud& weighted)
{
  // Six products of two differences in the plane and one in height.
  const LiftScale scale = liftScale(weighted);
  const int bits = 2 * (scale.bits + 1) + scale.heightBits + 1 + 3;
  return bits <= 126 && scale.heightBits <= 118 ? bruteForceAs<Int128>(weighted, scale.exponent)
                                                : bruteForceAs<mpz_class>(weighted, scale.exponent);
}

ReferenceTriangulation bruteForceTriangulation(
  const std::vector<std::array<std::int64_t, 3>>& weighted)
{
  std::vector<std::array<std::int64_t, 3>> lifts = weighted;
  for (auto& p : lifts)
  {
    p[2] = p[0] * p[0] + p[1] * p[1] - p[2];
  }
  return bruteForce(IntegerSpace<std::int64_t>(std::move(lifts)));
}

CgalKernel kernelForWeighted(const Cloud& weighted)
{
  const LiftScale scale = liftScale(weighted);
  const bool extreme = scale.bits > 300 || scale.heightBits > 600 || scale.exponent < -300 ||
    scale.exponent + scale.bits > 200 || 2 * scale.exponent + scale.heightBits > 400;
  return extreme ? CgalKernel::Rational : CgalKernel::Inexact;
}

Cell hiddenIds(std::int64_t count, const Cell& ids)
{
  Cell hidden;
  auto next = ids.begin();
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (next != ids.end() && *next == i)
    {
      ++next;
    }
    else
    {
      hidden.push_back(i);
    }
  }
  return hidden;
}

}
}
