// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// triangulation-benchmark: regular triangulations in the plane by this engine and CGAL.
#include "Suite.h"
#include "TriangulationContenders.h"

int main(int argc, char* argv[])
{
  flipflop::Suite suite;
  suite.program = "triangulation-benchmark";
  suite.what = "regular triangulations by FlipFlop and CGAL";
  suite.family = flipflop::Family::Plane;
  suite.distributions =
    "uniform:27,uniform:0.19,uniform:0,square-grid,weighted-grid,circle,clusters,scan";
  suite.distributionHelp =
    R"(of uniform:W, square-grid, weighted-grid, circle, clusters, collinear, scan;
                          W: weights in [0, W/n], none if not given
                          (all of them; uniform: 27, 0.19, 0))";
  suite.warmUp = flipflop::Distribution::parse("uniform:1", suite.family);
  suite.ours = flipflop::makeFlipFlopTriangulation;
  suite.peers = { { "cgal-regular", "CGAL RT", flipflop::makeCgalRegular, true, true },
    { "cgal-delaunay", "CGAL DT", flipflop::makeCgalDelaunay, false, true } };
  suite.versions = { { "cgal", flipflop::cgalTriangulationVersion() } };
  return flipflop::runBenchmark(suite, argc, argv);
}
