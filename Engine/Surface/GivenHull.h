// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A hull that was not built here but given: its polygon, or its triangles with a kernel point.
/// That it is convex is for validate() alone to decide.
#ifndef flipflop_GivenHull_h
#define flipflop_GivenHull_h

#include "Geometry/ConvexPolygon.h"
#include "Geometry/HullGeometry.h"
#include "Mesh/Polyhedron.h"
#include "Points/PointSource.h"
#include "Points/Vertex.h"
#include "Run/Span.h"
#include "Support/Monitor.h"
#include "Surface/CellMesh.h"
#include <flipflop/Hull.h>
#include <flipflop/Validate.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

class GivenHull
{
public:
  /// @param source of the input, or of the hull's points alone
  /// @param hull   after checkHullStructure
  GivenHull(const PointSource& source, const Hull& hull);

  /// Link the cells. In dimension 3, set the geometry's kernel point strictly inside, if they are a
  /// hull: the exact centroid of four independent corners is. It is rounded where that sees all
  /// triangles, too.
  /// @return NotClosed, Structure or, where all corners are in one plane, WrongDimension
  Validation link(HullGeometry& geometry, Monitor& monitor);

  /// Of dimension 2, the corner at an index around, which may be one round too high.
  const Vertex& around(std::size_t i) const
  {
    return this->corners[static_cast<std::size_t>(this->ring[i % this->ring.size()])];
  }

  /// Of dimension 2, where in its fan from around(0) a point of the plane lies, see
  /// fanTriangleOf().
  std::size_t fanTriangle(const HullGeometry& local, const Vertex& p) const
  {
    return fanTriangleOf(this->ring.size(),
      [&](std::size_t i, std::size_t j)
      { return local.planar(this->around(i), this->around(j), p, this->axes.p, this->axes.q); });
  }

  const PointSource& source;
  const Hull& hull;
  std::vector<Vertex> corners;    ///< by index; their ids are the source's
  std::vector<std::int64_t> ring; ///< of dimension 2: the corners in their order around
  PlaneAxes axes = { 0, 1 };      ///< of dimension 2
  Polyhedron solid;               ///< of dimension 3
  Buffer<std::uint32_t> cellOf;   ///< of its triangles
  Span independent;               ///< of dimension 3: four corners, by the source's ids
};

}

#endif
