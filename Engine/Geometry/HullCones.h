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
#include "Points/Vector3.h"

namespace flipflop
{

/// The plane of a triangle: how far a point lies above it, times twice the triangle's area.
class HullPlane
{
public:
  HullPlane() = default;
  HullPlane(const HullGeometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c)
    : origin{ { a.x[0], a.x[1], a.x[2] } }
  {
    const Vector3 u = subtract(b.x, a.x);
    const Vector3 v = subtract(c.x, a.x);
    this->normal = cross(u, v);
    this->bound = geometry.planeError(u.x, v.x);
  }

  double height(const double* p) const { return dot(this->normal, subtract(p, this->origin)); }

  /// By how much the height grows along a vector.
  double rise(const double* vector) const { return dot(this->normal, vector); }
  double slope(int axis) const { return this->normal[axis]; }

  /// height() of a point, or rise() along a vector within the extent, is off by no more than this.
  double error() const { return this->bound; }

private:
  Vector3 normal;
  Vector3 origin;
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
    Vector3 ray[3];
    for (int i = 0; i < 3; ++i)
    {
      ray[i] = subtract(corner[i]->x, geometry.kernel());
    }
    for (int i = 0; i < 3; ++i)
    {
      this->side[i] = cross(ray[i], ray[(i + 1) % 3]);
    }
  }

  /// det[v(i) - s; v(i+1) - s; p - s], from q = p - s: positive inside.
  double inside(int i, const double* q) const { return dot(this->side[i], q); }

  HullPlane plane;

private:
  Vector3 side[3];
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
    Vector3 offset[3];
    for (int i = 0; i < 3; ++i)
    {
      this->kernel[i] = geometry.kernel()[i];
      this->apex[i] = v.x[i];
    }
    const Vector3 axis = subtract(v.x, this->kernel);
    for (int i = 0; i < 3; ++i)
    {
      this->sector[i] = cross(axis, subtract(corner[i]->x, this->kernel));
      offset[i] = subtract(corner[i]->x, v.x);
    }
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      this->normal[i] = cross(offset[i], offset[j]);
      this->heightBound[i] = geometry.planeError(offset[i].x, offset[j].x);
    }
  }

  /// The child whose cone holds p, or -1 when that is too close to decide.
  int child(const double* p) const
  {
    const Vector3 q = subtract(p, this->kernel);
    const double f0 = dot(this->sector[0], q);
    const double f1 = dot(this->sector[1], q);
    const double f2 = dot(this->sector[2], q);
    return childOf(f0, f1, f2, this->coneBound);
  }

  /// How far p lies above a child, times twice its area.
  double height(int child, const double* p) const
  {
    return dot(this->normal[child], subtract(p, this->apex));
  }

  /// height() is off by no more than this.
  double heightError(int child) const { return this->heightBound[child]; }

private:
  Vector3 kernel;
  Vector3 apex;
  Vector3 sector[3];
  Vector3 normal[3];
  double heightBound[3];
  double coneBound;
};

}

#endif
