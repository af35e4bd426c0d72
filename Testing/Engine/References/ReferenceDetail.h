// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parts of the references that are written over any space of exact predicates.
#ifndef flipflop_test_ReferenceDetail_h
#define flipflop_test_ReferenceDetail_h

#include "Testing/Engine/References/Lift.h"
#include "Testing/Engine/References/Reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace flipflop
{
namespace test
{

__extension__ using Int128 = __int128;

template <class Space>
bool lexicographicLess(const Space& space, int i, int j)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (const int c = space.compare(axis, i, j))
    {
      return c < 0;
    }
  }
  return false;
}

/// One point for every position, the lowest; ascending.
template <class Space>
std::vector<int> distinct(const Space& space)
{
  std::vector<int> order(space.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int i, int j) { return lexicographicLess(space, i, j); });
  order.erase(std::unique(order.begin(), order.end(),
                [&](int i, int j) { return !lexicographicLess(space, i, j); }),
    order.end());
  std::sort(order.begin(), order.end());
  return order;
}

/// Affinely independent points among distinct ones, as many as there are.
template <class Space>
std::vector<int> basis(const Space& space, const std::vector<int>& points)
{
  std::vector<int> found;
  for (int p : points)
  {
    bool independent = true;
    if (found.size() == 2)
    {
      independent = space.normal(0, found[0], found[1], p) != 0 ||
        space.normal(1, found[0], found[1], p) != 0 || space.normal(2, found[0], found[1], p) != 0;
    }
    else if (found.size() == 3)
    {
      independent = space.orient(found[0], found[1], found[2], p) != 0;
    }
    if (independent)
    {
      found.push_back(p);
    }
    if (found.size() == 4)
    {
      break;
    }
  }
  return found;
}

/// The strictly extreme ones of coplanar points, counter-clockwise as seen from where
/// (j - i) x (k - i) points to, which must not be zero.
template <class Space>
std::vector<int> planarHull(const Space& space, std::vector<int> points, int i, int j, int k)
{
  int axis = 0;
  int turn = 0;
  for (axis = 0; axis < 3; ++axis)
  {
    turn = space.normal(axis, i, j, k);
    if (turn != 0)
    {
      break;
    }
  }
  std::sort(points.begin(), points.end(),
    [&](int p, int q)
    {
      const int c = space.compare((axis + 1) % 3, p, q);
      return c != 0 ? c < 0 : space.compare((axis + 2) % 3, p, q) < 0;
    });
  std::vector<int> chain;
  const auto walk = [&](auto first, auto last)
  {
    const std::size_t base = chain.size();
    for (auto it = first; it != last; ++it)
    {
      while (chain.size() >= base + 2 &&
        space.normal(axis, chain[chain.size() - 2], chain.back(), *it) <= 0)
      {
        chain.pop_back();
      }
      chain.push_back(*it);
    }
    chain.pop_back();
  };
  walk(points.begin(), points.end());
  walk(points.rbegin(), points.rend());
  if (turn < 0)
  {
    std::reverse(chain.begin(), chain.end());
  }
  return chain;
}

/// Fill in the ids from the cells, and put all into order.
inline void finish(ReferenceHull& hull)
{
  canonicalise(hull.cells);
  hull.ids = idsIn(hull.cells);
}

/// The hull of distinct points that span less than space; basis has at most three points.
template <class Space>
ReferenceHull flatHull(
  const Space& space, const std::vector<int>& points, const std::vector<int>& base)
{
  ReferenceHull hull;
  hull.dimension = static_cast<int>(base.size()) - 1;
  std::vector<int> cell = base;
  if (hull.dimension == 1)
  {
    const auto ends = std::minmax_element(
      points.begin(), points.end(), [&](int i, int j) { return lexicographicLess(space, i, j); });
    cell = { *ends.first, *ends.second };
  }
  else if (hull.dimension == 2)
  {
    cell = planarHull(space, points, base[0], base[1], base[2]);
    int up = 0;
    for (int axis = 2; axis >= 0 && up == 0; --axis)
    {
      up = space.normal(axis, base[0], base[1], base[2]);
    }
    if (up < 0)
    {
      std::reverse(cell.begin(), cell.end());
    }
  }
  if (hull.dimension >= 0)
  {
    hull.cells.emplace_back(cell.begin(), cell.end());
  }
  finish(hull);
  return hull;
}

