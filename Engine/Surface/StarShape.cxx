// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/StarShape.h"

#include "Points/PointSource.h"
#include "Points/Vector3.h"
#include "Surface/LinearProgram.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace flipflop
{

namespace
{

/// The bounding box as a unit cube, for the rounded parts: there nothing overflows.
class UnitCube
{
public:
  explicit UnitCube(const Polyhedron& polyhedron)
  {
    for (int i = 0; i < 3; ++i)
    {
      double low = HUGE_VAL;
      double high = -HUGE_VAL;
      for (const Vertex& v : polyhedron.vertices)
      {
        low = std::min(low, v.x[i]);
        high = std::max(high, v.x[i]);
      }
      this->middle[i] = 0.5 * low + 0.5 * high;
      this->half[i] = 0.5 * high - 0.5 * low;
    }
  }

  void map(const Vertex& v, double* x) const
  {
    for (int i = 0; i < 3; ++i)
    {
      x[i] = this->half[i] > 0 ? (v.x[i] - this->middle[i]) / this->half[i] : 0.0;
    }
  }

  void unmap(const double* x, double* p) const
  {
    for (int i = 0; i < 3; ++i)
    {
      p[i] = this->middle[i] + x[i] * this->half[i];
    }
  }

  /// Move p to a grid of at least 2^bits steps from the middle to either side: down, and then by a
  /// share of a step.
  void toGrid(int bits, const double* share, double* p) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const int step = this->half[i] > 0 ? std::ilogb(this->half[i]) - bits : 0;
      const double steps = std::ldexp(p[i], -step);
      // So far out doubles themselves are no finer.
      if (this->half[i] > 0 && std::fabs(steps) < 0x1p48)
      {
        p[i] = std::ldexp(std::floor(steps) + share[i], step);
      }
    }
  }

private:
  double middle[3];
  double half[3];
};

}

bool isInsideOut(const Polyhedron& polyhedron)
{
  const UnitCube unit(polyhedron);
  double volume = 0;
  for (const Triangle& t : polyhedron.triangles)
  {
    double x[3][3];
    for (int k = 0; k < 3; ++k)
    {
      unit.map(polyhedron.vertices[t.v[k]], x[k]);
    }
    volume += dot(x[0], cross(x[1], x[2]));
  }
  return volume < 0;
}

void turnOver(Polyhedron& polyhedron)
{
  // Corners 0, 1, 2 become 1, 0, 2: half-edge 0 stays where it is, 1 and 2 change places.
  for (Triangle& t : polyhedron.triangles)
  {
    std::swap(t.v[0], t.v[1]);
    std::swap(t.twin[1], t.twin[2]);
    for (std::uint32_t& twin : t.twin)
    {
      const int e = cornerOf(twin);
      twin = halfEdge(triangleOf(twin), e == 0 ? 0 : 3 - e);
    }
  }
}

bool seekKernel(const Polyhedron& polyhedron, double* coarse, double* fine)
{
  // In the unit cube: n . x + margin <= n . a for every triangle with the unit normal n through a.
  const UnitCube unit(polyhedron);
  std::vector<LinearConstraint<4>> constraints;
  constraints.reserve(polyhedron.triangles.size());
  for (const Triangle& t : polyhedron.triangles)
  {
    double a[3], b[3], c[3];
    unit.map(polyhedron.vertices[t.v[0]], a);
    unit.map(polyhedron.vertices[t.v[1]], b);
    unit.map(polyhedron.vertices[t.v[2]], c);
    const Vector3 n = cross(subtract(b, a), subtract(c, a));
    const double length = lengthOf(n);
    if (length > 0)
    {
      LinearConstraint<4> h;
      h.bound = 0;
      for (int i = 0; i < 3; ++i)
      {
        h.normal[i] = n[i] / length;
        h.bound += h.normal[i] * a[i];
      }
      h.normal[3] = 1;
      constraints.push_back(h);
    }
  }
  const double objective[4] = { 0, 0, 0, 1 };
  double best[4];
  if (!maximize<4>(objective, constraints, 4.0, best) || !(best[3] > 0))
  {
    return false;
  }
  // Half the box's extent has no bit lower than one below the points' lowest: neither grid then
  // reaches as low as the arithmetic carries a kernel point (see chooseArithmetic).
  constexpr double noShare[3] = { 0, 0, 0 };
  unit.unmap(best, fine);
  std::copy(fine, fine + 3, coarse);
  unit.toGrid(100, noShare, fine);
  // Unequal shares keep it off the planes that symmetric surfaces have through their middle.
  constexpr double unequal[3] = { 3.0 / 16, 7.0 / 16, 13.0 / 16 };
  unit.toGrid(20, unequal, coarse);
  return isFinite(coarse) && isFinite(fine);
}

}
