// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/CpuBuilder.h"

#include "FlipFlop/Builder.h"
#include "FlipFlop/InsertionBuilder.h"
#include "FlipFlop/PartsBuilder.h"
#include "Geometry/GeometryConcept.h"
#include "Geometry/HullCones.h"
#include "Geometry/HullLocator.h"
#include "Geometry/HullStart.h"
#include "Geometry/LiftedLocator.h"
#include "Geometry/LiftedStart.h"

#include <type_traits>
#include <utility>

namespace flipflop
{

static_assert(isGeometry<HullGeometry>());
static_assert(isGeometry<LiftedGeometry<false>>());
static_assert(isGeometry<LiftedGeometry<true>>());

template <class Geometry>
Polyhedron CpuBuilder<Geometry>::build(
  const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally, Statistics& statistics)
{
  using Inserting = std::conditional_t<std::is_same_v<Geometry, LiftedGeometry<false>>,
    PartsBuilder, InsertionBuilder<Geometry>>;
  using Chosen = std::conditional_t<Geometry::InsertsAtOnce, Inserting, Builder<Geometry>>;
  return Chosen::build(task, std::move(start), tally, statistics);
}

template class CpuBuilder<HullGeometry>;
template class CpuBuilder<LiftedGeometry<false>>;
template class CpuBuilder<LiftedGeometry<true>>;

}
