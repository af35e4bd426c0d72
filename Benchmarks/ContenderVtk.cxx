// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerJudge.h"
#include "VtkContenders.h"
#include "VtkProcess.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace flipflop
{
namespace
{

struct Judge
{
  Judgement (*judge)(const PointView&, const Answer&);
  std::string (*describe)(const Judgement&);
};

/// VTK's process outlives the contender: what is run first, to bind libraries and start threads, is
/// to do so for the measured run.
class VtkContender final : public Contender
{
public:
  VtkContender(std::shared_ptr<VtkProcess> process, Judge judge)
    : process(std::move(process))
    , ownJudge(judge)
  {
  }

  void prepare(const Coordinates& xyz) override
  {
    this->view = PointView(xyz.data(), static_cast<std::int64_t>(xyz.size() / 3));
    this->process->give(xyz);
  }
  void run() override { this->result = this->process->run(); }
  Outcome outcome() const override
  {
    Outcome outcome;
    outcome.vertices = this->result.answer.vertexCount();
    outcome.facets = this->result.answer.cellCount();
    outcome.seconds = this->result.seconds;
    outcome.peakBytes = this->result.peakBytes;
    return outcome;
  }
  Verdict judge() const override
  {
    const Judgement judgement = this->ownJudge.judge(this->view, this->result.answer);
    return { judgement.isValid(), this->ownJudge.describe(judgement) };
  }

private:
  std::shared_ptr<VtkProcess> process;
  Judge ownJudge;
  PointView view;
  VtkRun result;
};

/// @param threads of VTK's
ContenderFactory factory(const std::string& filter, int threads, Judge judge)
{
  // Called in the process of each run: the first contender there starts VTK.
  auto process = std::make_shared<std::shared_ptr<VtkProcess>>();
  return [=]
  {
    if (!*process)
    {
      *process =
        std::make_shared<VtkProcess>(std::vector<std::string>{ filter, std::to_string(threads) });
    }
    return std::make_unique<VtkContender>(*process, judge);
  };
}

}

ContenderFactory vtkHulls(const std::string& filter)
{
  return factory(filter, 1, { judgeHull, describeHull });
}

ContenderFactory vtkTriangulations(const std::string& filter, int threads)
{
  return factory(filter, threads, { judgeDelaunay, describeDelaunay });
}

std::string vtkVersion()
{
  try
  {
    return VtkProcess({ "--version" }).readLine();
  }
  catch (const std::runtime_error&)
  {
    std::fprintf(stderr, "FLIPFLOP_VTK_PYTHON names no Python that has VTK\n");
    std::exit(2);
  }
}

}
