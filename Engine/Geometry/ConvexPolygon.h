// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A convex polygon in space: the axes in which it is seen, and where in its fan a point lies.
#ifndef flipflop_ConvexPolygon_h
#define flipflop_ConvexPolygon_h

#include "Geometry/HullGeometry.h"
#include "Points/Vertex.h"

#include <cstddef>

namespace flipflop
{

/// Two coordinates, in their order.
struct PlaneAxes
{
  int p, q;
};

/// The coordinates in which Hull.h wants a polygon in the plane of abc counter-clockwise.
inline PlaneAxes planeAxes(
  const HullGeometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c)
{
  if (geometry.planar(a, b, c, 0, 1) != 0)
  {
    return { 0, 1 };
  }
  return geometry.planar(a, b, c, 2, 0) != 0 ? PlaneAxes{ 2, 0 } : PlaneAxes{ 1, 2 };
}

/// The triangle of the corners 0, i and i + 1 that holds a point of a strictly convex polygon's
/// plane, its border included: i, from 1 to @p size - 2; 0: the point is outside.
/// @param turn (std::size_t i, std::size_t j): positive where the point is on the left of the way
///             from corner i to corner j, zero on it
template <class Turn>
std::size_t fanTriangleOf(std::size_t size, const Turn& turn)
{
  // The wedge from corner 0, then its outer edge.
  if (turn(0, 1) < 0 || turn(0, size - 1) > 0)
  {
    return 0;
  }
  std::size_t low = 1;
  std::size_t high = size - 1;
  while (high - low > 1)
  {
    const std::size_t middle = (low + high) / 2;
    (turn(0, middle) >= 0 ? low : high) = middle;
  }
  return turn(low, low + 1) < 0 ? 0 : low;
}

}

#endif
