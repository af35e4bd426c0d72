// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A regular (weighted Delaunay) triangulation in the plane, in its canonical form.
#ifndef flipflop_Triangulation_h
#define flipflop_Triangulation_h

#include <flipflop/CellComplex.h>

namespace flipflop
{

/// The regular triangulation of weighted points, whatever they span:
///
/// | dimension | cells                                                                |
/// |-----------|----------------------------------------------------------------------|
/// | -1        | none: there was no point                                             |
/// | 0         | one cell of one corner: the greatest weight, then the lowest id      |
/// | 1         | the chain along the line: cells of two corners, the lower id first   |
/// | 2         | the triangles, counter-clockwise, none without area; or, as polygons, |
/// |           | one cell for all points of one power circle                          |
///
/// A point appears if its lift (x, y, x^2 + y^2 - w) is a strictly extreme vertex of the lower hull
/// of all lifts. The lowest id represents points with the same position and weight. All other
/// points are hidden, also ties.
struct Triangulation : CellComplex
{
  /// The ids of the points that do not appear, ascending. Points that were omitted because they
  /// are not finite are in neither list.
  Buffer<std::int64_t> hiddenIds;
};

}

#endif
