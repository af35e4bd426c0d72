// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Are linked triangles what a right result is? A hull in space is closed. A triangulation is the
/// upper side of a hull, above a convex border.
///
/// In the plane the triangles must turn left, the border never right, and once around: only one of
/// its corners is before both neighbours there, in the order of x and y. Then it is one convex
/// polygon, and as often as it winds around a position, so often do triangles cover that: once. (In
/// space, findStarFault() decides this.) If no edge is reflex besides, and of constrained ones none
/// that is not fixed, the surface is convex.
#ifndef flipflop_SurfaceCheck_h
#define flipflop_SurfaceCheck_h

#include "Mesh/CellStructure.h"
#include "Mesh/Faults.h"
#include "Mesh/Mesh.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

template <class Geometry>
class SurfaceCheck
{
public:
  /// @param linked  the fans of the complex's cells; twins are NoIndex at the border
  /// @param cellOf  each triangle's cell
  /// @param points  the vertices, by index
  SurfaceCheck(const CellComplex& cells, const Buffer<Triangle>& linked,
    const std::uint32_t* cellOf, const Vertex* points, const Geometry& signs, Monitor& monitorToUse)
    : complex(cells)
    , triangles(linked)
    , cell(cellOf)
    , vertices(points)
    , geometry(signs)
    , monitor(monitorToUse)
  {
  }

  /// Of a triangulation: do triangles fill a convex polygon, each position once?
  Validation checkPlane() const
  {
    std::atomic<int> lowest{ 0 };
    const Validation found = this->eachTriangle(
      [&](const Geometry& local, std::uint32_t t)
      {
        bool isSound = this->turn(local, halfEdge(t, 0), halfEdge(t, 1)) > 0;
        for (int e = 0; e < 3 && isSound; ++e)
        {
          if (this->triangles[t].twin[e] == NoIndex)
          {
            const std::uint32_t h = halfEdge(t, e);
            const std::uint32_t next = this->nextOnBorder(h);
            isSound = this->turn(local, h, next) >= 0;
            const bool isLowest = precedes(this->origin(next), this->origin(h)) &&
              precedes(this->origin(next), this->origin(nextHalfEdge(next)));
            lowest += isLowest ? 1 : 0;
          }
        }
        return isSound ? Validation() : faultAt(Fault::NotConvex, this->cell[t]);
      });
    return found && lowest.load() != 1 ? faultAt(Fault::NotConvex, -1) : found;
  }

  /// No edge is reflex, but where it is fixed.
  /// @param form       Canonical: cells are facets, whole and flat, or the triangles of their fans
  /// @param fixedEdges as ConstrainedTriangulation has them; null: none
  Validation checkEdges(CellForm form, const Buffer<std::int64_t>* fixedEdges = nullptr)
  {
    return this->eachTriangle(
      [&](const Geometry& local, std::uint32_t t)
      {
        const Triangle& own = this->triangles[t];
        const Vertex* const v = this->vertices;
        Validation found;
        for (int e = 0; e < 3 && found; ++e)
        {
          const std::uint32_t twin = own.twin[e];
          if (twin == NoIndex || twin < halfEdge(t, e))
          {
            continue;
          }
          const int sign = local.above(
            v[own.v[0]], v[own.v[1]], v[own.v[2]], this->origin(previousHalfEdge(twin)));
          if (sign > 0 || form == CellForm::Canonical)
          {
            found = this->checkEdge(halfEdge(t, e), twin, sign, form, fixedEdges);
          }
        }
        return found;
      });
  }

  /// After checkEdges: is each edge regular, also those that are fixed?
  bool isRegular() const { return this->regular.load(std::memory_order_relaxed); }

  /// Of a convex surface: is each point strictly extreme? Three planes meet there, as only two do
  /// along an edge. Derived from the definition, by nothing of the finish that is checked: each
  /// triangle is held against every plane that was found before, wherever around the point it is.
  Validation checkExtreme() const
  {
    std::vector<std::uint32_t> leaving(this->complex.pointIds.size(), NoIndex);
    for (std::size_t i = 0; i < 3 * this->triangles.size(); ++i)
    {
      const std::uint32_t h = halfEdge(static_cast<std::uint32_t>(i / 3), static_cast<int>(i % 3));
      std::uint32_t& first = leaving[this->index(h)]; // at the border, of the first triangle
      first = first == NoIndex || this->twin(h) == NoIndex ? h : first;
    }
    return firstFault(leaving.size(), ItemsPerTask, this->geometry,
      [&](const Geometry& local, std::size_t i)
      {
        return this->planesFrom(local, leaving[i]) == 3
          ? Validation()
          : faultAt(Fault::NotExtreme, static_cast<std::int64_t>(i));
      });
  }

private:
  static constexpr std::size_t ItemsPerTask = 1 << 12;

  const Triangle& triangle(std::uint32_t h) const { return this->triangles[triangleOf(h)]; }
  std::uint32_t twin(std::uint32_t h) const { return this->triangle(h).twin[cornerOf(h)]; }
  std::uint32_t index(std::uint32_t h) const { return this->triangle(h).v[cornerOf(h)]; }
  const Vertex& origin(std::uint32_t h) const { return this->vertices[this->index(h)]; }
  std::int64_t cellAt(std::uint32_t h) const { return this->cell[triangleOf(h)]; }

