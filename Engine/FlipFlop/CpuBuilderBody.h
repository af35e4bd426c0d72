// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CpuBuilder's member, for the files that compile it: one for each geometry, so that a machine's
/// cores share what takes longest to compile in the engine.
#ifndef flipflop_CpuBuilderBody_h
#define flipflop_CpuBuilderBody_h

#include "FlipFlop/CpuBuilder.h"

#include "FlipFlop/Builder.h"
#include "FlipFlop/InsertionBuilder.h"
#include "FlipFlop/PartsBuilder.h"
#include "Geometry/GeometryConcept.h"

#include <type_traits>
#include <utility>

namespace flipflop
{

template <class Geometry>
Polyhedron CpuBuilder<Geometry>::build(
  const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally, Statistics& statistics)
{
  static_assert(isGeometry<Geometry>());
  using Inserting = std::conditional_t<std::is_same_v<Geometry, LiftedGeometry<false>>,
    PartsBuilder, InsertionBuilder<Geometry>>;
  using Chosen = std::conditional_t<Geometry::InsertsAtOnce, Inserting, Builder<Geometry>>;
  return Chosen::build(task, std::move(start), tally, statistics);
}

}

#endif
