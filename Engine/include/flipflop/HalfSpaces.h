// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The intersection of half-spaces, as the dual of a convex hull.
#ifndef flipflop_HalfSpaces_h
#define flipflop_HalfSpaces_h

#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>

#include <cstdint>

namespace flipflop
{

/// A read-only view of half-spaces, of space or of the plane: the positions x with
/// normal . x + offset <= 0.
struct HalfSpaceView
{
  const double* rows = nullptr; ///< for each its normal, dimension numbers, then its offset
  std::int64_t count = 0;       ///< half-spaces
  int dimension = 3;            ///< 3, or 2
};

/// What half-spaces have in common.
enum class Intersection : std::uint8_t
{
  Bounded,   ///< a solid; in the plane a polygon
  Unbounded, ///< an inside, with a ray in it
  Flat,      ///< positions, but none is strictly inside all half-spaces
  Empty      ///< nothing
};

/// The intersection of half-spaces: a convex solid, or a polygon.
///
/// Its cells are its vertices, each with the half-spaces whose borders meet there, exactly: three
/// or more, counter-clockwise as seen from outside, so that those in turn share an edge; in the
/// plane the two before and after the vertex, and vertices are counter-clockwise, from the half-
/// plane of lowest id. pointIds are ids of half-spaces: those that have a facet; in the plane a
/// side. Others are redundant: duplicates (all but the lowest id), those that the border does not
/// touch, and those that it touches at a vertex or an edge alone.
struct HalfSpaceIntersection : CellComplex
{
  Intersection kind = Intersection::Empty; ///< others than Bounded have no cells

  /// A position strictly inside, the given one or one that was found; of Flat and Empty NaN.
  double interior[3] = { 0, 0, 0 };

  /// For each cell its position, dimension coordinates, each the nearest double of the exact one.
  Buffer<double> vertices;

  /// For each half-space, redundant ones too, its dual point: normal / -(normal . interior +
  /// offset), dimension coordinates, rounded to nearest. The half-spaces with a facet are the
  /// vertices of their hull. Of Bounded and Unbounded alone; a normal of zeros has the dual point
  /// 0.
  Buffer<double> dualPoints;
};

/// The exact intersection of half-spaces.
///
/// Which half-spaces meet at which vertex is the combinatorial hull of the dual points, decided by
/// signs of determinants of the given numbers (Preparata, Muller: Finding the intersection of n
/// half-spaces in time O(n log n), 1979). A normal of zeros stands for all positions, or for none
/// if its offset is positive.
/// @param halfSpaces finite numbers; at most 2^32 - 16 half-spaces
/// @param interior   a position that is strictly inside all, dimension coordinates; null: one is
///                   found
/// @param options    threads, progress; they change no bit of the result
/// @throw Error      BadArgument: with the index of the first half-space that does not hold the
///                   interior strictly inside; or where no position in doubles is found strictly
///                   inside; or where vertices or the interior are beyond about 2^1020. NonFinite
///                   (index: of the half-space), TooManyPoints, OutOfMemory, Aborted
HalfSpaceIntersection halfSpaceIntersection(const HalfSpaceView& halfSpaces,
  const double* interior = nullptr, const Options& options = Options());

}

#endif
