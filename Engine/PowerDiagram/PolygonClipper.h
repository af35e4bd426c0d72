// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A power cell in a convex polygon: the polygon, cut by the lines of equal power to the neighbours
/// of the cell's site.
///
/// All signs are exact (CellLines.h). So the cell is the true one, but for its corners'
/// coordinates, each rounded to nearest; neighbours find the same bits, and corners of the polygon
/// stay as they are. A cut starts at the corner that is farthest across the line. Neighbours come
/// in their order around the site, so that corner is near the last cut, and a cell takes a time
/// proportional to the sides and the neighbours.
#ifndef flipflop_PolygonClipper_h
#define flipflop_PolygonClipper_h

#include "PowerDiagram/CellClipper.h"
#include "PowerDiagram/CellLines.h"
#include "PowerDiagram/PowerCorners.h"
#include <flipflop/Buffer.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

class PolygonClipper
{
public:
  /// @param polygon from domainCorners(); it must live on
  PolygonClipper(const Buffer<PowerSite>& sites, const std::vector<double>& polygon)
    : sites(sites)
    , polygon(polygon)
  {
  }

  /// Make @p cell the cell of @p site in the polygon, empty where that has no inside. It starts
  /// where the edge to the first neighbour in the list starts that has one.
  /// @param neighbours of the site, counter-clockwise
  void clip(std::uint32_t site, const std::vector<std::uint32_t>& neighbours, CellPolygon& cell);

private:
  using Index = std::uint32_t;

  /// A corner, linked to the next ones. Its line is that of the edge to the next corner: a position
  /// in the list of neighbours, or a side of the polygon.
  struct Node
  {
    double x[2];
    std::int64_t line;
    Index before;
    Index after;
  };

  /// What a cut leaves: the way from one corner on to the other.
  struct Kept
  {
    Index first = NoIndex; ///< NoIndex: nothing
    Index last = NoIndex;
    int signOfFirst = 0;
    int signOfLast = 0;
  };

  void begin();
  void cut(const PowerSite& site, std::int64_t line);
  Index farthest(const CellCutter& cutter) const;
  Kept keptBy(const CellCutter& cutter, Index beyond) const;
  Index add(const PowerSite& site, std::int64_t lineBefore, std::int64_t line);
  void link(Index a, Index b);
  int sign(const CellCutter& cutter, Index corner) const;
  CellLine lineOf(std::int64_t line) const;
  CellLine lineBefore(Index corner) const
  {
    return this->lineOf(this->nodes[this->nodes[corner].before].line);
  }
  void write(CellPolygon& cell) const;

  const Buffer<PowerSite>& sites;
  const std::vector<double>& polygon;
  const std::vector<std::uint32_t>* neighbours = nullptr; ///< of the cell under way
  std::vector<Node> nodes;
  Index at = 0; ///< a corner of the cell, at the end of the last cut; NoIndex: the cell is empty
};

/// Is every position that rounds to @p x in the polygon? False where that is not certain.
bool surelyHolds(const std::vector<double>& polygon, const double* x);

}

#endif
