// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Predicates/WideSigns.h"

#include "Predicates/WideIntegers.h"

namespace flipflop
{

namespace
{

using Integer = WideInteger;
using flipflop::wideOffset;

template <int Count>
Integer wideOffset(const DeterminantRow<Count>& row, const double* origin, int axis)
{
  Integer result = 0;
  for (const double* point : row.point)
  {
    result += wideOffset(point, origin, axis);
  }
  return result;
}

int signOfDeterminant(const Integer* u, const Integer* v, const Integer* w)
{
  const Integer det = (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
    (u[0] * v[1] - u[1] * v[0]) * w[2];
  return det.sign();
}

template <int Count>
int wideOrient3(const double* a, const double* b, const double* c, const DeterminantRow<Count>& d)
{
  Integer u[3], v[3], w[3];
  for (int i = 0; i < 3; ++i)
  {
    u[i] = wideOffset(b, a, i);
    v[i] = wideOffset(c, a, i);
    w[i] = wideOffset(d, a, i);
  }
  return signOfDeterminant(u, v, w);
}

template <int Count>
int wideOrient2(const double* a, const double* b, const DeterminantRow<Count>& c, int p, int q)
{
  const Integer det =
    wideOffset(b, a, p) * wideOffset(c, a, q) - wideOffset(b, a, q) * wideOffset(c, a, p);
  return det.sign();
}

}

int WideSigns::orient3(
  const double* a, const double* b, const double* c, const DeterminantRow<1>& d)
{
  return wideOrient3(a, b, c, d);
}

int WideSigns::orient3(
  const double* a, const double* b, const double* c, const DeterminantRow<4>& d)
{
  return wideOrient3(a, b, c, d);
}

int WideSigns::orient2(const double* a, const double* b, const DeterminantRow<1>& c, int p, int q)
{
  return wideOrient2(a, b, c, p, q);
}

int WideSigns::orient2(const double* a, const double* b, const DeterminantRow<4>& c, int p, int q)
{
  return wideOrient2(a, b, c, p, q);
}

int WideSigns::compare(const double* a, const DeterminantRow<1>& b, int p)
{
  return -wideOffset(b, a, p).sign();
}

int WideSigns::compare(const double* a, const DeterminantRow<4>& b, int p)
{
  return -wideOffset(b, a, p).sign();
}

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
  Integer u[3], v[3], w[3];
  for (int i = 0; i < 3; ++i)
  {
    u[i] = liftedOffset(b, a, i);
    v[i] = liftedOffset(c, a, i);
    w[i] = liftedOffset(d.point[0], a, i);
  }
  return signOfDeterminant(u, v, w);
}

int WideLiftedSigns::orient2(
  const double* a, const double* b, const DeterminantRow<1>& c, int p, int q)
{
  const double* const d = c.point[0];
  const Integer det =
    liftedOffset(b, a, p) * liftedOffset(d, a, q) - liftedOffset(b, a, q) * liftedOffset(d, a, p);
  return det.sign();
}

int WideLiftedSigns::comparePowers(const double* q, const double* a, const double* b)
{
  return wideDifferenceOfPowers(q, a, b).sign();
}

int WideLiftedSigns::compare(const double* a, const DeterminantRow<1>& b, int p)
{
  return -liftedOffset(b.point[0], a, p).sign();
}

}
