// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Merge two parts of space that lie on both sides of the kernel point: the seam is a closed belt,
/// and nothing of the kernel point stays.
///
/// A merge needs an edge to start from, which common tangents give elsewhere. Here it is an edge of
/// the whole hull from one part to the other. Seen from a point far outside, on the plane that
/// separates the parts, both are polygons, which have the kernel point in common; their common
/// tangent there touches them at such an edge. Its ends may still be covered by triangles between
/// them and the border: those that the other end is above. When they are flipped away, both ends
/// are on the borders, and the bubble goes all around (PartMerge.h).
#ifndef flipflop_PartBelt_h
#define flipflop_PartBelt_h

#include "FlipFlop/PartMerge.h"

#include <cstdint>

namespace flipflop
{

class PartBelt : public PartMerge<HullGeometry>
{
public:
  using PartMerge::PartMerge;

  /// @param first, second separated by the plane through the kernel point of constant x
  void close(const Part& first, const Part& second);

private:
  /// Vertices, of each part one.
  struct HullEdge
  {
    std::uint32_t left;
    std::uint32_t right;
  };

  HullEdge findEdge() const;
  void uncoverFor(Shore& shore, std::uint32_t viewer);
  void startAt(Shore& shore, std::uint32_t vertex, std::uint32_t viewer);
};

}

#endif
