// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Results as bytes, which are equal if and only if all numbers have the same bits.
#ifndef flipflop_test_Bits_h
#define flipflop_test_Bits_h

#include <flipflop/AlphaComplex.h>
#include <flipflop/CellBoundary.h>
#include <flipflop/CentroidalCells.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/ConstraintCrossings.h>
#include <flipflop/HalfSpaces.h>
#include <flipflop/HullQueries.h>
#include <flipflop/JoinedLines.h>
#include <flipflop/PlaneFit.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/PrescribedAreas.h>
#include <flipflop/RefinedMesh.h>
#include <flipflop/SurfacePolygons.h>
#include <flipflop/TerrainMesh.h>

#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

using Bits = std::string;

template <class T>
Bits bitsOf(const T* values, std::size_t count)
{
  return std::to_string(count) + ":" +
    (count ? Bits(reinterpret_cast<const char*>(values), count * sizeof(T)) : Bits());
}

template <class T>
Bits bitsOf(const std::vector<T>& values)
{
  return bitsOf(values.data(), values.size());
}

template <class T>
Bits bitsOf(const Buffer<T>& values)
{
  return bitsOf(values.data(), values.size());
}

inline Bits bitsOf(const CellComplex& cells)
{
  return std::to_string(cells.dimension) + bitsOf(cells.pointIds) + bitsOf(cells.connectivity) +
    bitsOf(cells.offsets);
}

inline Bits bitsOf(const HalfSpaceIntersection& found)
{
  return std::to_string(static_cast<int>(found.kind)) +
    bitsOf(static_cast<const CellComplex&>(found)) + bitsOf(found.interior, 3) +
    bitsOf(found.vertices) + bitsOf(found.dualPoints);
}

inline Bits bitsOf(const Hull& hull)
{
  const double sizes[] = { hull.volume, hull.area };
  return bitsOf(static_cast<const CellComplex&>(hull)) + bitsOf(sizes, 2);
}

inline Bits bitsOf(const Triangulation& triangulation)
{
  return bitsOf(static_cast<const CellComplex&>(triangulation)) + bitsOf(triangulation.hiddenIds);
}

inline Bits bitsOf(const ConstrainedTriangulation& result)
{
  return bitsOf(static_cast<const Triangulation&>(result)) + bitsOf(result.fixedEdges) +
    bitsOf(result.constraintOf) + bitsOf(result.balance) + bitsOf(result.sideOf);
}

inline Bits bitsOf(const RefinedMesh& mesh)
{
  const std::int64_t counts[] = { mesh.newPoints, mesh.keptSegments, mesh.keptTriangles,
    mesh.isComplete };
  return bitsOf(static_cast<const ConstrainedTriangulation&>(mesh)) + bitsOf(mesh.points) +
    bitsOf(mesh.constraintOfPoint) + bitsOf(mesh.region) + bitsOf(counts, 4);
}

inline Bits bitsOf(const TerrainMesh& mesh)
{
  const std::int64_t counts[] = { mesh.beyond, mesh.unreachable };
  return bitsOf(static_cast<const ConstrainedTriangulation&>(mesh)) + bitsOf(mesh.errors) +
    bitsOf(&mesh.greatestError, 1) + bitsOf(counts, 2);
}

inline Bits bitsOf(const SplitConstraints& split)
{
  return bitsOf(split.ends) + bitsOf(split.constraintOf) + bitsOf(split.positions) +
    bitsOf(split.crossing) + bitsOf(split.offsets);
}

inline Bits bitsOf(const JoinedLines& joined)
{
  return bitsOf(joined.pointOf) + bitsOf(joined.added) + bitsOf(joined.positions) +
    bitsOf(joined.ends);
}

inline Bits bitsOf(const PowerDiagram& diagram)
{
  return bitsOf(diagram.corners) + bitsOf(diagram.connectivity) + bitsOf(diagram.offsets) +
    bitsOf(diagram.siteIds);
}

inline Bits bitsOf(const CentroidalCells& found)
{
  return bitsOf(found.sites) + bitsOf(found.cells) + bitsOf(found.areas) + bitsOf(found.centroids) +
    bitsOf(&found.lastMove, 1);
}

inline Bits bitsOf(const PrescribedAreas& found)
{
  return bitsOf(found.weights) + bitsOf(found.areas) + bitsOf(found.centroids);
}

inline Bits bitsOf(const FittedPlane& plane)
{
  return bitsOf(plane.start.data(), 3) + bitsOf(plane.origin.data(), 3) +
    bitsOf(plane.first.data(), 3) + bitsOf(plane.second.data(), 3);
}

inline Bits bitsOf(const Diameter& found)
{
  return bitsOf(&found.first, 1) + bitsOf(&found.second, 1) + bitsOf(&found.length, 1);
}

inline Bits bitsOf(const OrientedBox& found)
{
  return bitsOf(found.center, 3) + bitsOf(found.axes[0], 9) + bitsOf(found.lengths, 3) +
    bitsOf(&found.volume, 1) + bitsOf(&found.lowerBound, 1);
}

inline Bits bitsOf(const AlphaComplex& alpha)
{
  return bitsOf(alpha.cells) + bitsOf(alpha.edges) + bitsOf(alpha.edgeAlphas) +
    bitsOf(alpha.vertices) + bitsOf(alpha.vertexAlphas);
}

inline Bits bitsOf(const CellBoundary& border)
{
  return bitsOf(border.connectivity) + bitsOf(border.offsets);
}

inline Bits bitsOf(const PolygonTriangles& cut)
{
  return bitsOf(cut.corners) + bitsOf(cut.polygonIds);
}

}
}

#endif
