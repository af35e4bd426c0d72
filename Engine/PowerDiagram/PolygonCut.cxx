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
#include <unordered_map>
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
    , isGone(given.siteIds.size(), 0)
  {
  }

  RoundedCells run()
  {
    const std::size_t sides = this->polygon.size() / 2;
    for (std::size_t side = 0; side < sides; ++side)
    {
      this->monitor.poll();
      this->cutAt(static_cast<Index>(side));
    }
    return this->numbered();
  }

private:
  const double* cornerOfPolygon(std::size_t i) const
  {
    return this->polygon.data() + 2 * (i % (this->polygon.size() / 2));
  }

  std::array<double, 2> ownCorner(std::size_t i) const
  {
    const double* const x = this->cornerOfPolygon(i);
    return { { x[0] + 0.0, x[1] + 0.0 } }; // -0 is 0
  }

  const double* position(Index v) const { return this->positions.data() + 2 * std::size_t(v); }

  void cutAt(Index side)
  {
    const double* const p = this->cornerOfPolygon(side);
    const double* const q = this->cornerOfPolygon(side + std::size_t(1));
    this->signs.resize(this->positions.size() / 2);
    eachRun(this->signs.size(), CornersPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          this->signs[v] =
            static_cast<std::int8_t>(planeOrientation(p, q, this->position(static_cast<Index>(v))));
        }
      });
    std::map<std::pair<Index, Index>, Index> crossings;
    for (std::size_t cell = 0; cell < this->isGone.size(); ++cell)
    {
      if (!this->isGone[cell] && this->reachesOver(cell))
      {
        this->cut(cell, side, crossings);
      }
    }
  }

  bool reachesOver(std::size_t cell) const
  {
    const auto found = this->changed.find(cell);
    if (found != this->changed.end())
    {
      return std::any_of(found->second.begin(), found->second.end(),
        [this](const CutCorner& c) { return this->signs[c.corner] < 0; });
    }
    return std::any_of(this->diagram.connectivity.begin() + this->diagram.offsets[cell],
      this->diagram.connectivity.begin() + this->diagram.offsets[cell + 1],
      [this](std::int64_t v) { return this->signs[static_cast<std::size_t>(v)] < 0; });
  }

  CutRing& ringOf(std::size_t cell)
  {
    const auto found = this->changed.emplace(cell, CutRing());
    if (found.second)
    {
      for (std::int64_t i = this->diagram.offsets[cell]; i < this->diagram.offsets[cell + 1]; ++i)
      {
        found.first->second.push_back(
          { static_cast<Index>(this->diagram.connectivity[static_cast<std::size_t>(i)]), NoIndex });
      }
    }
    return found.first->second;
  }

  void cut(std::size_t cell, Index side, std::map<std::pair<Index, Index>, Index>& crossings)
  {
    CutRing& ring = this->ringOf(cell);
    if (std::none_of(ring.begin(), ring.end(),
          [this](const CutCorner& c) { return this->signs[c.corner] > 0; }))
    {
      this->isGone[cell] = 1;
      this->changed.erase(cell);
      return;
    }
    CutRing left;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const CutCorner& a = ring[i];
      const CutCorner& b = ring[i + 1 < ring.size() ? i + 1 : 0];
      const int atA = this->signs[a.corner];
      const int atB = this->signs[b.corner];
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
    const std::size_t sides = this->polygon.size() / 2;
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
    for (const auto& cell : this->changed)
    {
      for (const CutCorner& c : cell.second)
      {
        const double* const x = this->position(c.corner);
        result[c.corner] =
          atPlace.emplace(std::array<double, 2>{ x[0], x[1] }, c.corner).first->second;
      }
    }
    return result;
  }

  /// A cell's corners, none twice in succession.
  void ringAt(std::size_t cell, const std::vector<Index>& atPlace, Ring& ring) const
  {
    ring.clear();
    const auto add = [&](Index v)
    {
      if (ring.empty() || ring.back() != atPlace[v])
      {
        ring.push_back(atPlace[v]);
      }
    };
    const auto found = this->changed.find(cell);
    if (found != this->changed.end())
    {
      for (const CutCorner& c : found->second)
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
  }

  RoundedCells numbered() const
  {
    const std::vector<Index> atPlace = this->onePerPlace();
    std::vector<Index> numbers(atPlace.size(), NoIndex);
    RoundedCells result;
    result.ends.push_back(0);
    Ring ring;
    for (std::size_t cell = 0; cell < this->isGone.size(); ++cell)
    {
      if (this->isGone[cell])
      {
        continue;
      }
      this->ringAt(cell, atPlace, ring);
      if (ring.size() < 3)
      {
        continue; // rounding has left an edge, which the neighbours have as well
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
  std::vector<double> positions;                    ///< the diagram's, then those of cuts
  std::vector<std::int8_t> signs;                   ///< of these: 1 on the left of the side
  std::unordered_map<std::size_t, CutRing> changed; ///< cells that a side has cut
  std::vector<std::uint8_t> isGone;                 ///< by cell
};

}

RoundedCells cutAtPolygon(
  const PowerDiagram& diagram, const std::vector<double>& polygon, Monitor& monitor)
{
  return PolygonCut(diagram, polygon, monitor).run();
}

}
