// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangulate one part of the plane's weighted points: inserted one at a time (Insertion.h), by
/// perturbed signs. A point that is hidden within its part is hidden in the whole, so only the
/// part's visible vertices go on.
///
/// Points on one line have no triangle to start from. They are merged, one by one, in their order
/// along it.
#ifndef flipflop_WeightedPart_h
#define flipflop_WeightedPart_h

#include "FlipFlop/PlanePart.h"
#include "FlipFlop/Tally.h"
#include "Geometry/LiftedGeometry.h"
#include "Support/Monitor.h"

#include <cstdint>

namespace flipflop
{

class WeightedPart
{
public:
  using Geometry = LiftedGeometry<true>;

  /// @param first, count the part's vertices, which begin behind the virtual vertex; they are
  ///                     inserted in their order, which may change
  WeightedPart(const Geometry& geometryToUse, const Mesh& meshToFill, std::uint32_t firstVertex,
    std::uint32_t count, bool labelsLast, Monitor& monitorToPoll)
    : geometry(geometryToUse)
    , mesh(meshToFill)
    , begin(firstVertex)
    , end(firstVertex + count)
    , vBiased(labelsLast)
    , monitor(monitorToPoll)
  {
  }

  /// @param tally what is done is added to it
  PlanePart build(Tally& tally);

private:
  PlanePart insertAll(Tally& tally);
  PlanePart mergeAlongLine(Tally& tally);
  PlanePart mergeRange(std::uint32_t from, std::uint32_t to, Tally& tally) const;

  Geometry geometry; ///< with a kernel point inside the first triangle
  const Mesh mesh;
  const std::uint32_t begin;
  const std::uint32_t end;
  const bool vBiased;
  Monitor& monitor;
};

}

#endif
