// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Intersections of half-spaces from all triples of borders, in rationals.
#ifndef flipflop_test_HalfSpacesByForce_h
#define flipflop_test_HalfSpacesByForce_h

#include <flipflop/HalfSpaces.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

using Row = std::array<double, 4>; ///< normal . x + offset <= 0; in the plane the third is 0
using Exact = std::array<mpq_class, 3>;
using Ids = std::set<std::int64_t>;

struct Expected
{
  Intersection kind = Intersection::Empty;
  std::map<Exact, Ids> vertices; ///< of each the half-spaces with a facet there
};

inline mpq_class excess(const Row& row, const Exact& x)
{
  mpq_class sum(row[3]);
  for (std::size_t i = 0; i < 3; ++i)
  {
    sum += mpq_class(row[i]) * x[i];
  }
  return sum;
}

inline mpq_class determinant(const Exact& a, const Exact& b, const Exact& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

inline Exact difference(const Exact& a, const Exact& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Exact cross(const Exact& a, const Exact& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline bool isZero(const Exact& a)
{
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

/// Of the affine hull; -1: there is no position.
inline int dimensionOf(const std::vector<Exact>& positions)
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
inline std::map<Exact, Ids> meetings(const std::vector<Row>& rows)
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
inline Expected expected(std::vector<Row> rows, int dimension)
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
inline bool isNearest(double found, const mpq_class& exact)
{
  const mpq_class off = abs(mpq_class(found) - exact);
  const double next[2] = { std::nextafter(found, HUGE_VAL), std::nextafter(found, -HUGE_VAL) };
  return off <= abs(mpq_class(next[0]) - exact) && off <= abs(mpq_class(next[1]) - exact);
}

/// What is wrong; empty: nothing.
inline std::string faultOf(
  const std::vector<Row>& rows, int dimension, const HalfSpaceIntersection& found)
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

}
}

#endif