/// Of lifted points over one line, or position: the lower chain, by a scan along it.
template <class Space>
std::vector<Cell> chain(const Space& space, std::vector<int> points)
{
  std::sort(
    points.begin(), points.end(), [&](int i, int j) { return lexicographicLess(space, i, j); });
  const bool upright = points.empty() || space.compare(0, points.front(), points.back()) == 0;
  std::vector<int> visible;
  for (int p : points)
  {
    // Of one position, the lowest lift comes first.
    if (!visible.empty() && space.compare(0, visible.back(), p) == 0 &&
      space.compare(1, visible.back(), p) == 0)
    {
      continue;
    }
    while (visible.size() >= 2)
    {
      const int i = visible[visible.size() - 2];
      const int j = visible.back();
      if ((upright ? space.normal(0, i, j, p) : -space.normal(1, i, j, p)) > 0)
      {
        break;
      }
      visible.pop_back();
    }
    visible.push_back(p);
  }
  std::vector<Cell> cells;
  if (visible.size() == 1)
  {
    cells.push_back({ visible[0] });
  }
  for (std::size_t i = 1; i < visible.size(); ++i)
  {
    cells.push_back({ visible[i - 1], visible[i] });
  }
  return cells;
}

/// @param facing int (i, j, k, side): is what these three support a facet, as seen so (1) or the
///               other way round (-1), if all other points are at that side of it, or on it?
template <class Space, class Facing>
std::vector<Cell> facetsOf(const Space& space, const std::vector<int>& points, const Facing& facing)
{
  std::vector<Cell> cells;
  std::set<std::vector<int>> found;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      for (std::size_t k = j + 1; k < n; ++k)
      {
        const int a = points[i], b = points[j], c = points[k];
        int side = 0;
        bool supporting = true;
        std::vector<int> on;
        for (std::size_t l = 0; l < n && supporting; ++l)
        {
          const int o = space.orient(a, b, c, points[l]);
          if (o == 0)
          {
            on.push_back(points[l]);
          }
          supporting = o == 0 || side == 0 || o == side;
          side = o != 0 ? o : side;
        }
        const int way = supporting ? facing(a, b, c, side) : 0;
        if (way != 0 && found.insert(on).second)
        {
          const std::vector<int> polygon =
            planarHull(space, on, a, way > 0 ? b : c, way > 0 ? c : b);
          cells.emplace_back(polygon.begin(), polygon.end());
        }
      }
    }
  }
  return cells;
}

/// What @p find gives of all points, or of their lifts, in the narrowest integers that hold the
/// determinants. Small ones are seen from the first point: nothing depends on the place.
/// @param find ReferenceHull (const IntegerSpace<Int>&)
template <class Find>
ReferenceHull inIntegers(const Cloud& cloud, bool lifted, const Find& find)
{
  const LiftScale lift = lifted ? liftScale(cloud) : LiftScale();
  const Scale scale = lifted ? Scale{ lift.exponent, lift.bits } : commonScale(cloud);
  const auto findWide = [&]
  {
    std::vector<IntegerSpace<mpz_class>::Vector> points;
    for (const Point& p : cloud)
    {
      const auto at = [&](std::size_t k) { return toInteger(p[k], scale.exponent); };
      points.push_back(lifted ? liftOf(p, scale.exponent)
                              : IntegerSpace<mpz_class>::Vector{ at(0), at(1), at(2) });
    }
    return find(IntegerSpace<mpz_class>(std::move(points)));
  };
  if (scale.bits > 60 || lift.heightBits > 118)
  {
    return findWide();
  }
  std::vector<IntegerSpace<Int128>::Vector> points;
  Int128 widest[2] = { 0, 0 }; // of x and y; of z
  for (const Point& p : cloud)
  {
    const auto at = [&](std::size_t k, int times)
    { return static_cast<Int128>(std::ldexp(p[k], -times * scale.exponent)); };
    IntegerSpace<Int128>::Vector q = { at(0, 1), at(1, 1), at(2, lifted ? 2 : 1) };
    for (std::size_t k = 0; k < (lifted ? 2 : 3); ++k)
    {
      q[k] -= static_cast<Int128>(std::ldexp(cloud[0][k], -scale.exponent));
    }
    q[2] = lifted ? q[0] * q[0] + q[1] * q[1] - q[2] : q[2];
    for (std::size_t k = 0; k < 3; ++k)
    {
      widest[k / 2] = std::max(widest[k / 2], q[k] < 0 ? -q[k] : q[k]);
    }
    points.push_back(q);
  }
  // A determinant is the sum of six products of three differences.
  int bits = 3 + 3;
  for (; widest[0] > 0; widest[0] /= 2)
  {
    bits += 2;
  }
  for (; widest[1] > 0; widest[1] /= 2)
  {
    ++bits;
  }
  if (bits > 63)
  {
    return bits > 126 ? findWide() : find(IntegerSpace<Int128>(std::move(points)));
  }
  std::vector<IntegerSpace<std::int64_t>::Vector> narrow;
  for (const auto& p : points)
  {
    narrow.push_back({ static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1]),
      static_cast<std::int64_t>(p[2]) });
  }
  return find(IntegerSpace<std::int64_t>(std::move(narrow)));
}

}
}

#endif
