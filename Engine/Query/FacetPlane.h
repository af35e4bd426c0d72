// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The plane of a triangle, its normal a unit vector: rounded, but from exact minors, so that it is
/// right in each component however thin the triangle is: where expansions lose bits to underflow,
/// in integers of any size.
#ifndef flipflop_FacetPlane_h
#define flipflop_FacetPlane_h

#include "Geometry/Extents.h"
#include "Predicates/ExactSigns.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

struct FacetPlane
{
  double normal[3] = { 0, 0, 0 }; ///< outward, where the triangle is counter-clockwise from outside
  double offset = 0;              ///< normal . x + offset is the height of x above the plane

  FacetPlane() = default;

  /// @param a, b, c not on a line
  FacetPlane(const double* a, const double* b, const double* c)
  {
    Expansion<2> u[3], v[3];
    edge(a, b, u);
    edge(a, c, v);
    double largest = 0;
    for (int i = 0; i < 3; ++i)
    {
      const Expansion<16> exact = minor(u, v, (i + 1) % 3, (i + 2) % 3);
      for (int k = 0; k < exact.length; ++k)
      {
        this->normal[i] += exact.component[k];
      }
      largest = std::max(largest, std::fabs(this->normal[i]));
    }
    // Both edges are about one. What products lose to underflow is less than 2^-1060.
    constexpr double Thinnest = 0x1p-120;
    largest = largest < Thinnest ? wideNormal(a, b, c, this->normal) : largest;
    double square = 0;
    for (double& n : this->normal)
    {
      n = largest > 0 ? std::ldexp(n, -std::ilogb(largest)) : 0.0;
      square += n * n;
    }
    const double length = std::sqrt(square);
    const double most = largestOf(a[0], a[1], a[2]);
    const int exponent = most > 0 ? std::ilogb(most) : 0;
    DoubleDouble sum = { 0, 0 };
    for (int i = 0; i < 3; ++i)
    {
      this->normal[i] = length > 0 ? this->normal[i] / length : 0.0;
      sum =
        sum + DoubleDouble{ this->normal[i], 0 } * DoubleDouble{ std::ldexp(a[i], -exponent), 0 };
    }
    this->offset = 0.0 - std::ldexp(sum.high, exponent);
  }

  double height(const double* x) const
  {
    return this->normal[0] * x[0] + this->normal[1] * x[1] + this->normal[2] * x[2] + this->offset;
  }

private:
  /// The normal, of any length.
  /// @return its largest component; 0: the points are on a line
  static double wideNormal(const double* a, const double* b, const double* c, double* normal);

  /// From a to b, times a power of two that makes it about as long as one.
  static void edge(const double* a, const double* b, Expansion<2>* result)
  {
    double longest = 0;
    for (int i = 0; i < 3; ++i)
    {
      longest = std::max(longest, std::fabs(b[i] - a[i]));
    }
    const double scale = longest > 0x1p1000 ? 0.5 : 1.0; // against overflow
    longest = std::isfinite(longest) ? longest : 0x1p1023;
    const int exponent = longest > 0 ? -std::ilogb(longest) : 0;
    for (int i = 0; i < 3; ++i)
    {
      result[i] = difference(scale * b[i], scale * a[i]);
      for (int k = 0; k < result[i].length; ++k)
      {
        result[i].component[k] = std::ldexp(result[i].component[k], exponent);
      }
    }
  }
};

}

#endif
