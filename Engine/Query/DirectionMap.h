// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which corner of a hull is the farthest in a direction? Uphill over the edges, from a corner that
/// a cube map of directions shows.
///
/// A corner is extreme in a convex cone of directions. So where one is the only extreme corner in
/// the four directions at the corners of a map's cell, it is in all directions of the cell, and
/// there is no way to go: this is how corners with very many edges cost no more than others. The
/// map is filled from large cells to small ones, so that they cost little there, too.
#ifndef flipflop_DirectionMap_h
#define flipflop_DirectionMap_h

#include "Geometry/Direction.h"
#include "Mesh/Polyhedron.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

class DirectionMap
{
public:
  /// @param solid  a convex polyhedron, or corners only
  /// @param ring   the order of the corners around, where they are a polygon's; else empty
  /// @param isWide the corners need wide integers
  /// @throw Error  OutOfMemory, Aborted
  DirectionMap(
    const Polyhedron& solid, const std::vector<std::uint32_t>& ring, bool isWide, Monitor& monitor);

  /// The lowest of the corners that are farthest along a vector. Exact.
  std::uint32_t farthest(const double* vector) const;

private:
  struct Extreme
  {
    std::uint32_t corner; ///< the lowest
    bool alone;           ///< no other corner is as far
  };

  Extreme climb(const Direction& direction, std::uint32_t start) const;
  std::size_t cellOf(const Direction& direction, bool& certain) const;
  void link(const Polyhedron& solid, const std::vector<std::uint32_t>& ring);
  void fillFace(int face, Monitor& monitor);

  const Vertex* corners; ///< the solid's
  bool wide;
  bool flat;                   ///< a polygon
  Buffer<std::uint32_t> begin; ///< by corner: its neighbours
  Buffer<std::uint32_t> neighbours;
  std::int32_t side = 0;       ///< cells along a side of the cube
  Buffer<std::uint32_t> cells; ///< a corner; and OnlyOne
};

}

#endif
