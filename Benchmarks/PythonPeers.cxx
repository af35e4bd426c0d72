// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Python packages as programs: VTK's newest filters, scipy, meshlib, matplotlib, triangle, and our
/// own wheel. peers.py has the call of each by its name here. Their results are checked exactly.
#include "AnswerCheck.h"
#include "PeerProcess.h"
#include "Problems.h"

#include <map>

namespace flipflop
{
namespace
{

/// A check of a result, in words. Null: there is none.
using CheckAnswer = CheckResult (*)(const PointView&, const Answer&);

CheckResult checkHullAnswer(const PointView& points, const Answer& answer)
{
  const AnswerReport report = checkHull(points, answer);
  return { report.isValid(), describeHull(report) };
}
CheckResult checkDelaunayAnswer(const PointView& points, const Answer& answer)
{
  const AnswerReport report = checkDelaunay(points, answer);
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
  PythonPeer(const std::string& name, int threads, int parts, CheckAnswer check)
    : process(findProcess({ name, std::to_string(threads), std::to_string(parts) }))
    , checkAnswer(check)
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
    const Answer& answer = this->result.answer;
    Metrics metrics =
      metricsOf(answer.cellCount() ? answer.vertexCount() : std::int64_t(answer.points.size()) / 3,
        answer.cellCount());
    metrics.emplace_back("seconds", this->result.seconds);
    metrics.emplace_back("peak_bytes", this->result.peakBytes);
    return metrics;
  }
  CheckResult check() const override
  {
    return this->checkAnswer ? this->checkAnswer(this->points, this->result.answer) : CheckResult();
  }

private:
  std::shared_ptr<PeerProcess> process;
  CheckAnswer checkAnswer;
  PointView points;
  PeerRun result;
};

/// @param script  the name that peers.py has
/// @param threads 0: as the plan says, as for our own engine
ProgramKind peer(const std::string& name, const std::string& script, int threads, CheckAnswer check)
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
    peer("vtkflipflop", "our-hull", 0, checkHullAnswer),
    peer("vtk-convex-hull", "vtk-convex-hull", 1, checkHullAnswer),
    peer("vtk-delaunay-3d", "vtk-delaunay-3d", 1, checkHullAnswer),
    peer("scipy", "scipy-hull", 1, checkHullAnswer),
    peer("meshlib", "meshlib-hull", 1, checkHullAnswer),
  };
}

std::vector<ProgramKind> pythonTriangulationPrograms()
{
  return {
    peer("vtkflipflop", "our-triangulation", 0, checkDelaunayAnswer),
    peer("vtk-flower", "vtk-voronoi-flower-2d", 1, checkDelaunayAnswer),
    peer("vtk-flower-2", "vtk-voronoi-flower-2d", 2, checkDelaunayAnswer),
    peer("vtk-delaunay-2d", "vtk-delaunay-2d", 1, checkDelaunayAnswer),
    peer("vtk-delaunay-2d-sorted", "vtk-delaunay-2d-sorted", 1, checkDelaunayAnswer),
    peer("scipy", "scipy-triangulation", 1, checkDelaunayAnswer),
    peer("matplotlib", "matplotlib-triangulation", 1, checkDelaunayAnswer),
    peer("triangle", "triangle-triangulation", 1, checkDelaunayAnswer),
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
