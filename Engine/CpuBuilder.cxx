// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CpuBuilder.h"

#include "Builder.h"
#include "HullCones.h"
#include "HullLocator.h"
#include "HullStart.h"
#include "InsertionBuilder.h"
#include "LiftedLocator.h"
#include "LiftedStart.h"

#include <type_traits>
#include <utility>

namespace flipflop
{

template <class Geometry>
Polyhedron CpuBuilder<Geometry>::build(
  const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally, Statistics& statistics)
{
  using Chosen =
    std::conditional_t<Geometry::InsertsAtOnce, InsertionBuilder<Geometry>, Builder<Geometry>>;
  return Chosen::build(task, std::move(start), tally, statistics);
}

template class CpuBuilder<HullGeometry>;
template class CpuBuilder<LiftedGeometry<false>>;
template class CpuBuilder<LiftedGeometry<true>>;

}
