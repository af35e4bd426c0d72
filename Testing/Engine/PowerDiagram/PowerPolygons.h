// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What power diagrams are compared by: the bits, or the cells by position.
#ifndef flipflop_test_PowerPolygons_h
#define flipflop_test_PowerPolygons_h

#include "Testing/Engine/Conformance/Compare.h"

#include <flipflop/PowerDiagram.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

/// The corners of a cell, from its lowest.
using Polygon = std::vector<std::array<double, 2>>;

/// By the ids of their sites.
inline std::map<std::int64_t, Polygon> polygonsOf(const PowerDiagram& diagram)
{
  std::map<std::int64_t, Polygon> result;
  for (std::size_t c = 0; c < diagram.siteIds.size(); ++c)
  {
    Polygon& polygon = result[diagram.siteIds[c]];
    for (std::int64_t i = diagram.offsets[c]; i < diagram.offsets[c + 1]; ++i)
    {
      const std::int64_t corner = diagram.connectivity[i];
      polygon.push_back({ diagram.corners[2 * corner], diagram.corners[2 * corner + 1] });
    }
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  }
  return result;
}

/// What differs between two diagrams that must be equal bit for bit; empty when nothing does.
inline std::string bitDifference(const PowerDiagram& a, const PowerDiagram& b)
{
  if (!sameBits(a.corners, b.corners))
  {
    return "corners";
  }
  if (!sameBits(a.connectivity, b.connectivity))
  {
    return "connectivity";
  }
  if (!sameBits(a.offsets, b.offsets))
  {
    return "offsets";
  }
  return sameBits(a.siteIds, b.siteIds) ? "" : "siteIds";
}

}
}

#endif
