// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A run from the caller's points to their hull. ConvexHull.cxx has its steps.
#ifndef flipflop_HullRun_h
#define flipflop_HullRun_h

#include "Geometry/HullGeometry.h"
#include "Run/GeometryRun.h"
#include "Run/Span.h"
#include <flipflop/Hull.h>

namespace flipflop
{

class HullRun : public GeometryRun<HullGeometry>
{
public:
  /// @throw Error BadArgument, TooManyPoints
  HullRun(const PointView& points, const Options& options);

  /// The hull of all points: all steps, on the run's threads.
  /// @throw Error NonFinite, TooManyPoints, OutOfMemory, Aborted
  Hull compute(PolyhedronBuilder<HullGeometry>& builder);

  /// Scan the points, and choose the arithmetic. False: there is no finite point.
  /// @param kernel  a further point that the arithmetic has to carry, or null
  /// @param scanner scans the points; null: PointScanner does
  /// @throw Error NonFinite
  bool inspect(Hull& hull, const double* kernel = nullptr, PointScanner* scanner = nullptr);

  /// From a hull of perturbed points to the true one, in canonical form.
  void finish(Polyhedron&& polyhedron, Tally&& tally, Hull& hull);

private:
  void computeSteps(PolyhedronBuilder<HullGeometry>& builder, Hull& hull);
  void finishLower(const Span& span, Hull& hull);
};

}

#endif
