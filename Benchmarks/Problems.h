// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The problems, a file each, and what they share.
#ifndef flipflop_Problems_h
#define flipflop_Problems_h

#include "Program.h"
#include <flipflop/Statistics.h>

#include <string>
#include <vector>

namespace flipflop
{

Problem hullProblem();
Problem triangulationProblem();
Problem constrainedProblem();
Problem alphaProblem();
Problem areasProblem();
Problem centroidsProblem();
Problem terrainProblem();
Problem editsProblem();     ///< of a triangulation
Problem smallProblem();     ///< few points, in a fresh process
Problem manyHullsProblem(); ///< many small sets
Problem manyTrianglesProblem();
Problem planeBlocksProblem(); ///< distributed blocks
Problem spaceBlocksProblem();

/// Vertices, cells and the statistics of a run.
Metrics metricsOf(std::int64_t vertices, std::int64_t cells, const Statistics& statistics);
Metrics metricsOf(std::int64_t vertices, std::int64_t cells);

// Programs that several files define.
std::unique_ptr<Program> makeFlipFlopHull(const Settings& settings);
std::unique_ptr<Program> makeFlipFlopTriangulation(const Settings& settings);

// With CGAL or Qhull, where CMake has found them; a file each, as CGAL's flags are its own.
std::vector<ProgramKind> qhullPrograms();
std::vector<ProgramKind> cgalHullPrograms();
std::vector<ProgramKind> cgalTriangulationPrograms();
std::vector<ProgramKind> cgalConstrainedPrograms();
std::vector<ProgramKind> cgalAlphaPrograms();
std::vector<ProgramKind> cgalEditsPrograms();
std::vector<std::pair<std::string, std::string>> qhullFacts();
std::vector<std::pair<std::string, std::string>> cgalFacts();

// Python packages, VTK's filters among them: PythonPeers.cxx.
std::vector<ProgramKind> pythonHullPrograms();
std::vector<ProgramKind> pythonTriangulationPrograms();
std::vector<ProgramKind> pythonManyHullsPrograms();

// vtkFFHullFilter, where the filters are built: ManyBlocks.cxx.
std::vector<ProgramKind> filterManyHullsPrograms();

// On a device, where its runners are built: Cuda/.
std::vector<ProgramKind> cudaHullPrograms();
std::vector<ProgramKind> cudaTriangulationPrograms();
std::vector<Problem> cudaProblems();
std::vector<std::pair<std::string, std::string>> cudaFacts();

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more)
{
  to.insert(to.end(), more.begin(), more.end());
}

}

#endif
