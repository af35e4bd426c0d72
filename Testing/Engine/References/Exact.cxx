// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/References/Exact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{
namespace test
{

namespace
{

/// x = mantissa * 2^exponent with an odd mantissa, for x not zero.
struct Parts
{
  std::int64_t mantissa;
  int exponent;
};

Parts split(double x)
{
  int exponent = 0;
  std::int64_t mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  exponent -= 53;
  while (mantissa % 2 == 0)
  {
    mantissa /= 2;
    ++exponent;
  }
  return { mantissa, exponent };
}

/// Differences in this range neither overflow nor underflow in a product of three.
bool safe(double x)
{
  const double a = std::fabs(x);
  return a == 0 || (a > 1e-90 && a < 1e90);
}

}

Scale commonScale(const Cloud& cloud)
{
  int low = std::numeric_limits<int>::max();
  int high = std::numeric_limits<int>::min();
  for (const Point& p : cloud)
  {
    for (double x : p)
    {
      if (x != 0)
      {
        low = std::min(low, split(x).exponent);
        high = std::max(high, std::ilogb(x) + 1);
      }
    }
  }
  return low > high ? Scale{} : Scale{ low, high - low };
}

mpz_class toInteger(double x, int exponent)
{
  if (x == 0)
  {
    return 0;
  }
  const Parts parts = split(x);
  mpz_class result(static_cast<double>(parts.mantissa)); // of 53 bits
  mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), parts.exponent - exponent);
  return result;
}

FilteredSpace::FilteredSpace(const Cloud& cloud)
  : Points(cloud)
  , Exponent(commonScale(cloud).exponent)
{
}

int FilteredSpace::orient(int i, int j, int k, int l) const
{
  const Point& p = this->Points[i];
  const Point* ends[3] = { &this->Points[j], &this->Points[k], &this->Points[l] };
  double d[3][3];
  bool inRange = true;
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      d[r][c] = (*ends[r])[c] - p[c];
      inRange = inRange && safe(d[r][c]);
    }
  }
  if (inRange)
  {
    double det = 0;
    double permanent = 0;
    for (int c = 0; c < 3; ++c)
    {
      const int a = (c + 1) % 3;
      const int b = (c + 2) % 3;
      const double m = d[1][a] * d[2][b];
      const double n = d[1][b] * d[2][a];
      det += d[0][c] * (m - n);
      permanent += std::fabs(d[0][c]) * (std::fabs(m) + std::fabs(n));
    }
    // Twice the classical bound of about 7 units in the last place.
    if (std::fabs(det) > 2e-15 * permanent)
    {
      return det > 0 ? 1 : -1;
    }
  }
  std::vector<IntegerSpace<mpz_class>::Vector> four;
  for (int v : { i, j, k, l })
  {
    const Point& q = this->Points[v];
    four.push_back({ this->integer(q[0]), this->integer(q[1]), this->integer(q[2]) });
  }
  return IntegerSpace<mpz_class>(std::move(four)).orient(0, 1, 2, 3);
}

int FilteredSpace::normal(int axis, int i, int j, int k) const
{
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  const Point& p = this->Points[i];
  const Point& q = this->Points[j];
  const Point& r = this->Points[k];
  const double ua = q[a] - p[a];
  const double ub = q[b] - p[b];
  const double va = r[a] - p[a];
  const double vb = r[b] - p[b];
  if (safe(ua) && safe(ub) && safe(va) && safe(vb))
  {
    const double m = ua * vb;
    const double n = ub * va;
    if (std::fabs(m - n) > 2e-15 * (std::fabs(m) + std::fabs(n)))
    {
      return m > n ? 1 : -1;
    }
  }
  const mpz_class pa = this->integer(p[a]);
  const mpz_class pb = this->integer(p[b]);
  const mpz_class det = (this->integer(q[a]) - pa) * (this->integer(r[b]) - pb) -
    (this->integer(q[b]) - pb) * (this->integer(r[a]) - pa);
  return sgn(det);
}

}
}
