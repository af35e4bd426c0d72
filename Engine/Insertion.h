// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Insert points one at a time, each flipped in at once.
///
/// A point walks from the triangle of the point before it to its own, splits it, and the edges
/// opposite to the new vertex are tested and flipped until none is reflex. That is Algorithm 1
/// (paper, section 2.3) on a polyhedron that was convex before: its commonest step, the 2-2 flip of
/// such an edge, is taken here; what else it may ask for (a 3-1 flip, a label) goes to the Flipper.
///
/// In a random order each vertex costs a few flips wherever the points lie (see InsertionOrder.h).
#ifndef flipflop_Insertion_h
#define flipflop_Insertion_h

#include "Flipper.h"
#include "Growth.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (see HullGeometry)
/// @tparam Shared   see Flipper
template <class Geometry, class Shared>
class Insertion
{
public:
  Insertion(const Geometry& geometryToAsk, const Mesh& meshToGrow,
    Flipper<Geometry, Shared>& generalFlipper, std::vector<Duplicate>& duplicatesFound,
    std::uint32_t firstTriangle, std::uint32_t firstFree)
    : geometry(geometryToAsk)
    , mesh(meshToGrow)
    , flipper(generalFlipper)
    , duplicates(duplicatesFound)
    , last(firstTriangle)
    , next(firstFree)
  {
  }

  /// Insert the vertex at a place of the mesh's array, unless it lies beneath its triangle.
  void insert(std::uint32_t place)
  {
    const Vertex p = this->mesh.vertices[place];
    bool strictly;
    const std::uint32_t t = this->locate(p, strictly);
    this->last = t;
    const Triangle& triangle = this->mesh.triangles[t];
    const Vertex* const v = this->mesh.vertices;
    const Vertex& a = v[triangle.v[0]];
    const Vertex& b = v[triangle.v[1]];
    const Vertex& c = v[triangle.v[2]];
    const bool isVirtual = ((a.flags | b.flags | c.flags) & VertexVirtual) != 0;
    // Where all points are extreme, one inside a triangle of points is above it.
    if (!(Geometry::AllExtreme && strictly && !isVirtual) &&
      !isAbove(this->geometry, a, b, c, p, this->duplicates))
    {
      return;
    }
    const std::uint32_t child[3] = { t, this->next, this->next + 1 };
    this->next += 2;
    ++this->insertions;
    this->mesh.vertices[place].flags = VertexAlive;
    splitTriangle(this->mesh, child, place);
    this->flipIn(child, p, strictly && !isVirtual);
  }

  /// The first triangle that is not in use.
  std::uint32_t firstFree() const { return this->next; }

  void addTo(Statistics& statistics) const
  {
    statistics.insertions += this->insertions;
    statistics.moves += this->steps;
    statistics.flips22 += this->flips;
    statistics.flipsV += this->flips;
    statistics.edgeChecks += this->checks;
  }

private:
  /// The triangle in whose cone p lies, exactly (by perturbation, at a border); a triangle at a
  /// vertex for a p at the position of that vertex.
  /// @param strictly is set to whether p is inside without the perturbation
  std::uint32_t locate(const Vertex& p, bool& strictly)
  {
    std::uint32_t t = this->last;
    while (this->mesh.triangles[t].flags & TriangleDead)
    {
      --t;
    }
    int entry = 3;        // the side we came through
    bool onEntry = false; // p lies on it, and the perturbation moved it across
    // Among the triangles of a convex polyhedron no walk meets one twice.
    for (std::uint32_t step = 0; step <= this->next; ++step)
    {
      const Triangle& triangle = this->mesh.triangles[t];
      const Vertex* const corner[3] = { this->mesh.vertices + triangle.v[0],
        this->mesh.vertices + triangle.v[1], this->mesh.vertices + triangle.v[2] };
      int out = 3;
      int zeros = 0;
      for (int i = 0; i < 3; ++i)
      {
        if (i == entry)
        {
          continue;
        }
        const int sign = this->geometry.beneathKernel(*corner[i], *corner[nextCorner(i)], p);
        if (sign < 0)
        {
          out = i;
          break;
        }
        zeros |= (sign == 0) << i;
      }
      bool byTie = false;
      if (out == 3)
      {
        strictly = zeros == 0 && !onEntry;
        if (zeros == 0)
        {
          return t;
        }
        for (const Vertex* v : corner)
        {
          if (samePosition(*v, p))
          {
            return t;
          }
        }
        for (int i = 0; i < 3 && out == 3; ++i)
        {
          if (zeros >> i & 1 &&
            this->geometry.tieBeneathKernel(*corner[i], *corner[nextCorner(i)], p) < 0)
          {
            out = i;
          }
        }
        if (out == 3)
        {
          return t;
        }
        byTie = true;
      }
      ++this->steps;
      onEntry = byTie;
      const std::uint32_t twin = triangle.twin[out];
      t = triangleOf(twin);
      entry = cornerOf(twin);
    }
    throw Error(ErrorCode::Internal);
  }

  /// Test and flip the edges opposite to the new vertex.
  /// @param inside it lies strictly inside a triangle of points
  void flipIn(const std::uint32_t* child, const Vertex& p, bool inside)
  {
    std::size_t count = 3;
    std::reverse_copy(child, child + 3, this->waiting.begin());
    bool stuck = false;
    while (count > 0)
    {
      const std::uint32_t h = halfEdge(this->waiting[--count], 0);
      const Triangle& triangle = this->mesh.triangles[triangleOf(h)];
      const std::uint32_t twin = triangle.twin[0];
      if (this->mesh.isBorder(twin))
      {
        continue;
      }
      const Triangle& opposite = this->mesh.triangles[triangleOf(twin)];
      const Vertex* const v = this->mesh.vertices;
      const Vertex& a = v[triangle.v[0]];
      const Vertex& b = v[triangle.v[1]];
      const Vertex& d = v[opposite.v[previousCorner(cornerOf(twin))]];
      ++this->checks;
      if (this->geometry.perturbedAbove(a, b, p, d) <= 0)
      {
        continue;
      }
      // In the plane without weights, a quadrilateral whose edge is reflex is convex.
      if (!(Geometry::AllExtreme && inside && !(d.flags & VertexVirtual)) &&
        (this->geometry.perturbedBeneathKernel(a, d, p) < 0 ||
          this->geometry.perturbedBeneathKernel(d, b, p) < 0))
      {
        this->flipper.push(h);
        stuck = true;
        continue;
      }
      ++this->flips;
      flip(this->mesh, planFlip22(this->mesh, h));
      if (count + 2 > this->waiting.size())
      {
        this->waiting.resize(2 * this->waiting.size());
      }
      this->waiting[count++] = triangleOf(twin);
      this->waiting[count++] = triangleOf(h);
    }
    if (stuck)
    {
      this->flipper.run();
    }
  }

  const Geometry& geometry;
  const Mesh mesh;
  Flipper<Geometry, Shared>& flipper;
  std::vector<Duplicate>& duplicates;
  std::uint32_t last; ///< triangle, from which the next walk starts
  std::uint32_t next;
  std::vector<std::uint32_t> waiting = std::vector<std::uint32_t>(64); ///< triangles, at the new vertex by their corner 2
  std::int64_t insertions = 0;
  std::int64_t steps = 0;
  std::int64_t flips = 0;
  std::int64_t checks = 0;
};

}

#endif
