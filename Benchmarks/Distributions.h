// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The point sets that the benchmarks run on.
///
/// | name           | points                                                                  |
/// |----------------|-------------------------------------------------------------------------|
/// | cube           | uniform in the unit cube                                                |
/// | ball           | uniform in the ball of radius 0.5                                       |
/// | box:T          | uniform in the unit cube, at most T from its surface (T = 0.01)         |
/// | shell:T        | uniform in the ball of radius 0.5, at most T from its surface; T = 0:   |
/// |                | directions scaled to radius 0.5 and rounded, all of them extreme        |
/// | grid           | a cube of integer points, in raster order                               |
/// | surface-grid   | the points of such a grid on the cube's surface: six coplanar sheets    |
/// | rotated-grid   | the same, rotated and rounded: six sheets that are only nearly coplanar |
/// | duplicates     | shell:0, but only n / 100 different points, each drawn about 100 times  |
/// | coplanar       | z = x + y, exactly                                                      |
///
/// The first four are those of Gao et al. (gHull, 2012) and of the Flip-Flop paper.
///
/// In the plane, z is the point's weight:
///
/// | name           | points                                                                  |
/// |----------------|-------------------------------------------------------------------------|
/// | uniform:W      | uniform in the unit square, weights uniform in [0, W / n] (W = 0: none)  |
/// | square-grid    | a square of integer points, in raster order                             |
/// | weighted-grid  | the same, all of weight 1                                               |
/// | circle         | on a circle of radius 0.5, rounded                                      |
/// | clusters       | a hundred normal distributions of deviation 0.01                        |
/// | collinear      | y = 2 x, exactly                                                        |
/// | scan           | scan lines, noisy, in whole centimetres as airborne LiDAR has them      |
/// | repeats        | uniform:0, but only n / 2 different points, each drawn about twice      |
///
/// In space and in the plane there are those of ShapesInUse.h besides, in their order or shuffled.
///
/// file:PATH is read: x y z of each point, doubles (.f64) or floats (.f32). In the plane z is left
/// out.
///
/// uniform:27 keeps about a fifth of its points, uniform:0.19 all but a hundredth: those are the
/// Flip-Flop paper's.
#ifndef flipflop_Distributions_h
#define flipflop_Distributions_h

#include "Coordinates.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{

enum class Family
{
  Space,
  Plane
};

struct Distribution
{
  std::string name;
  double parameter = 0; ///< of box and shell: thickness; of uniform: W; 0 for the others
  std::string file;     ///< where the points are read from; the name is then the file's
  Family family = Family::Space;

  bool hasParameter() const
  {
    return this->name == "box" || this->name == "shell" || this->name == "uniform";
  }

  /// Have the points weights?
  bool isWeighted() const;

  /// As the command line gives it: "cube", "shell:0.01".
  std::string label() const;

  /// The reverse of label(), for one family's names.
  /// @throw std::invalid_argument which names the choices
  static Distribution parse(const std::string& text, Family family);
};

/// Those of ShapesInUse.h, each in its order and shuffled.
std::vector<Distribution> distributionsInUse(Family family);

/// x y z (or weight) of @p count points, a function of the arguments alone. The grids have the size
/// nearest to @p count that their shape allows; of a file it is all points.
/// @throw std::invalid_argument
Coordinates makePoints(const Distribution& distribution, std::int64_t count, std::uint64_t seed);

}

#endif
