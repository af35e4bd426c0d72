// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points with constraints as maps have them: coasts, contours, streets.
#ifndef flipflop_test_InputsConstrained_h
#define flipflop_test_InputsConstrained_h

#include "Testing/Engine/Inputs/Inputs.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{
namespace test
{

/// Points, and constraints between them; the last @c sides are sides of polygons.
struct ConstrainedInput
{
  Cloud cloud;
  std::vector<std::array<std::int64_t, 2>> segments;
  std::int64_t sides = 0;
};

/// A coast of an island, lakes in it, islands in these, and a pond in each of them: polygons of
/// about @p corners corners in all that do not cross. Land is inside. Soundings in the sea and
/// heights on land lie between.
ConstrainedInput coast(int corners, Random& random);

/// The contours of Mount St Helens (Data/sainthelens-contours.f32).
ConstrainedInput contours();

/// So many streets that cross: most short, some through the whole town, some in a grid's
/// directions.
ConstrainedInput streets(int count, Random& random);

/// About @p count points near those of a square grid, and @p most constraints, each from a point to
/// the one @p step further in its row, in every other row: a street map, or long lines.
ConstrainedInput gridWithSteps(int count, int step, int most, Random& random);

/// Points in the unit square of which a fifth are the ends of streets that cross: most are short,
/// one in a thousand is long.
ConstrainedInput streetsAmongPoints(int count, Random& random);

/// The contours, and as many points at random among them. No two points have one position.
ConstrainedInput contoursAmongPoints(int count, Random& random);

}
}

#endif
