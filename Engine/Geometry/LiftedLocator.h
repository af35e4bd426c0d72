// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// In which cone of a regular triangulation does a point lie: in which triangle of the plane, or in
/// which wedge beyond the border?
///
/// A grid holds a triangle near it; from there the point walks from triangle to triangle, by exact
/// signs. Such walks end: seen from the kernel point, the triangles of a convex polyhedron hide
/// each other in no circle.
#ifndef flipflop_LiftedLocator_h
#define flipflop_LiftedLocator_h

#include "Geometry/LiftedGeometry.h"
#include "Geometry/PositionGrid.h"
#include "Geometry/VisibilityWalk.h"
#include "Mesh/Mesh.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace flipflop
{

template <bool Weighted>
class LiftedLocator
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  /// @param triangles, count a regular triangulation and its virtual triangles: a mesh without
  ///                         borders or dead triangles. Both arrays must outlive the locator.
  /// @throw Error Aborted
  LiftedLocator(const Geometry& geometry, const Triangle* triangleArray, std::uint32_t count,
    const Vertex* vertexArray, Monitor& monitor)
    : triangles(triangleArray)
    , vertices(vertexArray)
    , cones(count)
  {
    StepPoll poll(monitor);
    for (std::uint32_t t = 0; t < count; ++t)
    {
      poll.step();
      const std::uint32_t* v = triangleArray[t].v;
      Cone& cone = this->cones[t];
      cone.virtualCorner = NoSide;
      for (int i = 0; i < 3; ++i)
      {
        const Vertex& corner = vertexArray[v[i]];
        const bool isVirtual = (corner.flags & VertexVirtual) != 0;
        cone.virtualCorner = isVirtual ? i : cone.virtualCorner;
        const double* position = isVirtual ? geometry.kernel() : corner.x;
        cone.x[i] = position[0];
        cone.y[i] = position[1];
      }
    }
    this->buildGrid(poll);
  }

  /// The cell of one point.
  std::uint32_t cellOf(const double* p) const { return this->grid.cellOf(p[0], p[1]); }

  /// A triangle near a point of a cell.
  std::uint32_t near(const Vertex& p, std::uint32_t cell) const
  {
    return this->grid.valueAt(cell, p.x[0], p.x[1]);
  }

  /// The triangle in whose cone p lies, exactly (by perturbation, at a border); any triangle at a
  /// vertex for a p at the position of that vertex, weight included. The walk starts at @p start.
  std::uint32_t locate(const Geometry& geometry, const Vertex& p, std::uint32_t start) const
  {
    const auto mostSteps = static_cast<std::uint32_t>(this->cones.size());
    const std::uint32_t found = visibilityWalk(this->triangles, NoIndex, start, mostSteps,
      [&](std::uint32_t t, int entry)
      {
        const Cone& cone = this->cones[t];
        const bool trusted = cone.virtualCorner == NoSide || !geometry.kernelIsSymbolic();
        return firstExit(entry,
          [&](int i)
          {
            double error;
            const double value = cone.side(i, p.x[0], p.x[1], error);
            if (trusted && (value > error || value < -error))
            {
              return value < 0 ? -1 : 1;
            }
            const std::uint32_t* const v = this->triangles[t].v;
            return exactSide(geometry, this->vertices[v[i]], this->vertices[v[nextCorner(i)]], p);
          });
      });
    ensure(found != NoIndex);
    return found;
  }

private:
  /// What a step of the walk reads of the corners, in one cache line.
  struct alignas(64) Cone
  {
    double x[3], y[3];          ///< positions of the corners; the kernel point's for a virtual one
    std::int32_t virtualCorner; ///< NoSide: none

    /// kernelBeneath(v(i), v(i+1), p): positive inside.
    double side(int i, double px, double py, double& error) const
    {
      const int j = nextCorner(i);
      const double left = (this->x[j] - this->x[i]) * (py - this->y[i]);
      const double right = (this->y[j] - this->y[i]) * (px - this->x[i]);
      const double most = std::fabs(left) + std::fabs(right);
      error = most > PlaneFloor ? PlaneError * most : std::numeric_limits<double>::infinity();
      // From and to the virtual corner, the kernel point's position is on the other side.
      const double turn = left - right;
      return i == this->virtualCorner || j == this->virtualCorner ? -turn : turn;
    }
  };

  /// Of each vertex, its position and a triangle at it.
  void buildGrid(StepPoll& poll)
  {
    std::uint32_t last = 0;
    for (std::uint32_t t = 0; t < this->cones.size(); ++t)
    {
      poll.step();
      const std::uint32_t* v = this->triangles[t].v;
      last = std::max({ last, v[0], v[1], v[2] });
    }
    std::vector<std::uint32_t> at(std::size_t(last) + 1, NoIndex);
    for (std::uint32_t t = 0; t < this->cones.size(); ++t)
    {
      poll.step();
      for (int i = 0; i < 3 && this->cones[t].virtualCorner == NoSide; ++i)
      {
        at[this->triangles[t].v[i]] = t;
      }
    }
    std::vector<ValuedPosition> positions;
    for (std::size_t v = 0; v < at.size(); ++v)
    {
      poll.step();
      if (at[v] != NoIndex)
      {
        positions.push_back({ { this->vertices[v].x[0], this->vertices[v].x[1] }, at[v] });
      }
    }
    this->grid.build(
      std::move(positions),
      [this](double x, double y, std::uint32_t t) { return this->walkTo(x, y, t); },
      [&poll] { poll.step(); });
  }

  /// About the triangle of a position, if that is near.
  std::uint32_t walkTo(double px, double py, std::uint32_t start) const
  {
    constexpr std::uint32_t MostSteps = 24;
    std::uint32_t last = start;
    visibilityWalk(this->triangles, NoIndex, start, MostSteps,
      [&](std::uint32_t t, int)
      {
        last = t;
        double error;
        return firstExit(
          NoSide, [&](int i) { return this->cones[t].side(i, px, py, error) < 0 ? -1 : 1; });
      });
    return last;
  }

  const Triangle* triangles;
  const Vertex* vertices;
  Buffer<Cone> cones;
  PositionGrid grid; ///< of triangles
};

}

#endif
