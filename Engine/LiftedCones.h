// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The tests of one cone, or of one split of a cone, over lifted points, prepared for many points.
///
/// As HullCones.h: each value comes with an error bound, and what lies within it goes to the exact
/// predicates. A cone of points is a triangle of the plane, so its points are within the triangle's
/// bounds: values are small there, and so are their errors. A virtual triangle's cone is a wedge
/// beyond the border.
#ifndef flipflop_LiftedCones_h
#define flipflop_LiftedCones_h

#include "GrowthRule.h"
#include "LiftedGeometry.h"

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

/// The cone of abc split in three by v inside it: child 0 is abv, 1 is bcv, 2 is cav.
template <bool Weighted>
class LiftedSplit
{
public:
  LiftedSplit(const LiftedGeometry<Weighted>& geometry, const Vertex& a, const Vertex& b,
    const Vertex& c, const Vertex& v)
  {
    const Vertex* corner[3] = { &a, &b, &c };
    for (int i = 0; i < 3; ++i)
    {
      this->apex[i] = v.x[i];
    }
    LiftedOffset offset[3];
    double most[2] = { 0.0, 0.0 };
    bool isVirtual = false;
    for (int i = 0; i < 3; ++i)
    {
      if (corner[i]->flags & VertexVirtual)
      {
        // The line from the kernel point's place through v.
        offset[i] = { v.x[0] - geometry.kernel()[0], v.x[1] - geometry.kernel()[1], 0.0 };
        isVirtual = true;
      }
      else
      {
        offset[i] = LiftedOffset::between<Weighted>(v.x, corner[i]->x);
      }
      this->sector[i][0] = offset[i].x;
      this->sector[i][1] = offset[i].y;
      most[0] = std::max(most[0], std::fabs(offset[i].x));
      most[1] = std::max(most[1], std::fabs(offset[i].y));
    }
    if (isVirtual)
    {
      // The kernel point's place is among the points, and points of a wedge are anywhere.
      most[0] = geometry.reachOf(0);
      most[1] = geometry.reachOf(1);
    }
    this->sectorError = isVirtual && geometry.kernelIsSymbolic()
      ? std::numeric_limits<double>::infinity()
      : LiftedNormal::boundInPlane(2 * most[0] * most[1]);
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      if (corner[i]->flags & VertexVirtual)
      {
        this->normal[i] = LiftedNormal::upright(-offset[j].x, -offset[j].y, most);
      }
      else if (corner[j]->flags & VertexVirtual)
      {
        this->normal[i] = LiftedNormal::upright(offset[i].x, offset[i].y, most);
      }
      else
      {
        this->normal[i] = LiftedNormal::across(offset[i], offset[j], geometry.reachOf(2));
      }
    }
  }

  /// The child whose cone holds p, or -1 when that is too close to tell.
  int child(const double* p) const
  {
    const double dx = p[0] - this->apex[0];
    const double dy = p[1] - this->apex[1];
    const double f0 = this->sector[0][0] * dy - this->sector[0][1] * dx;
    const double f1 = this->sector[1][0] * dy - this->sector[1][1] * dx;
    const double f2 = this->sector[2][0] * dy - this->sector[2][1] * dx;
    return childOf(f0, f1, f2, this->sectorError);
  }

  /// How far p lies above a child.
  double height(int child, const double* p) const
  {
    return this->normal[child].at(LiftedOffset::between<Weighted>(this->apex, p));
  }

  /// height() is off by no more than this, for a point in the child's cone.
  double heightError(int child) const { return this->normal[child].error; }

private:
  double apex[3];
  double sector[3][2];
  double sectorError;
  LiftedNormal normal[3];
};

}

#endif
