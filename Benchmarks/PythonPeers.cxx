// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Python packages as programs: VTK's newest filters, scipy, meshlib, matplotlib, triangle, and our
/// own wheel. peers.py has the call of each by its name here. Their results are checked exactly.
#include "PeerCheck.h"
#include "PeerProcess.h"
#include "Problems.h"

#include <map>

namespace flipflop
{
namespace
{

/// A check of a result, in words. Null: there is none.
using CheckOutput = CheckResult (*)(const PointView&, const PeerOutput&);

CheckResult checkHullOutput(const PointView& points, const PeerOutput& output)
{
  const PeerReport report = checkHull(points, output);
  return { report.isValid(), describeHull(report) };
}
CheckResult checkDelaunayOutput(const PointView& points, const PeerOutput& output)
{
  const PeerReport report = checkDelaunay(points, output);
  return { report.isValid(), describeDelaunay(report) };
}

/// A process that has bound its libraries and started its threads serves the measured run, too.
std::shared_ptr<PeerProcess> findProcess(const std::vector<std::string>& arguments)
{
  static std::map<std::vector<std::string>, std::shared_ptr<PeerProcess>> processes;
  std::shared_ptr<PeerProcess>& process = processes[arguments];
  if (!process)
  {
    process = std::make_shared<PeerProcess>(arguments);
  }
  return process;
}

class PythonPeer final : public Program
{
public:
  PythonPeer(const std::string& name, int threads, int parts, CheckOutput check)
    : process(findProcess({ name, std::to_string(threads), std::to_string(parts) }))
    , checkOutput(check)
  {
  }
  void prepare(const Input& input) override
  {
    this->points = input.points();
    this->process->setPoints(input.xyz);
  }
  void run() override { this->result = this->process->run(); }
  Metrics metrics() const override
  {
    const PeerOutput& output = this->result.output;
    Metrics metrics =
      metricsOf(output.cellCount() ? output.vertexCount() : std::int64_t(output.points.size()) / 3,
        output.cellCount());
    metrics.emplace_back("seconds", this->result.seconds);
    metrics.emplace_back("peak_bytes", this->result.peakBytes);
    return metrics;
  }
  CheckResult check() const override
  {
    return this->checkOutput ? this->checkOutput(this->points, this->result.output) : CheckResult();
  }

private:
  std::shared_ptr<PeerProcess> process;
  CheckOutput checkOutput;
  PointView points;
  PeerRun result;
};

/// @param script  the name that peers.py has
/// @param threads 0: as the plan says, as for our own engine
ProgramKind peer(const std::string& name, const std::string& script, int threads, CheckOutput check)
{
  ProgramKind kind;
  kind.name = name;
  kind.make = [=](const Settings& settings)
  {
    return std::make_unique<PythonPeer>(
      script, threads ? threads : settings.threads, settings.parts, check);
  };
  kind.isOurs = kind.hasThreads = kind.isExact = threads == 0;
  kind.hasWeights = false;
  return kind;
}

}

std::vector<ProgramKind> pythonHullPrograms()
{
  return {
    peer("vtkflipflop", "our-hull", 0, checkHullOutput),
    peer("vtk-convex-hull", "vtk-convex-hull", 1, checkHullOutput),
    peer("vtk-delaunay-3d", "vtk-delaunay-3d", 1, checkHullOutput),
    peer("scipy", "scipy-hull", 1, checkHullOutput),
    peer("meshlib", "meshlib-hull", 1, checkHullOutput),
  };
}

std::vector<ProgramKind> pythonTriangulationPrograms()
{
  return {
    peer("vtkflipflop", "our-triangulation", 0, checkDelaunayOutput),
    peer("vtk-flower", "vtk-voronoi-flower-2d", 1, checkDelaunayOutput),
    peer("vtk-flower-2", "vtk-voronoi-flower-2d", 2, checkDelaunayOutput),
    peer("vtk-delaunay-2d", "vtk-delaunay-2d", 1, checkDelaunayOutput),
    peer("vtk-delaunay-2d-sorted", "vtk-delaunay-2d-sorted", 1, checkDelaunayOutput),
    peer("scipy", "scipy-triangulation", 1, checkDelaunayOutput),
    peer("matplotlib", "matplotlib-triangulation", 1, checkDelaunayOutput),
    peer("triangle", "triangle-triangulation", 1, checkDelaunayOutput),
  };
}

std::vector<ProgramKind> pythonManyHullsPrograms()
{
  return {
    peer("vtkflipflop", "our-many-hulls", 0, nullptr),
    peer("vtkflipflop-loop", "our-hulls-in-a-loop", 0, nullptr),
    peer("scipy-loop", "scipy-hulls-in-a-loop", 1, nullptr),
  };
}

}
