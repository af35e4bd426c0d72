// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points and exact determinants for the tests of the predicates.
#ifndef flipflop_test_PredicateCases_h
#define flipflop_test_PredicateCases_h

#include "Geometry/HullGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gmpxx.h>

namespace flipflop
{
namespace test
{

using Row4 = std::array<mpq_class, 4>; ///< x, y, z and the homogeneous coordinate

inline Vertex makeVertex(double x, double y, double z, std::uint32_t id)
{
  Vertex v;
  v.x[0] = x;
  v.x[1] = y;
  v.x[2] = z;
  v.id = id;
  v.flags = 0;
  return v;
}

inline Row4 rowOf(const Vertex& v)
{
  return { mpq_class(v.x[0]), mpq_class(v.x[1]), mpq_class(v.x[2]), mpq_class(1) };
}

template <class Number>
using RowOf = std::array<Number, 4>;

template <class Number>
Number det3(
  const RowOf<Number>& a, const RowOf<Number>& b, const RowOf<Number>& c, int i, int j, int k)
{
  return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
    a[k] * (b[i] * c[j] - b[j] * c[i]);
}

/// The determinant of four homogeneous rows, by its first row.
template <class Number>
Number det4(
  const RowOf<Number>& a, const RowOf<Number>& b, const RowOf<Number>& c, const RowOf<Number>& d)
{
  return a[0] * det3<Number>(b, c, d, 1, 2, 3) - a[1] * det3<Number>(b, c, d, 0, 2, 3) +
    a[2] * det3<Number>(b, c, d, 0, 1, 3) - a[3] * det3<Number>(b, c, d, 0, 1, 2);
}

/// Sign of det[b - a; c - a; p - a].
inline int exactAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
{
  return -sgn(det4(rowOf(a), rowOf(b), rowOf(c), rowOf(p)));
}

/// Sign of det[a - s; b - s; c - s].
inline int exactBeneath(const Vertex& a, const Vertex& b, const Vertex& c, const Row4& s)
{
  return sgn(det4(rowOf(a), rowOf(b), rowOf(c), s));
}

inline double uniform(std::mt19937_64& random)
{
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

/// Below @p limit.
inline int below(std::mt19937_64& random, int limit)
{
  return static_cast<int>(random() % static_cast<unsigned>(limit));
}

/// Move by up to @p steps units in the last place.
inline double nudged(double x, std::mt19937_64& random, int steps)
{
  for (int k = below(random, steps + 1); k > 0; --k)
  {
    x = std::nextafter(x, random() % 2 ? HUGE_VAL : -HUGE_VAL);
  }
  return x;
}

/// @param coordinate double (int axis)
template <class Coordinate>
std::vector<Vertex> fourPoints(const Coordinate& coordinate)
{
  std::vector<Vertex> v(4, makeVertex(0, 0, 0, 0));
  for (std::uint32_t i = 0; i < 4; ++i)
  {
    v[i].id = i;
    for (int axis = 0; axis < 3; ++axis)
    {
      v[i].x[axis] = coordinate(axis);
    }
  }
  return v;
}

inline std::vector<Vertex> randomPoints(std::mt19937_64& random)
{
  return fourPoints([&](int) { return uniform(random); });
}

/// From all large or all small to any mixture; now and then the format's own ends, and two at one
/// position, but for z where @p isPlane.
inline std::vector<Vertex> ofExtremeRange(std::mt19937_64& random, bool isPlane)
{
  const int spreads[3] = { 20, 500, 2090 };
  const int spread = spreads[random() % 3];
  const int base = -1070 + below(random, 2091 - spread);
  std::vector<Vertex> v = fourPoints(
    [&](int)
    {
      const int exponent = std::min(base + below(random, spread), 1023);
      const double x = random() % 6 == 0 ? 0.0 : std::ldexp(uniform(random), exponent);
      return random() % 40 == 0 ? 0x1p-1074 : random() % 40 == 0 ? -1.7976931348623157e308 : x;
    });
  if (random() % 3 == 0)
  {
    const Vertex other = v[random() % 3];
    std::copy(other.x, other.x + (isPlane ? 2 : 3), v[3].x);
  }
  return v;
}

inline CoordinateRange rangeOf(const std::vector<Vertex>& points)
{
  CoordinateRange range;
  for (int i = 0; i < 3; ++i)
  {
    range.low[i] = HUGE_VAL;
    range.high[i] = -HUGE_VAL;
    range.smallest[i] = HUGE_VAL;
    for (const Vertex& v : points)
    {
      range.low[i] = std::fmin(range.low[i], v.x[i]);
      range.high[i] = std::fmax(range.high[i], v.x[i]);
      if (v.x[i] != 0)
      {
        range.smallest[i] = std::fmin(range.smallest[i], std::fabs(v.x[i]));
      }
    }
  }
  return range;
}

/// The geometry that a run on these points (and a kernel point) would use; scales them as the run
/// would.
/// @param lattice that they are on, before
inline HullGeometry geometryOf(std::vector<Vertex>& points, const Lattice& lattice = Lattice())
{
  CoordinateRange range = rangeOf(points);
  const Arithmetic arithmetic = chooseArithmetic(range);
  for (Vertex& v : points)
  {
    for (double& x : v.x)
    {
      x = std::ldexp(x, arithmetic.scaleExponent);
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    range.low[i] = std::ldexp(range.low[i], arithmetic.scaleExponent);
    range.high[i] = std::ldexp(range.high[i], arithmetic.scaleExponent);
  }
  return HullGeometry(
    range, arithmetic, { std::ldexp(lattice.unit, arithmetic.scaleExponent), lattice.everywhere });
}

}
}

#endif
