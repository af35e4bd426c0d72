// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The installed engine, without VTK.
#include <flipflop/ConvexHull.h>
#include <flipflop/Validate.h>

#include <cstdlib>

int main()
{
  const float xyz[] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.25f, 0.25f, 0.25f };
  const flipflop::PointView points(xyz, 5);
  const flipflop::Hull hull = flipflop::convexHull(points);
  const bool right = hull.dimension == 3 && hull.pointIds.size() == 4 && hull.cellCount() == 4;
  return right && flipflop::validate(points, hull) ? EXIT_SUCCESS : EXIT_FAILURE;
}
