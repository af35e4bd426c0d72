// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/RegularTriangulation.h>

#include "Run/TriangulationRun.h"

namespace flipflop
{

namespace
{

template <bool Weighted>
Triangulation triangulate(
  const PointView& points, const WeightView& weights, const Options& options)
{
  TriangulationRun<Weighted> run(points, weights, options);
  return run.template execute<Triangulation>(
    [&run](Triangulation& result) { run.triangulate(result); });
}

}

Triangulation regularTriangulation(
  const PointView& points, const WeightView& weights, const Options& options)
{
  return weights.data ? triangulate<true>(points, weights, options)
                      : triangulate<false>(points, weights, options);
}

}
