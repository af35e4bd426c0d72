// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The tests of one cone, or of one split of a cone, prepared for many points.
///
/// Growing moves points from cones to smaller cones. Nearly all these moves are decided by a few
/// products whose planes are computed once a cone; each value comes with an error bound, and what
/// lies within it goes to the exact predicates.
#ifndef flipflop_HullCones_h
#define flipflop_HullCones_h

#include "Geometry/ConeSplit.h"
#include "Geometry/HullGeometry.h"

namespace flipflop
{

namespace detail
{
inline void subtract(const double* a, const double* b, double* result)
{
  for (int i = 0; i < 3; ++i)
  {
    result[i] = a[i] - b[i];
  }
}
inline void cross(const double* u, const double* v, double* result)
{
  result[0] = u[1] * v[2] - u[2] * v[1];
  result[1] = u[2] * v[0] - u[0] * v[2];
  result[2] = u[0] * v[1] - u[1] * v[0];
}
inline double dot(const double* u, const double* v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
}

/// The plane of a triangle: how far a point lies above it, times twice the triangle's area.
class HullPlane
{
public:
  HullPlane() = default;
  HullPlane(const HullGeometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c)
  {
    double u[3], v[3];
    detail::subtract(b.x, a.x, u);
    detail::subtract(c.x, a.x, v);
    detail::cross(u, v, this->normal);
    this->bound = geometry.planeError(u, v);
    for (int i = 0; i < 3; ++i)
    {
      this->origin[i] = a.x[i];
    }
  }

  double height(const double* p) const
  {
    return this->normal[0] * (p[0] - this->origin[0]) + this->normal[1] * (p[1] - this->origin[1]) +
      this->normal[2] * (p[2] - this->origin[2]);
  }

  /// By how much the height grows along a vector.
  double rise(const double* vector) const { return detail::dot(this->normal, vector); }
  double slope(int axis) const { return this->normal[axis]; }

  /// height() of a point, or rise() along a vector within the extent, is off by no more than this.
  double error() const { return this->bound; }

private:
  double normal[3];
  double origin[3];
  double bound;
};

/// The cone of a triangle: through which of its sides a point lies outside.
class HullCone
{
public:
  HullCone() = default;
  HullCone(const HullGeometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c)
    : plane(geometry, a, b, c)
  {
    const Vertex* corner[3] = { &a, &b, &c };
    double ray[3][3];
    for (int i = 0; i < 3; ++i)
    {
      detail::subtract(corner[i]->x, geometry.kernel(), ray[i]);
    }
    for (int i = 0; i < 3; ++i)
    {
      detail::cross(ray[i], ray[(i + 1) % 3], this->side[i]);
    }
  }

  /// det[v(i) - s; v(i+1) - s; p - s], from q = p - s: positive inside.
  double inside(int i, const double* q) const { return detail::dot(this->side[i], q); }

  HullPlane plane;

private:
  double side[3][3];
};

/// The cone of abc split in three by v inside it: child 0 is abv, 1 is bcv, 2 is cav.
class HullSplit
{
public:
  HullSplit(const HullGeometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c,
    const Vertex& v)
    : coneBound(geometry.coneError())
  {
    const Vertex* corner[3] = { &a, &b, &c };
    double axis[3], ray[3], offset[3][3];
    for (int i = 0; i < 3; ++i)
    {
      this->kernel[i] = geometry.kernel()[i];
      this->apex[i] = v.x[i];
    }
    detail::subtract(v.x, this->kernel, axis);
    for (int i = 0; i < 3; ++i)
    {
      detail::subtract(corner[i]->x, this->kernel, ray);
      detail::cross(axis, ray, this->sector[i]);
      detail::subtract(corner[i]->x, v.x, offset[i]);
    }
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      detail::cross(offset[i], offset[j], this->normal[i]);
      this->heightBound[i] = geometry.planeError(offset[i], offset[j]);
    }
  }

  /// The child whose cone holds p, or -1 when that is too close to decide.
  int child(const double* p) const
  {
    const double q[3] = { p[0] - this->kernel[0], p[1] - this->kernel[1], p[2] - this->kernel[2] };
    const double f0 = detail::dot(this->sector[0], q);
    const double f1 = detail::dot(this->sector[1], q);
    const double f2 = detail::dot(this->sector[2], q);
    return childOf(f0, f1, f2, this->coneBound);
  }

  /// How far p lies above a child, times twice its area.
  double height(int child, const double* p) const
  {
    const double q[3] = { p[0] - this->apex[0], p[1] - this->apex[1], p[2] - this->apex[2] };
    return detail::dot(this->normal[child], q);
  }

  /// height() is off by no more than this.
  double heightError(int child) const { return this->heightBound[child]; }

private:
  double kernel[3];
  double apex[3];
  double sector[3][3];
  double normal[3][3];
  double heightBound[3];
  double coneBound;
};

}

#endif
