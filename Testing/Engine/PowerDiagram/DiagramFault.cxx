// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/PowerDiagram/DiagramFault.h"

#include "Testing/Engine/References/Exact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// How far beyond its true border a cell may reach: units in the last place of a corner's greater
/// coordinate.
constexpr double MostUnits = 16;

Cloud cornersOf(const PowerDiagram& diagram)
{
  Cloud corners;
  for (std::size_t i = 0; i + 1 < diagram.corners.size(); i += 2)
  {
    corners.push_back({ diagram.corners[i], diagram.corners[i + 1], 0 });
  }
  return corners;
}

std::vector<int> ringOf(const PowerDiagram& diagram, std::size_t cell)
{
  return std::vector<int>(diagram.connectivity.begin() + diagram.offsets[cell],
    diagram.connectivity.begin() + diagram.offsets[cell + 1]);
}

class Judge
{
public:
  Judge(const PowerDiagram& given, const Cloud& ofSites, const Box& inBox)
    : diagram(given)
    , sites(ofSites)
    , box(inBox)
    , corners(withBox(given, inBox))
    , space(corners)
  {
  }

  std::string formFault(const Triangulation& triangulation) const
  {
    const std::size_t cells = this->diagram.siteIds.size();
    const auto& offsets = this->diagram.offsets;
    if (offsets.size() != cells + 1 || offsets[0] != 0 ||
      offsets[cells] != static_cast<std::int64_t>(this->diagram.connectivity.size()))
    {
      return "cells and offsets differ in number, or do not end with the corners";
    }
    const auto& visible = triangulation.pointIds;
    std::int64_t used = 0;
    for (std::size_t c = 0; c < cells; ++c)
    {
      const std::int64_t id = this->diagram.siteIds[c];
      if ((c > 0 && this->diagram.siteIds[c - 1] >= id) ||
        !std::binary_search(visible.begin(), visible.end(), id) || offsets[c + 1] < offsets[c] + 3)
      {
        return "sites do not ascend, or are not visible, or a cell has less than three corners";
      }
      for (std::int64_t k = offsets[c]; k < offsets[c + 1]; ++k)
      {
        const std::int64_t corner = this->diagram.connectivity[static_cast<std::size_t>(k)];
        if (corner < 0 || corner > used)
        {
          return "corners are not in the order of their first use";
        }
        used = std::max(used, corner + 1);
      }
    }
    std::set<Point> positions;
    for (std::size_t i = 0; i + 4 < this->corners.size(); ++i)
    {
      const Point& x = this->corners[i];
      if (!positions.insert(x).second ||
        !(x[0] >= this->box[0] && x[0] <= this->box[1] && x[1] >= this->box[2] &&
          x[1] <= this->box[3]))
      {
        return "a position has two numbers, or is out of the box";
      }
    }
    return used == static_cast<std::int64_t>(positions.size()) ? "" : "a corner of no cell";
  }

  std::string cellsFault() const
  {
    // All cells of a few sites, some of very many.
    constexpr std::size_t MostComparisons = 20'000'000;
    const std::size_t step =
      1 + this->diagram.connectivity.size() * this->sites.size() / MostComparisons;
    for (std::size_t c = 0; c < this->diagram.siteIds.size(); ++c)
    {
      const std::string which = ", cell of site " + std::to_string(this->diagram.siteIds[c]);
      const std::vector<int> ring = ringOf(this->diagram, c);
      if (std::set<int>(ring.begin(), ring.end()).size() != ring.size() || !this->isSimple(ring))
      {
        return "not simple, or a corner twice" + which;
      }
      if (this->twiceArea(ring) <= 0)
      {
        return "not counter-clockwise" + which;
      }
      if (c % step == 0 && this->reachesTooFar(c))
      {
        return "beyond its border" + which;
      }
    }
    return this->edgesFault();
  }

private:
  /// And the corners of the box, last.
  static Cloud withBox(const PowerDiagram& diagram, const Box& box)
  {
    Cloud points = cornersOf(diagram);
    points.insert(points.end(),
      { { box[0], box[2], 0 }, { box[1], box[2], 0 }, { box[1], box[3], 0 },
        { box[0], box[3], 0 } });
    return points;
  }

  int orientation(int a, int b, int c) const { return this->space.normal(2, a, b, c); }

  bool isBetween(int a, int b, int p) const
  {
    return std::min(this->corners[a], this->corners[b]) <= this->corners[p] &&
      this->corners[p] <= std::max(this->corners[a], this->corners[b]);
  }

