// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/References/Lift.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace test
{

namespace
{

/// Products of two such differences and a height neither overflow nor underflow.
bool safe(double x, double low, double high)
{
  const double a = std::fabs(x);
  return a == 0 || (a > low && a < high);
}

/// Ten times what the roundings of a determinant of lifted differences can add up to.
constexpr double Bound = 2e-14;

}

LiftScale liftScale(const Cloud& weighted)
{
  Cloud flat = weighted;
  Cloud heights = weighted;
  for (std::size_t i = 0; i < weighted.size(); ++i)
  {
    flat[i][2] = 0;
    heights[i][0] = heights[i][1] = 0;
  }
  const Scale plane = commonScale(flat);
  const Scale weight = commonScale(heights);
  LiftScale result;
  // Half the weights' exponent, rounded down.
  const int half = (weight.exponent - (weight.exponent & 1)) / 2;
  result.exponent = plane.bits == 0 ? half
    : weight.bits == 0              ? plane.exponent
                                    : std::min(plane.exponent, half);
  result.bits = plane.bits == 0 ? 0 : plane.exponent + plane.bits - result.exponent;
  const int weightBits = weight.bits == 0 ? 0 : weight.exponent + weight.bits - 2 * result.exponent;
  result.heightBits = std::max(2 * result.bits + 1, weightBits) + 1;
  return result;
}

IntegerSpace<mpz_class>::Vector liftOf(const Point& weighted, int exponent)
{
  const mpz_class x = toInteger(weighted[0], exponent);
  const mpz_class y = toInteger(weighted[1], exponent);
  return { x, y, mpz_class(x * x + y * y - toInteger(weighted[2], 2 * exponent)) };
}

int LiftedSpace::orient(int i, int j, int k, int l) const
{
  const Point& p = this->Points[i];
  const Point* ends[3] = { &this->Points[j], &this->Points[k], &this->Points[l] };
  double d[3][3];
  double size[3]; // of the height's terms
  bool inRange = safe(p[2], 1e-90, 1e90);
  for (int r = 0; r < 3; ++r)
  {
    const Point& q = *ends[r];
    d[r][0] = q[0] - p[0];
    d[r][1] = q[1] - p[1];
    inRange = inRange && safe(d[r][0], 1e-45, 1e45) && safe(d[r][1], 1e-45, 1e45) &&
      safe(q[2], 1e-90, 1e90);
    const double square = d[r][0] * d[r][0] + d[r][1] * d[r][1];
    d[r][2] = square + (p[2] - q[2]);
    size[r] = square + std::fabs(p[2]) + std::fabs(q[2]);
  }
  if (inRange)
  {
    double det = 0;
    double permanent = 0;
    for (int r = 0; r < 3; ++r)
    {
      const double* u = d[(r + 1) % 3];
      const double* v = d[(r + 2) % 3];
      const double m = u[0] * v[1];
      const double n = u[1] * v[0];
      det += d[r][2] * (m - n);
      permanent += size[r] * (std::fabs(m) + std::fabs(n));
    }
    if (std::fabs(det) > Bound * permanent)
    {
      return det > 0 ? 1 : -1;
    }
  }
  std::vector<IntegerSpace<mpz_class>::Vector> four;
  for (int v : { i, j, k, l })
  {
    four.push_back(liftOf(this->Points[v], this->Exponent));
  }
  return IntegerSpace<mpz_class>(std::move(four)).orient(0, 1, 2, 3);
}

int LiftedSpace::turn(int i, int j, int k) const
{
  const Point& p = this->Points[i];
  const Point& q = this->Points[j];
  const Point& r = this->Points[k];
  const double d[4] = { q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1] };
  if (std::all_of(d, d + 4, [](double x) { return safe(x, 1e-90, 1e90); }))
  {
    const double m = d[0] * d[3];
    const double n = d[1] * d[2];
    if (std::fabs(m - n) > Bound * (std::fabs(m) + std::fabs(n)))
    {
      return m > n ? 1 : -1;
    }
  }
  mpz_class c[3][2];
  const int ids[3] = { i, j, k };
  for (int v = 0; v < 3; ++v)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      c[v][axis] = toInteger(this->Points[ids[v]][axis], this->Exponent);
    }
  }
  const mpz_class det =
    (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
  return sgn(det);
}

}
}
