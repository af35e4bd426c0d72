// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the growing of a regular triangulation starts (paper, section 4): one triangle of points
/// and the virtual vertex.
#ifndef flipflop_LiftedStart_h
#define flipflop_LiftedStart_h

#include "Geometry/HullStart.h"
#include "Geometry/LiftedGeometry.h"

#include <utility>

namespace flipflop
{

/// Set the geometry's kernel point inside a counter-clockwise triangle with area.
template <bool Weighted>
void setKernelInside(LiftedGeometry<Weighted>& geometry, const Vertex* corner)
{
  // Unequal weights keep the kernel off the lines of a grid.
  static constexpr double share[3] = { 0.3718281828, 0.3414213562, 0.286750461 };
  double s[2] = { 0, 0 };
  for (int i = 0; i < 2; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      s[i] += share[k] * corner[k].x[i];
    }
  }
  geometry.setKernel(s);
  for (int k = 0; k < 3; ++k)
  {
    if (geometry.kernelBeneath(corner[(k + 1) % 3], corner[k], virtualVertex()) <= 0)
    {
      const Vertex centroid[4] = { corner[0], corner[1], corner[2], corner[0] };
      geometry.setSymbolicKernel(centroid);
      break;
    }
  }
}

/// The tetrahedron of three points that are not collinear and the virtual vertex; the geometry's
/// kernel point is set inside it.
template <bool Weighted>
Polyhedron startingTetrahedron(
  LiftedGeometry<Weighted>& geometry, const PointSource& source, const std::uint32_t* ids)
{
  Vertex corner[4];
  for (int i = 0; i < 3; ++i)
  {
    corner[i] = source.vertex(ids[i]);
    corner[i].flags = VertexAlive;
  }
  if (geometry.orient(corner[0], corner[1], corner[2]) < 0)
  {
    std::swap(corner[1], corner[2]);
  }
  corner[3] = virtualVertex();
  Polyhedron result = makeTetrahedron(corner);
  setKernelInside(geometry, corner);
  return result;
}

}

#endif
