// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Algorithm 1, Flip-Flop (paper, sections 2.3 and 3.2), as rounds of kernels.
///
///   Check     each active triangle looks for an edge that the rule wants flipped, or an end of it
///             labelled, and votes for itself on all triangles of that flip
///   Resolve   a flip with all its triangles' votes is on; who lost stays active; labels are set
///   Publish   the flips that are on publish where their outer half-edges go
///   Relink    they replace their triangles; a neighbour that flips too has published where
///
/// A vote is the least of the keys (newest round first, half-edge), so it needs no reset, and the
/// least key of all wins all its triangles: every round that proposes a flip makes one. Flips that
/// are on share no triangle, so neither their order nor that of the lists matters. Labels that
/// Resolve sets are seen from the next round's Check on. What the floating-point filter leaves open
/// in Check goes to its exact twin. But nothing with exact arithmetic is launched before the host
/// knows of a triangle that needs it; until then, such triangles stay active.
///
/// An edge has two triangles. If both are active, the lower one examines it; if only one is, that
/// one does. A triangle goes to rest when no edge that it examines is one that may need a flip, and
/// is woken by a change of its own or by a label at a corner: so no edge is left unexamined.
///
/// The V-biased variant sets no labels while flips are many: in a round that proposes any, after
/// one that made more than a quarter as many as there are active triangles. To wait for the last
/// flip would take twice the rounds, for a handful of flips each.
#ifndef flipflop_FlipKernels_h
#define flipflop_FlipKernels_h

#include "FlipFlop/FlipRule.h"
#include "Mesh/Mesh.h"
#include "Rounds/Atomics.h"
#include "Rounds/Counters.h"
#include "Rounds/ExactKernel.h"
#include "Rounds/FilteredGeometry.h"
#include "Rounds/Kernel.h"
#include "Rounds/WideLoad.h"

#include <cstdint>

