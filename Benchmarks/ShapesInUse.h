// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points as drawings, machines, scanners and surveys give them: along lines, rims and curves, on
/// grids and walls, many times over.
///
/// | name             | points                                                                  |
/// |------------------|-------------------------------------------------------------------------|
/// | box-edges        | at random on the twelve edges of a box of 2 by 1 by 0.5                 |
/// | box-edges-mm     | the same, rounded to a thousandth                                       |
/// | plate            | at random on the edges of a drilled plate: its outline's and its holes' |
/// | cylinder         | the two rims of a cylinder, evenly, as float: what an STL file has      |
/// | rotated-cylinder | the same, rotated: rims that are only nearly coplanar                   |
/// | cone             | the tip and the rim of a cone, evenly, rotated                          |
/// | wall             | at random on a rectangle, rotated: coplanar but for the rounding        |
/// | room             | on the walls of a room and on ten boxes in it, to two millimetres       |
/// | gcode            | along a printer's paths, layer by layer: outline and infill, in microns |
/// | voxels           | integer points: the surface of a blob, row by row                       |
/// | rgb              | an image's colours as bytes: half of them grey, many times over         |
/// | ecef-tile        | ten kilometres of sea level, in metres from the Earth's centre          |
/// | strands          | along ten smooth curves                                                 |
/// | moment-curve     | at random on (t, t^2, t^3)                                              |
/// | helix            | evenly along twenty turns                                               |
/// | knot             | evenly along a trefoil                                                  |
/// | eight            | the corners of a cube, each n / 8 times                                 |
/// | pancake          | on an ellipsoid of semi-axes 1, 1 and 0.01, rotated                     |
///
/// In the plane, drawings and plots:
///
/// | name         | points                                                                      |
/// |--------------|-----------------------------------------------------------------------------|
/// | drawing      | at random on lines and arcs, as of a CAD drawing                            |
/// | outlines     | evenly along 400 equal parts on a sheet: rounded squares with a hole        |
/// | hatch        | evenly along 200 parallel lines that fill a disk                            |
/// | two-lines    | at random on two lines that cross                                           |
/// | near-line    | on a line, but for the rounding to doubles                                  |
/// | parabola     | at random on (t, t^2)                                                       |
/// | rings        | on concentric circles, evenly                                               |
/// | spiral       | along fifty turns                                                           |
/// | sines        | twenty sine curves, one above another                                       |
/// | time-series  | (i, a random walk)                                                          |
/// | pixels       | integer points at random, as many as the image has pixels: some twice       |
///
/// In the plane, surveys of the ground, and meshes:
///
/// | name          | points                                                                     |
/// |---------------|----------------------------------------------------------------------------|
/// | streets       | at random on a grid of lines, askew, in metres far from the origin         |
/// | roads         | evenly along 300 winding roads that begin at one another, in centimetres   |
/// | trajectories  | a hundred smooth random walks, step by step                                |
/// | lidar         | an airborne scanner's zig-zag, twenty times as dense along as across       |
/// | contours      | evenly along the contours of Mount St Helens, at every 20 m of height      |
/// | dem-utm       | a grid of ten metres in UTM coordinates                                    |
/// | dem-rotated   | the same, rotated and rounded                                              |
/// | jittered-grid | one point in each cell of a grid, away from the others: blue noise         |
/// | graded-mesh   | twenty clusters whose density falls with the squared distance              |
/// | terrain       | a jittered grid; the weights grow with the squared height of hills         |
/// | packing       | disks beside one another, of very different sizes; weight: squared radius  |
///
/// The contours are those of `Data/sainthelens-contours.f32`, polylines of 35,764 vertices: more
/// points than that lie on their straight pieces, every 26 m at 1e5 points.
///
/// Each is there as `NAME-shuffled`, too: the same points in random order.
#ifndef flipflop_ShapesInUse_h
#define flipflop_ShapesInUse_h

#include "Coordinates.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{

/// Their names as above, in space or in the plane.
std::vector<std::string> shapesInUse(bool space);

/// Each name, and that of the same points shuffled.
std::vector<std::string> withShuffled(const std::vector<std::string>& names);

/// Is it one of their names, and have its points weights?
bool isWeightedShape(const std::string& name);

/// x y z (in the plane: the weight, or 0) of @p count points, a function of the arguments alone.
/// @param name one of shapesInUse(), or of withShuffled()
/// @throw std::invalid_argument for another name, or where the contours cannot be read
Coordinates makeShapeInUse(const std::string& name, std::int64_t count, std::uint64_t seed);

}

#endif
