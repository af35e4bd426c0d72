// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Something is thrown, or a stop is asked for, on one process at any step: then all processes have
// failed, or none, and nobody waits for another.
#include "DistributedVersusSerial.h"

#include "vtkCommunicator.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkMultiProcessController.h"
#include "vtkPFFHullFilter.h"
#include "vtkPFFPowerDiagramFilter.h"
#include "vtkPFFRegularTriangulationFilter.h"

#include <cstdlib>
#include <random>
#include <stdexcept>

using namespace fftest;

namespace
{

/// Counts progress, and does harm at one time.
class FaultObserver : public vtkCommand
{
public:
  static FaultObserver* New() { return new FaultObserver; }
  vtkTypeMacro(FaultObserver, vtkCommand);

  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    // The executive reports before and after the filter's work, where nothing may be thrown.
    const bool isOutside = this->Count == 0 || *static_cast<double*>(data) >= 1.0;
    if (this->Count++ != this->At || (this->Throws && isOutside))
    {
      return;
    }
    this->Done = true;
    if (this->Throws)
    {
      throw std::runtime_error("a fault");
    }
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  }

  int Count = 0;
  int At = -1;
  bool Throws = false;
  bool Done = false;
};

/// Runs a filter anew, whose process @p where does harm at step @p at. Returns how many steps there
/// were here.
int run(const Pieces& pieces, int settings, int where, int at, bool throws)
{
  vtkSmartPointer<vtkFFAlgorithm> filter;
  if (settings % 7 == 6)
  {
    filter = vtkSmartPointer<vtkPFFPowerDiagramFilter>::New();
  }
  else if (settings % 7 == 5)
  {
    vtkNew<vtkPFFHullFilter> hull;
    hull->SetResultMode(vtkPFFHullFilter::RESULT_DISTRIBUTED);
    hull->SetNumberOfStreamDivisions(1 + settings % 2);
    filter = hull;
  }
  else
  {
    vtkNew<vtkPFFRegularTriangulationFilter> triangulation;
    triangulation->SetGenerateGhostCells(settings % 3 == 0);
    triangulation->SetMaximumEdgeLength(settings % 5 == 0 ? 0.3 : 0.0);
    filter = triangulation;
  }
  filter->SetNumberOfThreads(1);
  if (auto* planar = vtkFFPlanarAlgorithm::SafeDownCast(filter))
  {
    planar->SetProjectionPlaneMode(settings % 2 ? 2 : 0);
  }
  vtkNew<FaultObserver> fault;
  fault->At = rank() == where ? at : -1;
  fault->Throws = throws;
  filter->AddObserver(vtkCommand::ProgressEvent, fault);
  vtkNew<ErrorObserver> errors;
  vtkNew<ErrorObserver> warnings;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->AddObserver(vtkCommand::WarningEvent, warnings);
  filter->SetInputDataObject(pieces[static_cast<std::size_t>(rank())]);
  filter->Update();

  // All have an output, or none. Without a fault there is one.
  int own[3] = { filter->GetErrorCode() != vtkErrorCode::NoError, filter->GetDimension() >= 0,
    fault->Done };
  int sums[3] = { 0, 0, 0 };
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    own, sums, 3, vtkCommunicator::SUM_OP);
  const bool failed = sums[2] > 0;
  FF_CHECK(sums[0] == (failed && throws ? processes() : 0));
  // A stop may come too late.
  FF_CHECK(sums[1] == (failed ? 0 : processes()) || (failed && !throws && sums[1] == processes()));
  FF_CHECK(errors->Messages.size() == std::size_t(failed && throws && rank() == 0));
  return fault->Count;
}

}

void testFaults()
{
  const char* wanted = std::getenv("FLIPFLOP_TEST_CASES");
  const int cases = wanted ? std::atoi(wanted) : 30;
  const Pieces pieces = split(randomPoints(300, 130), byTurns);
  std::mt19937 generator(1);
  const auto below = [&](int end) { return static_cast<int>(generator() % unsigned(end)); };
  int most = run(pieces, 1, 0, -1, false);
  vtkMultiProcessController::GetGlobalController()->Broadcast(&most, 1, 0);
  FF_CHECK(most > 5);
  for (int k = 0; k < cases; ++k)
  {
    const int settings = below(210);
    const int where = below(processes());
    const int at = below(most);
    const bool throws = below(2) == 1;
    run(pieces, settings, where, at, throws);
  }
  run(pieces, 1, 0, -1, false);
}