namespace flipflop
{

/// What an active triangle wants.
struct Proposal
{
  std::uint32_t edge; ///< its own half-edge; NoIndex: it goes to rest
  FlipAction action;
  bool byDegree;
};

/// What the kernels work on, in the executor's memory.
template <class Geometry>
struct FlipData
{
  Geometry geometry;
  Mesh mesh;
  std::uint64_t* votes;   ///< by triangle: see voteKey
  std::uint32_t* moved;   ///< by half-edge: where it goes in this round's flip
  std::uint32_t* flipped; ///< by triangle: the last round that flipped it
  std::uint32_t* queued;  ///< by triangle: the last round it is active in
  std::uint32_t* sameAs;  ///< three by vertex: ids at its position, when it was last seen to go
  std::uint32_t* active[2];
  Proposal* proposals; ///< by index in the active list
  Proposal* flips;     ///< those that are on
  std::uint32_t* undecided;
  Counters* counters;
  bool vBiased;
};

/// Newer rounds go before older ones, then lower half-edges before higher.
FF_HD inline std::uint64_t voteKey(std::uint32_t round, std::uint32_t h)
{
  return static_cast<std::uint64_t>(~round) << 32 | h;
}

namespace flips
{

FF_HD inline bool isFlip(const Proposal& p)
{
  return p.action == FlipAction::Flip22 || p.action == FlipAction::RemoveA ||
    p.action == FlipAction::RemoveB;
}

/// The half-edge from the end that the proposal labels or removes.
FF_HD inline std::uint32_t halfEdgeFromEnd(const Mesh& mesh, const Proposal& p)
{
  return p.action == FlipAction::RemoveB || p.action == FlipAction::LabelB ? mesh.twin(p.edge)
                                                                           : p.edge;
}

FF_HD inline FlipPlan planOf(const Mesh& mesh, const Proposal& p)
{
  return p.action == FlipAction::Flip22 ? planFlip22(mesh, p.edge)
                                        : planFlip31(mesh, halfEdgeFromEnd(mesh, p));
}

/// Let triangle t be active in round @p next.
template <class Geometry>
FF_HD void wake(const FlipData<Geometry>& data, std::uint32_t next, std::uint32_t t)
{
  if (atomics::exchange(&data.queued[t], next) != next)
  {
    data.active[next & 1][atomics::add(&data.counters->active[next & 1], 1u)] = t;
  }
}

/// Note all duplicates of the origin of h: one of them may go next. For one item of a launch alone
/// to call.
template <class Geometry>
FF_HD void noteDuplicates(const FlipData<Geometry>& data, std::uint32_t h)
{
  std::uint32_t* const sameAs = data.sameAs + 3 * std::size_t(data.mesh.origin(h));
  eachDuplicateOfOrigin(data.mesh, h, [=](const Vertex& other, int k) { sameAs[k] = other.id; });
}

/// One of three that are in registers.
FF_HD FF_INLINE std::uint32_t pick(const std::uint32_t* of, int corner)
{
  return corner == 0 ? of[0] : corner == 1 ? of[1] : of[2];
}

/// What triangle @p t, active, wants.
/// @param own its copy
template <class Geometry, class Oracle>
FF_HD Proposal propose(const FlipData<Geometry>& data, const Oracle& geometry, std::uint32_t round,
  std::uint32_t t, const Triangle& own, std::uint32_t& checks)
{
  const Vertex* const vertices = data.mesh.vertices;
  Vertex a = whole(vertices[own.v[0]]);
  Vertex b = whole(vertices[own.v[1]]);
  Vertex c = whole(vertices[own.v[2]]);
  std::uint32_t twin = own.twin[0]; // of ab
  std::uint32_t next = own.twin[1]; // of bc
  std::uint32_t last = own.twin[2]; // of ca
  for (int e = 0; e < 3; ++e)
  {
    const std::uint32_t other = triangleOf(twin);
    if (!(other < t && data.queued[other] == round)) // else it examines this edge
    {
      ++checks;
      const Triangle second = whole(data.mesh.triangles[other]);
      const int g = cornerOf(twin);
      const Vertex d = whole(vertices[pick(second.v, previousCorner(g))]);
      const FlipDecision decision = decideFlip(geometry, a, b, c, d,
        triangleOf(last) == triangleOf(pick(second.twin, nextCorner(g))),
        triangleOf(next) == triangleOf(pick(second.twin, previousCorner(g))));
      if (decision.action != FlipAction::None || isUndecided(geometry))
      {
        return { halfEdge(t, e), decision.action, decision.byDegree };
      }
    }
    const Vertex first = a;
    a = b;
    b = c;
    c = first;
    const std::uint32_t of = twin;
    twin = next;
    next = last;
    last = of;
  }
  return { NoIndex, FlipAction::None, false };
}

/// Index @p i of the active list.
template <class Geometry, class Oracle>
FF_HD void check(const FlipData<Geometry>& data, const Oracle& geometry, std::uint32_t round,
  std::uint32_t i, std::uint32_t& checks)
{
  const std::uint32_t t = data.active[round & 1][i];
  Proposal proposal = { NoIndex, FlipAction::None, false };
  const Triangle own = whole(data.mesh.triangles[t]);
  if (!(own.flags & TriangleDead))
  {
    proposal = propose(data, geometry, round, t, own, checks);
    if (isUndecided(geometry))
    {
      // Where no exact kernel follows, the triangle stays active.
      data.undecided[atomics::add(&data.counters->undecided[round & 1], 1u)] = i;
      data.proposals[i] = { halfEdge(t, 0), FlipAction::None, false };
      return;
    }
  }
  data.proposals[i] = proposal;
  if (isFlip(proposal))
  {
    atomics::store(&data.counters->proposing, round);
    const FlipPlan plan = planOf(data.mesh, proposal);
    for (int k = 0; k < 3; ++k)
    {
      if (k < plan.triangleCount)
      {
        atomics::lower(&data.votes[plan.triangle[k]], voteKey(round, proposal.edge));
      }
    }
  }
}

}

/// Over all triangles, before the first round.
template <class Geometry>
struct WakeAll : Kernel
{
  static constexpr const char* Name = "wake all";
  static constexpr int Bytes = 4 + 4;
  FlipData<Geometry> data;
  std::uint32_t count;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    this->data.active[1][i] = i;
    this->data.queued[i] = 1;
  }
  FF_HD void once() const
  {
    Counters& counters = *this->data.counters;
    counters.active[1] = this->count;
    counters.undecided[0] = 0;
    counters.undecided[1] = 0;
  }
};

/// What the kernels of a round have in common.
/// @tparam Data the data, or a reference to them where a larger kernel has them (FlipTail)
template <class Geometry, class Data>
struct FlipKernel : Kernel
{
  Data held;
  std::uint32_t round;

  FF_HD const FlipData<Geometry>& data() const { return this->held; }
};