  /// test (geometry, triangle)
  template <class Test>
  Validation eachTriangle(const Test& test) const
  {
    return firstFault(this->triangles.size(), ItemsPerTask, this->geometry,
      [&](const Geometry& local, std::size_t t)
      {
        if (t % ItemsPerTask == 0)
        {
          this->monitor.poll();
        }
        return test(local, static_cast<std::uint32_t>(t));
      });
  }

  /// @param sign of the corner opposite: positive above the triangle of @p h
  Validation checkEdge(std::uint32_t h, std::uint32_t twin, int sign, CellForm form,
    const Buffer<std::int64_t>* fixedEdges)
  {
    const bool isFixed = fixedEdges && hasEdge(*fixedEdges, this->index(h), this->index(twin));
    if (sign > 0 && isFixed)
    {
      this->regular.store(false, std::memory_order_relaxed);
    }
    const bool isReflex = sign > 0 && !isFixed;
    const bool isWithin = this->cellAt(h) == this->cellAt(twin);
    const bool inPolygons = this->complex.cellSize != 3;
    // A facet that is bent, not whole, or parted by a fixed edge.
    const bool isMisfit = isFixed ? isWithin : isWithin != (inPolygons && sign == 0);
    if (isReflex || (form == CellForm::Canonical && isMisfit))
    {
      return faultAt(Fault::NotConvex, std::max(this->cellAt(h), this->cellAt(twin)));
    }
    // Triangles of one facet meet at its lowest corner, the first of each.
    const bool isInFan = cornerOf(h) != 1 && this->triangle(h).v[0] == this->triangle(twin).v[0];
    return form == CellForm::Canonical && !isFixed && !inPolygons && sign == 0 && !isInFan
      ? faultAt(Fault::Structure, this->cellAt(h))
      : Validation();
  }

  /// Of half-edge @p h, and of @p next, which leaves its end: positive to the left.
  int turn(const Geometry& local, std::uint32_t h, std::uint32_t next) const
  {
    return local.kernelBeneath(
      this->origin(h), this->origin(next), this->origin(nextHalfEdge(next)));
  }

  std::uint32_t nextOnBorder(std::uint32_t h) const
  {
    std::uint32_t next = nextHalfEdge(h);
    while (this->twin(next) != NoIndex)
    {
      next = nextHalfEdge(this->twin(next));
    }
    return next;
  }

  static bool precedes(const Vertex& a, const Vertex& b)
  {
    return a.x[0] != b.x[0] ? a.x[0] < b.x[0] : a.x[1] < b.x[1];
  }

  /// Is the edge of two points in the list? It is in lexicographic order.
  static bool hasEdge(const Buffer<std::int64_t>& edges, std::uint32_t a, std::uint32_t b)
  {
    const std::pair<std::int64_t, std::int64_t> wanted = std::minmax<std::int64_t>(a, b);
    const auto at = [&edges](std::size_t i)
    { return std::make_pair(edges[2 * i], edges[2 * i + 1]); };
    std::size_t low = 0;
    for (std::size_t high = edges.size() / 2; low < high;)
    {
      const std::size_t middle = low + (high - low) / 2;
      const bool isBefore = at(middle) < wanted;
      low = isBefore ? middle + 1 : low;
      high = isBefore ? high : middle;
    }
    return low < edges.size() / 2 && at(low) == wanted;
  }

  /// How many planes meet at the origin of a half-edge: up to three.
  /// @param first at the border, of the first triangle there
  int planesFrom(const Geometry& local, std::uint32_t first) const
  {
    std::uint32_t known[3];
    int planes = 0;
    std::uint32_t h = first;
    std::uint32_t last;
    do
    {
      const Vertex& a = this->origin(h);
      const Vertex& b = this->origin(nextHalfEdge(h));
      const Vertex& c = this->origin(previousHalfEdge(h));
      const auto isOn = [&](std::uint32_t g, const Vertex& p)
      {
        return local.above(
                 a, this->origin(nextHalfEdge(g)), this->origin(previousHalfEdge(g)), p) == 0;
      };
      if (!local.collinear(a, b, c) &&
        std::none_of(
          known, known + planes, [&](std::uint32_t g) { return isOn(g, b) && isOn(g, c); }))
      {
        known[planes++] = h;
      }
      last = previousHalfEdge(h);
      h = this->twin(last);
    } while (planes < 3 && h != NoIndex && h != first);
    // Beyond the border's edges planes are upright: one, where it goes straight on.
    const int upright = h != NoIndex ? 0 : (this->turn(local, last, first) == 0 ? 1 : 2);
    return std::min(planes + upright, 3);
  }

  const CellComplex& complex;
  const Buffer<Triangle>& triangles;
  const std::uint32_t* cell;
  const Vertex* vertices;
  const Geometry& geometry;
  Monitor& monitor;
  std::atomic<bool> regular{ true };
};

}

#endif
