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

#include "Predicates/DoubleDouble.h"
#include "Predicates/ErrorBounds.h"
#include "Predicates/Expansion.h"
#include "Predicates/FixedSigns.h"

#include <cmath>

namespace flipflop
{

/// The last row of a determinant, by its point: d of orient3(), c of orient2().
///
///                 | bx - ax   by - ay   bz - az |
///   orient3 = det | cx - ax   cy - ay   cz - az |     orient2 = det | bp - ap   bq - aq |
///                 | dx - ax   dy - ay   dz - az |                   | cp - ap   cq - aq |
///
/// It is a point (Count 1), or four points whose sum stands for their centroid (Count 4), the
/// symbolic kernel point. The coordinates stay the caller's.
template <int Count>
struct DeterminantRow
{
  const double* point[Count];
};

/// (p0 - origin) + ... + (pk - origin) in one coordinate.
FF_HD inline Expansion<2> offset(const DeterminantRow<1>& row, const double* origin, int axis)
{
  return difference(row.point[0][axis], origin[axis]);
}
FF_HD inline Expansion<8> offset(const DeterminantRow<4>& row, const double* origin, int axis)
{
  const double o = origin[axis];
  return sum(sum(difference(row.point[0][axis], o), difference(row.point[1][axis], o)),
    sum(difference(row.point[2][axis], o), difference(row.point[3][axis], o)));
}

/// The minor of two rows in the columns p, q.
FF_HD inline Expansion<16> minor(const Expansion<2>* u, const Expansion<2>* v, int p, int q)
{
  return sum(product(u[p], v[q]), product(u[q], v[p]), -1.0);
}

/// Do the points lie on a line for a reason that comparisons show: it is parallel to an axis, or
/// two of them are at one position?
FF_HD FF_INLINE bool collinearAtAGlance(const double* a, const double* b, const double* c)
{
  int ab = 0, bc = 0, ca = 0, all = 0;
  for (int i = 0; i < 3; ++i)
  {
    const bool x = a[i] == b[i], y = b[i] == c[i], z = c[i] == a[i];
    ab += x ? 1 : 0;
    bc += y ? 1 : 0;
    ca += z ? 1 : 0;
    all += x && y ? 1 : 0;
  }
  return all >= 2 || ab == 3 || bc == 3 || ca == 3;
}

/// Signs in expansions, for coordinates within their range.
struct ExpansionSigns
{
  /// Sign of det[b - a; c - a; d - a]. Most of what the floating-point filter leaves open is not
  /// zero, only small: twice its precision decides, at a fraction of the expansions' cost. What is
  /// zero mostly comes of points on one edge of a box, or fits integers of fixed size.
  template <int Count>
  FF_HD FF_OUTLINED static int orient3(
    const double* a, const double* b, const double* c, const DeterminantRow<Count>& d)
  {
    if (collinearAtAGlance(a, b, c))
    {
      return 0;
    }
    int sign = roundedOrient3(a, b, c, d);
    if (sign != 0 || (Count == 1 && fixedOrient3(a, b, c, d.point[0], sign)))
    {
      return sign;
    }
    Expansion<2> u[3];
    Expansion<2> v[3];
    for (int i = 0; i < 3; ++i)
    {
      u[i] = difference(b[i], a[i]);
      v[i] = difference(c[i], a[i]);
    }
    ProductSum det;
    for (int i = 0; i < 3; ++i)
    {
      det.add(minor(u, v, (i + 1) % 3, (i + 2) % 3), offset(d, a, i));
    }
    return det.sign();
  }

  /// Sign of det[b - a; c - a] in the coordinates p, q, in the same steps.
  template <int Count>
  FF_HD FF_OUTLINED static int orient2(
    const double* a, const double* b, const DeterminantRow<Count>& c, int p, int q)
  {
    int sign;
    if (Count == 1)
    {
      if (filterOrient2(a, b, c.point[0], p, q, sign))
      {
        return sign;
      }
      const DoubleDouble x1 = doubleDifference(b[p], a[p]);
      const DoubleDouble y1 = doubleDifference(b[q], a[q]);
      const DoubleDouble x2 = doubleDifference(c.point[0][p], a[p]);
      const DoubleDouble y2 = doubleDifference(c.point[0][q], a[q]);
      const bool isExact = x1.low == 0 && y1.low == 0 && x2.low == 0 && y2.low == 0;
      if (isExact ? signOfExactMinor(x1.high, y1.high, x2.high, y2.high, sign)
                  : signOfMinor(x1, y1, x2, y2, 0.0, 0.0, sign))
      {
        return sign;
      }
    }
    ProductSum det;
    det.add(offset(c, a, q), difference(b[p], a[p]));
    det.add(offset(c, a, p), difference(b[q], a[q]), -1.0);
    return det.sign();
  }

