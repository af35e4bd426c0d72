// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtk-hull-benchmark: convex hulls by this engine and by VTK's newest release.
#include "HullContenders.h"
#include "Suite.h"
#include "VtkContenders.h"

int main(int argc, char* argv[])
{
  flipflop::Suite suite;
  suite.program = "vtk-hull-benchmark";
  suite.what = "convex hulls by FlipFlop and VTK";
  suite.family = flipflop::Family::Space;
  suite.distributions = "cube,ball,shell:0.01,shell:0,grid,surface-grid,rotated-grid,duplicates,"
                        "coplanar," FLIPFLOP_REAL_POINTS;
  suite.distributionHelp =
    R"(as hull-benchmark's, coplanar, or file:PATH (.f32, .f64: x y z)
                          (a choice of them, and the points of Data/))";
  suite.warmUp = flipflop::Distribution::parse("ball", suite.family);
  suite.ours = flipflop::makeFlipFlop;
  suite.peers = { { "vtk-hull", "vtkConvexHull", flipflop::vtkHulls("convex-hull") },
    { "vtk-delaunay-3d", "vtkDelaunay3D", flipflop::vtkHulls("delaunay-3d") } };
  suite.versions = { { "vtk", flipflop::vtkVersion() } };
  return flipflop::runBenchmark(suite, argc, argv);
}
