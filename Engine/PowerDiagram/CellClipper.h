// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A power cell, clipped by the sides of a box (I. E. Sutherland, G. W. Hodgman, 1974).
///
/// A cell may reach infinity: a corner there is a direction, of which only the signs matter. Every
/// edge has the line it lies on: two sites' line of equal power, a side of the box, or infinity.
/// A clipped corner is taken from the two lines that meet there, never from rounded corners, so
/// neighbours find the same bits however their cells were clipped before.
#ifndef flipflop_CellClipper_h
#define flipflop_CellClipper_h

#include "Points/Vertex.h"
#include "PowerDiagram/PowerCorners.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Lines: a site's index (the line of equal power to it), else one of these.
constexpr std::int64_t LineAtInfinity = -1;
constexpr std::int64_t boxSide(int k) // 0: x least, 1: x greatest, 2: y least, 3: y greatest
{
  return -2 - k;
}

struct CellCorner
{
  double x[2]; ///< a position; at infinity: the signs of a direction
  bool atInfinity;
  std::uint32_t facet; ///< whose corner it is, or NoIndex
  std::int64_t line;   ///< of the edge to the next corner
};
using CellPolygon = std::vector<CellCorner>;

inline CellCorner finiteCorner(double x, double y, std::int64_t line, std::uint32_t facet = NoIndex)
{
  return { { x, y }, false, facet, line };
}

inline CellCorner infiniteCorner(int x, int y, std::int64_t line)
{
  return { { static_cast<double>(x), static_cast<double>(y) }, true, NoIndex, line };
}

class CellClipper
{
public:
  CellClipper(const Buffer<PowerSite>& sites, const double* box)
    : sites(sites)
    , box(box)
  {
  }

  bool inside(const double* x) const
  {
    return x[0] >= this->box[0] && x[0] <= this->box[1] && x[1] >= this->box[2] &&
      x[1] <= this->box[3];
  }

  /// What the box leaves of the cell of @p site.
  void clip(std::uint32_t site, CellPolygon& cell)
  {
    for (int k = 0; k < 4 && !cell.empty(); ++k)
    {
      this->next.clear();
      for (std::size_t i = 0; i < cell.size(); ++i)
      {
        const CellCorner& a = cell[i];
        const CellCorner& b = cell[(i + 1) % cell.size()];
        const int atA = this->sideOf(a, k);
        const int atB = this->sideOf(b, k);
        if (atA >= 0)
        {
          this->next.push_back(a);
        }
        if (atA >= 0 && atB < 0)
        {
          if (atA > 0)
          {
            this->next.push_back(this->meet(site, a, b, k));
          }
          this->next.back().line = boxSide(k);
        }
        else if (atA < 0 && atB > 0)
        {
          this->next.push_back(this->meet(site, a, b, k));
        }
      }
      cell.swap(this->next);
    }
  }

private:
  /// Within side @p k: 1, on it: 0, beyond: -1.
  int sideOf(const CellCorner& corner, int k) const
  {
    const double limit = corner.atInfinity ? 0.0 : this->box[k];
    const int sign = (corner.x[k / 2] > limit) - (corner.x[k / 2] < limit);
    return k % 2 ? -sign : sign;
  }

  /// Where the edge from @p a to @p b meets side @p k.
  CellCorner meet(std::uint32_t site, const CellCorner& a, const CellCorner& b, int k) const
  {
    const int axis = k / 2;
    if (a.line == LineAtInfinity)
    {
      // Counter-clockwise by less than half a turn: over y to the left, over -x downwards.
      const int turn = a.x[axis] > b.x[axis] ? 1 : -1;
      return axis == 0 ? infiniteCorner(0, turn, a.line) : infiniteCorner(-turn, 0, a.line);
    }
    CellCorner result = finiteCorner(this->box[k], this->box[k], a.line);
    result.x[1 - axis] = a.line < 0
      ? this->box[boxSide(0) - a.line]
      : powerCrossing(
          this->sites[site], this->sites[static_cast<std::size_t>(a.line)], axis, this->box[k]);
    return result;
  }

  const Buffer<PowerSite>& sites;
  const double* box;
  CellPolygon next;
};

}

#endif
