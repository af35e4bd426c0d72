// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which triangles are good, which vertices encroach upon a segment, and where a point is put to
/// divide a bad triangle.
///
/// Whether a triangle is good is decided exactly. What is inserted where is only chosen: there,
/// values are rounded.
#ifndef flipflop_TriangleQuality_h
#define flipflop_TriangleQuality_h

#include "Predicates/RoundedFractions.h"

#include <cmath>

namespace flipflop
{

struct Offset
{
  double x, y;

  Offset(const double* from, const double* to)
    : x(to[0] - from[0])
    , y(to[1] - from[1])
  {
  }

  double square() const { return this->x * this->x + this->y * this->y; }
  double dot(const Offset& other) const { return this->x * other.x + this->y * other.y; }
  double cross(const Offset& other) const { return this->x * other.y - this->y * other.x; }
};

/// A least angle, in degrees.
class AngleBound
{
public:
  explicit AngleBound(double degrees)
    : cosine(cosineOf(degrees))
    , square(this->cosine * this->cosine)
    , lens((2 * this->square - 1) * (2 * this->square - 1))
    , reach(0.475 * std::sqrt((1 + this->cosine) / (1 - this->cosine)))
  {
  }

  /// The square of its cosine.
  double cosineSquare() const { return this->square; }

  /// Is the angle between two edges less? Rounded.
  bool isLess(const Offset& u, const Offset& v) const
  {
    const double dot = u.dot(v);
    return dot > 0 && dot * dot > this->square * u.square() * v.square();
  }

  /// Does a vertex see a segment under an angle of more than 180 degrees less twice the bound?
  /// (L. P. Chew's lens: J. R. Shewchuk, "Delaunay refinement algorithms for triangular mesh
  /// generation", 2002, section 5)
  bool isInLens(const Offset& toA, const Offset& toB) const
  {
    const double dot = toA.dot(toB);
    return dot < 0 && dot * dot >= this->lens * toA.square() * toB.square();
  }

  /// From the middle of the shortest edge, in its lengths, how far away a new point may be (A.
  /// Uengoer, "Off-centers", 2004; by 0.475 instead of a half, as J. R. Shewchuk's Triangle has
  /// it).
  double farthest() const { return this->reach; }

private:
  /// The same on all machines: by the series.
  static double cosineOf(double degrees)
  {
    const double angle = degrees * (3.14159265358979323846 / 180);
    double term = 1;
    double sum = 1;
    for (int n = 1; n < 15; ++n)
    {
      term *= -angle * angle / ((2 * n - 1) * (2 * n));
      sum += term;
    }
    return sum;
  }

  double cosine, square, lens, reach;
};

/// Three corners, from the one that the shortest edge begins at.
struct ShapedTriangle
{
  const double* corner[3];
  int first;        ///< of the given ones it is corner[0]
  double square[3]; ///< of the lengths of its edges, from the shortest on

  ShapedTriangle(const double* a, const double* b, const double* c)
  {
    const double* const given[3] = { a, b, c };
    const double all[3] = { Offset(a, b).square(), Offset(b, c).square(), Offset(c, a).square() };
    this->first = all[0] <= all[1] && all[0] <= all[2] ? 0 : all[1] <= all[2] ? 1 : 2;
    for (int i = 0; i < 3; ++i)
    {
      this->corner[i] = given[(this->first + i) % 3];
      this->square[i] = all[(this->first + i) % 3];
    }
  }

  /// Is the angle at the last corner, its least, less than a bound?
  bool hasLess(const AngleBound& bound) const
  {
    const auto isLess = [&](const auto& k, int& sign)
    {
      const auto ux = k.difference(this->corner[0][0], this->corner[2][0]);
      const auto uy = k.difference(this->corner[0][1], this->corner[2][1]);
      const auto vx = k.difference(this->corner[1][0], this->corner[2][0]);
      const auto vy = k.difference(this->corner[1][1], this->corner[2][1]);
      const auto dot = ux * vx + uy * vy;
      const auto most =
        k.difference(bound.cosineSquare(), 0.0) * (ux * ux + uy * uy) * (vx * vx + vy * vy);
      return k.sign(k.difference(1.0, 0.0) * dot * dot - most, sign);
    };
    return exactSign(isLess,
             [&]
             {
               ExponentRange range = this->range();
               range.add(1.0);
               range.add(bound.cosineSquare());
               return range;
             }) > 0;
  }

  bool isLarger(double area) const
  {
    if (std::isinf(area))
    {
      return false;
    }
    const auto isLarger = [&](const auto& k, int& sign)
    {
      const auto ux = k.difference(this->corner[1][0], this->corner[0][0]);
      const auto uy = k.difference(this->corner[1][1], this->corner[0][1]);
      const auto vx = k.difference(this->corner[2][0], this->corner[0][0]);
      const auto vy = k.difference(this->corner[2][1], this->corner[0][1]);
      return k.sign(ux * vy - uy * vx - k.difference(2 * area, 0.0, 2), sign);
    };
    return exactSign(isLarger,
             [&]
             {
               ExponentRange range = this->range();
               int exponent = 0;
               std::frexp(area, &exponent);
               range.add(std::min((exponent - 54) / 2 - 1, 0), exponent / 2 + 2);
               return range;
             }) > 0;
  }

  /// The center of its circle, or what is nearer on the bisector of the shortest edge.
  void center(const AngleBound& bound, double* result) const
  {
    const Offset edge(this->corner[0], this->corner[1]);
    const Offset other(this->corner[0], this->corner[2]);
    const double area = edge.cross(other);
    const double shares[2] = { edge.square() / (2 * area), other.square() / (2 * area) };
    double x = other.y * shares[0] - edge.y * shares[1];
    double y = edge.x * shares[1] - other.x * shares[0];
    const double offX = 0.5 * edge.x - bound.farthest() * edge.y;
    const double offY = 0.5 * edge.y + bound.farthest() * edge.x;
    const double off = offX * offX + offY * offY;
    if (std::isfinite(off) && !(area > 0 && x * x + y * y <= off))
    {
      x = offX;
      y = offY;
    }
    result[0] = this->corner[0][0] + x;
    result[1] = this->corner[0][1] + y;
  }

private:
  ExponentRange range() const
  {
    ExponentRange result;
    for (const double* const x : this->corner)
    {
      result.add(x[0]);
      result.add(x[1]);
    }
    return result;
  }
};

}

#endif
