// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How far is a point from a hull's surface?
///
/// From outside, a walk over the surface leads to the nearest point: where no edge around leads
/// nearer, a plane that holds the hull behind it proves that nothing else is. From inside, branch
/// and bound over a tree of the triangles: a node knows its box, and a slab beneath which none of
/// its points is, which is tight where the surface is smooth. The nearest triangle's plane is as
/// near as the triangle, and no plane is nearer than the surface, so heights above planes are all
/// that is asked of triangles there.
///
/// Where the walk gets lost in rounding, and in lower dimensions, the tree tells, too; it is one of
/// a polygon's sides, or of the segment, or the point, then. Coordinates are in a frame in which
/// the largest of the hull is about one, so that squares neither overflow nor underflow.
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

  /// No point of a node is lower than this along a direction, above one of its corners.
  struct Slab
  {
    double normal[3];
    Corner origin;
    double least;
  };

  /// The point of a triangle that is nearest to another.
  struct Nearest
  {
    double square; ///< of the distance
    int edge;      ///< that it lies on; -1: inside the triangle
    int corner;    ///< that it is at; -1: none
  };

  void makeSlabs();
  static Nearest nearestOf(const Element& element, const double* x);
  double squareByWalk(const double* x, std::uint32_t start) const;
  std::uint32_t uphill(std::uint32_t t, int corner, const double* x) const;
  double squareByTree(const double* x, bool inside, double best) const;
  const Element& elementOf(std::uint32_t t) const { return this->elements[this->placeOf[t]]; }
  bool isOverPolygon(const double* x) const;

  int shift = 0;                         ///< from given coordinates to the frame's: times 2^shift
  std::vector<Corner> corners;           ///< in the frame; of a polygon, in their order
  Buffer<Element> elements;              ///< by place in the tree
  Buffer<std::uint32_t> placeOf;         ///< by triangle
  Buffer<Slab> slabs;                    ///< by node, in dimension 3
  const Triangle* triangles;             ///< of the hull; null: the elements are segments
  double polygonNormal[3] = { 0, 0, 0 }; ///< zero: there is no polygon
  std::optional<BoxTree> tree;
};

}

#endif
