// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What convex hulls are for: is a point inside, how far away is it, which vertex is the farthest
/// in a direction, how long is the hull, and which box holds it?
#ifndef flipflop_HullQueries_h
#define flipflop_HullQueries_h

#include <flipflop/Buffer.h>
#include <flipflop/Hull.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>
#include <memory>

namespace flipflop
{

/// Which coordinates count, of a hull's points and of the queries.
enum class PointSpace : std::uint8_t
{
  Space, ///< x, y and z
  Plane  ///< x and y: z is not read. A polygon has an inside, and its border is the surface
};

/// On which side of a hull's surface a point is. Of points in space, a hull below dimension 3 has
/// no inside; of points in the plane, one below dimension 2.
enum class Side : std::int8_t
{
  Outside = -1, ///< not in the hull
  On = 0,       ///< on the surface; of a hull without an inside, in the hull
  Inside = 1    ///< in the hull, not on its surface
};

/// Two points of a hull that are as far apart as any two are.
struct Diameter
{
  std::int64_t first = -1;  ///< its id: an index of the hull's points; -1: the hull is empty
  std::int64_t second = -1; ///< its id, not below the first; that of the same point in dimension 0
  double length = 0;        ///< their distance, off by a few units of its last place
};

/// A box in any position: the points center + x axes[0] + y axes[1] + z axes[2], with |x|, |y|, |z|
/// up to half of lengths[0], [1], [2].
struct OrientedBox
{
  double center[3] = { 0, 0, 0 }; ///< the middle of the box
  /// Orthonormal up to rounding, right-handed; the direction of the longest side first.
  double axes[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  /// Of the sides, descending; 0 from the hull's dimension on. Infinity: no double is so large.
  double lengths[3] = { 0, 0, 0 };
  double volume = 0;     ///< the product of the lengths; of points in the plane, of two
  double lowerBound = 0; ///< no box that holds the hull has less volume
};

class PreparedHull;

/// Questions about one hull. It keeps what it needs of the hull and its points, and prepares what a
/// kind of query needs when the first one comes. Any number of threads may query at once.
///
/// Of the options, threads and progress count, and nonFinite for the points of queries:
/// such a point is an error, or it has the result that each function names. Results do not depend
/// on the number of threads, bit for bit.
class HullQueries
{
public:
  /// @param points of the hull; not needed any more afterwards
  /// @param hull   as convexHull() or convexify() give it, in triangles or polygons; of any
  ///               dimension. That it is convex is not checked: see validate().
  /// @param options threads, progress
  /// @param space  Plane: the points are in the plane. The hull is that of the same points with one
  ///               z for all; then all questions are about the plane
  /// @throw Error  BadArgument (also for a hull that has not the form which Hull promises, or is
  /// not
  ///               one of these points), TooManyPoints, OutOfMemory, Aborted
  HullQueries(const PointView& points, const Hull& hull, const Options& options = Options(),
    PointSpace space = PointSpace::Space);
  HullQueries(const HullQueries&) = delete;
  HullQueries& operator=(const HullQueries&) = delete;
  /// Takes all over; @p other may then only be destroyed or assigned to.
  HullQueries(HullQueries&& other) noexcept;
  /// As the constructor.
  HullQueries& operator=(HullQueries&& other) noexcept;
  ~HullQueries();

  /// On which side each point is. Exact, for all finite points: no tolerance decides.
  ///
  /// Points outside the bounding box take a few comparisons each, and nearly all that are deep
  /// inside a table lookup. The others take a short walk over the triangles.
  /// @param queries points
  /// @param sides   space for one value a point: those of Side. Outside, for a point that is not
  ///                finite and ignored
  /// @param options threads, progress, nonFinite
  /// @throw Error   BadArgument, TooManyPoints, NonFinite, OutOfMemory, Aborted
  void contains(
    const PointView& queries, std::int8_t* sides, const Options& options = Options()) const;

