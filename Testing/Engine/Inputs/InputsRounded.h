// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Weighted sites that are all but degenerate, and so far from the origin that rounding tells: the
/// corners of their power cells round past each other.
#ifndef flipflop_test_InputsRounded_h
#define flipflop_test_InputsRounded_h

#include "Testing/Engine/Inputs/Inputs.h"

namespace flipflop
{
namespace test
{

const std::vector<Family>& roundedFamilies();

/// In radians.
double angleOf(double turns);

/// Points of a circle of radius 1 around (@p x, @p y), at equal angles.
Cloud circleAt(int count, double x, double y);

}
}

#endif
