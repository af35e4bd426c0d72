// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points as drawings, machines and scanners give them: along lines, rims and curves, many times
/// over.
///
/// | name         | points                                                                      |
/// |--------------|-----------------------------------------------------------------------------|
/// | box-edges    | at random on the twelve edges of a box of 2 by 1 by 0.5                     |
/// | box-edges-mm | the same, rounded to a thousandth                                           |
/// | plate        | at random on the edges of a drilled plate: its outline's and its holes'     |
/// | cylinder     | the two rims of a cylinder, evenly, as float: what an STL file has          |
/// | strands      | along ten smooth curves                                                     |
/// | eight        | the corners of a cube, each n / 8 times                                     |
/// | pancake      | on an ellipsoid of semi-axes 1, 1 and 0.01, rotated                         |
///
/// In the plane:
///
/// | name         | points                                                                      |
/// |--------------|-----------------------------------------------------------------------------|
/// | drawing      | at random on lines and arcs, as of a CAD drawing                            |
/// | streets      | at random on a grid of lines, askew, in metres far from the origin          |
/// | time-series  | (i, a random walk), shuffled                                                |
/// | two-lines    | at random on two lines that cross                                           |
/// | rings        | on concentric circles, evenly                                               |
/// | parabola     | on (t, t^2)                                                                 |
/// | near-line    | on a line, but for the rounding to doubles                                  |
#ifndef flipflop_ShapesInUse_h
#define flipflop_ShapesInUse_h

#include "Coordinates.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{

/// Their names, in space or in the plane.
std::vector<std::string> shapesInUse(bool space);

/// x y z (in the plane: 0) of @p count points, a function of the arguments alone.
/// @param name one of shapesInUse()
Coordinates makeShapeInUse(const std::string& name, std::int64_t count, std::uint64_t seed);

}

#endif
