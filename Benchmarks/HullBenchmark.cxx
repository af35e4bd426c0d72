// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// hull-benchmark: convex hulls by this engine, Qhull and CGAL.
#include "HullContenders.h"
#include "Suite.h"

int main(int argc, char* argv[])
{
  flipflop::Suite suite;
  suite.program = "hull-benchmark";
  suite.what = "convex hulls by FlipFlop, Qhull and CGAL";
  suite.family = flipflop::Family::Space;
  suite.distributions = "cube,ball,box,shell:0.1,shell:0.01,shell:0.001,shell:0.0001,shell:0,grid,"
                        "surface-grid,rotated-grid,duplicates";
  suite.distributionHelp =
    R"(of cube, ball, box:T, shell:T, grid, surface-grid, rotated-grid,
                          duplicates; T: thickness, 0.01 if not given; shell:0: on the sphere
                          (all of them; shells of 0.1, 0.01, 0.001, 0.0001 and 0))";
  suite.warmUp = flipflop::Distribution::parse("ball", suite.family);
  suite.ours = flipflop::makeFlipFlop;
  // Qhull drops vertices within its tolerance.
  suite.peers = { { "qhull", "Qhull", flipflop::makeQhull },
    { "cgal", "CGAL", flipflop::makeCgal } };
  suite.versions = { { "qhull", flipflop::qhullVersion() }, { "cgal", flipflop::cgalVersion() } };
  return flipflop::runBenchmark(suite, argc, argv);
}
