// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact signs for the tests, on GMP integers and sharing nothing with the engine: a double is an
/// integer times a power of two, and one common power for a whole cloud leaves every sign as it is.
#ifndef flipflop_test_Exact_h
#define flipflop_test_Exact_h

#include "Testing/Engine/Inputs/Cloud.h"

#include <array>
#include <cstdint>
#include <vector>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

/// Every coordinate of a cloud is an integer of at most @c bits bits times 2^exponent.
struct Scale
{
  int exponent = 0;
  int bits = 0;
};
Scale commonScale(const Cloud& cloud);

/// The integer k with x = k * 2^exponent.
mpz_class toInteger(double x, int exponent);

template <class Int>
int sign(const Int& x)
{
  return (x > 0) - (x < 0);
}

/// The sign of a determinant of three rows of differences, or of its first two columns' minor of
/// two; 0 where rounding leaves it open, or where a product may overflow or underflow.
/// @param size of the terms that the third column is the rounded sum of
int filteredSign(const double (&rows)[3][3], const double (&size)[3]);
int filteredSign(const double (&rows)[2][2]);

/// The predicates that a reference needs, over integer points of type Int.
template <class Int>
class IntegerSpace
{
public:
  using Vector = std::array<Int, 3>;

  explicit IntegerSpace(std::vector<Vector> points)
    : Points(std::move(points))
  {
  }

  int size() const { return static_cast<int>(this->Points.size()); }

  /// Positive when l lies where the normal (j - i) x (k - i) points.
  int orient(int i, int j, int k, int l) const
  {
    const Vector u = this->difference(j, i);
    const Vector v = this->difference(k, i);
    const Vector w = this->difference(l, i);
    const Int det = u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
      u[2] * (v[0] * w[1] - v[1] * w[0]);
    return sign(det);
  }

  /// The sign of component @p axis of the normal (j - i) x (k - i).
  int normal(int axis, int i, int j, int k) const
  {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    const Vector& p = this->Points[i];
    const Vector& q = this->Points[j];
    const Vector& r = this->Points[k];
    const Int det = (q[a] - p[a]) * (r[b] - p[b]) - (q[b] - p[b]) * (r[a] - p[a]);
    return sign(det);
  }

  int compare(int axis, int i, int j) const
  {
    const Int& a = this->Points[i][axis];
    const Int& b = this->Points[j][axis];
    return (a > b) - (a < b);
  }

private:
  Vector difference(int i, int j) const
  {
    const Vector& p = this->Points[i];
    const Vector& q = this->Points[j];
    return { Int(p[0] - q[0]), Int(p[1] - q[1]), Int(p[2] - q[2]) };
  }

  std::vector<Vector> Points;
};

/// The same over doubles: a cautious floating-point filter, then integers made on the spot.
class FilteredSpace
{
public:
  explicit FilteredSpace(const Cloud& cloud);

  int size() const { return static_cast<int>(this->Points.size()); }
  int orient(int i, int j, int k, int l) const;
  int normal(int axis, int i, int j, int k) const;
  int compare(int axis, int i, int j) const
  {
    const double a = this->Points[i][axis];
    const double b = this->Points[j][axis];
    return (a > b) - (a < b);
  }

private:
  mpz_class integer(double x) const { return toInteger(x, this->Exponent); }

  const Cloud& Points;
  int Exponent;
};

}
}

#endif
