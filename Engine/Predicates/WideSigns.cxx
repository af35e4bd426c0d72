// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Each sign is one formula over differences of coordinates, or of coordinates and heights.
#include "Predicates/WideSigns.h"

#include "Predicates/WideIntegers.h"

namespace flipflop
{

namespace
{

using Integer = WideInteger;
using Offset = Integer (*)(const double* point, const double* origin, int axis);

/// Of the sum of a row's points.
template <int Count>
Integer offsetOf(Offset offset, const DeterminantRow<Count>& row, const double* origin, int axis)
{
  Integer result = 0;
  for (const double* point : row.point)
  {
    result += offset(point, origin, axis);
  }
  return result;
}

template <int Count>
int signOfOrient3(
  Offset offset, const double* a, const double* b, const double* c, const DeterminantRow<Count>& d)
{
  Integer u[3], v[3], w[3];
  for (int i = 0; i < 3; ++i)
  {
    u[i] = offset(b, a, i);
    v[i] = offset(c, a, i);
    w[i] = offsetOf(offset, d, a, i);
  }
  const Integer det = (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
    (u[0] * v[1] - u[1] * v[0]) * w[2];
  return det.sign();
}

template <int Count>
int signOfOrient2(
  Offset offset, const double* a, const double* b, const DeterminantRow<Count>& c, int p, int q)
{
  const Integer det =
    offset(b, a, p) * offsetOf(offset, c, a, q) - offset(b, a, q) * offsetOf(offset, c, a, p);
  return det.sign();
}

}

template <int Count>
int WideSigns::orient3(
  const double* a, const double* b, const double* c, const DeterminantRow<Count>& d)
{
  return signOfOrient3(wideOffset, a, b, c, d);
}

template <int Count>
int WideSigns::orient2(
  const double* a, const double* b, const DeterminantRow<Count>& c, int p, int q)
{
  return signOfOrient2(wideOffset, a, b, c, p, q);
}

template <int Count>
int WideSigns::compare(const double* a, const DeterminantRow<Count>& b, int p)
{
  return -offsetOf(wideOffset, b, a, p).sign();
}

using Point = DeterminantRow<1>;
using FourPoints = DeterminantRow<4>;
template int WideSigns::orient3(const double*, const double*, const double*, const Point&);
template int WideSigns::orient3(const double*, const double*, const double*, const FourPoints&);
template int WideSigns::orient2(const double*, const double*, const Point&, int, int);
template int WideSigns::orient2(const double*, const double*, const FourPoints&, int, int);
template int WideSigns::compare(const double*, const Point&, int);
template int WideSigns::compare(const double*, const FourPoints&, int);

int WideSigns::along(const double* d, const double* a, const double* b)
{
  Integer sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    sum += toInteger(d[i]) * wideOffset(a, b, i);
  }
  return sum.sign();
}

int WideSigns::compareDistances(const double* a, const double* b, const double* c, const double* d)
{
  Integer sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Integer u = wideOffset(a, b, i);
    const Integer v = wideOffset(c, d, i);
    sum += u * u - v * v;
  }
  return sum.sign();
}

int WideLiftedSigns::orient3(
  const double* a, const double* b, const double* c, const DeterminantRow<1>& d)
{
  return signOfOrient3(liftedOffset, a, b, c, d);
}

int WideLiftedSigns::orient2(
  const double* a, const double* b, const DeterminantRow<1>& c, int p, int q)
{
  return signOfOrient2(liftedOffset, a, b, c, p, q);
}

int WideLiftedSigns::compare(const double* a, const DeterminantRow<1>& b, int p)
{
  return -offsetOf(liftedOffset, b, a, p).sign();
}

/// Of the power distance of q from a, less that from b.
int WideLiftedSigns::comparePowers(const double* q, const double* a, const double* b)
{
  Integer sum = wideOffset(b, a, 2) << 1074; // the squares' unit
  for (int i = 0; i < 2; ++i)
  {
    sum += wideOffset(a, b, i) * (wideOffset(a, q, i) + wideOffset(b, q, i));
  }
  return sum.sign();
}

}
