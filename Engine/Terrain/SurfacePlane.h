// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The plane over a triangle of a terrain, or the line over a segment: how far a point is above it.
///
/// A rounded value chooses which point is the worst. Whether a point is beyond a tolerance, and the
/// distance rounded to nearest, are found in double-double, and near a tie in integers.
#ifndef flipflop_SurfacePlane_h
#define flipflop_SurfacePlane_h

#include "Points/Vertex.h"
#include "Predicates/RoundedFractions.h"

#include <cmath>
#include <optional>

namespace flipflop
{

/// The corners of a cell: of a triangle, counter-clockwise; of a segment two, and null. The third
/// coordinate is the height.
struct SurfaceCorners
{
  const Vertex* a;
  const Vertex* b;
  const Vertex* c;
};

/// In double: for the order alone.
class RoundedPlane
{
public:
  RoundedPlane() = default;

  explicit RoundedPlane(const SurfaceCorners& corners)
    : origin{ corners.a->x[0], corners.a->x[1], corners.a->x[2] }
  {
    const double ux = corners.b->x[0] - this->origin[0];
    const double uy = corners.b->x[1] - this->origin[1];
    const double uz = corners.b->x[2] - this->origin[2];
    const double vx = corners.c ? corners.c->x[0] - this->origin[0] : -uy;
    const double vy = corners.c ? corners.c->x[1] - this->origin[1] : ux;
    const double vz = corners.c ? corners.c->x[2] - this->origin[2] : 0.0;
    const double area = ux * vy - uy * vx;
    // Heights may be as large as doubles are: they are multiplied last.
    this->slope[0] = uz * (vy / area) - vz * (uy / area);
    this->slope[1] = vz * (ux / area) - uz * (vx / area);
  }

  /// How far a point is from the plane; infinite where doubles do not hold it.
  double distance(double x, double y, double height) const
  {
    const double size = std::fabs((height - this->origin[2]) -
      (this->slope[0] * (x - this->origin[0]) + this->slope[1] * (y - this->origin[1])));
    return std::isfinite(size) ? size : HUGE_VAL;
  }

private:
  double origin[3];
  double slope[2];
};

/// In an arithmetic of RoundedFractions.h.
template <class Arithmetic>
class NumberPlane
{
public:
  using Number = typename Arithmetic::Number;

  NumberPlane(const Arithmetic& arithmetic, const SurfaceCorners& corners)
    : k(arithmetic)
    , origin(*corners.a)
    , normal{ k.whole(0), k.whole(0), k.whole(0) }
  {
    const Offset u = this->offset(*corners.b);
    const Offset v =
      corners.c ? this->offset(*corners.c) : Offset{ k.whole(0) - u.y, u.x, k.whole(0) };
    this->normal = { u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x };
  }

  /// The height of a point over the plane, rounded to nearest. False: it cannot decide.
  bool height(const Vertex& p, double& result) const
  {
    return this->k.round(0.0, this->above(p), this->normal.z, result);
  }

  /// The sign of its distance from the plane less the tolerance. False: it cannot decide.
  bool compare(const Vertex& p, double tolerance, int& sign) const
  {
    const Number above = this->above(p);
    const Number limit = this->normal.z * this->k.difference(tolerance, 0.0);
    int side = 0;
    // Where the side is open, both signs are the same, or the distance is as good as 0.
    const bool isKnown = this->k.sign(above, side);
    return isKnown ? this->k.sign(side < 0 ? this->k.whole(0) - above - limit : above - limit, sign)
                   : this->k.sign(above - limit, sign) && sign < 0 &&
        this->k.sign(this->k.whole(0) - above - limit, sign) && sign < 0;
  }

private:
  struct Offset
  {
    Number x, y, z;
  };

  Offset offset(const Vertex& p) const
  {
    return { this->k.difference(p.x[0], this->origin.x[0]),
      this->k.difference(p.x[1], this->origin.x[1]),
      this->k.difference(p.x[2], this->origin.x[2]) };
  }

  Number above(const Vertex& p) const
  {
    const Offset w = this->offset(p);
    return this->normal.x * w.x + this->normal.y * w.y + this->normal.z * w.z;
  }

  Arithmetic k;
  const Vertex& origin;
  Offset normal; ///< z: twice the area of the triangle, or the segment's length, squared
};

/// Exact. For one thread.
class SurfacePlane
{
public:
  explicit SurfacePlane(const SurfaceCorners& given)
    : corners(given)
    , rough(BoundedArithmetic<double>(), given)
  {
  }

  /// The height of a point over the plane, rounded to nearest.
  double height(const Vertex& p) const
  {
    const double level = p.x[2];
    double result = 0.0;
    if ((level == this->corners.a->x[2] && level == this->corners.b->x[2] &&
          (!this->corners.c || level == this->corners.c->x[2])) ||
      this->quickPlane().height(p, result))
    {
      return result;
    }
    decide(this->range(p, 0.0),
      [&](const auto& k) { return planeIn(k, this->corners).height(p, result); });
    return result;
  }

  /// Is a point farther from the plane than the tolerance?
  bool isBeyond(const Vertex& p, double tolerance) const
  {
    int sign = 0;
    return !std::isinf(tolerance) &&
      (this->rough.compare(p, tolerance, sign) ? sign > 0
                                               : this->isBeyond(p, this->height(p), tolerance));
  }

  /// The same.
  /// @param rounded its height over the plane, from height()
  bool isBeyond(const Vertex& p, double rounded, double tolerance) const
  {
    // Rounding is monotone.
    const double size = std::fabs(rounded);
    if (size != tolerance || std::isinf(tolerance))
    {
      return size > tolerance;
    }
    int sign = 0;
    if (!this->quickPlane().compare(p, tolerance, sign))
    {
      inIntegers(this->range(p, tolerance), MostBitsToRound,
        [&](const auto& k) { return planeIn(k, this->corners).compare(p, tolerance, sign); });
    }
    return sign > 0;
  }

private:
  template <class Arithmetic>
  static NumberPlane<Arithmetic> planeIn(const Arithmetic& k, const SurfaceCorners& corners)
  {
    return NumberPlane<Arithmetic>(k, corners);
  }

  /// Made when the rough one does not do.
  const NumberPlane<BoundedArithmetic<>>& quickPlane() const
  {
    if (!this->quick)
    {
      this->quick.emplace(BoundedArithmetic<>(), this->corners);
    }
    return *this->quick;
  }

  ExponentRange range(const Vertex& p, double tolerance) const
  {
    ExponentRange result;
    result.add(tolerance);
    for (const Vertex* v : { this->corners.a, this->corners.b, this->corners.c, &p })
    {
      for (int i = 0; v && i < 3; ++i)
      {
        result.add(v->x[i]);
      }
    }
    return result;
  }

  SurfaceCorners corners;
  NumberPlane<BoundedArithmetic<double>> rough;
  mutable std::optional<NumberPlane<BoundedArithmetic<>>> quick;
};

}

#endif
