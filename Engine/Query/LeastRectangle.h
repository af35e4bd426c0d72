// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rectangle of least area around points in the plane: one of its sides runs along a side of
/// their hull (H. Freeman, R. Shapira, 1975), and calipers that turn around the hull find it (G.
/// Toussaint, 1983). Rounded: what matters is measured again by the caller.
#ifndef flipflop_LeastRectangle_h
#define flipflop_LeastRectangle_h

#include "Geometry/ConvexPolygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace flipflop
{

using PlanePoint = std::array<double, 2>;

struct Rectangle
{
  double area = 0;
  PlanePoint along = { 1, 0 }; ///< of length one: the direction of a side
};

/// The corners of the points' convex hull, counter-clockwise; the points are sorted.
inline std::vector<PlanePoint> chainAround(std::vector<PlanePoint>& points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
  {
    return points;
  }
  return monotoneChain(points,
    [](const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
    { return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0; });
}

/// @param points one or more; they are sorted
inline Rectangle leastRectangle(std::vector<PlanePoint>& points)
{
  const std::vector<PlanePoint> hull = chainAround(points);
  const std::size_t n = hull.size();
  Rectangle least;
  if (n < 2)
  {
    return least;
  }
  least.area = HUGE_VAL;
  const auto at = [&](std::size_t i) -> const PlanePoint& { return hull[i % n]; };
  std::size_t right = 1;
  std::size_t top = 1;
  std::size_t left = 1;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = at(i + 1)[0] - at(i)[0];
    const double y = at(i + 1)[1] - at(i)[1];
    // Scaled, so that no square vanishes. (std::hypot's last bit is not the same everywhere.)
    const double longer = std::max(std::fabs(x), std::fabs(y));
    const double length = std::sqrt((x / longer) * (x / longer) + (y / longer) * (y / longer));
    const PlanePoint d = { x / longer / length, y / longer / length };
    const auto along = [&](const PlanePoint& p) { return d[0] * p[0] + d[1] * p[1]; };
    const auto above = [&](const PlanePoint& p) { return d[0] * p[1] - d[1] * p[0]; };
    // Each goes on from where it is, at most once around.
    right = std::max(right, i + 1);
    for (; right < i + n && along(at(right + 1)) > along(at(right)); ++right)
    {
    }
    top = std::max(top, right);
    for (; top < i + n && above(at(top + 1)) > above(at(top)); ++top)
    {
    }
    left = std::max(left, top);
    for (; left < i + n && along(at(left + 1)) < along(at(left)); ++left)
    {
    }
    const double area = (along(at(right)) - along(at(left))) * (above(at(top)) - above(at(i)));
    if (area < least.area)
    {
      least = { area, d };
    }
  }
  return least;
}

}

#endif
