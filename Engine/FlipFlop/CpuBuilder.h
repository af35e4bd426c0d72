// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The engine on this machine's threads. CpuBuilderBody.h has its member, which
/// is compiled once a geometry.
#ifndef flipflop_CpuBuilder_h
#define flipflop_CpuBuilder_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"

namespace flipflop
{

template <class Geometry>
class CpuBuilder : public PolyhedronBuilder<Geometry>
{
public:
  bool startsFromPoints() const override { return Geometry::IsPlanar; } // by PartsBuilder

  /// By PartsBuilder in the plane, by Builder in space.
  BuildResult build(const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override;
};

extern template class CpuBuilder<HullGeometry>;
extern template class CpuBuilder<LiftedGeometry<false>>;
extern template class CpuBuilder<LiftedGeometry<true>>;

}

#endif
