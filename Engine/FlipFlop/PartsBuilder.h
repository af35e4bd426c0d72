// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The CPU's engine for the plane: the points are cut into parts (PartTree.h), each part is
/// triangulated alone (PartTriangulation.h, WeightedPart.h), and parts are merged in pairs, up the
/// tree (PartMerge.h). Parts share nothing, so threads take any of them; which, changes nothing.
#ifndef flipflop_PartsBuilder_h
#define flipflop_PartsBuilder_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Geometry/LiftedGeometry.h"

#include <type_traits>

namespace flipflop
{

/// @tparam Weighted false: all weights are zero
template <bool Weighted>
class PartsBuilder
{
public:
  using Result = std::conditional_t<Weighted, Polyhedron, PlanePolyhedron>;

  /// As PolyhedronBuilder. Of the start, nothing is used.
  static Result build(const BuildTask<LiftedGeometry<Weighted>>& task, Polyhedron&& start,
    Tally& tally, Statistics& statistics);
};

extern template class PartsBuilder<false>;
extern template class PartsBuilder<true>;

}

#endif
