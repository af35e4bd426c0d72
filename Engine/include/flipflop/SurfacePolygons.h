// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The polygons of a surface as triangles.
#ifndef flipflop_SurfacePolygons_h
#define flipflop_SurfacePolygons_h

#include <flipflop/Buffer.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>

namespace flipflop
{

/// A read-only view of polygons.
struct PolygonView
{
  /// Of all polygons, one after another: indices of points.
  const std::int64_t* corners = nullptr;
  /// One more than there are polygons: polygon i has corners[offsets[i]] up to, but not including,
  /// corners[offsets[i + 1]].
  const std::int64_t* offsets = nullptr;
  std::int64_t count = 0; ///< polygons
};

/// Triangles that polygons were cut into.
struct PolygonTriangles
{
  Buffer<std::int64_t> corners;    ///< three for each triangle: indices of points
  Buffer<std::int64_t> polygonIds; ///< for each triangle the polygon that it is of, ascending
};

/// Cut polygons into triangles, two fewer than a polygon has corners. They have the polygon's
/// corners and no other, and its orientation.
///
/// A polygon is cut as it is seen along a coordinate axis: one in whose direction it does not fold,
/// if there is one, and if possible that which is nearest to its normal. So concave polygons can be
/// cut, and polygons that are not quite flat. The signs that decide are exact, so each flat polygon
/// that does not cross or touch itself is cut, and no triangle of it is without area. Corners may
/// lie on a straight stretch of the border. A convex polygon without such corners becomes the fan
/// from its first corner; so does one with a corner that is not finite.
/// @param points   the corners, in space
/// @param polygons of three or more different corners; offsets ascend from any start
/// @param options  only the progress function is used
/// @throw Error    BadTriangle (index: the first polygon with a corner out of range or used twice,
///                 or with fewer than three; count: how many), NotSimple, BadArgument, OutOfMemory,
///                 Aborted
PolygonTriangles triangulatePolygons(
  const PointView& points, const PolygonView& polygons, const Options& options = Options());

}

#endif
