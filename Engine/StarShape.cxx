// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StarShape.h"

#include "LinearProgram.h"
#include "PointSource.h"

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
    volume += x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1]) +
      x[0][1] * (x[1][2] * x[2][0] - x[1][0] * x[2][2]) +
      x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0]);
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

bool seekKernel(const Polyhedron& polyhedron, double* kernel)
{
  // In the unit cube: n . x + margin <= n . a for every triangle with the unit normal n through a.
  const UnitCube unit(polyhedron);
  std::vector<HalfSpace<4>> constraints;
  constraints.reserve(polyhedron.triangles.size());
  for (const Triangle& t : polyhedron.triangles)
  {
    double a[3], b[3], c[3], n[3];
    unit.map(polyhedron.vertices[t.v[0]], a);
    unit.map(polyhedron.vertices[t.v[1]], b);
    unit.map(polyhedron.vertices[t.v[2]], c);
    for (int i = 0; i < 3; ++i)
    {
      const int p = (i + 1) % 3;
      const int q = (i + 2) % 3;
      n[i] = (b[p] - a[p]) * (c[q] - a[q]) - (b[q] - a[q]) * (c[p] - a[p]);
    }
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length > 0)
    {
      HalfSpace<4> h;
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
  unit.unmap(best, kernel);
  return isFinite(kernel);
}

}
