// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What can be checked of a result without a coordinate: sizes, indices and order.
#ifndef flipflop_ValidateStructure_h
#define flipflop_ValidateStructure_h

#include <flipflop/CellComplex.h>
#include <flipflop/Hull.h>
#include <flipflop/Validate.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

inline Validation faultAt(Fault fault, std::int64_t index)
{
  Validation result;
  result.fault = fault;
  result.index = index;
  return result;
}

/// Of any result.
/// @param mayLackCells and so have points that no cell has
inline Validation checkStructure(std::int64_t pointsGiven, const CellComplex& complex,
  int mostDimension, bool mayLackCells = false)
{
  const auto pointCount = static_cast<std::int64_t>(complex.pointIds.size());
  const auto cornerCount = static_cast<std::int64_t>(complex.connectivity.size());
  if (complex.dimension < -1 || complex.dimension > mostDimension || complex.cellSize < 0 ||
    (complex.cellSize > 0 && cornerCount % complex.cellSize != 0))
  {
    return faultAt(Fault::Structure, -1);
  }
  for (std::int64_t i = 0; i < pointCount; ++i)
  {
    const std::int64_t id = complex.pointIds[i];
    if (id < 0 || id >= pointsGiven || (i > 0 && id <= complex.pointIds[i - 1]))
    {
      return faultAt(Fault::Structure, i);
    }
  }
  if (complex.cellSize == 0 && !complex.offsets.empty() &&
    (complex.offsets[0] != 0 || complex.offsets[complex.offsets.size() - 1] != cornerCount))
  {
    return faultAt(Fault::Structure, -1);
  }
  const std::int64_t cellCount = complex.cellCount();
  if ((cellCount == 0) != (cornerCount == 0))
  {
    return faultAt(Fault::Structure, -1);
  }
  const std::int64_t least = std::min(complex.dimension + 1, 3);
  std::vector<std::int64_t> lastCell(static_cast<std::size_t>(pointCount), -1);
  for (std::int64_t cell = 0; cell < cellCount; ++cell)
  {
    const std::int64_t begin = complex.cellBegin(cell);
    const std::int64_t end = complex.cellBegin(cell + 1);
    if (begin < 0 || end > cornerCount || end - begin < least ||
      (complex.dimension < 2 && end - begin > least))
    {
      return faultAt(Fault::Structure, cell);
    }
    const std::int64_t* corner = complex.connectivity.data();
    for (std::int64_t i = begin; i < end; ++i)
    {
      if (corner[i] < 0 || corner[i] >= pointCount || (i > begin && corner[i] <= corner[begin]) ||
        std::exchange(lastCell[static_cast<std::size_t>(corner[i])], cell) == cell)
      {
        return faultAt(Fault::Structure, cell);
      }
    }
    if (cell > 0 &&
      !std::lexicographical_compare(
        corner + complex.cellBegin(cell - 1), corner + begin, corner + begin, corner + end))
    {
      return faultAt(Fault::Structure, cell);
    }
  }
  const auto unused = std::find(lastCell.begin(), lastCell.end(), -1);
  if (unused != lastCell.end() && !mayLackCells)
  {
    return faultAt(Fault::Structure, unused - lastCell.begin());
  }
  return Validation();
}

/// Below dimension 2 a hull is one cell of its points.
inline Validation checkHullStructure(std::int64_t pointsGiven, const Hull& hull)
{
  const Validation structure = checkStructure(pointsGiven, hull, 3);
  if (structure && hull.dimension < 2 &&
    (static_cast<std::int64_t>(hull.pointIds.size()) != hull.dimension + 1 ||
      hull.cellCount() != (hull.dimension < 0 ? 0 : 1)))
  {
    return faultAt(Fault::Structure, -1);
  }
  return structure;
}

}

#endif
