// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What can be checked of cells without a coordinate: sizes, indices and order.
#ifndef flipflop_CellStructure_h
#define flipflop_CellStructure_h

#include "Mesh/Faults.h"
#include "Points/Vertex.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Hull.h>
#include <flipflop/Triangulation.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// How much of the form that CellComplex promises is required of cells.
enum class CellForm
{
  InRange,  ///< indices are in range, and cells have as many corners as the dimension requires
  Canonical ///< the order is right, too
};

/// Is the id of a point in range, and above the one before?
inline bool isInOrder(const CellComplex& complex, std::size_t point, std::int64_t pointsGiven)
{
  const Buffer<std::int64_t>& ids = complex.pointIds;
  return ids[point] > (point > 0 ? ids[point - 1] : -1) && ids[point] < pointsGiven;
}

/// Is a cell, of indices in range, in canonical form, and behind the one before?
/// @param sorted of use to the next call
inline bool isCanonical(
  const CellComplex& complex, std::int64_t cell, std::vector<std::int64_t>& sorted)
{
  const std::int64_t* const corners = complex.connectivity.data();
  const std::int64_t* const begin = corners + complex.cellBegin(cell);
  const std::int64_t* const end = corners + complex.cellBegin(cell + 1);
  sorted.assign(begin, end);
  std::sort(sorted.begin(), sorted.end());
  if (sorted.front() != *begin || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
  {
    return false;
  }
  // Where the cell before begins is for its own check.
  const std::int64_t before = cell > 0 ? complex.cellBegin(cell - 1) : -1;
  return before < 0 || before > complex.cellBegin(cell) ||
    std::lexicographical_compare(corners + before, begin, begin, end);
}

/// Of cells over points that have been checked.
inline Validation checkCells(const CellComplex& complex, int mostDimension, CellForm form)
{
  constexpr std::size_t CellsPerTask = 1 << 13;
  const int dimension = complex.dimension;
  const auto points = static_cast<std::int64_t>(complex.pointIds.size());
  const auto size = static_cast<std::int64_t>(complex.connectivity.size());
  if (dimension < -1 || dimension > mostDimension || complex.cellSize < 0 ||
    (dimension < 1 && points != dimension + 1) || (dimension == 1 && points < 2) ||
    (complex.cellSize > 0 && size % complex.cellSize != 0) || size >= NoIndex)
  {
    return faultAt(Fault::Structure, -1);
  }
  const std::int64_t cells = complex.cellCount();
  if ((cells == 0) != (size == 0) ||
    (cells > 0 && (complex.cellBegin(0) != 0 || complex.cellBegin(cells) != size)))
  {
    return faultAt(Fault::Structure, -1);
  }
  const std::int64_t least = std::min(dimension + 1, 3);
  const std::int64_t most = dimension < 2 ? least : NoIndex;
  return firstFault(static_cast<std::size_t>(cells), CellsPerTask, std::vector<std::int64_t>(),
    [&](std::vector<std::int64_t>& sorted, std::size_t c)
    {
      const auto cell = static_cast<std::int64_t>(c);
      const std::int64_t begin = complex.cellBegin(cell);
      const std::int64_t end = complex.cellBegin(cell + 1);
      const std::int64_t* const corners = complex.connectivity.data();
      const bool isSound = begin >= 0 && end >= begin && end <= size && end - begin >= least &&
        end - begin <= most &&
        std::all_of(corners + begin, corners + end,
          [points](std::int64_t corner) { return corner >= 0 && corner < points; }) &&
        (form == CellForm::InRange || isCanonical(complex, cell, sorted));
      return isSound ? Validation() : faultAt(Fault::Structure, cell);
    });
}

/// Of any result.
/// @param mayLackCells and so have points that no cell has
inline Validation checkStructure(std::int64_t pointsGiven, const CellComplex& complex,
  int mostDimension, bool mayLackCells = false)
{
  for (std::size_t i = 0; i < complex.pointIds.size(); ++i)
  {
    if (!isInOrder(complex, i, pointsGiven))
    {
      return faultAt(Fault::Structure, static_cast<std::int64_t>(i));
    }
  }
  const Validation cells = checkCells(complex, mostDimension, CellForm::Canonical);
  if (!cells || mayLackCells)
  {
    return cells;
  }
  std::vector<bool> isUsed(complex.pointIds.size());
  for (const std::int64_t corner : complex.connectivity)
  {
    isUsed[static_cast<std::size_t>(corner)] = true;
  }
  const auto unused = std::find(isUsed.begin(), isUsed.end(), false);
  return unused == isUsed.end() ? cells : faultAt(Fault::Structure, unused - isUsed.begin());
}

/// Below dimension 2 a hull is one cell of its points.
inline Validation checkHullStructure(std::int64_t pointsGiven, const Hull& hull)
{
  const Validation structure = checkStructure(pointsGiven, hull, 3);
  const auto points = static_cast<std::int64_t>(hull.pointIds.size());
  const bool isSound = hull.dimension == 1 ? points == 2 : points > std::min(hull.dimension, 2);
  return structure && !isSound ? faultAt(Fault::Structure, -1) : structure;
}

/// Below dimension 2 a triangulation is one corner, or a chain of them.
inline Validation checkTriangulationStructure(
  std::int64_t pointsGiven, const Triangulation& triangulation)
{
  const Validation structure = checkStructure(pointsGiven, triangulation, 2);
  const auto points = static_cast<std::int64_t>(triangulation.pointIds.size());
  const bool isSound = triangulation.dimension == 1 ? triangulation.cellCount() == points - 1
                                                    : points > triangulation.dimension;
  return structure && !isSound ? faultAt(Fault::Structure, -1) : structure;
}

}

#endif
