// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Is a surface the border of the points' convex hull, however it is cut into triangles?
///
/// `validate` accepts one canonical form, which other libraries need not return. This accepts any
/// triangulation of the same border, over either geometry (a Delaunay triangulation is such a
/// surface too, closed at its border by the virtual vertex), and decides by exact signs that
///
///   every triangle supports the hull: no point is strictly beyond its plane (strictly inside its
///   circle), whichever way it is turned;
///   the surface is closed;
///   it covers the hull once: one direction at one extreme point suffices, since a closed surface
///   of supporting triangles covers all of the hull equally often.
///
/// Whether a triangle supports is a local question: all points lie in the cone that an extreme
/// point's edges span, and those are known from the true complex.
#ifndef flipflop_SurfaceCheck_h
#define flipflop_SurfaceCheck_h

#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"
#include "Points/PointSource.h"
#include "Points/Vertex.h"
#include "Support/Parallel.h"
#include "SurfaceEdges.h"
#include <flipflop/CellComplex.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace flipflop
{

/// What is the matter with a surface.
struct SurfaceFaults
{
  std::int64_t triangles = 0;     ///< that the surface has
  std::int64_t needed = 0;        ///< that it takes to cover the hull with all extreme points
  std::int64_t beyond = 0;        ///< triangles with points beyond them
  std::int64_t borderBeyond = 0;  ///< border edges with points beyond them
  std::int64_t openEdges = 0;     ///< used by an odd number of triangles
  std::int64_t foldedEdges = 0;   ///< between triangles that lie upon each other
  std::int64_t sheets = 1;        ///< how often the hull is covered
  std::int64_t missing = 0;       ///< extreme points that are no corner
  std::int64_t extreme = 0;       ///< points that there are
  std::int64_t notExtreme = 0;    ///< corners that are not; no fault
  std::int64_t withoutArea = 0;   ///< triangles; no fault
  std::int64_t turnedInwards = 0; ///< triangles of a closed surface; no fault

  bool any() const
  {
    return this->beyond || this->borderBeyond || this->openEdges || this->foldedEdges ||
      this->sheets != 1 || this->missing;
  }
};

inline bool areCollinear(
  const HullGeometry& geometry, const Vertex& a, const Vertex& b, const Vertex& c)
{
  return geometry.collinear(a, b, c);
}
inline bool areCollinear(
  const LiftedGeometry<false>& geometry, const Vertex& a, const Vertex& b, const Vertex& c)
{
  return geometry.orient(a, b, c) == 0;
}

template <class Geometry>
class SurfaceCheck
{
public:
  /// @param truth the exact complex in polygons, its facets' corners extreme
  /// @param apex  id of the vertex that closes surfaces at their border, NoIndex for the virtual
  ///              one; null: they have to be closed
  SurfaceCheck(const Geometry& geometry, const PointSource& source, const CellComplex& truth,
    const std::uint32_t* apex)
    : geometry(geometry)
    , source(source)
    , truth(truth)
    , apex(apex)
    , index(source.count(), NoIndex)
    , starts(truth.pointIds.size() + 1, 0)
  {
    for (std::size_t i = 0; i < truth.pointIds.size(); ++i)
    {
      this->index[static_cast<std::size_t>(truth.pointIds[i])] = static_cast<std::uint32_t>(i);
    }
    this->findNeighbours();
  }

  /// @param corners of the surface: input ids; for a position, the lowest that has it
  SurfaceFaults check(std::vector<SurfaceTriangle> triangles) const
  {
    SurfaceFaults faults;
    faults.triangles = static_cast<std::int64_t>(triangles.size());
    this->countCorners(triangles, faults);
    for (SurfaceTriangle& t : triangles)
    {
      this->checkTriangle(t, faults);
    }
    forEachEdge(edgesOf(triangles),
      [&](const SurfaceEdge& edge, int forwards, int backwards)
      {
        if (this->apex)
        {
          // The apex's triangles close the border, whatever it is.
          const std::uint32_t from = forwards > backwards ? edge.high : edge.low;
          const std::uint32_t to = forwards > backwards ? edge.low : edge.high;
          if (forwards != backwards && !this->supports({ from, to, *this->apex }))
          {
            ++faults.borderBeyond;
          }
        }
        else if ((forwards + backwards) % 2)
        {
          ++faults.openEdges;
        }
        else if (forwards != backwards)
        {
          ++faults.foldedEdges;
        }
      });
    for (std::int64_t cell = 0; cell < this->truth.cellCount(); ++cell)
    {
      faults.needed += this->truth.cellBegin(cell + 1) - this->truth.cellBegin(cell) - 2;
    }
    faults.sheets = this->countSheets(triangles);
    return faults;
  }

  /// Is no point beyond the triangle?
  bool supports(const SurfaceTriangle& t) const
  {
    std::uint32_t best = NoIndex;
    const auto degree = [this](std::uint32_t i) { return this->starts[i + 1] - this->starts[i]; };
    for (const std::uint32_t id : t)
    {
      const std::uint32_t i = id == NoIndex ? NoIndex : this->index[id];
      best = i != NoIndex && (best == NoIndex || degree(i) < degree(best)) ? i : best;
    }
    const auto isBeyond = [&](std::uint32_t id) {
      return std::find(t.begin(), t.end(), id) == t.end() && this->above(t, this->vertex(id)) > 0;
    };
    if (best == NoIndex)
    {
      // No corner is extreme: test them all.
      return std::none_of(this->truth.pointIds.begin(), this->truth.pointIds.end(),
        [&](std::int64_t id) { return isBeyond(static_cast<std::uint32_t>(id)); });
    }
    return std::none_of(this->neighbours.begin() + this->starts[best],
      this->neighbours.begin() + this->starts[best + 1], isBeyond);
  }

private:
  Vertex vertex(std::uint32_t id) const
  {
    return id == NoIndex ? virtualVertex() : this->source.vertex(id);
  }

  /// The ends of the true complex's edges, by vertex.
  void findNeighbours()
  {
    std::vector<SurfaceEdge> edges;
    for (std::int64_t cell = 0; cell < this->truth.cellCount(); ++cell)
    {
      std::int64_t last = this->truth.cellBegin(cell + 1) - 1;
      for (std::int64_t i = this->truth.cellBegin(cell); i < this->truth.cellBegin(cell + 1); ++i)
      {
        edges.push_back(
          SurfaceEdge::from(static_cast<std::uint32_t>(this->truth.connectivity[last]),
            static_cast<std::uint32_t>(this->truth.connectivity[i])));
        last = i;
      }
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    const auto id = [this](std::uint32_t i)
    { return static_cast<std::uint32_t>(this->truth.pointIds[i]); };
    forEachEdge(std::move(edges),
      [&](const SurfaceEdge& edge, int forwards, int backwards)
      {
        pairs.emplace_back(edge.low, id(edge.high));
        pairs.emplace_back(edge.high, id(edge.low));
        if (forwards != backwards)
        {
          pairs.emplace_back(edge.low, NoIndex);
          pairs.emplace_back(edge.high, NoIndex);
        }
      });
    threads::sort(pairs.begin(), pairs.end(), std::less<>());
    for (const auto& pair : pairs)
    {
      ++this->starts[pair.first + 1];
      this->neighbours.push_back(pair.second);
    }
    for (std::size_t i = 1; i < this->starts.size(); ++i)
    {
      this->starts[i] += this->starts[i - 1];
    }
  }

  void countCorners(const std::vector<SurfaceTriangle>& triangles, SurfaceFaults& faults) const
  {
    std::vector<bool> used(this->source.count());
    for (const SurfaceTriangle& t : triangles)
    {
      for (const std::uint32_t id : t)
      {
        faults.notExtreme += this->index[id] == NoIndex && !used[id] ? 1 : 0;
        used[id] = true;
      }
    }
    for (const std::int64_t id : this->truth.pointIds)
    {
      const bool isPoint = !this->apex || static_cast<std::uint32_t>(id) != *this->apex;
      faults.extreme += isPoint ? 1 : 0;
      faults.missing += isPoint && !used[static_cast<std::size_t>(id)] ? 1 : 0;
    }
  }

  /// Check one, and turn it outwards.
  void checkTriangle(SurfaceTriangle& t, SurfaceFaults& faults) const
  {
    if (this->isFlat(t))
    {
      ++faults.withoutArea;
      return;
    }
    const SurfaceTriangle turned = { t[0], t[2], t[1] };
    if (this->apex)
    {
      // The apex is beneath all: which side is out is known, of wrong triangles too.
      t = this->above(t, this->vertex(*this->apex)) > 0 ? turned : t;
      faults.beyond += this->supports(t) ? 0 : 1;
    }
    else if (!this->supports(t))
    {
      const bool inwards = this->supports(turned);
      t = inwards ? turned : t;
      ++(inwards ? faults.turnedInwards : faults.beyond);
    }
  }

  int above(const SurfaceTriangle& t, const Vertex& p) const
  {
    return this->geometry.above(this->vertex(t[0]), this->vertex(t[1]), this->vertex(t[2]), p);
  }

  bool isFlat(const SurfaceTriangle& t) const
  {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
      areCollinear(this->geometry, this->vertex(t[0]), this->vertex(t[1]), this->vertex(t[2]));
  }

  /// The triangles that cover a facet at its first corner, along the edge that leaves there.
  std::int64_t countSheets(const std::vector<SurfaceTriangle>& triangles) const
  {
    const auto id = [this](std::int64_t i)
    { return static_cast<std::uint32_t>(this->truth.pointIds[this->truth.connectivity[i]]); };
    const auto isApex = [this](std::uint32_t i) { return this->apex && i == *this->apex; };
    std::int64_t cell = 0;
    std::int64_t begin = 0;
    SurfaceTriangle facet;
    do // a facet of points alone
    {
      begin = this->truth.cellBegin(cell++);
      facet = { id(begin), id(begin + 1), id(begin + 2) };
    } while (std::any_of(facet.begin(), facet.end(), isApex));

    // Any point beneath the facet decides which way three on it turn.
    const std::uint32_t corner = this->index[facet[0]];
    Vertex beneath = this->vertex(facet[0]);
    for (std::uint32_t i = this->starts[corner]; i < this->starts[corner + 1]; ++i)
    {
      const Vertex candidate = this->vertex(this->neighbours[i]);
      beneath = this->above(facet, candidate) < 0 ? candidate : beneath;
    }
    const auto turn = [&](std::uint32_t a, std::uint32_t b) {
      return a == b ? 0 : -this->above({ facet[0], a, b }, beneath);
    };

    std::int64_t sheets = 0;
    for (const SurfaceTriangle& t : triangles)
    {
      const auto at = std::find(t.begin(), t.end(), facet[0]);
      if (at == t.end())
      {
        continue;
      }
      const auto position = static_cast<std::size_t>(at - t.begin());
      const std::uint32_t right = t[(position + 1) % 3];
      const std::uint32_t left = t[(position + 2) % 3];
      const auto isOn = [&](std::uint32_t i)
      {
        return std::find(facet.begin(), facet.end(), i) != facet.end() ||
          this->above(facet, this->vertex(i)) == 0;
      };
      sheets += isOn(right) && isOn(left) && turn(right, facet[1]) >= 0 && turn(facet[1], left) > 0;
    }
    return sheets;
  }

  const Geometry& geometry;
  const PointSource& source;
  const CellComplex& truth;
  const std::uint32_t* apex;
  std::vector<std::uint32_t> index;      ///< in the true complex, by input id
  std::vector<std::uint32_t> starts;     ///< in neighbours, by index
  std::vector<std::uint32_t> neighbours; ///< input ids, or NoIndex: the virtual vertex
};

}

#endif