  /// The distance of each point from the surface; of a hull without an inside, from the hull. It is
  /// negative inside, 0 on the surface and positive outside; this sign is exact. The distance
  /// itself is rounded: it is off by no more than 1e-14 times the distance to the farthest vertex,
  /// and 5e-324, whatever the size and the shape of the hull.
  ///
  /// Branch and bound over a tree of the triangles, from one near the point. It takes about as long
  /// as the logarithm of their number, but for points that very many triangles are about as near
  /// to, such as the centre of a sphere.
  /// @param queries   points
  /// @param distances space for one value a point, in the unit of the coordinates. Infinity: the
  /// hull
  ///                  is empty, or no double is so large. NaN: the point is not finite and ignored
  /// @param options   threads, progress, nonFinite
  /// @throw Error     BadArgument, TooManyPoints, NonFinite, OutOfMemory, Aborted
  void distance(
    const PointView& queries, double* distances, const Options& options = Options()) const;

  /// The vertex that is farthest along each direction: the one with the largest dot product. Exact,
  /// for all finite directions, of any length; of several such vertices it is the one of lowest id.
  /// All are equally far along the direction 0 0 0.
  ///
  /// A table of directions holds a vertex near the result, or the result where a vertex is extreme
  /// in many directions. From there on the way leads uphill over the edges.
  /// @param directions vectors
  /// @param ids     space for one id a direction: an index of the hull's points. -1: the hull is
  ///                empty, or the direction is not finite and ignored
  /// @param options threads, progress, nonFinite
  /// @throw Error   BadArgument, TooManyPoints, NonFinite, OutOfMemory, Aborted
  void support(
    const PointView& directions, std::int64_t* ids, const Options& options = Options()) const;

  /// The vertices that are farthest apart: of all such pairs that of the lowest first id, then of
  /// the lowest second. Distances are compared exactly.
  ///
  /// Branch and bound over pairs of boxes. It is near-linear for solids and for spheres, where very
  /// many vertices are nearly as far from another one.
  /// @param options threads, progress
  /// @throw Error   OutOfMemory, Aborted
  Diameter diameter(const Options& options = Options()) const;

  /// A small box that holds the hull: of the boxes that are tried, the one of least volume. It is
  /// not proven to be the least of all, but no box has less volume than its lowerBound, the greater
  /// of the hull's volume and three times that of a large tetrahedron in the hull.
  ///
  /// Tried are the box along the coordinate axes, and the least boxes that have an axis along the
  /// normal of a facet; where these are less than 128, also along an edge, or along one of some
  /// directions all around. Of hulls of up to 64 edges, triangulated, also the boxes with two
  /// sides, next to each other, that run along an edge each, as a least box has: these are sampled,
  /// and the promising ones improved. The best boxes are improved by keeping each axis in turn and
  /// choosing the others again. A hull of dimension 2 gets its rectangle of least area, up to
  /// rounding. Of points in the plane, that is the box: its third axis is z, and volume and
  /// lowerBound are the rectangle's area.
  ///
  /// No vertex is farther outside the box than 1e-14 times the hull's largest coordinate or length.
  /// (So a side of less than 1e-300 times the longest may be zero.)
  /// @param options threads, progress
  /// @return        for an empty hull, a box of lengths 0 at the origin
  /// @throw Error   OutOfMemory, Aborted
  OrientedBox minimalBox(const Options& options = Options()) const;

private:
  std::unique_ptr<const PreparedHull> model;
};

/// The planes of a hull's cells: four doubles a cell, the outward unit normal n and the offset d,
/// so that n . x + d is at most 0 for the hull's points, and the distance from the plane elsewhere.
/// For a hull of dimension 2, the plane of the polygon, its normal on the side that Hull names.
/// Empty below dimension 2.
///
/// Each component of a normal is off by no more than 1e-15 of itself and 1e-280, however thin the
/// cell is. The corners of the hull give n . x + d at most 2e-15 times the hull's largest
/// coordinate. An offset that no double holds is infinite.
/// @param points  of the hull
/// @param hull    in triangles or polygons, as convexHull() or convexify() give it
/// @param options threads, progress
/// @throw Error   BadArgument (also for a hull that has not the form which Hull promises, or is not
///                one of these points), TooManyPoints, OutOfMemory, Aborted
Buffer<double> facetPlanes(
  const PointView& points, const Hull& hull, const Options& options = Options());

}

#endif
