// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Algorithm 2's loop (paper, section 3.1) inside one cone: insert the furthest point, split the
/// cone, pass its points on, depth first.
///
/// A cone's points are a range of the vertex array. The furthest moves to the front of the range,
/// where it stays for good as a vertex; the others are partitioned behind it into the three
/// children's ranges, and the points that lie beneath their child are dropped. Which vertex is
/// inserted depends on the set of points only, never on their order: height, then the lower id.
///
/// Every point is in the cone it is passed to exactly (by perturbation, at a border). A point
/// exactly on its triangle is dropped: it is never strictly extreme. If it is a corner's duplicate,
/// its id is kept.
#ifndef flipflop_Growth_h
#define flipflop_Growth_h

#include "FlipFlop/GrowthRule.h"
#include "Mesh/Mesh.h"
#include "Points/Duplicate.h"
#include "Support/Monitor.h"
#include <flipflop/Buffer.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace flipflop
{

/// The furthest of a set of points from a triangle.
struct Furthest
{
  double height = -std::numeric_limits<double>::infinity();
  std::uint32_t id = NoIndex;
  std::uint32_t slot = NoIndex;

  /// A height that overflowed (NaN) counts as the least: which vertex goes first is no matter of
  /// exactness.
  void offer(double h, std::uint32_t pointId, std::uint32_t at)
  {
    h = h == h ? h : -std::numeric_limits<double>::infinity();
    if (h > this->height || (h == this->height && pointId < this->id))
    {
      this->height = h;
      this->id = pointId;
      this->slot = at;
    }
  }
};

template <class Geometry>
class Growth
{
public:
  using Split = typename Geometry::Split;

  Growth(const Geometry& geometry, const Mesh& mesh, std::vector<Duplicate>& duplicates,
    Monitor& monitor)
    : geometry(geometry)
    , mesh(mesh)
    , duplicates(duplicates)
    , monitor(monitor)
  {
  }

  /// Grow triangle @p t by the points in [begin, end) of the vertex array, all strictly above it
  /// and in its cone. New triangles go to @p nextTriangle and up, two an insertion.
  void grow(std::uint32_t t, std::uint32_t begin, std::uint32_t end, const Furthest& furthest,
    std::uint32_t& nextTriangle)
  {
    this->stack.push_back({ t, begin, end, furthest.slot });
    while (!this->stack.empty())
    {
      const Cone cone = this->stack.back();
      this->stack.pop_back();
      this->insert(cone, nextTriangle);
    }
  }

  std::int64_t insertionCount() const { return this->insertions; }
  std::int64_t moveCount() const { return this->moves; }

private:
  struct Cone
  {
    std::uint32_t triangle;
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t furthest;
  };

  void insert(const Cone& cone, std::uint32_t& nextTriangle)
  {
    Vertex* const points = this->mesh.vertices;
    std::swap(points[cone.begin], points[cone.furthest]);
    points[cone.begin].flags = VertexAlive;
    ++this->insertions;

    const std::uint32_t child[3] = { cone.triangle, nextTriangle, nextTriangle + 1 };
    nextTriangle += 2;
    const Triangle& parent = this->mesh.triangles[cone.triangle];
    const std::uint32_t corner[3] = { parent.v[0], parent.v[1], parent.v[2] };
    splitTriangle(this->mesh, child, cone.begin);
    if (cone.end - cone.begin > 1)
    {
      this->partition(cone, child, corner);
    }
  }

  void partition(const Cone& cone, const std::uint32_t* child, const std::uint32_t* corner)
  {
    Vertex* const points = this->mesh.vertices;
    const Vertex& v = points[cone.begin];
    const Vertex* const corners[3] = { &points[corner[0]], &points[corner[1]], &points[corner[2]] };
    const Split split(this->geometry, *corners[0], *corners[1], *corners[2], v);

    const std::uint32_t first = cone.begin + 1;
    const std::size_t capacity = cone.end - first;
    for (auto& side : this->aside)
    {
      if (side.size() < capacity)
      {
        side.allocate(capacity + capacity / 2);
      }
    }
    // The first child's points stay in place, the others' wait aside. Slots count within the
    // child.
    Vertex* const to[3] = { points + first, this->aside[0].data(), this->aside[1].data() };
    std::uint32_t count[3] = { 0, 0, 0 };
    Furthest furthest[3];
    for (std::uint32_t i = first; i < cone.end; ++i)
    {
      const Vertex p = points[i];
      int k = split.child(p.x);
      if (k < 0)
      {
        k = childOf(this->geometry, v, *corners[0], *corners[1], *corners[2], p);
      }
      const double height = split.height(k, p.x);
      const double error = split.heightError(k);
      if (!(height > error) &&
        (height < -error ||
          !isAbove(this->geometry, *corners[k], *corners[nextCorner(k)], v, p, this->duplicates)))
      {
        continue;
      }
      furthest[k].offer(height, p.id, count[k]);
      to[k][count[k]++] = p;
    }
    this->moves += static_cast<std::int64_t>(capacity);
    if (capacity > 0x4000)
    {
      this->monitor.poll();
    }

    std::uint32_t begin = first;
    for (int k = 0; k < 3; ++k)
    {
      if (count[k])
      {
        if (k)
        {
          std::memcpy(points + begin, to[k], count[k] * sizeof(Vertex));
        }
        this->stack.push_back({ child[k], begin, begin + count[k], begin + furthest[k].slot });
        begin += count[k];
      }
    }
  }

  const Geometry& geometry;
  const Mesh mesh;
  std::vector<Duplicate>& duplicates;
  Monitor& monitor;
  std::vector<Cone> stack;
  Buffer<Vertex> aside[2];
  std::int64_t insertions = 0;
  std::int64_t moves = 0;
};

}

#endif
