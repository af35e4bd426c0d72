// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// In which cone of a regular triangulation does a point lie: in which triangle of the plane, or in
/// which wedge beyond the border?
///
/// A grid tells a triangle near it; from there the point walks from triangle to triangle, by exact
/// signs. Such walks end: seen from the kernel point, the triangles of a convex polyhedron hide
/// each other in no circle.
#ifndef flipflop_LiftedLocator_h
#define flipflop_LiftedLocator_h

#include "Geometry/LiftedCones.h"
#include "Geometry/PlaceGrid.h"
#include "Mesh/Mesh.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

template <bool Weighted>
class LiftedLocator
{
public:
  /// Points looked at together: they stay in the first cache.
  static constexpr int BlockSize = 256;

  struct Block
  {
    double x[3][BlockSize];
    std::uint32_t cell[BlockSize];  ///< of the grid
    std::int32_t inside[BlockSize]; ///< certainly hidden: never told here
  };

  using Geometry = LiftedGeometry<Weighted>;

  /// @param triangles, count a regular triangulation and its virtual triangles: a mesh without
  ///                         borders or dead triangles. Both arrays must outlive the locator.
  /// @throw Error Aborted
  LiftedLocator(const Geometry& geometry, const Triangle* triangleArray, std::uint32_t count,
    const Vertex* vertexArray, Monitor& monitor)
    : triangles(triangleArray)
    , vertices(vertexArray)
    , cones(count)
    , planes(count)
  {
    StepPoll poll(monitor);
    for (std::uint32_t t = 0; t < count; ++t)
    {
      poll.step();
      const std::uint32_t* v = triangleArray[t].v;
      this->planes[t] =
        LiftedPlane<Weighted>(geometry, vertexArray[v[0]], vertexArray[v[1]], vertexArray[v[2]]);
      Cone& cone = this->cones[t];
      cone.virtualCorner = 3;
      for (int i = 0; i < 3; ++i)
      {
        const Vertex& corner = vertexArray[v[i]];
        const bool isVirtual = (corner.flags & VertexVirtual) != 0;
        cone.virtualCorner = isVirtual ? i : cone.virtualCorner;
        const double* place = isVirtual ? geometry.kernel() : corner.x;
        cone.x[i] = place[0];
        cone.y[i] = place[1];
        cone.twin[i] = triangleArray[t].twin[i];
      }
    }
    this->buildGrid(poll);
  }

  /// Fill in the block's results for the first @p n points.
  void classify(Block& block, int n) const
  {
    for (int i = 0; i < n; ++i)
    {
      block.cell[i] = this->grid.cellOf(block.x[0][i], block.x[1][i]);
      block.inside[i] = 0;
    }
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
    std::uint32_t t = start;
    int entry = 3; // the side we came through
    // In a regular triangulation no walk meets a triangle twice.
    for (std::size_t step = 0; step <= this->cones.size(); ++step)
    {
      const Cone& cone = this->cones[t];
      const bool trusted = cone.virtualCorner == 3 || !geometry.kernelIsSymbolic();
      int out = 3;
      for (int i = 0; i < 3 && out == 3; ++i)
      {
        if (i == entry)
        {
          continue;
        }
        double error;
        const double value = cone.side(i, p.x[0], p.x[1], error);
        if (trusted && (value > error || value < -error))
        {
          out = value < 0 ? i : 3;
          continue;
        }
        const Vertex& a = this->vertices[this->triangles[t].v[i]];
        const Vertex& b = this->vertices[this->triangles[t].v[nextCorner(i)]];
        if (samePosition(a, p) || samePosition(b, p))
        {
          return t; // the walk around a corner, by exact signs, would tell no more
        }
        out = geometry.perturbedBeneathKernel(a, b, p) < 0 ? i : 3;
      }
      if (out == 3)
      {
        return t;
      }
      const std::uint32_t twin = cone.twin[out];
      t = triangleOf(twin);
      entry = cornerOf(twin);
    }
    throw Error(ErrorCode::Internal);
  }

  const LiftedPlane<Weighted>& plane(std::uint32_t triangle) const
  {
    return this->planes[triangle];
  }

private:
  /// All that a step of the walk reads, in one cache line.
  struct alignas(64) Cone
  {
    double x[3], y[3]; ///< places of the corners; the kernel point's for a virtual one
    std::uint32_t twin[3];
    std::int32_t virtualCorner; ///< 3: none

    /// beneathKernel(v(i), v(i+1), p): positive inside.
    double side(int i, double px, double py, double& error) const
    {
      const int j = nextCorner(i);
      const double left = (this->x[j] - this->x[i]) * (py - this->y[i]);
      const double right = (this->y[j] - this->y[i]) * (px - this->x[i]);
      error = LiftedNormal::boundInPlane(std::fabs(left) + std::fabs(right));
      // From and to the virtual corner, the kernel point's place is on the other side.
      const double turn = left - right;
      return i == this->virtualCorner || j == this->virtualCorner ? -turn : turn;
    }
  };

  /// Of each vertex, its place and a triangle at it.
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
      for (int i = 0; i < 3 && this->cones[t].virtualCorner == 3; ++i)
      {
        at[this->triangles[t].v[i]] = t;
      }
    }
    std::vector<ValuedPlace> places;
    for (std::size_t v = 0; v < at.size(); ++v)
    {
      poll.step();
      if (at[v] != NoIndex)
      {
        places.push_back({ { this->vertices[v].x[0], this->vertices[v].x[1] }, at[v] });
      }
    }
    this->grid.build(
      std::move(places),
      [this](double x, double y, std::uint32_t t) { return this->walkTo(x, y, t); },
      [&poll] { poll.step(); });
  }

  /// About the triangle of a place, if that is near.
  std::uint32_t walkTo(double px, double py, std::uint32_t start) const
  {
    constexpr int MostSteps = 24;
    std::uint32_t t = start;
    for (int step = 0; step < MostSteps; ++step)
    {
      const Cone& cone = this->cones[t];
      int out = 3;
      for (int i = 0; i < 3 && out == 3; ++i)
      {
        double error;
        out = cone.side(i, px, py, error) < 0 ? i : 3;
      }
      if (out == 3)
      {
        break;
      }
      t = triangleOf(cone.twin[out]);
    }
    return t;
  }

  const Triangle* triangles;
  const Vertex* vertices;
  Buffer<Cone> cones;
  Buffer<LiftedPlane<Weighted>> planes;
  PlaceGrid grid; ///< of triangles
};

}

#endif
