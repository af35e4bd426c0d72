// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The sides cut one after another (I. E. Sutherland, G. W. Hodgman, 1974). All that a cut decides,
/// it decides by the exact signs of corners, and each edge that crosses a side gets one new corner,
/// whichever of its two cells comes first. So cells still meet edge to edge, whatever was rounded.
/// An edge on a side knows that side: where the next side crosses it is the polygon's own corner.
#include "PowerDiagram/PolygonCut.h"

#include "Points/Vertex.h"
#include "PowerDiagram/PlanarRings.h"
#include "Predicates/DoubleDouble.h"
#include "Predicates/PlaneOrientation.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

namespace flipflop
{
namespace
{

using Index = std::uint32_t;

constexpr std::size_t CornersPerTask = 1 << 13;

/// A cell's corner, and the side of the polygon on which the edge from it lies; NoIndex: on none.
struct CutCorner
{
  Index corner;
  Index side;
};
using CutRing = std::vector<CutCorner>;

class PolygonCut
{
public:
  PolygonCut(const PowerDiagram& given, const std::vector<double>& sides, Monitor& toTell)
    : diagram(given)
    , polygon(sides)
    , monitor(toTell)
    , positions(given.corners.begin(), given.corners.end())
  {
  }

  RoundedCells run()
  {
    this->takeCells();
    for (std::size_t side = 0; side < this->sideCount(); ++side)
    {
      this->monitor.poll();
      std::map<std::pair<Index, Index>, Index> crossings;
      for (CutRing& ring : this->rings)
      {
        this->cut(ring, static_cast<Index>(side), crossings);
      }
    }
    return this->numbered();
  }

private:
  std::size_t sideCount() const { return this->polygon.size() / 2; }

  const double* cornerOfPolygon(std::size_t i) const
  {
    return this->polygon.data() + 2 * (i % this->sideCount());
  }

  std::array<double, 2> ownCorner(std::size_t i) const
  {
    const double* const x = this->cornerOfPolygon(i);
    return { { x[0] + 0.0, x[1] + 0.0 } }; // -0 is 0
  }

  const double* position(Index v) const { return this->positions.data() + 2 * std::size_t(v); }

  /// The cells that have a corner outside of the polygon. The others stay as they are.
  void takeCells()
  {
    std::vector<std::uint8_t> isOutside(this->positions.size() / 2);
    eachRun(isOutside.size(), CornersPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          isOutside[v] = this->isOutside(this->position(static_cast<Index>(v))) ? 1 : 0;
        }
      });
    for (std::size_t cell = 0; cell < this->diagram.siteIds.size(); ++cell)
    {
      const auto begin = this->diagram.connectivity.begin() + this->diagram.offsets[cell];
      const auto end = this->diagram.connectivity.begin() + this->diagram.offsets[cell + 1];
      if (std::any_of(begin, end,
            [&](std::int64_t v) { return isOutside[static_cast<std::size_t>(v)] != 0; }))
      {
        this->cells.push_back(cell);
        this->rings.emplace_back();
        std::for_each(begin, end,
          [this](std::int64_t v) {
            this->rings.back().push_back({ static_cast<Index>(v), NoIndex });
          });
      }
    }
  }

  /// Is a place on the right of a side? Of the polygon's fan from its first corner, one triangle
  /// may have it.
  bool isOutside(const double* x) const
  {
    const double* const first = this->cornerOfPolygon(0);
    std::size_t low = 1;
    std::size_t high = this->sideCount() - 1;
    if (planeOrientation(first, this->cornerOfPolygon(low), x) < 0 ||
      planeOrientation(first, this->cornerOfPolygon(high), x) > 0)
    {
      return true;
    }
    while (high - low > 1)
    {
      const std::size_t middle = low + (high - low) / 2;
      (planeOrientation(first, this->cornerOfPolygon(middle), x) < 0 ? high : low) = middle;
    }
    return planeOrientation(this->cornerOfPolygon(low), this->cornerOfPolygon(high), x) < 0;
  }

