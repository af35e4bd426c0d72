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

/// In this range a product of four neither overflows nor underflows.
bool isOrdinary(double x)
{
  const double a = std::fabs(x);
  return a == 0 || (a > 1e-70 && a < 1e70);
}

/// Ten times what the roundings of a determinant can add up to.
constexpr double Bound = 2e-14;

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

int filteredSign(const double (&rows)[3][3], const double (&size)[3])
{
  double det = 0;
  double permanent = 0;
  for (int r = 0; r < 3; ++r)
  {
    const double* u = rows[(r + 1) % 3];
    const double* v = rows[(r + 2) % 3];
    if (!isOrdinary(rows[r][0]) || !isOrdinary(rows[r][1]) || !isOrdinary(size[r]))
    {
      return 0;
    }
    const double m = u[0] * v[1];
    const double n = u[1] * v[0];
    det += rows[r][2] * (m - n);
    permanent += size[r] * (std::fabs(m) + std::fabs(n));
  }
  return std::fabs(det) > Bound * permanent ? sign(det) : 0;
}

int filteredSign(const double (&rows)[2][2])
{
  const double m = rows[0][0] * rows[1][1];
  const double n = rows[0][1] * rows[1][0];
  for (const auto& row : rows)
  {
    if (!isOrdinary(row[0]) || !isOrdinary(row[1]))
    {
      return 0;
    }
  }
  return std::fabs(m - n) > Bound * (std::fabs(m) + std::fabs(n)) ? sign(m - n) : 0;
}

FilteredSpace::FilteredSpace(const Cloud& cloud)
  : Points(cloud)
  , Exponent(commonScale(cloud).exponent)
{
}

int FilteredSpace::orient(int i, int j, int k, int l) const
{
  const Point& p = this->Points[i];
  const int ends[3] = { j, k, l };
  double d[3][3];
  double size[3];
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      d[r][c] = this->Points[ends[r]][c] - p[c];
    }
    size[r] = std::fabs(d[r][2]);
  }
  if (const int found = filteredSign(d, size))
  {
    return found;
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
  const double d[2][2] = { { q[a] - p[a], q[b] - p[b] }, { r[a] - p[a], r[b] - p[b] } };
  if (const int found = filteredSign(d))
  {
    return found;
  }
  const mpz_class pa = this->integer(p[a]);
  const mpz_class pb = this->integer(p[b]);
  const mpz_class det = (this->integer(q[a]) - pa) * (this->integer(r[b]) - pb) -
    (this->integer(q[b]) - pb) * (this->integer(r[a]) - pa);
  return sgn(det);
}

}
}
