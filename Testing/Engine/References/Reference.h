// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Convex hulls in the engine's canonical form, found by other means and in exact arithmetic.
#ifndef flipflop_test_Reference_h
#define flipflop_test_Reference_h

#include "Testing/Engine/References/Exact.h"

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

using Cell = std::vector<std::int64_t>;

/// What Hull promises, in plain containers. Cells are polygons of input ids.
struct ReferenceHull
{
  int dimension = -1;
  std::vector<std::int64_t> ids;
  std::vector<Cell> cells;
};

bool operator==(const ReferenceHull& a, const ReferenceHull& b);

/// Every plane through three points, every point against it: for up to about 40 points.
ReferenceHull bruteForceHull(const Cloud& cloud);

enum class CgalKernel
{
  Filtered, ///< interval arithmetic first: quick, for ordinary ranges
  Rational  ///< rationals throughout: slow, for extreme ranges
};

/// By CGAL in space, with its facets merged exactly; by an exact monotone chain in a plane.
/// @throw std::runtime_error when CGAL's surface is not a closed convex polyhedron.
ReferenceHull cgalHull(const Cloud& cloud, CgalKernel kernel);
ReferenceHull cgalHull(const Cloud& cloud); ///< by the kernel that kernelForHull() chooses

/// Which of CGAL's kernels is right for the cloud, and quickest.
CgalKernel kernelForHull(const Cloud& cloud);

/// Turn every cell to start at its lowest id, and sort the cells.
void canonicalise(std::vector<Cell>& cells);

/// The ids that occur in the cells, ascending.
Cell idsIn(const std::vector<Cell>& cells);

/// Every cell of more than two corners as a fan from its first, sorted.
std::vector<Cell> triangulate(const std::vector<Cell>& polygons);

/// For every point the lowest id at its position (0 and -0 are one position).
std::vector<std::int64_t> lowestIds(const Cloud& cloud);

/// The volume of the solid, and the area of the surface, in long double.
struct Measures
{
  double volume = 0;
  double area = 0;
};
Measures measure(const Cloud& cloud, const ReferenceHull& hull);

/// For failure messages.
std::string toString(const Cell& cell);
std::string toString(const Cloud& cloud);

}
}

#endif
