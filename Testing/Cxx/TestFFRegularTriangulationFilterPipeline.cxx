// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The planar filters as a part of a pipeline: point data on each port, progress, abort, what makes
// them run again, composite input, PrintSelf.
#include "FFPlanar.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"

#include <algorithm>
#include <sstream>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

vtkSmartPointer<vtkPolyData> weightedPoints(int count, int type = VTK_DOUBLE)
{
  const auto points = randomPoints(count, 41);
  std::vector<double> weights;
  for (const Point& p : points)
  {
    weights.push_back(p[2] / count);
  }
  auto input = makeWeighted(points, weights);
  input->SetPoints(makePoints(points, type)->GetPoints());
  return input;
}

/// Floats stay floats; each port has the data of its points.
void testPointData()
{
  const auto input = weightedPoints(2000, VTK_FLOAT);
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 2000; ++i)
  {
    names->InsertNextValue("point " + std::to_string(i));
    vectors->InsertNextTuple3(double(i), 0.1, 0.2);
  }
  input->GetPointData()->AddArray(names);
  input->GetPointData()->SetVectors(vectors);
  vtkNew<vtkDoubleArray> field;
  field->SetName("time");
  field->InsertNextValue(4.5);
  input->GetFieldData()->AddArray(field);

  Watched<Filter> run(input, "weights");
  run->VisiblePointIdsOn();
  run->GenerateBoundaryOn();
  run.Run();
  FF_CHECK(isTriangulationOf(input, "weights", run.Get()));
  FF_CHECK(run->GetNumberOfHiddenPoints() > 0);
  vtkIdType sum = 0;
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* output = run->GetOutput(port);
    const auto ids = originalIds(output);
    sum += port < 2 ? output->GetNumberOfPoints() : 0;
    FF_CHECK(!ids.empty());
    FF_CHECK_EQUAL(output->GetPoints()->GetDataType(), VTK_FLOAT);
    FF_CHECK(output->GetFieldData()->HasArray("time"));
    FF_CHECK_EQUAL(output->GetPointData()->GetNumberOfArrays(), 5);
    auto* passed = vtkStringArray::SafeDownCast(output->GetPointData()->GetAbstractArray("names"));
    auto* velocity = vtkFloatArray::SafeDownCast(output->GetPointData()->GetVectors());
    auto* weights = vtkDoubleArray::SafeDownCast(output->GetPointData()->GetArray("weights"));
    auto* visible =
      vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("OriginalPointIds"));
    auto* given = input->GetPointData()->GetArray("weights");
    if (!passed || !velocity || !weights || !visible)
    {
      FF_CHECK(!"an array is missing, or of another type");
      continue;
    }
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      const auto i = static_cast<vtkIdType>(k);
      FF_CHECK(passed->GetValue(i) == "point " + std::to_string(ids[k]));
      FF_CHECK(velocity->GetTypedComponent(i, 0) == static_cast<float>(ids[k]));
      FF_CHECK(weights->GetValue(i) == given->GetTuple1(ids[k]));
      FF_CHECK_EQUAL(visible->GetValue(i), ids[k]);
    }
  }
  FF_CHECK_EQUAL(sum, 2000);

  run->PassPointDataOff();
  run->VisiblePointIdsOff();
  run.Run();
  for (int port = 0; port < 3; ++port)
  {
    FF_CHECK_EQUAL(run->GetOutput(port)->GetPointData()->GetNumberOfArrays(), 1);
  }
}

/// Progress goes from 0 to 1; a wish to stop is heard on the way, and the next run is whole.
template <class FilterT>
void testProgressAndAbort(const char* weights)
{
  for (const double mark : { 2.0, 0.01, 0.2, 0.5, 1.0 })
  {
    Watched<FilterT> run(weightedPoints(mark > 1.0 ? 50000 : 200000), weights);
    vtkNew<ProgressObserver> progress;
    progress->AbortAt = mark;
    run->AddObserver(vtkCommand::ProgressEvent, progress);
    run.Run();
    if (mark > 1.0)
    {
      checkProgress(progress->Values);
      continue;
    }
    FF_CHECK(hasForgotten(run.Get()));
    FF_CHECK(progress->StoppedOnTheWay() || mark == 1.0);
    progress->AbortAt = 2.0;
    run->SetAbortExecute(0);
    run->Modified();
    FF_CHECK(run.Run()->GetNumberOfCells() > 1000);
  }
}

/// It runs again when something changed that matters, and only then.
void testModification()
{
  const auto input = makeWeighted(randomPoints(100, 42), std::vector<double>(100, 0.0));
  vtkDataArray* weights = input->GetPointData()->GetArray("weights");
  vtkNew<vtkTransform> transform;
  Watched<Filter> run(input);
  Watched<vtkFFPowerDiagramFilter> diagram(input);
  int runs = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&runs);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  const auto runsAgain = [&](auto& watched)
  {
    const int before = runs;
    watched.Run();
    watched.Run();
    return runs == before + 1;
  };
  run->AddObserver(vtkCommand::EndEvent, counter);
  diagram->AddObserver(vtkCommand::EndEvent, counter);
  FF_CHECK(runsAgain(run));
  FF_CHECK(runsAgain(diagram));
  run->SetProjectionPlaneModeToXYPlane();
  run->SetTransform(nullptr);
  run->SetAlpha(0.0);
  FF_CHECK(!runsAgain(run));
  diagram->SetPowerDiagramBoxModeToPoints();
  diagram->StorePowerDiagramBounds(0, 1, 0, 1);
  FF_CHECK(!runsAgain(diagram));

  useWeights(run.Get());
  FF_CHECK(runsAgain(run));
  FF_CHECK_EQUAL(run->GetNumberOfHiddenPoints(), 0);
  weights->SetTuple1(17, -100.0);
  weights->Modified();
  FF_CHECK(runsAgain(run));
  FF_CHECK((originalIds(run->GetHiddenPointsOutput()) == Ids{ 17 }));
  FF_CHECK(isTriangulationOf(input, "weights", run.Get()));
  run->SetTransform(transform);
  FF_CHECK(runsAgain(run));
  transform->RotateX(20.0);
  FF_CHECK(runsAgain(run));
  run->GenerateCellMeasuresOn();
  FF_CHECK(runsAgain(run)); // the use of the inverse is no change of the transform

  diagram->SetPowerDiagramBoxModeToBounds();
  FF_CHECK(runsAgain(diagram));
  diagram->SetPowerDiagramBounds(-1, 1, -1, 1);
  FF_CHECK(runsAgain(diagram));
  diagram->SetTransform(transform);
  FF_CHECK(runsAgain(diagram));

  run->SetProjectionPlaneMode(9);
  FF_CHECK_EQUAL(run->GetProjectionPlaneMode(), int(Filter::BEST_FITTING_PLANE));
  diagram->SetPowerDiagramBoxMode(-9);
  FF_CHECK_EQUAL(diagram->GetPowerDiagramBoxMode(), int(vtkFFPowerDiagramFilter::BOX_OF_POINTS));
}

