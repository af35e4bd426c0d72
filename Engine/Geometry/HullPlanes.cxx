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
#include "Support/PowersOfTwo.h"
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
  return doubleOf(bitsOf(x) & 0x7FF0000000000000ull);
}

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

// As many doubles as a vector unit has. Written as a loop, the comparison becomes a branch that is
// mispredicted. (g++ ignores a vector's size that depends on a template parameter.)
#if defined(__GNUC__)
using TwoDoubles = double __attribute__((vector_size(2 * sizeof(double))));
using FourDoubles = double __attribute__((vector_size(4 * sizeof(double))));
using EightDoubles = double __attribute__((vector_size(8 * sizeof(double))));
#else
using TwoDoubles = double;
#endif

/// What HullPlanes::highest() is called for.
struct Comparison
{
  const std::vector<HullPlanes::Plane>& planes;
  const double* x[3];
  int count;
  double* height;
  double* plane;
};

/// @tparam Several of the vector unit that there is: g++ copies wider vectors through memory
template <class Several>
FF_INLINE void compareBy(const Comparison& work)
{
  constexpr int Step = 2 * sizeof(Several) / sizeof(double);
  static_assert(HullPlanes::Lanes % Step == 0);
  for (int begin = 0; begin < work.count; begin += Step)
  {
    Several p[3][2];
    for (int k = 0; k < 3; ++k)
    {
      std::memcpy(p[k], work.x[k] + begin, sizeof(p[k]));
    }
    Several most[2] = { Several{} - HUGE_VAL, Several{} - HUGE_VAL };
    Several which[2] = { Several{}, Several{} };
    double next = 0;
    for (const HullPlanes::Plane& to : work.planes)
    {
      const Several number = Several{} + next++;
      for (int i = 0; i < 2; ++i)
      {
        const Several h = to.normal[0] * (p[0][i] - to.origin[0]) +
          to.normal[1] * (p[1][i] - to.origin[1]) + to.normal[2] * (p[2][i] - to.origin[2]) +
          to.error;
        which[i] = h > most[i] ? number : which[i];
        most[i] = h > most[i] ? h : most[i];
      }
    }
    std::memcpy(work.height + begin, most, sizeof(most));
    std::memcpy(work.plane + begin, which, sizeof(which));
  }
}

// Members would be exported: the loader is to find what picks one of these.
#if defined(FF_VECTOR_TARGETS)
__attribute__((target("arch=x86-64-v4"))) void compare(const Comparison& work)
{
  compareBy<EightDoubles>(work);
}
__attribute__((target("arch=x86-64-v3"))) void compare(const Comparison& work)
{
  compareBy<FourDoubles>(work);
}
__attribute__((target("default")))
#endif
void compare(const Comparison& work)
{
  compareBy<TwoDoubles>(work);
}

}

void HullPlanes::highest(
  const double* x, const double* y, const double* z, int n, double* height, double* plane) const
{
  compare({ this->planes, { x, y, z }, n, height, plane });
}

}
