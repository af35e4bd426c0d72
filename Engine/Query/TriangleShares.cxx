// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/TriangleShares.h"

#include "Predicates/DoubleDouble.h"
#include "Predicates/ErrorBounds.h"
#include "Support/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

namespace
{

/// A cross product, and the sum of its terms' magnitudes.
struct Area
{
  DoubleDouble value;
  double most;
};

/// u x v. Products of low parts are left out.
FF_INLINE Area cross(const DoubleDouble* u, const DoubleDouble* v)
{
  double left, leftLow, right, rightLow, high, low;
  twoProduct(u[0].high, v[1].high, left, leftLow);
  twoProduct(u[1].high, v[0].high, right, rightLow);
  twoSum(left, -right, high, low);
  low += (leftLow - rightLow) +
    ((u[0].high * v[1].low + u[0].low * v[1].high) - (u[1].high * v[0].low + u[1].low * v[0].high));
  Area area;
  area.value.high = high + low;
  area.value.low = low - (area.value.high - high);
  area.most = std::fabs(left) + std::fabs(right);
  return area;
}

/// Is an area right to far more than a double's places? It is if no product has lost bits, either.
FF_INLINE double surplus(const Area& area)
{
  constexpr double Least = 0x1p-900;
  constexpr double Most = 0x1p900;
  const double high = area.value.high;
  const double few = std::min(high - PlaneValueShare * area.most, high - Least);
  return std::min(few, Most - area.most);
}

FF_VECTOR_CLONES
void computeShares(const double (*given)[TriangleShares::Capacity],
  double (*shares)[TriangleShares::Capacity], double* done)
{
  for (int i = 0; i < TriangleShares::Capacity; ++i)
  {
    DoubleDouble to[3][2];
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        to[corner][axis] = doubleDifference(given[2 * corner + axis][i], given[6 + axis][i]);
      }
    }
    const Area a = cross(to[1], to[2]);
    const Area b = cross(to[2], to[0]);
    const Area c = cross(to[0], to[1]);
    double some, someLow, all, allLow;
    twoSum(a.value.high, b.value.high, some, someLow);
    twoSum(some, c.value.high, all, allLow);
    all += (someLow + allLow) + (a.value.low + b.value.low + c.value.low);
    shares[0][i] = a.value.high / all;
    shares[1][i] = b.value.high / all;
    shares[2][i] = c.value.high / all;
    done[i] = std::min(std::min(surplus(a), surplus(b)), surplus(c));
  }
}

}

void TriangleShares::compute()
{
  computeShares(this->given, this->shares, this->done);
}

}
