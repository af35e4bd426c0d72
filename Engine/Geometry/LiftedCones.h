// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The test of one cone over lifted points, prepared for many points.
///
/// As HullCones.h: each value comes with an error bound, and what lies within it goes to the exact
/// predicates. A cone of points is a triangle of the plane, so its points are within the triangle's
/// bounds: values are small there, and so are their errors. A virtual triangle's cone is a wedge
/// beyond the border.
#ifndef flipflop_LiftedCones_h
#define flipflop_LiftedCones_h

#include "Geometry/LiftedGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{

/// A point relative to another: place and height over the other's (see LiftedSigns).
struct LiftedOffset
{
  double x, y, h;

  LiftedOffset() = default;
  LiftedOffset(double px, double py, double ph)
    : x(px)
    , y(py)
    , h(ph)
  {
  }

  template <bool Weighted>
  static LiftedOffset between(const double* from, const double* p)
  {
    const double dx = p[0] - from[0];
    const double dy = p[1] - from[1];
    return { dx, dy, Weighted ? (p[2] - from[2]) - (dx * dx + dy * dy) : -(dx * dx + dy * dy) };
  }
};

/// The plane through three lifted points, or the vertical plane through two.
struct LiftedNormal
{
  double x, y, h;
  double error; ///< of the value at a point in the triangle's cone

  /// Of two offsets; points of the cone are within them.
  static LiftedNormal across(const LiftedOffset& u, const LiftedOffset& v, double weightReach)
  {
    const double mx = std::max(std::fabs(u.x), std::fabs(v.x));
    const double my = std::max(std::fabs(u.y), std::fabs(v.y));
    const double bound = LiftedError * mx * my * (mx * mx + my * my + weightReach);
    return { u.y * v.h - u.h * v.y, u.h * v.x - u.x * v.h, u.x * v.y - u.y * v.x,
      bound >= LiftedUnderflow ? bound : std::numeric_limits<double>::infinity() };
  }

  /// Upright over an edge's direction: positive to its left. Points are as far as @p reach.
  static LiftedNormal upright(double dx, double dy, const double* reach)
  {
    const double most = std::fabs(dx) * reach[1] + std::fabs(dy) * reach[0];
    return { -dy, dx, 0.0, boundInPlane(most) };
  }

  static double boundInPlane(double most)
  {
    // Below, products lose bits.
    return most > 1e-280 ? PlaneError * (1 + 1e-15) * most
                         : std::numeric_limits<double>::infinity();
  }

  double at(const LiftedOffset& p) const { return this->x * p.x + this->y * p.y + this->h * p.h; }
};

/// How far a point lies above a triangle.
template <bool Weighted>
class LiftedPlane
{
public:
  LiftedPlane() = default;
  LiftedPlane(
    const LiftedGeometry<Weighted>& geometry, const Vertex& a, const Vertex& b, const Vertex& c)
  {
    // An edge of points first, where one corner is virtual.
    const bool isVirtual = ((a.flags | b.flags | c.flags) & VertexVirtual) != 0;
    const bool rotateOnce = isVirtual && (a.flags & VertexVirtual);
    const bool rotateTwice = isVirtual && (b.flags & VertexVirtual);
    const Vertex& first = rotateOnce ? b : (rotateTwice ? c : a);
    const Vertex& second = rotateOnce ? c : (rotateTwice ? a : b);
    for (int i = 0; i < 3; ++i)
    {
      this->origin[i] = first.x[i];
    }
    if (isVirtual)
    {
      const double reach[2] = { geometry.reachOf(0), geometry.reachOf(1) };
      this->normal =
        LiftedNormal::upright(second.x[0] - first.x[0], second.x[1] - first.x[1], reach);
    }
    else
    {
      this->normal = LiftedNormal::across(LiftedOffset::between<Weighted>(a.x, b.x),
        LiftedOffset::between<Weighted>(a.x, c.x), geometry.reachOf(2));
    }
  }

  double height(const double* p) const
  {
    return this->normal.at(LiftedOffset::between<Weighted>(this->origin, p));
  }

  /// height() is off by no more than this, for a point in the triangle's cone.
  double error() const { return this->normal.error; }

private:
  double origin[3];
  LiftedNormal normal;
};

}

#endif
