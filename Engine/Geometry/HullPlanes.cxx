// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Why a point that is dropped is inside. A triangle's plane has the normal n and goes through
// the corner a. A point p is dropped if n . (p - a) + e, as computed, is negative for all
// planes. Here e is the bound of the first step's error for the whole determinant. Scaling n and
// e by a power of two is exact, and the rounded sum of two numbers has the sign of the exact
// one, so p is strictly inside each plane. Two kinds of triangles are not compared:
// - those without area, by an exact sign: they bound nothing;
// - those in a side of the points' bounding box: no point is above it, but a point may be on it,
//   and may be a duplicate of a vertex all of whose planes are such sides. Such a vertex is a
//   corner of the box. So points at the box's corners are looked up among the vertices, as are
//   all others that the bound leaves open.
// A point counts as above a plane if the computed sum is more than PlaneClearance e. Exact signs
// insert the furthest one. Testing/Engine/Geometry/TestHullLocator.cxx compares points about the
// border with exact signs.
#include "Geometry/HullPlanes.h"

#include "Geometry/HullCones.h"
#include "Support/VectorClones.h"

#include <cmath>
#include <cstring>

namespace flipflop
{

namespace
{

/// The greatest power of two up to a normal number.
double powerOfTwo(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  bits &= 0x7FF0000000000000ull;
  std::memcpy(&x, &bits, sizeof(bits));
  return x;
}

/// A vector unit's doubles, or several units'. Written as a loop, the comparison becomes a branch
/// that is mispredicted.
#if defined(__GNUC__)
using Several = double __attribute__((vector_size(HullPlanes::Lanes / 2 * sizeof(double))));
#else
using Several = double;
#endif
static_assert(2 * sizeof(Several) == HullPlanes::Lanes * sizeof(double));

}

HullPlanes::HullPlanes(
  const HullGeometry& geometry, const Polyhedron& polyhedron, const CoordinateRange& rangeOfAll)
  : range(rangeOfAll)
{
  double extent[3];
  this->reliable = geometry.extent(extent);
  this->planes.reserve(this->reliable ? polyhedron.triangleCount() : 0);
  for (std::uint32_t t = 0; this->reliable && t < polyhedron.triangleCount(); ++t)
  {
    const std::uint32_t* const v = polyhedron.triangles[t].v;
    this->add(
      geometry, polyhedron.vertices[v[0]], polyhedron.vertices[v[1]], polyhedron.vertices[v[2]], t);
  }
  for (const Vertex& v : polyhedron.vertices)
  {
    this->hasCorner = this->hasCorner || this->isCorner(v.x);
  }
}

void HullPlanes::add(const HullGeometry& geometry, const Vertex& a, const Vertex& b,
  const Vertex& c, std::uint32_t triangle)
{
  for (int i = 0; i < 3; ++i)
  {
    const double side = a.x[i];
    if (b.x[i] == side && c.x[i] == side &&
      (side == this->range.low[i] || side == this->range.high[i]))
    {
      return;
    }
  }
  const HullPlane plane(geometry, a, b, c);
  // A triangle without area bounds nothing.
  if (!(-plane.height(geometry.kernel()) > plane.error()) && geometry.collinear(a, b, c))
  {
    return;
  }
  const double most = largestOf(plane.slope(0), plane.slope(1), plane.slope(2));
  const double error = plane.error();
  this->reliable = error < HUGE_VAL && most >= FilterFloor * FilterFloor;
  if (!this->reliable)
  {
    return;
  }
  const double unit = 1 / powerOfTwo(most);
  this->planes.push_back({ { plane.slope(0) * unit, plane.slope(1) * unit, plane.slope(2) * unit },
    { a.x[0], a.x[1], a.x[2] }, error * unit, triangle });
}

namespace
{

// A member would be exported: the loader is to find what picks the clone.
FF_VECTOR_CLONES
void compare(const HullPlanes::Plane* planes, std::size_t count, const double* x, const double* y,
  const double* z, int n, double* height, double* plane)
{
  for (int begin = 0; begin < n; begin += HullPlanes::Lanes)
  {
    Several p[3][2];
    std::memcpy(p[0], x + begin, sizeof(p[0]));
    std::memcpy(p[1], y + begin, sizeof(p[1]));
    std::memcpy(p[2], z + begin, sizeof(p[2]));
    Several most[2] = { Several{} - HUGE_VAL, Several{} - HUGE_VAL };
    Several which[2] = { Several{}, Several{} };
    for (std::size_t k = 0; k < count; ++k)
    {
      const HullPlanes::Plane& to = planes[k];
      const Several number = Several{} + static_cast<double>(k);
      for (int i = 0; i < 2; ++i)
      {
        const Several h = to.normal[0] * (p[0][i] - to.origin[0]) +
          to.normal[1] * (p[1][i] - to.origin[1]) + to.normal[2] * (p[2][i] - to.origin[2]) +
          to.error;
        which[i] = h > most[i] ? number : which[i];
        most[i] = h > most[i] ? h : most[i];
      }
    }
    std::memcpy(height + begin, most, sizeof(most));
    std::memcpy(plane + begin, which, sizeof(which));
  }
}

}

void HullPlanes::highest(
  const double* x, const double* y, const double* z, int n, double* height, double* plane) const
{
  compare(this->planes.data(), this->planes.size(), x, y, z, n, height, plane);
}

}
