// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The filter as a part of a pipeline: progress, abort, what makes it run again, PrintSelf.
#include "FFTest.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace fftest;

namespace
{

/// Counts an object's events of one kind.
class Counter
{
public:
  Counter(vtkObject* object, unsigned long event)
  {
    this->Command->SetClientData(&this->Count);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    object->AddObserver(event, this->Command);
  }
  int Count = 0;

private:
  vtkNew<vtkCallbackCommand> Command;
};

std::vector<Point> onSphere(int count)
{
  auto points = randomPoints(count, 41);
  for (Point& p : points)
  {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    p = { p[0] / length, p[1] / length, p[2] / length };
  }
  return points;
}

void testProgress()
{
  const auto points = onSphere(50000);
  vtkNew<vtkFFHullFilter> hull;
  vtkNew<ProgressObserver> progress;
  hull->AddObserver(vtkCommand::ProgressEvent, progress);
  hull->SetInputData(makePoints(points));
  hull->Update();
  checkProgress(progress->Values);

  // The blocks of a composite share the way from 0 to 1.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(points));
  blocks->SetBlock(1, makePoints(points));
  progress->Values.clear();
  hull->SetInputData(blocks);
  hull->Update();
  checkProgress(progress->Values);
}

/// The text beside the progress tells what is being made, and the step.
void testProgressText()
{
  const auto textsOf = [](vtkFFAlgorithm* algorithm, vtkDataObject* input)
  {
    vtkNew<ProgressObserver> progress;
    algorithm->AddObserver(vtkCommand::ProgressEvent, progress);
    algorithm->SetInputDataObject(input);
    algorithm->Update();
    return progress->Texts;
  };
  /// They begin with these titles, and some are of these steps, in this order.
  const auto check = [](const std::vector<std::string>& texts,
                       const std::vector<std::string>& titles,
                       const std::vector<std::string>& steps)
  {
    for (const std::string& text : texts)
    {
      FF_CHECK(std::any_of(titles.begin(), titles.end(),
        [&](const std::string& title) { return text.compare(0, title.size(), title) == 0; }));
    }
    auto text = texts.begin();
    for (const std::string& step : steps)
    {
      text = std::find(text, texts.end(), step);
      if (text == texts.end())
      {
        std::cerr << "no step " << step << "\n";
      }
      FF_CHECK(text != texts.end());
    }
  };
  const auto points = makePoints(onSphere(50000));
  vtkNew<vtkFFHullFilter> hull;
  check(textsOf(hull, points), { "Convex hull" },
    { "Convex hull: scanning", "Convex hull: sorting", "Convex hull: finishing" });
  vtkNew<vtkFFConvexifyFilter> convexify;
  check(textsOf(convexify, hull->GetOutput()), { "Convexify" },
    { "Convexify: flipping", "Convexify: finishing" });
  vtkNew<vtkFFRegularTriangulationFilter> triangulation;
  triangulation->GeneratePowerDiagramOn();
  check(textsOf(triangulation, points), { "Regular triangulation", "Power diagram" },
    { "Regular triangulation: scanning", "Regular triangulation: finishing",
      "Power diagram: making cells" });
  // A second run begins with the first title.
  triangulation->Modified();
  check(textsOf(triangulation, points), { "Regular triangulation", "Power diagram" },
    { "Regular triangulation: scanning", "Power diagram: making cells" });
}

void testAbort()
{
  const auto input = makePoints(onSphere(200000));
  for (const double mark : { 0.01, 0.5 })
  {
    vtkNew<vtkFFHullFilter> hull;
    const auto errors = ErrorObserver::Of(hull);
    vtkNew<ProgressObserver> progress;
    progress->AbortAt = mark;
    hull->AddObserver(vtkCommand::ProgressEvent, progress);
    hull->SetInputData(input);
    hull->Update();
    FF_CHECK(isEmpty(hull->GetOutput()));
    FF_CHECK(errors->Messages.empty());
    FF_CHECK_EQUAL(errors->FailedRequests, 0);
    FF_CHECK_EQUAL(hull->GetDimension(), -1);
    FF_CHECK(progress->StoppedOnTheWay());

    // Without the wish to stop it runs to its end.
    progress->AbortAt = 2.0;
    hull->SetAbortExecute(0);
    hull->Modified();
    hull->Update();
    FF_CHECK(hull->GetOutput()->GetNumberOfPoints() > 1000);
    FF_CHECK(errors->Messages.empty());
  }
}

/// The pipeline learns of an error, and runs nothing behind it.
void testError()
{
  auto points = cubeCorners();
  points.push_back({ 0, 0, std::numeric_limits<double>::quiet_NaN() });
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  hull->SetInputData(makePoints(points));
  vtkNew<vtkFFConvexifyFilter> behind;
  behind->SetInputConnection(hull->GetOutputPort());
  const Counter runs(behind, vtkCommand::EndEvent);
  FF_CHECK_EQUAL(behind->GetExecutive()->Update(), 0);
  FF_CHECK_EQUAL(errors->FailedRequests, 1);
  FF_CHECK_EQUAL(runs.Count, 0);
  hull->SetNonFinitePointsToIgnore();
  FF_CHECK_EQUAL(behind->GetExecutive()->Update(), 1);
  FF_CHECK_EQUAL(errors->FailedRequests, 1);
  FF_CHECK_EQUAL(runs.Count, 1);
  FF_CHECK_EQUAL(behind->GetVolume(), 1.0);
}

/// It runs again when something changed that matters, and only then.
void testModification()
{
  auto corners = cubeCorners();
  const auto input = makePoints(corners);
  vtkNew<vtkFFHullFilter> hull;
  const Counter runs(hull, vtkCommand::EndEvent);
  hull->SetInputData(input);
  hull->Update();
  hull->Update();
  FF_CHECK_EQUAL(runs.Count, 1);

  int expected = 1;
  const auto runsAgain = [&]()
  {
    hull->Update();
    hull->Update();
    return runs.Count == ++expected;
  };
  const auto runsNot = [&]()
  {
    hull->Update();
    return runs.Count == expected;
  };
  hull->SetFacetModeToTriangles();
  hull->SetEngineToAutomatic();
  hull->SetNonFinitePointsToError();
  hull->PassPointDataOn();
  hull->SetNumberOfThreads(0);
  hull->VBiasedOn();
  hull->VisiblePointIdsOff();
  hull->SetCompositeModeToEachBlock();
  FF_CHECK(runsNot());
  hull->SetFacetModeToPolygons();
  FF_CHECK(runsAgain());
  hull->SetEngineToCPU();
  FF_CHECK(runsAgain());
  hull->SetNonFinitePointsToIgnore();
  FF_CHECK(runsAgain());
  hull->PassPointDataOff();
  FF_CHECK(runsAgain());
  hull->SetNumberOfThreads(2);
  FF_CHECK(runsAgain());
  hull->VBiasedOff();
  FF_CHECK(runsAgain());
  hull->VisiblePointIdsOn();
  FF_CHECK(runsAgain());
  hull->SetCompositeModeToAllBlocks();
  FF_CHECK(runsAgain());

  FF_CHECK_EQUAL(hull->GetVolume(), 1.0);
  input->GetPoints()->SetPoint(7, 1.0, 1.0, 2.0);
  input->GetPoints()->Modified();
  input->Modified();
  FF_CHECK(runsAgain());
  FF_CHECK(hull->GetVolume() > 1.0);
  FF_CHECK(isHullOf(input, hull->GetOutput(), 3));

  // The output's own: what the filter gives must not change with the input afterwards.
  double before[3];
  hull->GetOutput()->GetPoint(0, before);
  input->GetPoints()->SetPoint(0, -5.0, -5.0, -5.0);
  double after[3];
  hull->GetOutput()->GetPoint(0, after);
  FF_CHECK(before[0] == after[0] && before[1] == after[1] && before[2] == after[2]);
}

/// Values out of range end at the range's ends.
void testClamps()
{
  vtkNew<vtkFFHullFilter> hull;
  hull->SetEngine(99);
  FF_CHECK_EQUAL(hull->GetEngine(), int(vtkFFAlgorithm::ENGINE_CUDA));
  hull->SetEngine(-99);
  FF_CHECK_EQUAL(hull->GetEngine(), int(vtkFFAlgorithm::ENGINE_AUTOMATIC));
  hull->SetNumberOfThreads(-3);
  FF_CHECK_EQUAL(hull->GetNumberOfThreads(), 0);
  hull->SetFacetMode(7);
  FF_CHECK_EQUAL(hull->GetFacetMode(), int(vtkFFAlgorithm::FACETS_AS_POLYGONS));
  hull->SetNonFinitePoints(7);
  FF_CHECK_EQUAL(hull->GetNonFinitePoints(), int(vtkFFAlgorithm::NON_FINITE_IGNORE));
}

/// More threads than there are points, or than the machine has, do no harm.
void testManyThreads()
{
  const auto input = makePoints(cubeCorners());
  vtkNew<vtkFFHullFilter> hull;
  hull->SetNumberOfThreads(64);
  hull->SetInputData(input);
  hull->Update();
  FF_CHECK(isHullOf(input, hull->GetOutput(), 3));
}

/// From a source, through both filters.
void testPipeline()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(16);
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkFFConvexifyFilter> again;
  again->SetInputConnection(hull->GetOutputPort());
  again->Update();
  FF_CHECK(hull->GetOutput()->GetNumberOfPoints() > 100);
  FF_CHECK_EQUAL(again->GetOutput()->GetNumberOfPoints(), hull->GetOutput()->GetNumberOfPoints());
  FF_CHECK_EQUAL(again->GetOutput()->GetNumberOfPolys(), hull->GetOutput()->GetNumberOfPolys());
  sphere->SetThetaResolution(32);
  const vtkIdType before = hull->GetOutput()->GetNumberOfPoints();
  again->Update();
  FF_CHECK(hull->GetOutput()->GetNumberOfPoints() > before);
}

