// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Weighted points and their exact lifts, for the tests of the predicates on them.
#ifndef flipflop_test_LiftedCases_h
#define flipflop_test_LiftedCases_h

#include "Geometry/LiftedGeometry.h"
#include "Testing/Engine/Predicates/PredicateCases.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace flipflop
{
namespace test
{

/// The geometry that a run on these weighted points would use; scales them as the run would. The
/// virtual vertex may be among them.
template <bool Weighted>
LiftedGeometry<Weighted> liftedGeometryOf(
  std::vector<Vertex>& points, const Lattice& lattice = Lattice(), bool* wide = nullptr)
{
  CoordinateRange range = rangeOf(points);
  const Arithmetic arithmetic = chooseLiftedArithmetic(range);
  for (int i = 0; i < 3; ++i)
  {
    const int exponent = (i == 2 ? 2 : 1) * arithmetic.scaleExponent;
    for (Vertex& v : points)
    {
      v.x[i] = std::ldexp(v.x[i], exponent);
    }
    range.low[i] = std::ldexp(range.low[i], exponent);
    range.high[i] = std::ldexp(range.high[i], exponent);
  }
  if (wide)
  {
    *wide = arithmetic.wide;
  }
  return LiftedGeometry<Weighted>(
    range, arithmetic, { std::ldexp(lattice.unit, arithmetic.scaleExponent), lattice.everywhere });
}

/// The same signs, and the determinants themselves, in integers: places in units of 2^-bits,
/// heights in units of 2^-2bits. The virtual vertex is straight down, in homogeneous coordinates.
class ExactLift
{
public:
  using IntegerRow = RowOf<mpz_class>;

  explicit ExactLift(const std::vector<Vertex>& points)
  {
    for (const Vertex& v : points)
    {
      this->include(v);
    }
  }

  void setKernel(const double* s)
  {
    this->kernelParts = { makeVertex(s[0], s[1], 0, 0) };
    this->include(this->kernelParts[0]);
  }

  void setSymbolicKernel(const Vertex* corners) { this->kernelParts.assign(corners, corners + 4); }

  /// (x, y, height, 1).
  IntegerRow rowOf(const Vertex& v) const
  {
    if (v.flags & VertexVirtual)
    {
      return { 0, 0, -1, 0 };
    }
    IntegerRow row = { integer(v.x[0], this->bits), integer(v.x[1], this->bits), 0, 1 };
    row[2] = integer(v.x[2], 2 * this->bits) - row[0] * row[0] - row[1] * row[1];
    return row;
  }

  int above(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    return sgn(this->determinant(a, b, c, p));
  }

  /// det[b - a; c - a; p - a].
  mpq_class height(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    const bool isVirtual = ((a.flags | b.flags | c.flags | p.flags) & VertexVirtual) != 0;
    mpq_class result(this->determinant(a, b, c, p));
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(),
      static_cast<mp_bitcnt_t>((isVirtual ? 2 : 4) * this->bits));
    return result;
  }

  int orient(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return sgn(det3<mpz_class>(this->rowOf(a), this->rowOf(b), this->rowOf(c), 0, 1, 3));
  }

  /// Seen from all points alike, the kernel point is straight down too; but the virtual vertex is
  /// below it.
  int kernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    IntegerRow s = { 0, 0, -1, 0 };
    if ((a.flags | b.flags | c.flags) & VertexVirtual)
    {
      s[2] = 0;
      for (const Vertex& part : this->kernelParts)
      {
        s[0] += integer(part.x[0], this->bits);
        s[1] += integer(part.x[1], this->bits);
        s[3] += 1;
      }
    }
    return sgn(det4<mpz_class>(this->rowOf(a), this->rowOf(b), this->rowOf(c), s));
  }

  /// Is b, on the line of a and c, above the line through their lifts?
  bool isAboveChord(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const IntegerRow p = this->rowOf(a), q = this->rowOf(b), r = this->rowOf(c);
    const int axis = p[0] == r[0] ? 1 : 0;
    const mpz_class whole = r[axis] - p[axis], part = q[axis] - p[axis];
    return (q[2] - p[2]) * whole * whole > (r[2] - p[2]) * part * whole;
  }

  /// |q - a|^2 - a's weight, less the same of b.
  int comparePowers(const Vertex& q, const Vertex& a, const Vertex& b) const
  {
    const IntegerRow p = this->rowOf(q), u = this->rowOf(a), v = this->rowOf(b);
    return sgn(mpz_class(2 * p[0] * (v[0] - u[0]) + 2 * p[1] * (v[1] - u[1]) + v[2] - u[2]));
  }

  /// Do the lifts lie on a line?
  bool collinear(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const IntegerRow p = this->rowOf(a), q = this->rowOf(b), r = this->rowOf(c);
    return det3<mpz_class>(p, q, r, 0, 1, 3) == 0 && det3<mpz_class>(p, q, r, 1, 2, 3) == 0 &&
      det3<mpz_class>(p, q, r, 2, 0, 3) == 0;
  }

private:
  mpz_class determinant(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    return -det4<mpz_class>(this->rowOf(a), this->rowOf(b), this->rowOf(c), this->rowOf(p));
  }

  /// value * 2^shift, which must be whole.
  static mpz_class integer(double value, int shift)
  {
    int exponent = 0;
    mpz_class result(std::ldexp(std::frexp(value, &exponent), 53));
    const int left = exponent - 53 + shift;
    if (left >= 0)
    {
      mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(left));
    }
    else
    {
      mpz_tdiv_q_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(-left));
    }
    return result;
  }

  /// The least shift for which it is whole.
  static int fractionBits(double value)
  {
    if (value == 0)
    {
      return 0;
    }
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    int zeros = 0;
    while (!(mantissa >> zeros & 1))
    {
      ++zeros;
    }
    return std::max(0, 53 - exponent - zeros);
  }

  void include(const Vertex& v)
  {
    if (!(v.flags & VertexVirtual))
    {
      this->bits = std::max(
        { this->bits, fractionBits(v.x[0]), fractionBits(v.x[1]), (fractionBits(v.x[2]) + 1) / 2 });
    }
  }

  int bits = 0;
  std::vector<Vertex> kernelParts;
};

}
}

#endif