/// Over the active triangles.
template <class Geometry, class Data = FlipData<Geometry>>
struct Check : FlipKernel<Geometry, Data>
{
  static constexpr const char* Name = "check";
  // Four vertices and two triangles are many registers, and the filter in the plane takes more.
  static constexpr unsigned LeastBlocks = Geometry::IsPlanar ? 3 : 0;
  static constexpr int Bytes = 4 + 4 * 32 + 6 * 32 + 8 + 2 * 8;
  RoundRecord* record;         ///< of the round before; null: nobody reads it
  using Local = std::uint32_t; ///< edges examined
  FF_HD Local begin() const { return 0; }
  FF_HD void operator()(std::uint32_t i, Local& checks) const
  {
    flips::check(
      this->data(), FilteredGeometry<Geometry>(this->data().geometry), this->round, i, checks);
  }
  FF_HD void end(Local checks) const
  {
    atomics::add(&this->data().counters->round.edgeChecks, checks);
  }
  FF_HD void once() const
  {
    Counters& counters = *this->data().counters;
    const std::uint32_t before = (this->round & 1) ^ 1;
    if (this->record)
    {
      *this->record = { counters.triangles, counters.vertices, 0, 0,
        counters.active[this->round & 1], counters.undecided[before] };
    }
    counters.active[before] = 0;
    counters.flips[this->round & 1] = 0;
    // The round before is over. One without work comes after the last, so nothing is lost.
    RoundCounts& counts = counters.round;
    counters.flips22 += counts.flips22;
    counters.flips31 += counts.flips31;
    counters.flipsD += counts.flipsD;
    counters.labelled += counts.labelled;
    counts.flips22 = 0;
    counts.flips31 = 0;
    counts.flipsD = 0;
    counts.labelled = 0;
  }
};

/// Over the undecided of Check.
template <class Geometry>
struct CheckExact : ExactKernel<Geometry, FlipData<Geometry>>
{
  static constexpr const char* Name = "check, exact";
  static constexpr int Bytes = Check<Geometry>::Bytes + 4;
  std::uint32_t round;

  FF_HD void operator()(std::uint32_t i, const Geometry& local) const
  {
    std::uint32_t checks = 0; // the fast kernel has counted them
    flips::check(this->data, local, this->round, this->data.undecided[i], checks);
  }
};

/// Over the active triangles.
template <class Geometry, class Data = FlipData<Geometry>>
struct Resolve : FlipKernel<Geometry, Data>
{
  static constexpr const char* Name = "resolve";
  static constexpr int Bytes = 4 + 8 + 2 * 8 + 8 + 8;
  using Local = std::uint32_t; ///< vertices labelled
  FF_HD Local begin() const { return 0; }
  FF_HD void operator()(std::uint32_t i, Local& labelled) const
  {
    const FlipData<Geometry>& d = this->data();
    const Proposal proposal = d.proposals[i];
    if (proposal.action == FlipAction::None)
    {
      if (proposal.edge != NoIndex)
      {
        flips::wake(d, this->round + 1, triangleOf(proposal.edge));
      }
      return;
    }
    if (!flips::isFlip(proposal))
    {
      if (d.vBiased && this->flipsAreMany())
      {
        flips::wake(d, this->round + 1, triangleOf(proposal.edge));
      }
      else
      {
        this->label(flips::halfEdgeFromEnd(d.mesh, proposal), labelled);
      }
      return;
    }
    const std::uint64_t key = voteKey(this->round, proposal.edge);
    const FlipPlan plan = flips::planOf(d.mesh, proposal);
    bool won = true;
    for (int k = 0; k < 3; ++k)
    {
      won = won && (k >= plan.triangleCount || d.votes[plan.triangle[k]] == key);
    }
    if (won)
    {
      const int turn = static_cast<int>(this->round & 1);
      d.flips[atomics::add(&d.counters->flips[turn], 1u)] = proposal;
    }
    else
    {
      flips::wake(d, this->round + 1, triangleOf(proposal.edge));
    }
  }
  FF_HD void end(Local labelled) const
  {
    atomics::add(&this->data().counters->round.labelled, labelled);
  }
  /// Check has counted.
  FF_HD void once() const
  {
    Counters& counters = *this->data().counters;
    counters.undecided[(this->round & 1) ^ 1] = 0;
    counters.edgeChecks += counters.round.edgeChecks;
    counters.round.edgeChecks = 0;
  }

private:
  /// This round's flips are still being counted, those of the last round are known.
  FF_HD bool flipsAreMany() const
  {
    const Counters& counters = *this->data().counters;
    const std::uint64_t flipsBefore = counters.flips[(this->round & 1) ^ 1];
    return counters.proposing == this->round &&
      (this->round == 1 || 4 * flipsBefore > counters.active[this->round & 1]);
  }

  /// Label the origin of h, and wake its triangles.
  FF_HD void label(std::uint32_t h, Local& labelled) const
  {
    const FlipData<Geometry>& d = this->data();
    std::uint32_t* const flags = &d.mesh.vertices[d.mesh.origin(h)].flags;
    if (atomics::setBits(flags, std::uint32_t(VertexLabelled)) & VertexLabelled)
    {
      return; // another triangle wants it too
    }
    flips::noteDuplicates(d, h);
    ++labelled;
    std::uint32_t spoke = h;
    do
    {
      flips::wake(d, this->round + 1, triangleOf(spoke));
      spoke = d.mesh.twin(previousHalfEdge(spoke));
    } while (spoke != h);
  }
};

