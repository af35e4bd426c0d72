// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Is a closed surface star-shaped from a kernel point, and from which point could it be?
#ifndef flipflop_StarShape_h
#define flipflop_StarShape_h

#include "Mesh/Polyhedron.h"

#include <algorithm>
#include <cstdint>

namespace flipflop
{

/// Triangles that keep a polyhedron from being star-shaped; count 0: it is.
struct StarFault
{
  std::int64_t triangle = -1; ///< the first
  std::int64_t count = 0;
};

/// Triangles that the geometry's kernel point does not see strictly from inside; where it sees all,
/// those that cover one direction beyond the first: the surface then winds around the kernel more
/// than once. Exact.
/// @param polyhedron closed, oriented, manifold
template <class Geometry>
StarFault findStarFault(const Geometry& geometry, const Polyhedron& polyhedron)
{
  StarFault fault;
  const auto note = [&fault](std::uint32_t t)
  { fault.triangle = fault.count++ ? fault.triangle : static_cast<std::int64_t>(t); };
  const Vertex* v = polyhedron.vertices.data();
  for (std::uint32_t t = 0; t < polyhedron.triangleCount(); ++t)
  {
    const std::uint32_t* corner = polyhedron.triangles[t].v;
    if (geometry.kernelBeneath(v[corner[0]], v[corner[1]], v[corner[2]]) <= 0)
    {
      note(t);
    }
  }
  if (fault.count)
  {
    return fault;
  }

  // Each triangle covers its directions once, so the surface covers all directions equally often:
  // one direction shows. Perturbed, it is on no cone's border.
  Vertex probe{};
  const std::uint32_t* first = polyhedron.triangles[0].v;
  for (int i = 0; i < 3; ++i)
  {
    const double a = v[first[0]].x[i];
    const double b = v[first[1]].x[i];
    const double c = v[first[2]].x[i];
    // In the bounding box, however it is rounded.
    probe.x[i] = std::max(
      std::min({ a, b, c }), std::min(0.5 * a + (0.25 * b + 0.25 * c), std::max({ a, b, c })));
  }
  probe.id = NoIndex;
  std::int64_t covered = 0;
  for (std::uint32_t t = 0; t < polyhedron.triangleCount(); ++t)
  {
    const std::uint32_t* corner = polyhedron.triangles[t].v;
    const Vertex& a = v[corner[0]];
    const Vertex& b = v[corner[1]];
    const Vertex& c = v[corner[2]];
    if (geometry.perturbedKernelBeneath(a, b, probe) > 0 &&
      geometry.perturbedKernelBeneath(b, c, probe) > 0 &&
      geometry.perturbedKernelBeneath(c, a, probe) > 0 && covered++ > 0)
    {
      note(t);
    }
  }
  return fault;
}

/// Is the surface turned inside out, by the sign of its (rounded) volume?
bool isInsideOut(const Polyhedron& polyhedron);

/// Turn all triangles over.
void turnOver(Polyhedron& polyhedron);

/// Seek a point that sees all triangles of an outward surface from inside, with the greatest
/// margin: rounded linear programming. What it finds is for findStarFault to decide.
/// @param coarse the point on a grid of about a millionth of the extent: signs with it are quick
/// @param fine   as it was found, but for bits so low that the arithmetic might not carry them: for
///               where the coarse one does not see all
/// @return false when the surface has no such point, as far as rounding allows
bool seekKernel(const Polyhedron& polyhedron, double* coarse, double* fine);

}

#endif
