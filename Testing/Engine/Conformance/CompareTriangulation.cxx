// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Conformance/CompareTriangulation.h"

#include <algorithm>

namespace flipflop
{
namespace test
{

namespace
{

Buffer<std::int64_t> bufferOf(const Cell& values)
{
  Buffer<std::int64_t> buffer(values.size());
  std::copy(values.begin(), values.end(), buffer.begin());
  return buffer;
}

}

WeightView weightsOf(const Cloud& weighted)
{
  // Without points a place all the same: no data means no weights.
  static const double none = 0;
  return WeightView(
    weighted.empty() ? &none : &weighted[0][2], static_cast<std::int64_t>(weighted.size()), 3);
}

Triangulation clone(const Triangulation& triangulation)
{
  Triangulation copy;
  copyCells(triangulation, copy);
  copy.hiddenIds = bufferOf(Cell(triangulation.hiddenIds.begin(), triangulation.hiddenIds.end()));
  return copy;
}

Triangulation makeTriangulation(
  const ReferenceTriangulation& reference, std::int64_t points, FacetMode facets)
{
  Triangulation result;
  result.dimension = reference.dimension;
  result.pointIds = bufferOf(reference.ids);
  result.hiddenIds = bufferOf(hiddenIds(points, reference.ids));
  const bool fans = facets == FacetMode::Triangles && reference.dimension >= 2;
  Cell corners;
  Cell starts = { 0 };
  for (const Cell& cell : fans ? triangulate(reference.cells) : reference.cells)
  {
    for (std::int64_t id : cell)
    {
      corners.push_back(
        std::lower_bound(reference.ids.begin(), reference.ids.end(), id) - reference.ids.begin());
    }
    starts.push_back(static_cast<std::int64_t>(corners.size()));
  }
  result.connectivity = bufferOf(corners);
  if (fans)
  {
    result.cellSize = 3;
  }
  else if (reference.dimension == 0 || reference.dimension == 1)
  {
    result.cellSize = reference.dimension + 1;
  }
  else
  {
    result.offsets = bufferOf(starts);
  }
  return result;
}

std::string difference(const Triangulation& triangulation, const ReferenceTriangulation& reference,
  FacetMode facets, std::int64_t points)
{
  const CellComplex& cells = triangulation;
  const std::string fault = difference(cells, reference, facets);
  const Cell hidden(triangulation.hiddenIds.begin(), triangulation.hiddenIds.end());
  return !fault.empty() || hidden == hiddenIds(points, reference.ids) ? fault : "hiddenIds";
}

std::string bitDifference(const Triangulation& a, const Triangulation& b)
{
  const std::string fault =
    bitDifference(static_cast<const CellComplex&>(a), static_cast<const CellComplex&>(b));
  const bool same =
    std::equal(a.hiddenIds.begin(), a.hiddenIds.end(), b.hiddenIds.begin(), b.hiddenIds.end());
  return !fault.empty() || same ? fault : "hiddenIds";
}

std::string statisticsFault(const Triangulation& triangulation, std::int64_t points)
{
  const std::size_t left = triangulation.pointIds.size() + triangulation.hiddenIds.size();
  return static_cast<std::int64_t>(left) + triangulation.statistics.nonFinite != points
    ? "visible, hidden and non-finite points are not all"
    : statisticsFault(static_cast<const CellComplex&>(triangulation), points);
}

}
}