/// Over the round's flips.
template <class Geometry, class Data = FlipData<Geometry>>
struct Publish : FlipKernel<Geometry, Data>
{
  static constexpr const char* Name = "publish";
  static constexpr int Bytes = 8 + 2 * 32 + 4 * 4 + 2 * 4;
  FF_HD void operator()(std::uint32_t i, Kernel::Local&) const
  {
    const FlipData<Geometry>& d = this->data();
    const FlipPlan plan = flips::planOf(d.mesh, d.flips[i]);
    for (int k = 0; k < 4; ++k)
    {
      if (k < plan.outerCount)
      {
        d.moved[plan.from[k]] = plan.to[k];
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      if (k < plan.triangleCount)
      {
        d.flipped[plan.triangle[k]] = this->round;
      }
    }
  }
};

/// Over the round's flips. Each writes to its own triangles, and to half-edges opposite to them in
/// triangles that do not flip.
template <class Geometry, class Data = FlipData<Geometry>>
struct Relink : FlipKernel<Geometry, Data>
{
  static constexpr const char* Name = "relink";
  static constexpr int Bytes = 8 + 2 * 32 + 4 * (4 + 4 + 4) + 2 * 32 + 2 * 8;
  struct Local
  {
    std::uint32_t flips22 = 0;
    std::uint32_t flips31 = 0;
    std::uint32_t byDegree = 0;
  };
  FF_HD Local begin() const { return Local(); }
  FF_HD void operator()(std::uint32_t i, Local& local) const
  {
    const FlipData<Geometry>& d = this->data();
    const Proposal proposal = d.flips[i];
    const FlipPlan plan = flips::planOf(d.mesh, proposal);
    if (proposal.action == FlipAction::Flip22)
    {
      ++local.flips22;
    }
    else
    {
      ++local.flips31;
      if (!proposal.byDegree)
      {
        flips::noteDuplicates(d, flips::halfEdgeFromEnd(d.mesh, proposal));
      }
    }
    local.byDegree += proposal.byDegree ? 1 : 0;

    std::uint32_t outer[4] = {};
    for (int k = 0; k < 4; ++k)
    {
      if (k < plan.outerCount)
      {
        const std::uint32_t other = d.mesh.twin(plan.from[k]);
        const bool flips = d.flipped[triangleOf(other)] == this->round;
        outer[k] = flips ? d.moved[other] : other;
        if (!flips)
        {
          d.mesh.triangles[triangleOf(other)].twin[cornerOf(other)] = plan.to[k];
        }
      }
    }
    replaceTriangles(d.mesh, plan);
    for (int k = 0; k < 4; ++k)
    {
      if (k < plan.outerCount)
      {
        d.mesh.triangles[triangleOf(plan.to[k])].twin[cornerOf(plan.to[k])] = outer[k];
      }
    }
    flips::wake(d, this->round + 1, plan.triangle[0]);
    if (proposal.action == FlipAction::Flip22)
    {
      flips::wake(d, this->round + 1, plan.triangle[1]);
    }
  }
  FF_HD void end(const Local& local) const
  {
    RoundCounts& counts = this->data().counters->round;
    atomics::add(&counts.flips22, local.flips22);
    atomics::add(&counts.flips31, local.flips31);
    atomics::add(&counts.flipsD, local.byDegree);
  }
};

/// Rounds of few active triangles, one after another and without the host. It ends after a round
/// that had nothing to do; before one that has too much; or, if the filter leaves anything open,
/// between Check and Resolve, for the exact kernel's stack is too much for so many threads.
template <class Geometry>
struct FlipTail
{
  static constexpr const char* Name = "tail of flips";
  FlipData<Geometry> data;
  std::uint32_t round; ///< the first
  std::uint32_t most;  ///< active triangles

  /// See HostExecutor's together().
  template <class Run>
  FF_HD void operator()(const Run& run, bool isFirst) const
  {
    using Data = const FlipData<Geometry>&;
    Counters& counters = *this->data.counters;
    std::uint32_t now = this->round;
    bool isChecked = false;
    for (;; ++now)
    {
      const int turn = static_cast<int>(now & 1);
      const std::uint32_t active = atomics::load(&counters.active[turn]);
      if (active > this->most)
      {
        break;
      }
      run(Check<Geometry, Data>{ { {}, this->data, now }, nullptr }, &counters.active[turn]);
      if (atomics::load(&counters.undecided[turn]) != 0)
      {
        isChecked = true;
        break;
      }
      run(Resolve<Geometry, Data>{ { {}, this->data, now } }, &counters.active[turn]);
      run(Publish<Geometry, Data>{ { {}, this->data, now } }, &counters.flips[turn]);
      run(Relink<Geometry, Data>{ { {}, this->data, now } }, &counters.flips[turn]);
      if (active == 0)
      {
        break;
      }
    }
    if (isFirst)
    {
      counters.tailRound = now;
      counters.tailChecked = isChecked ? 1 : 0;
    }
  }
};

}

#endif
