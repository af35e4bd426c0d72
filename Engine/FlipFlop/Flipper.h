// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Algorithm 1, Flip-Flop (paper, section 2.3), on one patch of a mesh, depth first.
///
/// Edges to check wait on a stack; a triangle's flags hold which of its half-edges do, so no edge
/// waits twice. A flip hands its outer edges to the stack, a label the edges of the labelled
/// vertex. Whether and how an edge is flipped is FlipRule's decision alone.
///
/// A patch owns its triangles. A vertex that triangles of other patches share too must not be
/// labelled here, for they read its label: such edges are left to the patch that has the vertex
/// inside (deferred).
///
/// The V-biased variant labels only when no other flip is left to do.
#ifndef flipflop_Flipper_h
#define flipflop_Flipper_h

#include "FlipFlop/FlipRule.h"
#include "FlipFlop/Tally.h"
#include "Mesh/Mesh.h"
#include "Points/Duplicate.h"
#include "Support/Monitor.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Of a mesh that is one patch.
struct NoneShared
{
  bool operator()(std::uint32_t) const { return false; }
};

/// @tparam Geometry a model of the geometry concept (GeometryConcept.h).
/// @tparam Shared   bool operator()(std::uint32_t vertex): may other patches read this vertex's
/// label?
template <class Geometry, class Shared>
class Flipper
{
public:
  Flipper(const Geometry& geometry, const Mesh& mesh, Shared shared, bool vBiased, Monitor& monitor)
    : geometry(geometry)
    , mesh(mesh)
    , shared(shared)
    , vBiased(vBiased)
    , monitor(monitor)
  {
  }

  /// Let the edge of h be checked by the next run.
  void push(std::uint32_t h)
  {
    Triangle& triangle = this->mesh.triangles[triangleOf(h)];
    const std::uint32_t bit = 1u << cornerOf(h);
    const std::uint32_t twin = triangle.twin[cornerOf(h)];
    if (this->mesh.isBorder(twin) || (triangle.flags & (bit | TriangleDead)))
    {
      return;
    }
    if (this->mesh.triangles[triangleOf(twin)].flags >> cornerOf(twin) & 1)
    {
      return;
    }
    triangle.flags |= bit;
    this->stack.push_back(h);
  }

  /// Let those of a few edges be checked that the rule can be concerned with. Their tests do not
  /// wait for each other, nor for what comes of them: most are quiet, and cost little so.
  void pushConcerned(const std::uint32_t* edges, int count)
  {
    bool concerned[4];
    for (int i = 0; i < count; ++i)
    {
      concerned[i] = this->isConcerned(edges[i]);
    }
    for (int i = 0; i < count; ++i)
    {
      if (concerned[i])
      {
        this->push(edges[i]);
      }
    }
  }

  /// Check edges, and flip, until none is left to check. V-biased, what needs a label waits.
  void checkWaiting()
  {
    while (!this->stack.empty())
    {
      const std::uint32_t h = this->stack.back();
      this->stack.pop_back();
      std::uint32_t& flags = this->mesh.triangles[triangleOf(h)].flags;
      if (flags >> cornerOf(h) & 1)
      {
        flags &= ~(1u << cornerOf(h));
        this->check(h);
      }
    }
  }

  /// The same until nothing needs a label either.
  void run()
  {
    this->checkWaiting();
    while (!this->pending.empty())
    {
      this->labelPending();
      this->checkWaiting();
    }
  }

  /// Check one edge now.
  void check(std::uint32_t h)
  {
    ++this->checks;
    if (++this->sincePoll == 0x4000)
    {
      this->sincePoll = 0;
      this->monitor.poll();
    }
    std::uint32_t twin;
    const FlipDecision decision = this->decide(h, twin);
    switch (decision.action)
    {
      case FlipAction::None:
        return;
      case FlipAction::Flip22:
      {
        std::uint32_t outer[4];
        this->flip22(h, outer);
        ++this->flips22;
        this->pushConcerned(outer, 4);
        break;
      }
      case FlipAction::RemoveA:
      case FlipAction::RemoveB:
      {
        const std::uint32_t removed = decision.action == FlipAction::RemoveA ? h : twin;
        if (!decision.byDegree)
        {
          this->noteDuplicates(removed);
        }
        std::uint32_t outer[4];
        this->flip31(removed, outer);
        ++this->flips31;
        this->pushConcerned(outer, 3);
        break;
      }
      case FlipAction::LabelA:
      case FlipAction::LabelB:
        this->wantLabel(decision.action == FlipAction::LabelA ? h : twin);
        return;
    }
    (decision.byDegree ? this->flipsD : this->flipsV) += 1;
  }

  /// Label the origin of h, and let its edges be checked.
  void label(std::uint32_t h)
  {
    Vertex& vertex = this->mesh.vertices[this->mesh.origin(h)];
    if (vertex.flags & VertexLabelled)
    {
      return;
    }
    vertex.flags |= VertexLabelled;
    ++this->labelled;
    this->pushEdgesAt(h);
  }

  /// Let the edges at the origin of h, a vertex inside the patch, be checked by the next run.
  void pushEdgesAt(std::uint32_t h)
  {
    const std::uint32_t origin = this->mesh.origin(h);
    std::uint32_t spoke = h;
    do
    {
      this->push(spoke);
      spoke = this->mesh.twin(previousHalfEdge(spoke));
      // The ring of such a vertex does not meet the patch's border, and ends at its start.
      ensure(!this->mesh.isBorder(spoke) && this->mesh.origin(spoke) == origin);
    } while (spoke != h);
  }

