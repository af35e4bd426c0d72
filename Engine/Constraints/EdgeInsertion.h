// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constraints as edges of a Delaunay triangulation, one after another, and the flips that make the
/// rest constrained Delaunay again.
///
/// A new edge changes nothing but the triangles that it crosses (J. R. Shewchuk, B. C. Brown, "Fast
/// segment insertion and incremental construction of constrained Delaunay triangulations", 2015):
/// they are triangulated again (Cavity.h), and flipped by the V-criterion, which needs no labels
/// here, for no point is hidden. So the result is unique but for ties, which the surface decides,
/// or leaves to the finish.
#ifndef flipflop_EdgeInsertion_h
#define flipflop_EdgeInsertion_h

#include "Constraints/Cavity.h"
#include "Mesh/Mesh.h"
#include "Support/Monitor.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace flipflop
{

/// @tparam Surface a Delaunay triangulation with the virtual vertex, with no two vertices at one
///                 position:
///                   Mesh mesh()
///                   int orient(a, b, c), of vertices
///                   bool isAbove(triangle, vertex): is the vertex in its circle?
///                   std::uint32_t leaving(v): a half-edge that leaves the vertex
///                   setLeaving(v, h), leaveThrough(t): the triangle's, of its three corners
///                   willChange(t): called before a triangle is written
///                   changed(triangles): these were
template <class Surface>
class EdgeInsertion
{
public:
  EdgeInsertion(Surface& toChange, Monitor& monitor)
    : surface(toChange)
    , poll(monitor)
    , cavity(toChange, this->poll)
  {
  }

  /// Make the segment from vertex @p u to vertex @p v one or more edges.
  /// @param isKnown bool (): it begins with a fixed edge to another vertex; is the rest there, too?
  /// @param edge    void (from, to): it has this edge, from u on
  /// @param cross   void (half-edge): it crosses this fixed edge
  /// @return        false: it crosses one; edges before the first crossing were made
  template <class IsKnown, class Edge, class Cross>
  bool insert(
    std::uint32_t u, std::uint32_t v, const IsKnown& isKnown, const Edge& edge, const Cross& cross)
  {
    bool crosses = false;
    const auto meet = [&](std::uint32_t h)
    {
      crosses = true;
      cross(h);
    };
    const std::uint32_t first = u;
    while (u != v)
    {
      const Exit exit = this->exitOf(u, v);
      std::uint32_t end = exit.end;
      if (u == first && exit.along != NoIndex && end != v &&
        this->surface.mesh().isFixed(exit.along) && isKnown())
      {
        return true;
      }
      if (exit.along == NoIndex)
      {
        end = this->cavity.open(u, v, exit.across, meet);
        if (crosses)
        {
          this->cavity.leave();
        }
        else
        {
          this->fix(this->cavity.close(u, end));
          this->waiting = this->cavity.innerEdges();
          this->makeDelaunay();
          this->surface.changed(this->cavity.triangles());
        }
      }
      else if (!crosses)
      {
        this->fix(exit.along);
      }
      if (!crosses)
      {
        edge(u, end);
      }
      u = end;
    }
    return !crosses;
  }

  /// An edge is no longer fixed. Flip what this asks for.
  void release(std::uint32_t h)
  {
    const Mesh mesh = this->surface.mesh();
    for (const std::uint32_t side : { h, mesh.twin(h) })
    {
      this->surface.willChange(triangleOf(side));
      mesh.triangles[triangleOf(side)].flags &= ~(EdgeFixed << cornerOf(side));
    }
    this->waiting.assign(1, h);
    this->makeDelaunay();
  }

  /// Have fewer triangles the corner v than u? It takes as many steps as the fewer are.
  bool hasSmallerStar(std::uint32_t v, std::uint32_t u)
  {
    const Mesh mesh = this->surface.mesh();
    const std::uint32_t first[2] = { this->surface.leaving(u), this->surface.leaving(v) };
    std::uint32_t h[2] = { first[0], first[1] };
    do
    {
      this->poll.step();
      for (std::uint32_t& spoke : h)
      {
        spoke = mesh.twin(previousHalfEdge(spoke));
      }
    } while (h[0] != first[0] && h[1] != first[1]);
    return h[0] != first[0];
  }

  std::int64_t flipCount() const { return this->flips; }
  std::int64_t checkCount() const { return this->checks; }

private:
  /// How a line leaves a vertex.
  struct Exit
  {
    std::uint32_t along;  ///< a half-edge of the edge that it takes; NoIndex: there is none
    std::uint32_t end;    ///< of that edge
    std::uint32_t across; ///< else the half-edge opposite to the vertex that it crosses
  };

  /// Around u, the edge along the line to v, or the triangle that the line leaves through.
  Exit exitOf(std::uint32_t u, std::uint32_t v)
  {
    const Mesh mesh = this->surface.mesh();
    const Vertex& from = mesh.vertices[u];
    const Vertex& to = mesh.vertices[v];
    const int axis = from.x[0] != to.x[0] ? 0 : 1;
    const bool ascends = from.x[axis] < to.x[axis];
    const auto isVirtual = [](const Vertex& p) { return (p.flags & VertexVirtual) != 0; };
    const auto isAhead = [&](const Vertex& p)
    { return ascends ? p.x[axis] > from.x[axis] : p.x[axis] < from.x[axis]; };
    const auto sideOf = [&](const Vertex& p)
    { return isVirtual(p) ? 0 : this->surface.orient(from, to, p); };

    const std::uint32_t first = this->surface.leaving(u);
    std::uint32_t h = first;
    int side = sideOf(mesh.vertices[mesh.origin(nextHalfEdge(h))]);
    do
    {
      this->poll.step();
      const std::uint32_t last = previousHalfEdge(h);
      const std::uint32_t p = mesh.origin(nextHalfEdge(h));
      const std::uint32_t q = mesh.origin(last);
      const Vertex& right = mesh.vertices[p];
      const Vertex& left = mesh.vertices[q];
      const int nextSide = sideOf(left);
      if (side <= 0 && nextSide >= 0 && !isVirtual(right) && !isVirtual(left))
      {
        const bool alongRight = side == 0 && isAhead(right);
        const bool alongLeft = nextSide == 0 && isAhead(left);
        const bool between = side < 0 && nextSide > 0;
        // A triangle without area, at the border, has no edges of its own.
        if ((alongRight || alongLeft || between) && this->surface.orient(from, right, left) > 0)
        {
          return between ? Exit{ NoIndex, NoIndex, nextHalfEdge(h) }
            : alongRight ? Exit{ h, p, NoIndex }
                         : Exit{ last, q, NoIndex };
        }
      }
      side = nextSide;
      h = mesh.twin(last);
    } while (h != first);
    throw Error(ErrorCode::Internal); // the triangulation is convex
  }

  void fix(std::uint32_t h)
  {
    const Mesh mesh = this->surface.mesh();
    const std::uint32_t twin = mesh.twin(h);
    for (const std::uint32_t side : { h, twin })
    {
      this->surface.willChange(triangleOf(side));
      mesh.triangles[triangleOf(side)].flags |= EdgeFixed << cornerOf(side);
    }
    mesh.setFlat(h, false);
    // The next constraint often goes on here.
    this->surface.setLeaving(mesh.origin(h), h);
    this->surface.setLeaving(mesh.origin(twin), twin);
  }

  /// Flip from the edges that wait on.
  void makeDelaunay()
  {
    const Mesh mesh = this->surface.mesh();
    while (!this->waiting.empty())
    {
      this->poll.step();
      const std::uint32_t h = this->waiting.back();
      this->waiting.pop_back();
      if (mesh.isFixed(h))
      {
        continue;
      }
      ++this->checks;
      const std::uint32_t apex = mesh.origin(previousHalfEdge(mesh.twin(h)));
      if (!this->surface.isAbove(mesh.triangles[triangleOf(h)], mesh.vertices[apex]))
      {
        continue;
      }
      const FlipPlan plan = planFlip22(mesh, h);
      for (int i = 0; i < plan.outerCount; ++i)
      {
        this->surface.willChange(triangleOf(plan.from[i]));
        this->surface.willChange(triangleOf(mesh.twin(plan.from[i])));
      }
      flip(mesh, plan);
      ++this->flips;
      this->surface.leaveThrough(plan.triangle[0]);
      this->surface.leaveThrough(plan.triangle[1]);
      this->waiting.insert(this->waiting.end(), plan.to, plan.to + plan.outerCount);
    }
  }

  Surface& surface;
  StepPoll poll;
  Cavity<Surface> cavity;
  std::vector<std::uint32_t> waiting; ///< half-edges to be checked
  std::int64_t flips = 0;
  std::int64_t checks = 0;
};

}

#endif
