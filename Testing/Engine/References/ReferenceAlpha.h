// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Alpha complexes by CGAL.
#ifndef flipflop_test_ReferenceAlpha_h
#define flipflop_test_ReferenceAlpha_h

#include "Testing/Engine/References/Reference.h"

#include <vector>

namespace flipflop
{
namespace test
{

/// Simplices by ids, which ascend; in lexicographic order.
struct ReferenceAlpha
{
  std::vector<Cell> triangles;
  std::vector<Cell> edges;    ///< that are no side of these
  std::vector<Cell> vertices; ///< that are at no end of any
};

/// By CGAL's alpha shapes, in their general mode, with exact comparisons. A weighted cloud without
/// ties: z is the weight.
/// @param alpha 0 or more; CGAL is given its square
ReferenceAlpha cgalAlpha(const Cloud& weighted, double alpha);

}
}

#endif
