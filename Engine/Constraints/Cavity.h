// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The triangles that a new edge crosses, and others in their place that have the edge.
///
/// On either side of the edge, the sides of the crossed triangles form a chain from one of its ends
/// to the other. Each corner of it sees the edge along an edge that was crossed, so one scan of the
/// chain that cuts off each corner that turns towards the edge leaves nothing but triangles. A
/// chain may pass one position twice, where it goes around an edge that has crossed triangles on
/// both sides.
#ifndef flipflop_Cavity_h
#define flipflop_Cavity_h

#include "Mesh/Mesh.h"
#include "Support/Monitor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// While constraints are inserted: the triangle is one of those that are crossed.
constexpr std::uint32_t TriangleCrossed = 0x40000000u;

/// @tparam Surface what EdgeInsertion changes
template <class Surface>
class Cavity
{
public:
  Cavity(Surface& toChange, StepPoll& toPoll)
    : surface(toChange)
    , poll(toPoll)
  {
  }

  /// Walk along the line from vertex @p u towards @p v, up to the next vertex on it.
  /// @param h    the half-edge opposite to u of the triangle that the line leaves u through
  /// @param meet void (half-edge): a fixed edge is crossed
  /// @return     the vertex
  template <class Meet>
  std::uint32_t open(std::uint32_t u, std::uint32_t v, std::uint32_t h, const Meet& meet)
  {
    this->mesh = this->surface.mesh();
    this->crossed.clear();
    this->right.assign(1, this->sideOf(previousHalfEdge(h)));
    this->left.assign(1, this->sideOf(nextHalfEdge(h)));
    // h runs from the right of the line to its left.
    for (;;)
    {
      this->poll.step();
      this->cross(triangleOf(h));
      if (this->mesh.isFixed(h))
      {
        meet(h);
      }
      const std::uint32_t twin = this->mesh.twin(h);
      const std::uint32_t apex = this->mesh.origin(previousHalfEdge(twin));
      ensure(!(this->vertex(apex).flags & VertexVirtual));
      const int side = this->surface.orient(this->vertex(u), this->vertex(v), this->vertex(apex));
      if (side <= 0)
      {
        this->right.push_back(this->sideOf(nextHalfEdge(twin)));
      }
      if (side >= 0)
      {
        this->left.push_back(this->sideOf(previousHalfEdge(twin)));
      }
      if (side == 0)
      {
        this->cross(triangleOf(twin));
        return apex;
      }
      h = side > 0 ? nextHalfEdge(twin) : previousHalfEdge(twin);
    }
  }

  /// No edge is to be made: the triangles are as they were.
  void leave()
  {
    for (const std::uint32_t t : this->crossed)
    {
      this->mesh.triangles[t].flags &= ~TriangleCrossed;
    }
  }

  /// Triangulate it again, with the edge from @p u to @p w, where the walk began and ended.
  /// @return a half-edge of the edge
  std::uint32_t close(std::uint32_t u, std::uint32_t w)
  {
    this->inner.clear();
    this->folds.clear();
    this->used = 0;
    std::reverse(this->left.begin(), this->left.end());
    for (std::vector<Side>* chain : { &this->right, &this->left })
    {
      for (Side& side : *chain)
      {
        side.isFold = (this->mesh.triangles[triangleOf(side.outer)].flags & TriangleCrossed) != 0;
      }
    }
    const std::uint32_t back = this->fill(this->right, w);
    const std::uint32_t forth = this->fill(this->left, u);
    ensure(this->used == this->crossed.size());
    this->linkFolds();
    this->mesh.link(back, forth);
    return forth;
  }

  /// After close(): its triangles.
  const std::vector<std::uint32_t>& triangles() const { return this->crossed; }

  /// And a half-edge of each edge between two of them, but for the new one.
  const std::vector<std::uint32_t>& innerEdges() const { return this->inner; }

private:
  /// An edge of a chain, which will be a side of a new triangle.
  struct Side
  {
    std::uint32_t from;   ///< the vertex that it leaves
    std::uint32_t before; ///< its half-edge until now; NoIndex: it is new
    std::uint32_t outer;  ///< the opposite one
    bool isFixed;
    bool isFold; ///< the triangle on the other side is crossed, too
  };

  /// A side between two new triangles, of which the other is not known yet.
  struct Fold
  {
    std::uint32_t before, outer; ///< half-edges until now
    std::uint32_t now;
  };

  const Vertex& vertex(std::uint32_t v) const { return this->mesh.vertices[v]; }

  Side sideOf(std::uint32_t h) const
  {
    return { this->mesh.origin(h), h, this->mesh.twin(h), this->mesh.isFixed(h), false };
  }

  void cross(std::uint32_t t)
  {
    this->surface.willChange(t);
    this->crossed.push_back(t);
    this->mesh.triangles[t].flags |= TriangleCrossed;
  }

  /// @param end where the chain ends
  /// @return    the half-edge from there to its beginning
  std::uint32_t fill(const std::vector<Side>& chain, std::uint32_t end)
  {
    this->scan.clear();
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
      this->poll.step();
      this->scan.push_back(chain[i]);
      const std::uint32_t c = i + 1 < chain.size() ? chain[i + 1].from : end;
      while (this->scan.size() >= 2)
      {
        const Side& last = this->scan.back();
        Side& first = *(this->scan.end() - 2);
        if (this->surface.orient(
              this->vertex(first.from), this->vertex(last.from), this->vertex(c)) <= 0)
        {
          break;
        }
        const std::uint32_t t = this->crossed[this->used++];
        this->mesh.triangles[t].flags = 0;
        this->attach(halfEdge(t, 0), first);
        this->attach(halfEdge(t, 1), last);
        this->mesh.triangles[t].v[2] = c;
        this->surface.leaveThrough(t);
        first = { first.from, NoIndex, halfEdge(t, 2), false, false };
        this->scan.pop_back();
      }
    }
    ensure(this->scan.size() == 1);
    return this->scan.front().outer;
  }

  void attach(std::uint32_t h, const Side& side)
  {
    Triangle& triangle = this->mesh.triangles[triangleOf(h)];
    triangle.v[cornerOf(h)] = side.from;
    triangle.flags |= side.isFixed ? EdgeFixed << cornerOf(h) : 0u;
    if (side.isFold)
    {
      this->folds.push_back({ side.before, side.outer, h });
      return;
    }
    this->surface.willChange(triangleOf(side.outer));
    this->mesh.link(h, side.outer);
    if (side.before == NoIndex)
    {
      this->inner.push_back(h);
    }
  }

  void linkFolds()
  {
    const auto isBefore = [](const Fold& a, const Fold& b) { return a.before < b.before; };
    std::sort(this->folds.begin(), this->folds.end(), isBefore);
    for (const Fold& fold : this->folds)
    {
      const auto other = std::lower_bound(
        this->folds.begin(), this->folds.end(), Fold{ fold.outer, NoIndex, NoIndex }, isBefore);
      ensure(other != this->folds.end() && other->before == fold.outer);
      if (fold.before < other->before)
      {
        this->mesh.link(fold.now, other->now);
        this->inner.push_back(fold.now);
      }
    }
  }

  Surface& surface;
  Mesh mesh; ///< the surface's
  StepPoll& poll;
  std::vector<std::uint32_t> crossed;
  std::size_t used = 0;          ///< of these, by new triangles
  std::vector<Side> right, left; ///< chains, from u to w; while it closes, left from w to u
  std::vector<Side> scan;
  std::vector<Fold> folds;
  std::vector<std::uint32_t> inner;
};

}

#endif
