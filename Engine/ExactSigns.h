// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exact stage of the predicates: signs of small determinants, in expansions.
///
/// Points are pointers to three coordinates. The last row of each determinant is a Row: a point, or
/// the sum of four points, which stands for their centroid (the symbolic kernel point). Scaling a
/// row by a positive number does not change a sign, so the centroid is never divided, hence never
/// rounded.
#ifndef flipflop_ExactSigns_h
#define flipflop_ExactSigns_h

#include "Expansion.h"

namespace flipflop
{

template <int Count>
struct Row
{
  const double* point[Count];
};

/// (p0 - origin) + ... + (pk - origin) in one coordinate.
FF_HD inline Expansion<2> offset(const Row<1>& row, const double* origin, int axis)
{
  return difference(row.point[0][axis], origin[axis]);
}
FF_HD inline Expansion<8> offset(const Row<4>& row, const double* origin, int axis)
{
  const double o = origin[axis];
  return sum(sum(difference(row.point[0][axis], o), difference(row.point[1][axis], o)),
    sum(difference(row.point[2][axis], o), difference(row.point[3][axis], o)));
}

/// Signs in expansions, for coordinates within their range.
struct ExpansionSigns
{
  /// Sign of det[b - a; c - a; d - a].
  template <int Count>
  FF_HD static int orient3(const double* a, const double* b, const double* c, const Row<Count>& d)
  {
    Expansion<2> u[3];
    Expansion<2> v[3];
    for (int i = 0; i < 3; ++i)
    {
      u[i] = difference(b[i], a[i]);
      v[i] = difference(c[i], a[i]);
    }
    const auto x = product(minor(u, v, 1, 2), offset(d, a, 0));
    const auto y = product(minor(u, v, 2, 0), offset(d, a, 1));
    const auto z = product(minor(u, v, 0, 1), offset(d, a, 2));
    return sum(sum(x, y), z).sign();
  }

  /// Sign of det[b - a; c - a] in the coordinates p, q.
  template <int Count>
  FF_HD static int orient2(const double* a, const double* b, const Row<Count>& c, int p, int q)
  {
    const auto left = product(offset(c, a, q), difference(b[p], a[p]));
    const auto right = product(offset(c, a, p), difference(b[q], a[q]));
    return sum(left, right, -1.0).sign();
  }

  /// Sign of a - b in the coordinate p.
  template <int Count>
  FF_HD static int compare(const double* a, const Row<Count>& b, int p)
  {
    return -offset(b, a, p).sign();
  }

private:
  FF_HD static Expansion<16> minor(const Expansion<2>* u, const Expansion<2>* v, int p, int q)
  {
    return sum(product(u[p], v[q]), product(u[q], v[p]), -1.0);
  }
};

}

#endif
