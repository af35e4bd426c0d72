// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances from hulls by every cell, in numbers of many bits.
#ifndef flipflop_test_ReferenceDistance_h
#define flipflop_test_ReferenceDistance_h

#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include <flipflop/Hull.h>

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace flipflop
{
namespace test
{

constexpr int Bits = 6000; // any two doubles' product, and some
using Real = mpf_class;
using Vector = std::array<Real, 3>;

inline Vector exactly(const Point& p)
{
  return { Real(p[0], Bits), Real(p[1], Bits), Real(p[2], Bits) };
}
inline Vector operator-(const Vector& a, const Vector& b)
{
  return { Real(a[0] - b[0]), Real(a[1] - b[1]), Real(a[2] - b[2]) };
}
inline Real dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b)
{
  return { Real(a[1] * b[2] - a[2] * b[1]), Real(a[2] * b[0] - a[0] * b[2]),
    Real(a[0] * b[1] - a[1] * b[0]) };
}

inline Real squareFromSegment(const Vector& a, const Vector& b, const Vector& x)
{
  const Vector edge = b - a;
  const Real length = dot(edge, edge);
  const Real along = dot(edge, x - a);
  if (along <= 0 || length == 0)
  {
    return dot(x - a, x - a);
  }
  if (along >= length)
  {
    return dot(x - b, x - b);
  }
  return dot(x - a, x - a) - along * along / length;
}

/// The square of the distance from a polygon, its border included.
inline Real squareFromCell(const std::vector<Vector>& cell, const Vector& x)
{
  bool over = cell.size() > 2;
  Vector normal;
  Real least(-1, Bits);
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    const Vector& a = cell[i];
    const Vector& b = cell[(i + 1) % cell.size()];
    if (over)
    {
      normal = i == 0 ? cross(cell[1] - cell[0], cell[2] - cell[0]) : normal;
      over = dot(normal, cross(b - a, x - a)) >= 0;
    }
    const Real square = squareFromSegment(a, b, x);
    least = least < 0 || square < least ? square : least;
  }
  if (over)
  {
    const Real height = dot(normal, x - cell[0]);
    least = height * height / dot(normal, normal);
  }
  return least;
}

/// Is a place of a polygon on its border? Exact. (Squares of distances are not: a quotient is in
/// them.)
inline bool isOnBorder(const std::vector<std::vector<Vector>>& edges, const Vector& x)
{
  for (const std::vector<Vector>& edge : edges)
  {
    const Vector turn = cross(edge[1] - edge[0], x - edge[0]);
    if (turn[0] == 0 && turn[1] == 0 && turn[2] == 0)
    {
      return true;
    }
  }
  return false;
}

/// The corners of each cell.
inline std::vector<std::vector<Vector>> cornersOf(const Hull& hull, const Cloud& cloud)
{
  std::vector<std::vector<Vector>> cells;
  for (const Cell& cell : cellsOf(hull))
  {
    cells.emplace_back();
    for (const std::int64_t id : cell)
    {
      cells.back().push_back(exactly(cloud[static_cast<std::size_t>(id)]));
    }
  }
  return cells;
}

/// The squares of the distances to the nearest cell and to the farthest corner.
inline void squaresFromCells(
  const std::vector<std::vector<Vector>>& cells, const Vector& x, Real& least, Real& farthest)
{
  least = Real(-1, Bits);
  farthest = Real(0, Bits);
  for (const std::vector<Vector>& cell : cells)
  {
    const Real square = squareFromCell(cell, x);
    least = least < 0 || square < least ? square : least;
    for (const Vector& corner : cell)
    {
      const Real far = dot(x - corner, x - corner);
      farthest = far > farthest ? far : farthest;
    }
  }
}

/// Is a distance, but for its sign, as near to the wanted one as is promised? Infinite, where no
/// double is so large.
inline bool isDistance(double found, const Real& square, const Real& farthestSquare)
{
  const Real wanted = sqrt(square);
  if (std::isinf(found))
  {
    return wanted * (1 + 1e-14) >= Real(std::numeric_limits<double>::max(), Bits);
  }
  const Real off = abs(Real(std::fabs(found), Bits) - wanted);
  return off <= 1e-14 * Real(sqrt(farthestSquare)) + Real(5e-324, Bits);
}

}
}

#endif
