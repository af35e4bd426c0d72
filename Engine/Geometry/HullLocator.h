// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// In which cone of a convex polyhedron does a point lie, and is it certainly inside?
///
/// The directions from the kernel point are cut into the cells of a cube map. A cell holds a
/// distance below which a point in it is certainly inside, and a triangle from which the walk to a
/// point's cone starts. The distance: the gauge of a convex body (one over the distance to its
/// border, along a ray) is convex, so over a cell it is greatest at a corner. Points that a cell
/// does not dismiss walk, by exact signs.
#ifndef flipflop_HullLocator_h
#define flipflop_HullLocator_h

#include "Geometry/HullCones.h"
#include "Mesh/Mesh.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstdint>

namespace flipflop
{

class HullLocator
{
public:
  /// Points examined together: they stay in the first cache.
  static constexpr int BlockSize = 256;

  struct Block
  {
    double x[3][BlockSize];
    std::int32_t cell[BlockSize];   ///< cell of the direction of p - s
    std::int32_t inside[BlockSize]; ///< certainly inside
  };

  /// @param triangles, count a convex polyhedron, star-shaped from the geometry's kernel point: a
  ///                         mesh without borders or dead triangles. Both arrays must outlive
  ///                         the locator.
  /// @throw Error Aborted
  HullLocator(const HullGeometry& geometry, const Triangle* triangles, std::uint32_t count,
    const Vertex* vertices, Monitor& monitor);

  /// Fill in the block's results for the first @p n points.
  void classify(Block& block, int n) const;

  /// The cell of one point.
  std::int32_t cellOf(const double* p) const;

  /// A triangle near the points of a cell.
  std::uint32_t near(const Vertex&, std::int32_t cell) const
  {
    return this->resolution ? this->hints[cell] : 0;
  }

  /// The triangle in whose cone p lies, exactly (by perturbation, at a border); any triangle at a
  /// vertex for a p at the position of that vertex. The walk starts at @p start.
  std::uint32_t locate(const HullGeometry& geometry, const Vertex& p, std::uint32_t start) const;

  const HullPlane& plane(std::uint32_t triangle) const { return this->cones[triangle].plane; }

private:
  void buildGrid(const HullGeometry& geometry, StepPoll& poll);
  double innerRadius(const HullGeometry& geometry, StepPoll& poll) const;
  std::uint32_t walkTo(const double* direction, std::uint32_t start, StepPoll& poll) const;

  const Triangle* triangles;
  const Vertex* vertices;
  std::uint32_t count;
  Buffer<HullCone> cones;
  Buffer<float> limits;
  Buffer<std::uint32_t> hints;
  double kernel[3];
  double unit[3];
  std::int32_t resolution = 0; ///< cells along a side of the cube; 0: no grid
};

}

#endif
