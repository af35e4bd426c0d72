// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The alpha complex of points in the plane, also of weighted ones (H. Edelsbrunner, "Weighted
/// alpha shapes", 1992): the shape that remains where a circle of radius alpha, moved among the
/// points, takes away what it can reach without a point in it.
#ifndef flipflop_AlphaComplex_h
#define flipflop_AlphaComplex_h

#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <cstdint>

namespace flipflop
{

/// What of a triangulation is in its alpha complex.
///
/// The circle of a cell, an edge or a point is the least one of power distance 0 from all its
/// corners. Without weights, it is the least circle through them: a point's has the radius 0. With
/// weights, the square of its radius may be negative. A simplex is in the complex if the square of
/// its own circle is at most alpha |alpha|, and no other corner has a negative power distance from
/// that circle; or if a larger simplex of the complex has it. So alpha is a length, and a negative
/// one stands for a negative square. With alpha 0, the complex of disks (the weight is the square
/// of the radius) is the nerve of their union.
struct AlphaComplex
{
  Buffer<std::uint8_t> cells; ///< for each cell of the triangulation: 1 if it is in the complex
  std::int64_t cellCount = 0; ///< how many are

  /// The edges in the complex that are no side of such a cell, two corners each: indices into
  /// pointIds, the lower one first. In lexicographic order. They are called singular.
  Buffer<std::int64_t> edges;
  Buffer<double> edgeAlphas; ///< of each of them, as cellAlphas() has them

  /// The points in the complex that are at no such cell or edge: indices into pointIds, ascending.
  Buffer<std::int64_t> vertices;
  Buffer<double> vertexAlphas; ///< of each of them; without weights, 0
};

/// The alpha complex of a triangulation. All is decided exactly, at every range: a circle as large
/// as alpha is in. The circle of a polygon is that of all its corners.
///
/// A constrained triangulation has a complex as well. What is said of other corners then holds of
/// those of the two cells at an edge.
/// @param points        as they were triangulated; x and y are read
/// @param weights       as they were triangulated
/// @param triangulation of these points; dimension -1 to 2, in triangles or polygons. Cells may be
///                      missing
/// @param alpha         a length; infinity: all is in
/// @param singular      whether the remaining edges and points are wanted
/// @param options       only the threads and the progress function are used
/// @return              the complex
/// @throw Error         BadArgument (alpha is NaN, a dimension of 3, an index or id out of range, a
///                      corner that is not finite, a cell that is not counter-clockwise; with
///                      @p singular, an edge of more than two cells), WeightCount, TooManyPoints,
///                      OutOfMemory, Aborted
AlphaComplex alphaComplex(const PointView& points, const WeightView& weights,
  const CellComplex& triangulation, double alpha, bool singular = false,
  const Options& options = Options());

/// All alphas at once: for each cell the least double for which alphaComplex() has it. So the cells
/// of the complex are those whose number is not greater than alpha, exactly. Without weights, it is
/// the radius of the circumcircle, rounded up; infinity if that is no double.
/// @param points, weights, triangulation, options as for alphaComplex()
/// @param alphas        receives a number for each cell
/// @throw Error         as alphaComplex(); BadArgument also for no array for the results
void cellAlphas(const PointView& points, const WeightView& weights,
  const CellComplex& triangulation, double* alphas, const Options& options = Options());

}

#endif
