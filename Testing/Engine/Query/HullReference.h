// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is true of a hull, by every cell and all pairs: in integers of any size, distances in
/// numbers of many bits. Faults are words; empty where there is none.
#ifndef flipflop_test_HullReference_h
#define flipflop_test_HullReference_h

#include "Testing/Engine/Inputs/Cloud.h"

#include <flipflop/HullQueries.h>

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

Hull hullOf(const Cloud& cloud, FacetMode facets);

class HullReference
{
public:
  /// @param points of the hull; in the plane, z is taken for 0, and so is that of the queries
  explicit HullReference(const Cloud& points, PointSpace pointSpace = PointSpace::Space);

  /// The side of each query, by every facet.
  std::vector<std::int8_t> sides(const Cloud& queries) const;
  /// What is wrong with the distance of a query that is on that side.
  std::string distanceFault(const Point& query, std::int8_t side, double distance) const;
  /// The farthest vertex in each direction, the lowest of several.
  std::vector<std::int64_t> farthest(const Cloud& directions) const;
  std::string diameterFault(const Diameter& diameter) const;
  std::string boxFault(const OrientedBox& box) const;
  /// @param given of the same points
  std::string planesFault(const Hull& given, const Buffer<double>& planes) const;

  const PointSpace space;
  const Cloud cloud;
  const Hull hull; ///< in polygons
};

/// The cells beyond each side of each cell, by a map from edges to cells; a segment's ends are
/// edges from a corner to itself.
std::vector<std::int64_t> neighborsByMap(const CellComplex& complex);

}
}

#endif
