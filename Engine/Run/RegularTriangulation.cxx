// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/RegularTriangulation.h>

#include "FlipFlop/CpuBuilder.h"
#include "Run/TriangulationRun.h"

namespace flipflop
{

Triangulation regularTriangulation(
  const PointView& points, const WeightView& weights, const Options& options)
{
  return withOrWithoutWeights(weights,
    [&](auto weighted)
    {
      TriangulationRun<weighted> run(points, weights, options);
      CpuBuilder<LiftedGeometry<weighted>> engine;
      return run.template execute<Triangulation>(
        [&](Triangulation& result) { run.triangulate(engine, result); });
    });
}

}
