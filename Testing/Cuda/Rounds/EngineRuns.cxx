// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Cuda/Rounds/EngineRuns.h"

#include "Run/HullRun.h"
#include "Run/TriangulationRun.h"

namespace flipflop
{
namespace test
{

namespace
{

template <bool Weighted>
Triangulation triangulate(PolyhedronBuilder<LiftedGeometry<Weighted>>& engine,
  const PointView& points, const WeightView& weights, const Options& options)
{
  TriangulationRun<Weighted> run(points, weights, options);
  return run.compute(engine);
}

}

Hull hullBy(
  PolyhedronBuilder<HullGeometry>& engine, const PointView& points, const Options& options)
{
  HullRun run(points, options);
  return run.compute(engine);
}

Triangulation triangulationBy(PolyhedronBuilder<LiftedGeometry<true>>& engine,
  const PointView& points, const WeightView& weights, const Options& options)
{
  return triangulate(engine, points, weights, options);
}

Triangulation triangulationBy(
  PolyhedronBuilder<LiftedGeometry<false>>& engine, const PointView& points, const Options& options)
{
  return triangulate(engine, points, WeightView(), options);
}

}
}
