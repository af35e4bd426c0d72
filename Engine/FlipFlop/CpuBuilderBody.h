// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CpuBuilder's member, for the files that compile it: one for each geometry, so that a machine's
/// cores share what takes longest to compile in the engine.
#ifndef flipflop_CpuBuilderBody_h
#define flipflop_CpuBuilderBody_h

#include "FlipFlop/CpuBuilder.h"

#include "FlipFlop/Builder.h"
#include "FlipFlop/PartsBuilder.h"
#include "Geometry/GeometryConcept.h"

#include <type_traits>
#include <utility>

namespace flipflop
{

template <class Geometry>
BuildResult CpuBuilder<Geometry>::build(
  const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally, Statistics& statistics)
{
  static_assert(isGeometry<Geometry>());
  if constexpr (Geometry::IsPlanar)
  {
    return triangulateByParts<!Geometry::AllExtreme>(task, tally, statistics);
  }
  else
  {
    return Builder<Geometry>::build(task, std::move(start), tally, statistics);
  }
}

}

#endif
