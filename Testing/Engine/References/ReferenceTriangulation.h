// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Regular triangulations in the engine's canonical form, found by other means and in exact
/// arithmetic.
///
/// A weighted cloud is a Cloud of (x, y, weight): what makes, moves and prints clouds serves here
/// too.
#ifndef flipflop_test_ReferenceTriangulation_h
#define flipflop_test_ReferenceTriangulation_h

#include "Testing/Engine/References/Reference.h"

namespace flipflop
{
namespace test
{

/// What Triangulation promises, in plain containers; cells are polygons of input ids. The hidden
/// ids are all the others.
using ReferenceTriangulation = ReferenceHull;

/// Every triple of points, every lift against its plane: for up to about 40 points.
ReferenceTriangulation bruteForceTriangulation(const Cloud& weighted);

/// By CGAL in the plane, with its facets merged and its ties removed exactly; by an exact monotone
/// chain on a line.
/// @throw std::runtime_error when CGAL's triangles are not regular, or hide what they should not.
ReferenceTriangulation cgalTriangulation(
  const Cloud& weighted, CgalKernel kernel = CgalKernel::Filtered);

/// Which of CGAL's kernels is right for the cloud, and quickest.
CgalKernel kernelForWeighted(const Cloud& weighted);

/// All ids below @p count that are not among @p ids, which ascend.
Cell hiddenIds(std::int64_t count, const Cell& ids);

}
}

#endif
