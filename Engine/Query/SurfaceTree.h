// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How far is a point from a hull's surface?
///
/// From outside, a walk over the surface leads to the nearest point: where no edge around leads
/// nearer, a plane that holds the hull behind it proves that nothing else is. From inside, branch
/// and bound over a tree of the triangles: a node has its box, and a slab beneath which none of
/// its points is, which is tight where the surface is smooth. The nearest triangle's plane is as
/// near as the triangle, and no plane is nearer than the surface, so heights above planes are all
/// that is computed of triangles there.
///
/// Where the walk comes to a thin triangle or gets lost in rounding, and in lower dimensions, the
/// tree gives the distance, too. A polygon is cut into triangles there; the border of a polygon in
/// the plane, a segment and a point are triangles without area.
///
/// All is computed from offsets to the query, in a frame in which the farthest corner is one or two
/// away: squares neither overflow, nor underflow where that counts (OffsetFrame.h).
#ifndef flipflop_SurfaceTree_h
#define flipflop_SurfaceTree_h

#include "Mesh/Polyhedron.h"
#include "Query/OffsetFrame.h"
#include "Support/BoxTree.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <array>
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
  /// @param isBorder the surface of a polygon is its border, and not the polygon
  /// @param exponent the corners are scaled by 2^ this
  SurfaceTree(const Polyhedron& solid, const std::vector<std::uint32_t>& ring, bool isBorder,
    int exponent, Monitor& monitor);

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

  /// A triangle; without area, its normal is zero.
  struct Element
  {
    Corner corner[3];
    double normal[3];
    bool isThin; ///< walks over it are not to be trusted
  };

  /// No point of a node is lower than this along a direction, above one of its corners.
  struct Slab
  {
    double normal[3];
    Corner origin;
    double least; ///< in the hull's own frame
  };

  /// The point of a triangle that is nearest to another.
  struct Nearest
  {
    double square; ///< of the distance
    int edge;      ///< that it lies on; -1: inside the triangle
    int corner;    ///< that it is at; -1: none
  };

  using Cell = std::array<std::uint32_t, 3>;

  static std::vector<Cell> flatCells(
    const std::vector<std::uint32_t>& ring, bool isBorder, std::uint32_t count);
  Element makeElement(const Corner* corner, bool isFlat) const;
  void makeSlabs();
  static Nearest nearestOf(const Element& element, const OffsetFrame& frame);
  double squareByWalk(const OffsetFrame& frame, std::uint32_t start) const;
  std::uint32_t uphill(std::uint32_t t, int corner, const OffsetFrame& frame) const;
  double squareByTree(const OffsetFrame& frame, bool inside) const;
  const Element& elementOf(std::uint32_t t) const { return this->elements[this->slotOf[t]]; }

  Buffer<Element> elements;     ///< by slot in the tree; corners as they were given
  Buffer<std::uint32_t> slotOf; ///< by triangle
  Buffer<Slab> slabs;           ///< by node, in dimension 3
  const Triangle* triangles;    ///< of the hull; null below dimension 3
  int hullExponent = 0;         ///< of the frame about the hull's own size
  std::optional<BoxTree> tree;
};

}

#endif
