// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Insert points one at a time, each flipped in at once.
///
/// A point walks from the triangle of the point before it to its own, splits it, and the edges
/// opposite to the new vertex are tested and flipped until none is reflex. That is Algorithm 1
/// (paper, section 2.3) on a polyhedron that was convex before: its commonest step, the 2-2 flip of
/// such an edge, is taken here; what else it may want (a 3-1 flip, a label) goes to the Flipper.
///
/// In a random order each vertex costs a few flips wherever the points lie (see InsertionOrder.h).
#ifndef flipflop_Insertion_h
#define flipflop_Insertion_h

#include "FlipFlop/Flipper.h"
#include "FlipFlop/GrowthRule.h"
#include "FlipFlop/Tally.h"
#include "Geometry/VisibilityWalk.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// @tparam Geometry a model of the geometry concept (GeometryConcept.h)
template <class Geometry>
class Insertion
{
public:
  using LocalFlipper = Flipper<Geometry, NoneShared>;

  /// @param generalFlipper takes note of duplicates, too
  /// @param firstTriangle from which the first walk starts
  /// @param firstFree     new triangles go to this slot and up, two an insertion
  /// @param mostTriangles no more are there to walk through
  Insertion(const Geometry& geometryToUse, const Mesh& meshToGrow, LocalFlipper& generalFlipper,
    std::uint32_t firstTriangle, std::uint32_t firstFree, std::uint32_t mostTriangles)
    : geometry(geometryToUse)
    , mesh(meshToGrow)
    , flipper(generalFlipper)
    , last(firstTriangle)
    , next(firstFree)
    , mostSteps(mostTriangles)
  {
  }

  /// Insert the vertex at a slot of the mesh's array, unless it lies beneath its triangle. The
  /// walk starts where the last one ended.
  /// @return false: the triangle where it starts has gone
  bool insert(std::uint32_t slot) { return this->insertFrom(this->last, slot); }

  /// The same, of a walk from a triangle, which may have gone.
  bool insertFrom(std::uint32_t start, std::uint32_t slot)
  {
    if (this->mesh.triangles[start].flags & TriangleDead)
    {
      return false;
    }
    const Vertex p = this->mesh.vertices[slot];
    const Located at =
      locateFrom(this->geometry, this->mesh, start, p, this->mostSteps, this->walked);
    if (at.triangle == NoIndex)
    {
      return false;
    }
    this->last = at.triangle;
    const Triangle& triangle = this->mesh.triangles[at.triangle];
    const Vertex* const v = this->mesh.vertices;
    const Vertex& a = v[triangle.v[0]];
    const Vertex& b = v[triangle.v[1]];
    const Vertex& c = v[triangle.v[2]];
    const bool inside = at.strictly && !((a.flags | b.flags | c.flags) & VertexVirtual);
    if (!isAbove(this->geometry, a, b, c, p, this->flipper.duplicates))
    {
      return true;
    }
    if (!inside && this->geometry.above(a, b, c, p) == 0)
    {
      ++this->ties; // the edges at the new vertex are flat, and not tested
    }
    const std::uint32_t child[3] = { at.triangle, this->next, this->next + 1 };
    this->next += 2;
    ++this->insertions;
    this->mesh.vertices[slot].flags = VertexAlive;
    splitTriangle(this->mesh, child, slot);
    this->flipIn(child, p, inside);
    return true;
  }

  /// The first triangle that is not in use.
  std::uint32_t firstFree() const { return this->next; }

  void addTo(Tally& tally) const
  {
    tally.ties += this->ties;
    Statistics& statistics = tally.statistics;
    statistics.insertions += this->insertions;
    statistics.moves += this->walked;
    statistics.flips22 += this->flips;
    statistics.flipsV += this->flips;
    statistics.edgeChecks += this->checks;
  }

private:
  /// Test and flip the edges opposite to the new vertex, at the corner 2 of three triangles.
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
      const Triangle& opposite = this->mesh.triangles[triangleOf(twin)];
      const Vertex* const v = this->mesh.vertices;
      const Vertex& a = v[triangle.v[0]];
      const Vertex& b = v[triangle.v[1]];
      const Vertex& d = v[opposite.v[previousCorner(cornerOf(twin))]];
      ++this->checks;
      int sign = this->geometry.above(a, b, p, d);
      if (sign == 0)
      {
        ++this->ties;
        sign = this->geometry.tieAbove(a, b, p, d);
      }
      if (sign <= 0)
      {
        if (!inside && ((a.flags | b.flags) & VertexVirtual))
        {
          this->last = triangleOf(h); // outside, the next point may well be, too
        }
        continue;
      }
      if (this->geometry.perturbedKernelBeneath(a, d, p) < 0 ||
        this->geometry.perturbedKernelBeneath(d, b, p) < 0)
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
      this->flipGenerally(child[0]);
    }
  }

  /// Leave the rest to the Flipper, around the new vertex, at the corner 2 of @p triangle.
  ///
  /// The edges at the new vertex are not tested, as long as flips only put triangles at it in the
  /// slot of those it sees: they are convex then, where all edges were before. That is so no more
  /// after a label: flips at a labelled vertex take its triangles away without regard to the new
  /// one.
  void flipGenerally(std::uint32_t triangle)
  {
    const std::uint32_t slot = this->mesh.triangles[triangle].v[2];
    this->flipper.follow(slot, triangle);
    std::int64_t labelled = this->flipper.labelledCount();
    this->flipper.run();
    while ((this->mesh.vertices[slot].flags & VertexAlive) != 0 &&
      this->flipper.labelledCount() > labelled)
    {
      const std::uint32_t t = this->flipper.followedTriangle();
      const std::uint32_t* const v = this->mesh.triangles[t].v;
      this->flipper.pushEdgesAt(halfEdge(t, static_cast<int>(std::find(v, v + 2, slot) - v)));
      labelled = this->flipper.labelledCount();
      this->flipper.run();
    }
    this->last = this->flipper.followedTriangle();
  }

  const Geometry& geometry;
  const Mesh mesh;
  LocalFlipper& flipper;
  std::uint32_t last;
  std::uint32_t next;
  std::uint32_t mostSteps;
  std::vector<std::uint32_t> waiting = std::vector<std::uint32_t>(64); ///< triangles
  std::int64_t insertions = 0;
  std::int64_t ties = 0;
  std::int64_t walked = 0;
  std::int64_t flips = 0;
  std::int64_t checks = 0;
};

}

#endif
