// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a task has done and found besides its part of the mesh.
#ifndef flipflop_Tally_h
#define flipflop_Tally_h

#include "Points/Duplicate.h"
#include <flipflop/Statistics.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

/// Counters that tasks gather on their own and hand up.
struct Tally
{
  Statistics statistics;
  std::vector<Duplicate> duplicates;
  std::int64_t ties = 0; ///< none: no edge of the mesh is flat, for its check would have met one

  /// Count what a task's copy of a geometry has decided.
  template <class Geometry>
  void addPredicates(const Geometry& task, const Geometry& from)
  {
    this->statistics.exactCalls += task.predicateCounts().exact - from.predicateCounts().exact;
    this->ties += task.predicateCounts().ties - from.predicateCounts().ties;
  }

  void add(Tally&& other)
  {
    this->statistics += other.statistics;
    this->ties += other.ties;
    this->duplicates.insert(
      this->duplicates.end(), other.duplicates.begin(), other.duplicates.end());
  }
};

}

#endif
