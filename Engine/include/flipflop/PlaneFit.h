// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points in space as points of the xy plane, or of the plane that fits them best, and back.
#ifndef flipflop_PlaneFit_h
#define flipflop_PlaneFit_h

#include <flipflop/Buffer.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// A plane in space, with a right-handed frame: first, second, and the normal.
struct FittedPlane
{
  std::array<double, 3> start{};  ///< the first finite point: (0, 0) in the plane; the origin: none
  std::array<double, 3> origin{}; ///< its foot on the plane
  std::array<double, 3> first{};  ///< the first axis, of length 1 but for rounding
  std::array<double, 3> second{}; ///< the second axis
};

/// The plane through the points' centroid with the least sum of squared distances to them. Points
/// that are not finite do not count.
///
/// The normal's component of largest magnitude is positive (the last one, if several are equal).
/// Of several planes that fit alike, as those of points on a line do, one is taken. The first axis
/// is the next coordinate axis after that component's (y after x, x after z), projected into the
/// plane.
///
/// All is computed in double and in a fixed order, so the same points give the same bits.
/// @param points  in space
/// @param options only the progress function is used; it is called with 0 from time to time
/// @throw Error   BadArgument, TooManyPoints, Aborted
FittedPlane fitPlane(const PointView& points, const Options& options = Options());

/// What fitPlane() sums, for points that come in parts, such as those of several processes. The
/// sums depend on the order of the points, so parts are added in this order, each to what the one
/// before it left:
///
///     for each part: addExtent(sums, part);   // or of each part alone, then joinExtent() in order
///     for each part: addToSum(sums, part);
///     for each part: addToSpread(sums, part);
///     planeOf(sums)                           // fitPlane() of all, bit for bit
///
/// It is plain doubles, which can be sent.
struct PlaneSums
{
  std::array<double, 3> start{};                 ///< the first finite point
  double count = 0.0;                            ///< finite points
  double largest = 0.0;                          ///< magnitude of a coordinate
  std::array<double, 3> sum{};                   ///< of the points, from start
  std::array<std::array<double, 3>, 3> spread{}; ///< of products of coordinates, from the mean
};

///@{
/// The three passes over the points of a part.
/// @param sums    of all parts before it
/// @param points  in space
/// @param options only the progress function is used; it is called with 0 from time to time
/// @throw Error   BadArgument, TooManyPoints, Aborted
void addExtent(PlaneSums& sums, const PointView& points, const Options& options = Options());
void addToSum(PlaneSums& sums, const PointView& points, const Options& options = Options());
void addToSpread(PlaneSums& sums, const PointView& points, const Options& options = Options());
///@}

/// Add to the extent of parts that of the parts that follow.
void joinExtent(PlaneSums& sums, const PlaneSums& next);

/// The plane of all parts.
FittedPlane planeOf(const PlaneSums& sums);

/// The positions of points in the plane: x and y of each, measured from start; rounded. NaN, if a
/// coordinate of the point is not finite.
/// @param points  in space
/// @param plane   that fitPlane() gave
/// @param options only the threads and the progress function are used
/// @throw Error   BadArgument, TooManyPoints, OutOfMemory, Aborted
Buffer<double> positionsInPlane(
  const PointView& points, const FittedPlane& plane, const Options& options = Options());

/// The position in space of a position in the plane, rounded.
std::array<double, 3> positionOf(const FittedPlane& plane, double x, double y);

/// x and y of points whose z does not matter, but must be finite: x is NaN where z is not.
/// @param points  in space
/// @param options only the threads and the progress function are used
/// @return x and y of each; empty if all z are finite, so that x and y can be read in place
/// @throw Error   BadArgument, TooManyPoints, OutOfMemory, Aborted
Buffer<double> positionsInXY(const PointView& points, const Options& options = Options());

/// Where the xy plane lies for what is drawn in it: at the lowest z of the points that are in the
/// triangulation or hidden; at 0 if there is none. It is never -0.
/// @param points        in space
/// @param triangulation of these points, projected to the xy plane
double heightBelow(const PointView& points, const Triangulation& triangulation);

}

#endif