  /// Edges that share a corner go on, or turn, but not back; others do not touch.
  bool isSimple(const std::vector<int>& ring) const
  {
    const std::size_t count = ring.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const int a = ring[i];
      const int b = ring[(i + 1) % count];
      const int next = ring[(i + 2) % count];
      if (this->orientation(a, b, next) == 0 && !this->isBetween(a, next, b))
      {
        return false;
      }
      for (std::size_t k = i + 2; k < count && (k + 1) % count != i; ++k)
      {
        const int c = ring[k];
        const int d = ring[(k + 1) % count];
        const int side[4] = { this->orientation(a, b, c), this->orientation(a, b, d),
          this->orientation(c, d, a), this->orientation(c, d, b) };
        if ((side[0] == 0 && this->isBetween(a, b, c)) ||
          (side[1] == 0 && this->isBetween(a, b, d)) ||
          (side[2] == 0 && this->isBetween(c, d, a)) ||
          (side[3] == 0 && this->isBetween(c, d, b)) ||
          (side[0] * side[1] < 0 && side[2] * side[3] < 0))
        {
          return false;
        }
      }
    }
    return true;
  }

  mpq_class twiceArea(const std::vector<int>& ring) const
  {
    mpq_class area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Point& a = this->corners[ring[i]];
      const Point& b = this->corners[ring[(i + 1) % ring.size()]];
      area += mpq_class(a[0]) * mpq_class(b[1]) - mpq_class(a[1]) * mpq_class(b[0]);
    }
    return area;
  }

  /// Inside, every edge is there once in either direction; on the box, end to end.
  std::string edgesFault() const
  {
    std::set<std::pair<int, int>> edges;
    mpq_class area = 0;
    for (std::size_t c = 0; c < this->diagram.siteIds.size(); ++c)
    {
      const std::vector<int> ring = ringOf(this->diagram, c);
      area += this->twiceArea(ring);
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        if (!edges.insert({ ring[i], ring[(i + 1) % ring.size()] }).second)
        {
          return "an edge twice in one direction";
        }
      }
    }
    std::map<Point, Point> border;
    for (const auto& edge : edges)
    {
      if (edges.count({ edge.second, edge.first }) == 0 &&
        !border.emplace(this->corners[edge.first], this->corners[edge.second]).second)
      {
        return "two edges of the border leave one place";
      }
    }
    const int first = static_cast<int>(this->corners.size()) - 4;
    Point at = this->corners[first];
    for (int side = 0; side < 4; ++side)
    {
      const Point& end = this->corners[first + (side + 1) % 4];
      const int axis = side % 2;
      const double sign = side < 2 ? 1 : -1;
      while (at != end)
      {
        const auto next = border.find(at);
        if (next == border.end() || next->second[1 - axis] != at[1 - axis] ||
          !(sign * at[axis] < sign * next->second[axis]))
        {
          return "the border has a gap, or an edge has no other side";
        }
        at = next->second;
        border.erase(next);
      }
    }
    return !border.empty() ? "an edge has no other side"
      : area != this->twiceArea({ first, first + 1, first + 2, first + 3 })
      ? "not the area of the box"
      : "";
  }

  /// Is a corner too far on the wrong side of the line of equal power to some site?
  bool reachesTooFar(std::size_t cell) const
  {
    const Point& mine = this->sites[static_cast<std::size_t>(this->diagram.siteIds[cell])];
    for (const int corner : ringOf(this->diagram, cell))
    {
      const Point& x = this->corners[corner];
      const double size = std::max(std::fabs(x[0]), std::fabs(x[1]));
      // Of zero, too, the unit is that of the least doubles.
      const double unit =
        std::max(size - std::nextafter(size, 0), std::numeric_limits<double>::denorm_min());
      const double limit = MostUnits * unit;
      for (const Point& other : this->sites)
      {
        const long double u = static_cast<long double>(x[0]) - mine[0];
        const long double v = static_cast<long double>(x[1]) - mine[1];
        const long double s = static_cast<long double>(x[0]) - other[0];
        const long double t = static_cast<long double>(x[1]) - other[1];
        const long double length = 2 *
          std::hypot(static_cast<long double>(other[0]) - mine[0],
            static_cast<long double>(other[1]) - mine[1]);
        const long double beyond = u * u + v * v - mine[2] - (s * s + t * t - other[2]);
        const long double error =
          0x1p-60L * (u * u + v * v + s * s + t * t + std::fabs(mine[2]) + std::fabs(other[2]));
        if (beyond + error > limit * length && length > 0 && isExactlyBeyond(x, mine, other, limit))
        {
          return true;
        }
      }
    }
    return false;
  }

  /// Is it farther on the side of @p other than so much?
  static bool isExactlyBeyond(
    const Point& x, const Point& mine, const Point& other, double distance)
  {
    const auto power = [&x](const Point& site) -> mpq_class
    {
      const mpq_class u = mpq_class(x[0]) - mpq_class(site[0]);
      const mpq_class v = mpq_class(x[1]) - mpq_class(site[1]);
      return u * u + v * v - mpq_class(site[2]);
    };
    const mpq_class beyond = power(mine) - power(other);
    const mpq_class u = mpq_class(other[0]) - mpq_class(mine[0]);
    const mpq_class v = mpq_class(other[1]) - mpq_class(mine[1]);
    const mpq_class limit(distance);
    return beyond > 0 && beyond * beyond > 4 * limit * limit * (u * u + v * v);
  }

  const PowerDiagram& diagram;
  const Cloud& sites;
  const Box& box;
  const Cloud corners;
  const FilteredSpace space;
};

}

std::string diagramFault(const PowerDiagram& diagram, const Cloud& sites,
  const Triangulation& triangulation, const Box& box)
{
  const Judge judge(diagram, sites, box);
  const std::string fault = judge.formFault(triangulation);
  return !fault.empty() || triangulation.pointIds.empty() ? fault : judge.cellsFault();
}

bool hasReflexCorner(const PowerDiagram& diagram)
{
  const Cloud corners = cornersOf(diagram);
  const FilteredSpace space(corners);
  for (std::size_t c = 0; c < diagram.siteIds.size(); ++c)
  {
    const std::vector<int> ring = ringOf(diagram, c);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (space.normal(2, ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) < 0)
      {
        return true;
      }
    }
  }
  return false;
}

}
}
