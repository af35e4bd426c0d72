// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// In which cone of a regular triangulation does a point lie: in which triangle of the plane, or in
/// which wedge beyond the border?
///
/// A grid of cells over the triangulation tells where to start; from there the point walks from
/// triangle to triangle, by exact signs. Such walks end: seen from the kernel point, the triangles
/// of a convex polyhedron hide each other in no circle.
#ifndef flipflop_LiftedLocator_h
#define flipflop_LiftedLocator_h

#include "Buffer.h"
#include "LiftedCones.h"
#include "Mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

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
    std::int32_t cell[BlockSize];   ///< of the grid
    std::int32_t inside[BlockSize]; ///< certainly hidden: never told here
  };

  using Geometry = LiftedGeometry<Weighted>;

  /// @param triangles, count a regular triangulation and its virtual triangles: a mesh without
  ///                         borders or dead triangles. Both arrays must outlive the locator.
  LiftedLocator(const Geometry& geometry, const Triangle* triangleArray, std::uint32_t count,
    const Vertex* vertexArray)
    : triangles(triangleArray)
    , vertices(vertexArray)
    , cones(count)
    , planes(count)
  {
    for (std::uint32_t t = 0; t < count; ++t)
    {
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
    this->buildGrid();
  }

  /// Fill in the block's results for the first @p n points.
  void classify(Block& block, int n) const
  {
    const float last = static_cast<float>(this->resolution - 1);
    for (int i = 0; i < n; ++i)
    {
      const float column = static_cast<float>((block.x[0][i] - this->low[0]) * this->perCell[0]);
      const float row = static_cast<float>((block.x[1][i] - this->low[1]) * this->perCell[1]);
      // Any cell will do for what is not a number.
      const float c = column > 0 ? (column < last ? column : last) : 0;
      const float r = row > 0 ? (row < last ? row : last) : 0;
      block.cell[i] =
        static_cast<std::int32_t>(r) * this->resolution + static_cast<std::int32_t>(c);
      block.inside[i] = 0;
    }
  }

  /// The cell of one point.
  std::int32_t cellOf(const double* p) const
  {
    Block block;
    block.x[0][0] = p[0];
    block.x[1][0] = p[1];
    this->classify(block, 1);
    return block.cell[0];
  }

  /// The triangle in whose cone p lies, exactly (by perturbation, at a border).
  std::uint32_t locate(const Geometry& geometry, const Vertex& p, std::int32_t cell) const
  {
    std::uint32_t t = this->hints[static_cast<std::size_t>(cell)];
    int entry = 3; // the side we came through
    for (;;)
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
        const bool known = trusted && (value > error || value < -error);
        const Triangle& triangle = this->triangles[t];
        if (known ? value < 0
                  : geometry.perturbedBeneathKernel(this->vertices[triangle.v[i]],
                      this->vertices[triangle.v[nextCorner(i)]], p) < 0)
        {
          out = i;
        }
      }
      if (out == 3)
      {
        return t;
      }
      const std::uint32_t twin = cone.twin[out];
      t = triangleOf(twin);
      entry = cornerOf(twin);
    }
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

  void buildGrid()
  {
    const std::size_t count = this->cones.size();
    double high[2] = { -HUGE_VAL, -HUGE_VAL };
    this->low[0] = this->low[1] = HUGE_VAL;
    for (const Cone& cone : this->cones)
    {
      for (int i = 0; i < 3; ++i)
      {
        this->low[0] = std::min(this->low[0], cone.x[i]);
        this->low[1] = std::min(this->low[1], cone.y[i]);
        high[0] = std::max(high[0], cone.x[i]);
        high[1] = std::max(high[1], cone.y[i]);
      }
    }
    this->resolution = 1;
    while (this->resolution < 4096 &&
      static_cast<std::size_t>(this->resolution) * static_cast<std::size_t>(this->resolution) <
        count)
    {
      this->resolution *= 2;
    }
    double cell[2];
    for (int i = 0; i < 2; ++i)
    {
      cell[i] = (high[i] - this->low[i]) / this->resolution;
      this->perCell[i] = 1 / cell[i];
    }
    const auto side = static_cast<std::size_t>(this->resolution);
    this->hints.allocate(side * side);
    std::uint32_t t = 0;
    for (std::size_t row = 0; row < side; ++row)
    {
      for (std::size_t i = 0; i < side; ++i)
      {
        // Forth and back, so that each walk starts next to where it ends.
        const std::size_t column = row % 2 ? side - 1 - i : i;
        t = this->walkTo(this->low[0] + (static_cast<double>(column) + 0.5) * cell[0],
          this->low[1] + (static_cast<double>(row) + 0.5) * cell[1], t);
        this->hints[row * side + column] = t;
      }
    }
  }

  /// About the triangle of a place.
  std::uint32_t walkTo(double px, double py, std::uint32_t start) const
  {
    std::uint32_t t = start;
    for (std::size_t step = 0; step < this->cones.size(); ++step)
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
  Buffer<std::uint32_t> hints; ///< by cell
  double low[2];
  double perCell[2];
  std::int32_t resolution = 1; ///< cells along a side of the grid
};

}

#endif
