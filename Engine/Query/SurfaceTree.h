// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How far is a point from a hull's surface? Branch and bound over a tree of boxes around the
/// triangles; around the sides of a polygon, or the segment, or the point, in lower dimensions.
///
/// From inside, the nearest triangle's plane is as near as the triangle, and no plane is nearer
/// than the surface. So there the heights above the planes are all that is asked of triangles.
///
/// Coordinates are in a frame in which the largest of the hull is about one, so that squares
/// neither overflow nor underflow.
#ifndef flipflop_SurfaceTree_h
#define flipflop_SurfaceTree_h

#include "Mesh/Polyhedron.h"
#include "Query/BoxTree.h"
#include "Query/FacetPlane.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace flipflop
{

class SurfaceTree
{
public:
  /// @param solid    the hull; only its corners below dimension 3
  /// @param ring     the corners in their order, in dimension 2; else empty
  /// @param exponent the corners are scaled by 2^ this
  SurfaceTree(const Polyhedron& solid, const std::vector<std::uint32_t>& ring, int exponent,
    Monitor& monitor);

  /// The distance of a point that is not on the surface; rounded.
  /// @param x      as it was given
  /// @param inside the solid
  /// @param start  a triangle near it, in dimension 3
  double distance(const double* x, bool inside, std::uint32_t start) const;

private:
  struct Corner
  {
    double x[3];
  };

  /// A triangle, or a segment of two corners.
  struct Element
  {
    Corner corner[3];
    double normal[3];
  };

  static double squaredDistance(const Corner& a, const Corner& b, const double* x);
  double squaredDistance(const Element& element, const double* x, bool inside) const;
  bool isOverPolygon(const double* x) const;

  int shift = 0;                         ///< from given coordinates to the frame's: times 2^shift
  std::vector<Corner> corners;           ///< in the frame; of a polygon, in their order
  Buffer<Element> elements;              ///< by place in the tree
  Buffer<std::uint32_t> placeOf;         ///< by triangle
  bool solidHull = false;                ///< the elements are triangles
  double polygonNormal[3] = { 0, 0, 0 }; ///< zero: there is no polygon
  std::optional<BoxTree> tree;
};

}

#endif
