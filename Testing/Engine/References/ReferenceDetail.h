// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parts of the references that are written over any space of exact predicates.
#ifndef flipflop_test_ReferenceDetail_h
#define flipflop_test_ReferenceDetail_h

#include "Testing/Engine/References/Reference.h"

#include <algorithm>
#include <numeric>

namespace flipflop
{
namespace test
{

#if defined(__SIZEOF_INT128__)
__extension__ using Int128 = __int128;
#else
using Int128 = mpz_class; // of any size, and slower
#endif

/// The integer as an Int, which has room for it.
template <class Int>
Int narrow(const mpz_class& x)
{
  Int result = 0;
  const mpz_class size = abs(x);
  for (int shift = 120; shift >= 0; shift -= 30) // a long may have 32 bits
  {
    const mpz_class digit = (size >> shift) % (1 << 30);
    result = result * (1 << 30) + digit.get_si();
  }
  return sgn(x) < 0 ? static_cast<Int>(-result) : result;
}
template <>
inline mpz_class narrow<mpz_class>(const mpz_class& x)
{
  return x;
}

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

}
}

#endif
