// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constrained Delaunay triangulations in the engine's canonical form, found by other means and in
/// exact arithmetic. Clouds have nothing but zeros for z.
#ifndef flipflop_test_ReferenceConstrained_h
#define flipflop_test_ReferenceConstrained_h

#include "Testing/Engine/References/ReferenceTriangulation.h"

#include <array>
#include <cstdint>
#include <vector>

namespace flipflop
{
namespace test
{

/// Ids of both ends.
using Segment = std::array<std::int64_t, 2>;

/// An edge and the first constraint that runs along it.
struct FixedSegment
{
  Segment ends; ///< the lower one first
  std::int64_t constraint;

  friend bool operator==(const FixedSegment& a, const FixedSegment& b)
  {
    return a.ends == b.ends && a.constraint == b.constraint;
  }
};

/// What ConstrainedTriangulation promises, in plain containers.
struct ReferenceConstrained
{
  ReferenceTriangulation triangulation;
  std::vector<FixedSegment> fixed; ///< in the order of their ends
  /// The first constraint that crosses an earlier one between points, and the first that it
  /// crosses. Where there is one, nothing else is told.
  std::int64_t crossing = -1;
  std::int64_t crossed = -1;
};

/// Any triangulation that has the constraints, and flips one after another: for up to about 12
/// points.
ReferenceConstrained bruteForceConstrained(
  const Cloud& cloud, const std::vector<Segment>& constraints);

/// By CGAL, with its ties merged exactly. The points are not all on one line, and no constraints
/// cross. CGAL does not tell which constraint an edge comes of: -1.
/// @throw std::runtime_error when an edge is not locally Delaunay, or CGAL sees a crossing
ReferenceConstrained cgalConstrained(const Cloud& cloud, const std::vector<Segment>& constraints);

}
}

#endif
