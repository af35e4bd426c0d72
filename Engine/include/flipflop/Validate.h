// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The validator: is this the convex hull, or the regular or constrained triangulation, of these
/// points, in canonical form?
///
/// It uses the engine's exact predicates, and the checks and walks of queries, but no code that
/// computes results. The predicates themselves are tested against rationals.
#ifndef flipflop_Validate_h
#define flipflop_Validate_h

#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Hull.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <cstdint>

namespace flipflop
{

/// What is wrong with a result.
enum class Fault
{
  None,          ///< nothing
  Structure,     ///< sizes, indices, order of ids or cells; a cell not at its lowest corner; a
                 ///< facet's triangles not the fan from its lowest corner
  NotClosed,     ///< an edge without its opposite, or used twice
  NotConvex,     ///< an edge that is reflex, or flat where two polygons meet; a facet not planar; a
                 ///< border that turns right, or -1: goes around more than once
  NotExtreme,    ///< a hull point that is not strictly extreme
  PointOutside,  ///< an input point outside the hull
  NotFixed,      ///< a constraint that is no chain of fixed edges; or -1: a fixed edge that is no
                 ///< edge, or of another constraint than it names
  WrongId,       ///< a hull point that has a duplicate with a lower id
  WrongDimension ///< the input spans another dimension
};

/// A judgement: the first fault that was found, if any.
struct Validation
{
  Fault fault = Fault::None; ///< what is wrong
  std::int64_t index = -1;   ///< cell, hull point or input point at fault, by kind
  /// Whether all is right.
  explicit operator bool() const { return this->fault == Fault::None; }
};

/// Decide exactly whether @p hull is the convex hull of the finite points among @p points, in the
/// form that Hull promises. Near-linear in the number of points.
/// @param points  the points of the hull
/// @param hull    with facets as triangles or as polygons
/// @param threads as in Options
/// @return the first fault, or none
/// @throw Error   TooManyPoints, OutOfMemory, BadArgument
Validation validate(const PointView& points, const Hull& hull, int threads = 0);

/// Decide exactly whether @p triangulation is the regular triangulation of the finite points among
/// the weighted points, in the form that Triangulation promises: every triangle counter-clockwise,
/// every edge regular, the union convex, every hidden point really hidden. Here NotExtreme is a
/// point that should be hidden, and PointOutside is a point that should not be hidden.
/// @param points        the points that were triangulated
/// @param weights       as they were triangulated
/// @param triangulation with facets as triangles or as polygons
/// @param threads       as in Options
/// @return the first fault, or none
/// @throw Error         WeightCount, TooManyPoints, OutOfMemory, BadArgument
Validation validate(const PointView& points, const WeightView& weights,
  const Triangulation& triangulation, int threads = 0);

/// Decide exactly whether @p triangulation is the constrained Delaunay triangulation of the finite
/// points, in the form that ConstrainedTriangulation promises: every triangle counter-clockwise,
/// every edge fixed or locally Delaunay, every constraint a chain of fixed edges, the union convex.
/// Here PointOutside is a point of no corner.
/// @param points        the points that were triangulated
/// @param constraints   as they were given
/// @param triangulation with facets as triangles or as polygons
/// @param threads       as in Options
/// @return the first fault, or none
/// @throw Error         ConstraintPoint, TooManyPoints, OutOfMemory, BadArgument
Validation validate(const PointView& points, const ConstraintView& constraints,
  const ConstrainedTriangulation& triangulation, int threads = 0);

/// A fault in words.
const char* describe(Fault fault);

}

#endif
