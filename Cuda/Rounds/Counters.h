// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the rounds count, in the executor's memory: how long each list is, how many slots are
/// taken, and what was done. Kernels take their item counts from here, so no round waits for the
/// host.
///
/// A list that one round fills and the next one reads takes turns: two counts, one of which is
/// cleared before it is added to.
///
/// What the host needs of a round, the first kernel of the next one writes (RoundRecord).
#ifndef flipflop_Counters_h
#define flipflop_Counters_h

#include <cstdint>

namespace flipflop
{

/// What a round of flips adds to the sums. Apart, for a warp's 32-bit additions are one.
struct RoundCounts
{
  std::uint32_t edgeChecks = 0;
  std::uint32_t flips22 = 0;
  std::uint32_t flips31 = 0;
  std::uint32_t flipsD = 0;
  std::uint32_t labelled = 0;
};

/// What a round has left, in memory that kernels write to and the host reads.
struct RoundRecord
{
  std::uint32_t triangles = 0;
  std::uint32_t vertices = 0;
  std::uint32_t live = 0;
  std::uint32_t candidates = 0;
  std::uint32_t active = 0;
  std::uint32_t undecided = 0;
};

struct Counters
{
  // Slots taken.
  std::uint32_t triangles = 0;
  std::uint32_t vertices = 0;

  // Growth.
  std::uint32_t live[2] = { 0, 0 }; ///< points still above the polyhedron, by turns
  std::uint32_t candidates = 0;     ///< triangles that may have points
  std::uint32_t inserted = 0;       ///< vertices, in the last round

  // Flip-Flop.
  std::uint32_t active[2] = { 0, 0 }; ///< triangles to check, by turns
  std::uint32_t flips[2] = { 0, 0 };  ///< flips of a round, by turns
  std::uint32_t proposing = 0;        ///< the last round in which any triangle proposed a flip
  std::uint32_t tailRound = 0;        ///< the round that FlipTail has ended in
  std::uint32_t tailChecked = 0;      ///< 1: between that round's Check and Resolve
  RoundCounts round;                  ///< of the round under way

  // Items that the filter leaves open.
  std::uint32_t unlocated = 0;           ///< points, until LocateExact has found where they are
  std::uint32_t undecided[2] = { 0, 0 }; ///< active triangles of a round, by turns
  std::uint32_t strayed = 0;             ///< 1: a walk to a point has not ended

  std::uint32_t duplicates = 0; ///< vertices with records of duplicates

  // The finish.
  std::uint32_t points = 0;         ///< of the result
  std::uint32_t cells = 0;          ///< of the result
  std::uint32_t firstPoint = 0;     ///< the vertex of lowest id
  std::uint32_t labelledAlive = 0;  ///< 1: a vertex is labelled and still there
  std::uint32_t duplicatesGone = 0; ///< 1: a vertex that went had duplicates

  // Sums over all rounds.
  std::uint64_t exactCalls = 0;
  std::uint64_t ties = 0;
  std::uint64_t insertions = 0;
  std::uint64_t edgeChecks = 0;
  std::uint64_t flips22 = 0;
  std::uint64_t flips31 = 0;
  std::uint64_t flipsD = 0;
  std::uint64_t labelled = 0;
};

}

#endif
