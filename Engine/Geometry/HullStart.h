// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the growing of a hull in space starts, the kernel point it sees everything from, and the
/// axes in which points are sorted around it.
#ifndef flipflop_HullStart_h
#define flipflop_HullStart_h

#include "Geometry/HullGeometry.h"
#include "Geometry/InsertionOrder.h"
#include "Mesh/Polyhedron.h"
#include "Points/PointSource.h"

#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// The tetrahedron of four vertices, of which the last is beneath the triangle of the others.
Polyhedron makeTetrahedron(const Vertex* corner);

/// The kernel point, rounded when it is symbolic, as a vertex: behind all points' ids, as where the
/// perturbation breaks ties with it.
inline Vertex kernelVertex(const HullGeometry& geometry)
{
  const double* const s = geometry.kernel();
  return { { s[0], s[1], s[2] }, NoIndex, VertexAlive };
}

/// Set the geometry's kernel point inside a tetrahedron.
void setKernelInside(HullGeometry& geometry, const Polyhedron& tetrahedron);

/// The tetrahedron of four independent points; the geometry's kernel point is set inside it.
Polyhedron startingTetrahedron(
  HullGeometry& geometry, const PointSource& source, const std::uint32_t* ids);

/// Move the kernel point to the middle of a convex polyhedron, where that is exactly inside.
void centerKernel(HullGeometry& geometry, const Polyhedron& polyhedron);

/// Directions from the kernel point, in the axes of a polyhedron's vertices: those of a thin or
/// slanted one are spread as a ball's.
OctahedralMap octahedralMapOf(const HullGeometry& geometry, const Polyhedron& polyhedron);

/// The same from any position, in the axes of some vertices.
/// @param unit of each coordinate: about how far vertices are from the position; null: their axes
///             are not spread
OctahedralMap octahedralMapOf(
  const double* from, const double* unit, const Vertex* vertices, std::size_t count);

}

#endif