  /// Follow a vertex through the flips to come, from one of its triangles on.
  void follow(std::uint32_t vertex, std::uint32_t triangle)
  {
    this->followed = vertex;
    this->near = triangle;
  }

  /// A triangle of the followed vertex; one that lies where it was, if it has gone.
  std::uint32_t followedTriangle() const { return this->near; }

  std::int64_t labelledCount() const { return this->labelled; }

  /// Half-edges that a larger patch must check.
  std::vector<std::uint32_t> deferred;

  /// Vertices that went, or will, though they are at another's position.
  std::vector<Duplicate> duplicates;

  /// Add what was counted, and the duplicates.
  void addTo(Tally& tally) const
  {
    tally.duplicates.insert(
      tally.duplicates.end(), this->duplicates.begin(), this->duplicates.end());
    Statistics& statistics = tally.statistics;
    statistics.flips22 += this->flips22;
    statistics.flips31 += this->flips31;
    statistics.flipsV += this->flipsV;
    statistics.flipsD += this->flipsD;
    statistics.labelled += this->labelled;
    statistics.edgeChecks += this->checks;
  }

private:
  FF_NOINLINE void flip22(std::uint32_t h, std::uint32_t* outer)
  {
    const FlipPlan plan = planFlip22(this->mesh, h);
    flip(this->mesh, plan);
    this->followThrough(plan);
    std::copy(plan.to, plan.to + 4, outer);
  }
  FF_NOINLINE void flip31(std::uint32_t h, std::uint32_t* outer)
  {
    const FlipPlan plan = planFlip31(this->mesh, h);
    flip(this->mesh, plan);
    this->followThrough(plan);
    std::copy(plan.to, plan.to + 3, outer);
  }

  void followThrough(const FlipPlan& plan)
  {
    const std::uint32_t* const end = plan.triangle + plan.triangleCount;
    if (std::find(plan.triangle, end, this->near) != end)
    {
      const std::uint32_t* const own = plan.corners[0];
      const bool stays =
        plan.triangleCount == 3 || std::find(own, own + 3, this->followed) != own + 3;
      this->near = plan.triangle[stays ? 0 : 1];
    }
  }

  bool isConcerned(std::uint32_t h)
  {
    const Triangle& first = this->mesh.triangles[triangleOf(h)];
    const std::uint32_t twin = first.twin[cornerOf(h)];
    if (this->mesh.isBorder(twin))
    {
      return false;
    }
    ++this->checks;
    const Triangle& second = this->mesh.triangles[triangleOf(twin)];
    const int e = cornerOf(h);
    const Vertex* v = this->mesh.vertices;
    return mayNeedFlip(this->geometry, v[first.v[e]], v[first.v[nextCorner(e)]],
      v[first.v[previousCorner(e)]], v[second.v[previousCorner(cornerOf(twin))]]);
  }

  FlipDecision decide(std::uint32_t h, std::uint32_t& twin) const
  {
    const EdgeSurroundings edge = surroundingsOf(this->mesh, h);
    twin = edge.twin;
    return decideFlip(this->geometry, this->mesh.vertices, edge);
  }

  void wantLabel(std::uint32_t h)
  {
    if (this->vBiased)
    {
      this->pending.push_back(h);
    }
    else
    {
      this->labelOrDefer(h);
    }
  }

  void labelOrDefer(std::uint32_t h)
  {
    if (this->shared(this->mesh.origin(h)))
    {
      this->deferred.push_back(h);
    }
    else
    {
      this->noteDuplicates(h);
      this->label(h);
    }
  }

  void noteDuplicates(std::uint32_t h)
  {
    const std::uint32_t id = this->mesh.vertices[this->mesh.origin(h)].id;
    eachDuplicateOfOrigin(this->mesh, h,
      [&](const Vertex& other, int) {
        this->duplicates.push_back({ id, other.id });
      });
  }

  /// V-biased: all V-flips are done; label what still needs it.
  void labelPending()
  {
    std::vector<std::uint32_t> wanted;
    for (const std::uint32_t h : this->pending)
    {
      const Triangle& triangle = this->mesh.triangles[triangleOf(h)];
      if ((triangle.flags & TriangleDead) || this->mesh.isBorder(triangle.twin[cornerOf(h)]))
      {
        continue;
      }
      std::uint32_t twin;
      const FlipAction action = this->decide(h, twin).action;
      if (action == FlipAction::LabelA || action == FlipAction::LabelB)
      {
        wanted.push_back(action == FlipAction::LabelA ? h : twin);
      }
    }
    this->pending.clear();
    for (const std::uint32_t h : wanted)
    {
      this->labelOrDefer(h);
    }
  }

  const Geometry& geometry;
  const Mesh mesh;
  Shared shared;
  bool vBiased;
  Monitor& monitor;
  std::vector<std::uint32_t> stack;
  std::vector<std::uint32_t> pending;
  std::uint32_t followed = NoIndex; ///< a vertex
  std::uint32_t near = NoIndex;     ///< a triangle
  std::uint32_t sincePoll = 0;
  std::int64_t checks = 0;
  std::int64_t flips22 = 0;
  std::int64_t flips31 = 0;
  std::int64_t flipsV = 0;
  std::int64_t flipsD = 0;
  std::int64_t labelled = 0;
};

}

#endif
