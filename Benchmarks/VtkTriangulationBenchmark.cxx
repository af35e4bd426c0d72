// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtk-triangulation-benchmark: Delaunay triangulations by this engine and by VTK's newest release.
#include "Suite.h"
#include "TriangulationContenders.h"
#include "VtkContenders.h"

int main(int argc, char* argv[])
{
  flipflop::Suite suite;
  suite.program = "vtk-triangulation-benchmark";
  suite.what = "Delaunay triangulations by FlipFlop and VTK";
  suite.family = flipflop::Family::Plane;
  suite.distributions = "uniform:0,square-grid,clusters,circle,repeats,scan," FLIPFLOP_REAL_POINTS;
  suite.distributionHelp =
    R"(of uniform, square-grid, clusters, circle, repeats, scan, or
                          file:PATH (.f32, .f64: x y z, of which z is left out)
                          (all of them, and the points of Data/))";
  suite.warmUp = flipflop::Distribution::parse("uniform:0", suite.family);
  suite.ours = flipflop::makeFlipFlopTriangulation;
  const auto peer = [](const char* name, const char* title, const char* filter, int threads)
  {
    return flipflop::Peer{ name, title, flipflop::vtkTriangulations(filter, threads), false, false,
      threads };
  };
  suite.peers = { peer("vtk-flower", "vtkVoronoiFlower2D", "voronoi-flower-2d", 1),
    peer("vtk-flower-2", "vtkVoronoiFlower2D, 2 threads", "voronoi-flower-2d", 2),
    peer("vtk-delaunay-2d-sorted", "vtkDelaunay2D, sorted", "delaunay-2d-sorted", 1),
    peer("vtk-delaunay-2d", "vtkDelaunay2D", "delaunay-2d", 1) };
  suite.versions = { { "vtk", flipflop::vtkVersion() } };
  return flipflop::runBenchmark(suite, argc, argv);
}
