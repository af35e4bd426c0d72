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
#include <cstdint>
#include <limits>
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

  /// Of points of which one coordinate is the same.
  struct Row
  {
    double level, from, slope, across;

    /// @param along the other coordinate
    double distance(double along, double height) const
    {
      const double size =
        std::fabs((height - this->level) - (this->slope * (along - this->from) + this->across));
      return size <= std::numeric_limits<double>::max() ? size : HUGE_VAL;
    }
  };

  /// @param axis  of the coordinate that is not the same
  /// @param other the one that is
  Row row(int axis, double other) const
  {
    return { this->origin[2], this->origin[axis], this->slope[axis],
      this->slope[1 - axis] * (other - this->origin[1 - axis]) };
  }

  /// How far a point is from the plane; infinite where doubles do not hold it.
  double distance(const Vertex& p) const { return this->row(0, p.x[1]).distance(p.x[0], p.x[2]); }

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
    , origin{ corners.a->x[0], corners.a->x[1], corners.a->x[2] }
    , normal{ k.whole(0), k.whole(0), k.whole(0) }
  {
    const Offset u = this->offset(corners.b->x[0], corners.b->x[1], corners.b->x[2]);
    const Offset v = corners.c ? this->offset(corners.c->x[0], corners.c->x[1], corners.c->x[2])
                               : Offset{ k.whole(0) - u.y, u.x, k.whole(0) };
    this->normal = { u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x };
  }

  /// The height of a point over the plane, rounded to nearest. False: it cannot decide.
  bool height(double x, double y, double z, double& result) const
  {
    return this->k.round(0.0, this->above(x, y, z), this->normal.z, result);
  }

  /// Is it farther from the plane than the tolerance? False: no, or it cannot decide.
  bool isBeyond(double x, double y, double z, double tolerance) const
  {
    const Number above = this->above(x, y, z);
    const Number limit = this->limit(tolerance);
    return this->k.positive(above - limit) | this->k.positive(this->k.whole(0) - above - limit);
  }

  /// Is it nearer? False: no, or it cannot decide.
  bool isWithin(double x, double y, double z, double tolerance) const
  {
    const Number above = this->above(x, y, z);
    const Number limit = this->limit(tolerance);
    return this->k.positive(limit - above) & this->k.positive(limit + above);
  }

private:
  struct Offset
  {
    Number x, y, z;
  };

  Offset offset(double x, double y, double z) const
  {
    return { this->k.difference(x, this->origin[0]), this->k.difference(y, this->origin[1]),
      this->k.difference(z, this->origin[2]) };
  }

  Number above(double x, double y, double z) const
  {
    const Offset w = this->offset(x, y, z);
    return this->normal.x * w.x + this->normal.y * w.y + this->normal.z * w.z;
  }

  Number limit(double tolerance) const
  {
    return this->normal.z * this->k.difference(tolerance, 0.0);
  }

  Arithmetic k;
  double origin[3];
  Offset normal; ///< z: twice the area of the triangle, or the segment's length, squared
};

/// Some points, for vector units.
struct SurfacePoints
{
  static constexpr int Capacity = 64;

  int size = 0;
  std::uint32_t number[Capacity];
  double x[Capacity], y[Capacity], height[Capacity];

  void add(std::uint32_t p, double toX, double toY, double toHeight)
  {
    this->number[this->size] = p;
    this->x[this->size] = toX;
    this->y[this->size] = toY;
    this->height[this->size++] = toHeight;
  }
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
  double height(const double* x) const;

  /// The same of several.
  void heights(const SurfacePoints& some, double* result) const;

  /// Is a point farther from the plane than the tolerance?
  bool isBeyond(const double* x, double tolerance) const
  {
    return !std::isinf(tolerance) &&
      (this->rough.isBeyond(x[0], x[1], x[2], tolerance) ||
        (!this->rough.isWithin(x[0], x[1], x[2], tolerance) &&
          this->isBeyond(x, this->height(x), tolerance)));
  }

  /// The same.
  /// @param rounded its height over the plane, from height()
  bool isBeyond(const double* x, double rounded, double tolerance) const
  {
    // Rounding is monotone.
    const double size = std::fabs(rounded);
    return size == tolerance ? this->isBeyondTie(x, tolerance) : size > tolerance;
  }

  /// Is none of several?
  bool areWithin(const SurfacePoints& some, double tolerance) const;

private:
  /// Made when the rough one does not do.
  const NumberPlane<BoundedArithmetic<>>& quickPlane() const
  {
    if (!this->quick)
    {
      this->quick.emplace(BoundedArithmetic<>(), this->corners);
    }
    return *this->quick;
  }

  bool isLevel(double height) const;
  bool isBeyondTie(const double* x, double tolerance) const;
  ExponentRange range(const double* x, double tolerance) const;

  SurfaceCorners corners;
  NumberPlane<BoundedArithmetic<double>> rough;
  mutable std::optional<NumberPlane<BoundedArithmetic<>>> quick;
};

}

#endif
