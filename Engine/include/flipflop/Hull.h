// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A convex hull, in its canonical form.
#ifndef flipflop_Hull_h
#define flipflop_Hull_h

#include <flipflop/CellComplex.h>

namespace flipflop
{

/// The convex hull of a point set, whatever its dimension:
///
/// | dimension | cells                                                             |
/// |-----------|-------------------------------------------------------------------|
/// | -1        | none: there was no point                                          |
/// | 0         | one cell of one corner                                            |
/// | 1         | one cell of two corners: the ends                                 |
/// | 2         | the polygon once (or its triangles); its normal's last non-zero   |
/// |           | component is positive                                             |
/// | 3         | the facets (or their triangles), counter-clockwise from outside   |
///
/// Each point is strictly extreme, and has the lowest id of its position.
struct Hull : CellComplex
{
  double volume = 0; ///< of the solid; 0 below dimension 3
  double area = 0;   ///< of the surface; of the polygon, once, in dimension 2
};

}

#endif