  void cut(CutRing& ring, Index side, std::map<std::pair<Index, Index>, Index>& crossings)
  {
    const double* const p = this->cornerOfPolygon(side);
    const double* const q = this->cornerOfPolygon(side + std::size_t(1));
    this->signs.clear();
    for (const CutCorner& c : ring)
    {
      this->signs.push_back(planeOrientation(p, q, this->position(c.corner)));
    }
    const auto has = [this](int sign)
    { return std::find(this->signs.begin(), this->signs.end(), sign) != this->signs.end(); };
    if (!has(-1))
    {
      return;
    }
    if (!has(1))
    {
      ring.clear();
      return;
    }
    CutRing left;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::size_t j = i + 1 < ring.size() ? i + 1 : 0;
      const CutCorner& a = ring[i];
      const CutCorner& b = ring[j];
      const int atA = this->signs[i];
      const int atB = this->signs[j];
      if (atA >= 0)
      {
        left.push_back({ a.corner, atA == 0 && atB < 0 ? side : a.side });
      }
      if (atA * atB < 0)
      {
        const auto ends = std::minmax(a.corner, b.corner);
        const auto found = crossings.emplace(ends, NoIndex);
        if (found.second)
        {
          found.first->second = this->addCrossing(ends.first, ends.second, a.side, side);
        }
        left.push_back({ found.first->second, atA > 0 ? side : a.side });
      }
    }
    ring.swap(left);
  }

  /// @param along the side on which the edge from @p a to @p b lies, or NoIndex
  Index addCrossing(Index a, Index b, Index along, Index side)
  {
    const std::size_t sides = this->sideCount();
    std::array<double, 2> x;
    if (along != NoIndex && (along + std::size_t(1)) % sides == side && this->spans(a, b, side))
    {
      x = this->ownCorner(side);
    }
    else if (along != NoIndex && (side + std::size_t(1)) % sides == along &&
      this->spans(a, b, along))
    {
      x = this->ownCorner(along);
    }
    else
    {
      this->cross(a, b, side, x.data());
    }
    this->positions.insert(this->positions.end(), x.begin(), x.end());
    return static_cast<Index>(this->positions.size() / 2 - 1);
  }

  /// Is a corner of the polygon between two on a side? At a bend of nearly none, rounding may have
  /// the next side cross the edge anywhere.
  bool spans(Index a, Index b, std::size_t own) const
  {
    const double* const p = this->position(a);
    const double* const q = this->position(b);
    const int axis = std::fabs(q[1] - p[1]) > std::fabs(q[0] - p[0]) ? 1 : 0;
    const auto range = std::minmax(p[axis], q[axis]);
    const double at = this->cornerOfPolygon(own)[axis];
    return range.first <= at && at <= range.second;
  }

  /// Twice the area of the triangle of a side and a point; of all its digits.
  double above(Index side, const double* x) const
  {
    const double* const p = this->cornerOfPolygon(side);
    const double* const q = this->cornerOfPolygon(side + std::size_t(1));
    return (doubleDifference(q[0], p[0]) * doubleDifference(x[1], p[1]) -
      doubleDifference(q[1], p[1]) * doubleDifference(x[0], p[0]))
      .high;
  }

  /// From the nearer end, so that the way there is rounded the least.
  void cross(Index a, Index b, Index side, double* x) const
  {
    const double* near = this->position(a);
    const double* far = this->position(b);
    double toNear = std::fabs(this->above(side, near));
    double toFar = std::fabs(this->above(side, far));
    if (toFar < toNear)
    {
      std::swap(near, far);
      std::swap(toNear, toFar);
    }
    const double share = toNear / (toNear + toFar);
    for (int k = 0; k < 2; ++k)
    {
      const double at = near[k] + share * (far[k] - near[k]) + 0.0; // -0 is 0
      x[k] = std::min(std::max(at, std::min(near[k], far[k])), std::max(near[k], far[k]));
    }
  }

  // ---- The end -------------------------------------------------------------------------------

  /// Of each corner one at its place: rounding may have brought a new one to another.
  std::vector<Index> onePerPlace() const
  {
    std::vector<Index> result(this->positions.size() / 2);
    std::iota(result.begin(), result.end(), 0u);
    std::map<std::array<double, 2>, Index> atPlace;
    for (const CutRing& ring : this->rings)
    {
      for (const CutCorner& c : ring)
      {
        const double* const x = this->position(c.corner);
        result[c.corner] =
          atPlace.emplace(std::array<double, 2>{ x[0], x[1] }, c.corner).first->second;
      }
    }
    return result;
  }

  RoundedCells numbered() const
  {
    const std::vector<Index> atPlace = this->onePerPlace();
    std::vector<Index> numbers(atPlace.size(), NoIndex);
    RoundedCells result;
    result.ends.push_back(0);
    Ring ring; // none twice in succession
    const auto add = [&](Index v)
    {
      if (ring.empty() || ring.back() != atPlace[v])
      {
        ring.push_back(atPlace[v]);
      }
    };
    std::size_t next = 0; // of the cells that were taken
    for (std::size_t cell = 0; cell < this->diagram.siteIds.size(); ++cell)
    {
      ring.clear();
      if (next < this->cells.size() && this->cells[next] == cell)
      {
        for (const CutCorner& c : this->rings[next++])
        {
          add(c.corner);
        }
      }
      else
      {
        std::for_each(this->diagram.connectivity.begin() + this->diagram.offsets[cell],
          this->diagram.connectivity.begin() + this->diagram.offsets[cell + 1],
          [&](std::int64_t v) { add(static_cast<Index>(v)); });
      }
      while (ring.size() > 1 && ring.back() == ring.front())
      {
        ring.pop_back();
      }
      if (ring.size() < 3)
      {
        continue; // nothing is left, or rounding has left an edge, which the neighbours have as
                  // well
      }
      for (const Index v : ring)
      {
        if (numbers[v] == NoIndex)
        {
          numbers[v] = static_cast<Index>(result.positions.size() / 2);
          result.positions.insert(result.positions.end(), this->position(v), this->position(v) + 2);
        }
        result.corners.push_back(numbers[v]);
      }
      result.ends.push_back(static_cast<std::int64_t>(result.corners.size()));
      result.ids.push_back(this->diagram.siteIds[cell]);
    }
    return result;
  }

  const PowerDiagram& diagram;
  const std::vector<double>& polygon;
  Monitor& monitor;
  std::vector<double> positions;  ///< the diagram's, then those of cuts
  std::vector<std::size_t> cells; ///< that have a corner outside of the polygon, ascending
  std::vector<CutRing> rings;     ///< of each of them what is left
  std::vector<int> signs;         ///< of a ring's corners: 1 on the left of the side
};

}

RoundedCells cutAtPolygon(
  const PowerDiagram& diagram, const std::vector<double>& polygon, Monitor& monitor)
{
  return PolygonCut(diagram, polygon, monitor).run();
}

}
