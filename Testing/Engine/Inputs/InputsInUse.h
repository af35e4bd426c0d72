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
/// | twenty-turns     | evenly along a helix                                                    |
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
/// The contours are polylines of 35,764 vertices: more points than that lie on their straight
/// pieces, every 26 m at 1e5 points.
///
/// Each is there as `NAME-shuffled`, too: the same points in random order.
///
/// Other families of millions of points, which tests and benchmarks call by name:
///
/// | name            | points                                                                   |
/// |-----------------|--------------------------------------------------------------------------|
/// | shell1e3        | in the ball of radius 0.5, at most 0.001 times the radius from its sphere |
/// | cube-grid       | a cube of integer points, in raster order                                |
/// | surface-grid    | the points of such a grid on the cube's surface: six coplanar sheets     |
/// | rotated-grid    | the same, rotated and rounded: six sheets that are only nearly coplanar  |
/// | duplicates      | on a sphere: n / 100 positions, each 100 times                           |
/// | coplanar        | z = x + y, exactly                                                       |
///
/// | in the plane    |                                                                          |
/// |-----------------|--------------------------------------------------------------------------|
/// | hundred-normals | a hundred normal distributions of deviation 0.01                         |
/// | scan            | scan lines, noisy, in whole centimetres as airborne LiDAR has them       |
/// | repeats         | uniform, but only n / 2 positions, each twice                            |
#ifndef flipflop_test_InputsInUse_h
#define flipflop_test_InputsInUse_h

#include "Testing/Engine/Inputs/Inputs.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

const std::vector<Family>& familiesInSpace();
const std::vector<Family>& familiesInPlane();

/// The families in use, of points in space or of weighted sites in the plane.
std::vector<std::string> namesInUse(bool isPlane);

/// Each name, and that of the same points shuffled.
std::vector<std::string> withShuffled(const std::vector<std::string>& names);

/// The points of a family: of families() or weightedFamilies(), or of this file; a function of the
/// arguments alone. Grids have the size nearest to @p count that their shape allows.
/// @param name may end in "-shuffled"
/// @throw std::invalid_argument for an unknown name: the message has the known ones
Cloud makeCloud(const std::string& name, bool isPlane, int count, std::uint64_t seed);

}
}

#endif
