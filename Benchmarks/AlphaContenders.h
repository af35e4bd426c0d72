// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a contender has found of an alpha complex, and in what time.
#ifndef flipflop_AlphaContenders_h
#define flipflop_AlphaContenders_h

#include <cstdint>
#include <vector>

namespace flipflop
{

struct AlphaOutcome
{
  double seconds = 0;
  std::int64_t triangles = 0; ///< in the complex
  std::int64_t edges = 0;     ///< in it beside these
};

/// CGAL's Alpha_shape_2 with exact comparisons, in its general mode: triangulated, all alphas
/// sorted, and the simplices of one alpha counted.
/// @param places x, y of each point
AlphaOutcome runCgalAlpha(const std::vector<double>& places, double alpha);

}

#endif