/// The executive takes the filter through the data sets: each port has what a run of each gives.
/// One at fault leaves the others alone.
template <class FilterT>
void testComposite()
{
  const auto bad = makeWeighted({ { 0, 0, 0 }, { 1, 0, 0 }, { notANumber, 1, 0 } }, { 0, 0, 0 });
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, weightedPoints(300));
  blocks->SetBlock(2, bad);
  blocks->SetBlock(3, weightedPoints(500));
  const bool weighted = !std::is_same<FilterT, vtkFFConstrainedDelaunayFilter>::value;
  Watched<FilterT> run(blocks, weighted ? "weights" : nullptr);
  run->GenerateCellMeasuresOn();
  run->Update();
  FF_CHECK_EQUAL(run.Errors->Messages.size(), std::size_t(1));
  FF_CHECK(run.Errors->Has("point 2 of data set 1 of the composite"));
  FF_CHECK_EQUAL(run->GetErrorCode(), vtkFFErrorCode::NonFiniteError);
  FF_CHECK_EQUAL(run->GetNumberOfInputPoints(), 800);
  for (const unsigned int block : { 0U, 2U, 3U })
  {
    Watched<FilterT> alone(blocks->GetBlock(block), weighted ? "weights" : nullptr);
    alone->GenerateCellMeasuresOn();
    alone->Update();
    FF_CHECK((alone->GetOutput()->GetNumberOfCells() > 200) == (block != 2));
    for (int port = 0; port < run->GetNumberOfOutputPorts(); ++port)
    {
      auto* output = vtkMultiBlockDataSet::SafeDownCast(run->GetOutputDataObject(port));
      FF_CHECK(output && isIdentical(output->GetBlock(block), alone->GetOutput(port), "block"));
    }
  }
}

/// Its output has the ids of its own input, and passes for an input again.
void testChain()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputConnection(sphere->GetOutputPort());
  vtkNew<Filter> first;
  first->SetInputConnection(hull->GetOutputPort());
  vtkNew<Filter> second;
  second->SetInputConnection(first->GetOutputPort());
  second->Update();
  FF_CHECK(isTriangulationOf(hull->GetOutput(), nullptr, first));
  FF_CHECK(isTriangulationOf(first->GetOutput(), nullptr, second));
  FF_CHECK_EQUAL(second->GetNumberOfHiddenPoints(), 0);
}

/// PrintSelf has each property.
template <class FilterT>
void testPrint(const std::vector<std::string>& own)
{
  std::vector<std::string> names{ "Engine", "CUDAThreshold", "FacetMode", "Dimension",
    "NumberOfInputPoints", "ProjectionPlaneMode", "Transform", "WeightMode", "WeightFactor",
    "GenerateCellMeasures" };
  names.insert(names.end(), own.begin(), own.end());
  vtkNew<FilterT> filter;
  vtkNew<vtkTransform> transform;
  std::ostringstream text;
  filter->Print(text);
  filter->SetTransform(transform);
  filter->Print(text);
  for (const std::string& name : names)
  {
    const bool has = text.str().find("\n  " + name + ": ") != std::string::npos;
    FF_CHECK_EQUAL(has ? name : "missing", name);
  }
  FF_CHECK(text.str().find("\n  Volume: ") == std::string::npos);
  FF_CHECK(text.str().find("Matrix") != std::string::npos);
}

}

int TestFFRegularTriangulationFilterPipeline(int, char*[])
{
  testPointData();
  testProgressAndAbort<Filter>("weights");
  testProgressAndAbort<vtkFFPowerDiagramFilter>("weights");
  testProgressAndAbort<vtkFFConstrainedDelaunayFilter>(nullptr);
  testModification();
  testComposite<Filter>();
  testComposite<vtkFFPowerDiagramFilter>();
  testComposite<vtkFFConstrainedDelaunayFilter>();
  testChain();
  testPrint<Filter>({ "Alpha", "AlphaLines", "AlphaVerts", "GenerateAlphas", "GenerateBoundary",
    "MaximumEdgeLength", "NumberOfHiddenPoints", "NumberOfDroppedCells" });
  testPrint<vtkFFPowerDiagramFilter>(
    { "PowerDiagramBoxMode", "PowerDiagramBounds", "NumberOfHiddenPoints" });
  testPrint<vtkFFConstrainedDelaunayFilter>(
    { "SplitCrossingConstraints", "PolygonRule", "NumberOfSplitPoints", "NumberOfDroppedCells" });
  return result();
}
