// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One run of the engine from the caller's points to the canonical hull: ranges, stages, finish.
#ifndef flipflop_HullRun_h
#define flipflop_HullRun_h

#include "Geometry/HullCones.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/HullLocator.h"
#include "Geometry/HullStart.h"
#include "Run/GeometryRun.h"
#include <flipflop/Hull.h>

namespace flipflop
{

class HullRun : public GeometryRun<HullGeometry>
{
public:
  /// Most points of most inputs are dismissed at once: a thread takes some ten thousand of them.
  /// @throw Error BadArgument, TooManyPoints
  HullRun(const PointView& points, const Options& options)
    : GeometryRun(points, 3, PointSource(points), options, 0.25)
  {
  }

  /// The hull of all points.
  void hullOfPoints(PolyhedronBuilder<HullGeometry>& engine, Hull& hull);

  /// Look at all points, and choose the arithmetic. False: there is no finite point.
  /// @param kernel a further point that the arithmetic has to carry, or null
  /// @param scanner see look()
  /// @throw Error NonFinite
  bool inspect(Hull& hull, const double* kernel = nullptr, PointScanner* scanner = nullptr);

  /// From a hull of perturbed points to the true one, in canonical form.
  void finish(Polyhedron&& polyhedron, Tally&& tally, Hull& hull);

private:
  void write(CanonicalForm<Polyhedron>& form, Hull& hull);
};

}

#endif
