// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangulate one part of weighted points of the plane, or of points in space: inserted one at a
/// time (Insertion.h), by perturbed signs. A point that is hidden within its part is hidden in the
/// whole, so only the part's visible vertices go on.
///
/// Points on one line of the plane have no triangle to start from, nor have points in space that
/// are on one plane with the kernel point. They are merged, one by one, in their order along the
/// line, or around the kernel point.
#ifndef flipflop_PerturbedPart_h
#define flipflop_PerturbedPart_h

#include "FlipFlop/Part.h"
#include "FlipFlop/Tally.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"
#include "Support/Monitor.h"

#include <cstdint>

namespace flipflop
{

/// @tparam Geometry LiftedGeometry<true> or HullGeometry
template <class Geometry>
class PerturbedPart
{
public:
  /// @param geometryToUse its kernel point is the virtual vertex
  /// @param first, count the part's vertices, which begin behind the virtual vertex; they are
  ///                     inserted in their order, which may change
  PerturbedPart(const Geometry& geometryToUse, const Mesh& meshToFill, std::uint32_t firstVertex,
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
  Part build(Tally& tally);

private:
  Part insertAll(Tally& tally);
  Part merge(const Geometry& local, Tally& tally);
  Part mergeRange(std::uint32_t from, std::uint32_t to, const Geometry& local, Tally& tally) const;

  const Geometry& geometry;
  const Mesh mesh;
  const std::uint32_t begin;
  const std::uint32_t end;
  const bool vBiased;
  Monitor& monitor;
};

extern template class PerturbedPart<LiftedGeometry<true>>;
extern template class PerturbedPart<HullGeometry>;

}

#endif
