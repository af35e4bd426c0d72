// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/ConvexHull.h>

#include "FlipFlop/CpuBuilder.h"
#include "Run/HullRun.h"

namespace flipflop
{

Hull convexHull(const PointView& points, const Options& options)
{
  HullRun run(points, options);
  CpuBuilder<HullGeometry> engine;
  return run.execute<Hull>([&](Hull& hull) { run.hullOfPoints(engine, hull); });
}

}