  /// Sign of x1 * y2 - y1 * x2 in double-double; false when its error bound leaves it open.
  /// @param error1, error2 of y1 and y2
  FF_HD static bool signOfMinor(const DoubleDouble& x1, const DoubleDouble& y1,
    const DoubleDouble& x2, const DoubleDouble& y2, double error1, double error2, int& sign)
  {
    const DoubleDouble left = x1 * y2;
    const DoubleDouble right = y1 * x2;
    const DoubleDouble det = left - right;
    const double most = std::fabs(left.high) + std::fabs(right.high);
    const double bound =
      MinorError * most + MinorSlack * (std::fabs(x1.high) * error2 + std::fabs(x2.high) * error1);
    sign = det.high > 0 ? 1 : -1;
    return most > MinorFloor && most < MinorCeiling && std::fabs(det.high) > bound;
  }

  /// Sign of x1 * y2 - y1 * x2, exactly: rounding is monotone, so where the rounded products
  /// differ, they are in the order of the products; where they do not, the errors are.
  /// @return false: an error may be lost
  FF_HD static bool signOfExactMinor(double x1, double y1, double x2, double y2, int& sign)
  {
    double left, leftError, right, rightError;
    twoProduct(x1, y2, left, leftError);
    twoProduct(y1, x2, right, rightError);
    sign = left > right ? 1 : (left < right ? -1 : 0);
    if (sign == 0)
    {
      sign = leftError > rightError ? 1 : (leftError < rightError ? -1 : 0);
    }
    const double most = std::fabs(left) + std::fabs(right);
    const double least = std::fmin(std::fabs(left), std::fabs(right));
    return most < MinorCeiling && (least > MinorFloor || (most > MinorFloor && least == 0.0));
  }

  /// The same in double; false when the error bound leaves it open. The sign is that of the rounded
  /// value.
  FF_HD FF_INLINE static bool filterOrient2(
    const double* a, const double* b, const double* c, int p, int q, int& sign)
  {
    const double bp = b[p] - a[p], bq = b[q] - a[q];
    const double cp = c[p] - a[p], cq = c[q] - a[q];
    const double left = bp * cq;
    const double right = bq * cp;
    const double det = left - right;
    const double most = std::fabs(left) + std::fabs(right);
    const double error = PlaneError * most;
    sign = det > 0 ? 1 : (det < 0 ? -1 : 0);
    if (most > PlaneFloor && (det > error || det < -error))
    {
      return true;
    }
    // Zero because differences are.
    return (bp == 0 || cq == 0) && (bq == 0 || cp == 0);
  }

  /// Sign of a - b in the coordinate p.
  template <int Count>
  FF_HD FF_OUTLINED static int compare(const double* a, const DeterminantRow<Count>& b, int p)
  {
    return -offset(b, a, p).sign();
  }

  /// Sign of d . (a - b), d a vector.
  static int along(const double* d, const double* a, const double* b)
  {
    ProductSum sum;
    for (int i = 0; i < 3; ++i)
    {
      sum.add(difference(a[i], b[i]), difference(d[i], 0.0));
    }
    return sum.sign();
  }

  /// Sign of |a - b| - |c - d|.
  static int compareDistances(const double* a, const double* b, const double* c, const double* d)
  {
    ProductSum sum;
    for (int i = 0; i < 3; ++i)
    {
      const Expansion<2> u = difference(a[i], b[i]);
      const Expansion<2> v = difference(c[i], d[i]);
      sum.add(u, u);
      sum.add(v, v, -1.0);
    }
    return sum.sign();
  }

private:
  /// orient3 in double-double, or 0 when its error bound leaves it open.
  template <int Count>
  FF_HD FF_OUTLINED FF_FLATTEN static int roundedOrient3(
    const double* a, const double* b, const double* c, const DeterminantRow<Count>& d)
  {
    DoubleDouble u[3], v[3], w[3];
    double bound = 1.0;
    for (int i = 0; i < 3; ++i)
    {
      u[i] = doubleDifference(b[i], a[i]);
      v[i] = doubleDifference(c[i], a[i]);
      w[i] = doubleDifference(d.point[0][i], a[i]);
      double size = std::fabs(w[i].high);
      for (int k = 1; k < Count; ++k)
      {
        const DoubleDouble more = doubleDifference(d.point[k][i], a[i]);
        w[i] = w[i] + more;
        size += std::fabs(more.high);
      }
      size = std::fmax(size, std::fmax(std::fabs(u[i].high), std::fabs(v[i].high)));
      if (!(size >= FilterFloor && size <= FilterCeiling))
      {
        return 0;
      }
      bound *= size;
    }
    const DoubleDouble det = (u[1] * v[2] - u[2] * v[1]) * w[0] +
      (u[2] * v[0] - u[0] * v[2]) * w[1] + (u[0] * v[1] - u[1] * v[0]) * w[2];
    bound *= RoundedDeterminantError;
    return det.high > bound ? 1 : (det.high < -bound ? -1 : 0);
  }
};

}

#endif
