// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the exact kernels have in common: they take what a fast kernel left undecided, by a
/// geometry of the thread's own, whose counts are added up at the end.
#ifndef flipflop_ExactKernel_h
#define flipflop_ExactKernel_h

#include "Predicates/PredicateSteps.h"
#include "Rounds/Atomics.h"
#include "Rounds/Counters.h"
#include "Rounds/Kernel.h"

#include <cstdint>

namespace flipflop
{

/// @tparam Data with a geometry and the counters
template <class Geometry, class Data>
struct ExactKernel : Kernel
{
  static constexpr bool Exact = true;
  using Local = Geometry;
  Data data;

  FF_HD Geometry begin() const { return this->data.geometry; }

  FF_HD void end(const Geometry& local) const
  {
    const PredicateCounts& now = local.predicateCounts();
    const PredicateCounts& then = this->data.geometry.predicateCounts();
    Counters* const counters = this->data.counters;
    atomics::add(&counters->exactCalls, static_cast<std::uint64_t>(now.exact - then.exact));
    atomics::add(&counters->ties, static_cast<std::uint64_t>(now.ties - then.ties));
  }
};

}

#endif
