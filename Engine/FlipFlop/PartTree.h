// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points cut into parts of a few thousand: the leaves of a binary tree.
///
/// The cut goes along Hilbert's curve at cells of a quadtree. In the plane, a vertical or a
/// horizontal line separates the two halves of every node. That is exact: the cell of a point is a
/// monotone function of each of its coordinates. In space, a plane through the kernel point does
/// (OctahedralMap.h). What is so near a cell's border that rounding may have put it on the wrong
/// side is left out of the parts. Where a cell has too many points for a part, it is cut in the
/// same way, along the curve through the box of its own points. Points at one position are one
/// part, however many.
#ifndef flipflop_PartTree_h
#define flipflop_PartTree_h

#include "Geometry/HilbertCurve.h"
#include "Geometry/OctahedralMap.h"
#include "Mesh/PlaneMesh.h"
#include "Points/PointSource.h"
#include "Points/PointSubset.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

struct PartNode
{
  std::uint32_t begin = 0; ///< its vertices are those from here
  std::uint32_t end = 0;   ///< up to here
  std::uint32_t left = 0;  ///< a node; 0: this one is a part
  std::uint32_t right = 0;
  std::uint32_t trianglesEnd = 0; ///< for the builder: of a part's
};

/// A range of vertices.
struct VertexRange
{
  std::uint32_t begin;
  std::uint32_t end;
};

/// @tparam AnyVertex Vertex, or PlaneVertex
template <class AnyVertex>
struct PartTree
{
  Buffer<AnyVertex> vertices;   ///< the first is left to the caller; then all points, part by part
  std::vector<PartNode> nodes;  ///< the root is the first
  std::vector<VertexRange> out; ///< in no part
};

/// @param curve through the map's positions
/// @param most  points of a part, but for points at one position
/// @throw Error Aborted, OutOfMemory
template <class AnyVertex>
PartTree<AnyVertex> cutIntoParts(const PointSource& source, const PointSubset& subset,
  const OctahedralMap& map, const HilbertCurve& curve, std::uint32_t most, Monitor& monitor);

}

#endif