void testPrint()
{
  const auto has = [](vtkObject* object, const std::vector<std::string>& names)
  {
    std::ostringstream text;
    object->Print(text);
    for (const std::string& name : names)
    {
      if (text.str().find("\n  " + name + ": ") == std::string::npos)
      {
        std::cerr << "PrintSelf leaves out " << name << "\n";
        ++failures();
      }
    }
  };
  const std::vector<std::string> common{ "Engine", "CUDAThreshold", "NumberOfThreads", "FacetMode",
    "NonFinitePoints", "PassPointData", "VisiblePointIds", "VBiased", "EngineUsed", "EngineReason",
    "Dimension", "Volume", "Area", "NumberOfInputPoints", "NumberOfNonFinitePoints",
    "NumberOfCulledPoints", "NumberOfInsertions", "NumberOfPointMoves", "NumberOfFlips22",
    "NumberOfFlips31", "NumberOfFlipsByVolume", "NumberOfFlipsByDegree", "NumberOfLabelledVertices",
    "NumberOfRedundantVertices", "NumberOfEdgeChecks", "NumberOfExactPredicates",
    "NumberOfThreadsUsed", "SecondsToScan", "SecondsToLocate", "SecondsToGrow", "SecondsToFlip",
    "SecondsToFinish", "SecondsTotal" };
  vtkNew<vtkFFHullFilter> hull;
  has(hull, common);
  has(hull, { "CompositeMode", "NumberOfStreamDivisions" });
  vtkNew<vtkFFConvexifyFilter> convexify;
  has(convexify, common);
  has(convexify, { "KernelPoint", "UseKernelPoint" });
}

}

int TestFFHullFilterPipeline(int, char*[])
{
  testProgress();
  testProgressText();
  testAbort();
  testError();
  testModification();
  testClamps();
  testManyThreads();
  testPipeline();
  testPrint();
  return result();
}
