// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a task has done and found beside its part of the mesh.
#ifndef flipflop_Tally_h
#define flipflop_Tally_h

#include "Duplicate.h"
#include "Statistics.h"

#include <vector>

namespace flipflop
{

/// Counters that tasks gather on their own and hand up.
struct Tally
{
  Statistics statistics;
  std::vector<Duplicate> duplicates;

  void add(Tally&& other)
  {
    Statistics& s = this->statistics;
    const Statistics& o = other.statistics;
    s.insertions += o.insertions;
    s.flips22 += o.flips22;
    s.flips31 += o.flips31;
    s.flipsV += o.flipsV;
    s.flipsD += o.flipsD;
    s.labelled += o.labelled;
    s.edgeChecks += o.edgeChecks;
    s.exactCalls += o.exactCalls;
    s.culled += o.culled;
    s.secondsGrow += o.secondsGrow;
    s.secondsFlip += o.secondsFlip;
    this->duplicates.insert(
      this->duplicates.end(), other.duplicates.begin(), other.duplicates.end());
  }
};

}

#endif
