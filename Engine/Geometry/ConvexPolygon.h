// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A convex polygon: its corners among points, the axes in which it is seen in space, and where in
/// its fan a point lies.
#ifndef flipflop_ConvexPolygon_h
#define flipflop_ConvexPolygon_h

#include "Geometry/HullGeometry.h"
#include "Points/Vertex.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace flipflop
{

/// Half of A. M. Andrew's monotone chain: appends points along a line to a chain, without those at
/// which it does not turn as it must.
/// @param turns bool (a, b, c): b stays, between a and c
template <class Point, class Turns>
void appendChain(const std::vector<Point>& points, const Turns& turns, std::vector<Point>& chain)
{
  const std::size_t base = chain.size();
  for (const Point& point : points)
  {
    while (chain.size() >= base + 2 && !turns(chain[chain.size() - 2], chain.back(), point))
    {
      chain.pop_back();
    }
    chain.push_back(point);
  }
}

/// The corners of the convex hull of points in the plane, counter-clockwise.
/// @param points two or more, in their order by one coordinate, then the other; no two at one
///               position
template <class Point, class TurnsLeft>
std::vector<Point> monotoneChain(std::vector<Point>& points, const TurnsLeft& turnsLeft)
{
  std::vector<Point> chain;
  for (int half = 0; half < 2; ++half)
  {
    appendChain(points, turnsLeft, chain);
    chain.pop_back(); // begins the other half
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

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
