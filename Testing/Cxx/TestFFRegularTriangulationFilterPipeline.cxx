// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The filter as a part of a pipeline: point data on each port, progress, abort, what makes it run
// again, composite input, PrintSelf.
#include "FFTest.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"

#include <algorithm>
#include <sstream>

using namespace fftest;

namespace
{

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

  vtkNew<vtkFFRegularTriangulationFilter> filter;
  useWeights(filter);
  filter->SetInputData(input);
  filter->VisiblePointIdsOn();
  filter->Update();
  FF_CHECK(isTriangulationOf(input, "weights", filter));
  FF_CHECK(filter->GetNumberOfHiddenPoints() > 0);
  std::size_t sum = 0;
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData* output = filter->GetOutput(port);
    const auto ids = originalIds(output);
    sum += ids.size();
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
  FF_CHECK_EQUAL(sum, std::size_t(2000));

  filter->PassPointDataOff();
  filter->VisiblePointIdsOff();
  filter->Update();
  FF_CHECK_EQUAL(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
  FF_CHECK_EQUAL(filter->GetHiddenPointsOutput()->GetPointData()->GetNumberOfArrays(), 1);
}

void testProgress()
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  vtkNew<ProgressObserver> progress;
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  filter->SetInputData(weightedPoints(50000));
  std::ptrdiff_t endsBefore = 0;
  for (int diagram = 0; diagram < 2; ++diagram)
  {
    progress->Values.clear();
    filter->SetGeneratePowerDiagram(diagram);
    filter->Update();
    const auto& values = progress->Values;
    checkProgress(values);
    // The end of the triangulation is not the run's while the diagram is to come.
    const auto ends = std::count(values.begin(), values.end(), 1.0);
    FF_CHECK(diagram == 0 || ends == endsBefore);
    endsBefore = ends;
    filter->Modified();
  }
}

void testAbort()
{
  const auto input = weightedPoints(200000);
  for (const double mark : { 0.01, 0.2, 0.5, 1.0 })
  {
    vtkNew<vtkFFRegularTriangulationFilter> filter;
    const auto errors = ErrorObserver::Of(filter);
    vtkNew<ProgressObserver> progress;
    progress->AbortAt = mark;
    filter->AddObserver(vtkCommand::ProgressEvent, progress);
    filter->SetInputData(input);
    useWeights(filter);
    filter->SetGeneratePowerDiagram(mark != 0.01);
    filter->Update();
    for (int port = 0; port < 3; ++port)
    {
      FF_CHECK(isEmpty(filter->GetOutput(port)));
    }
    FF_CHECK(errors->Messages.empty());
    FF_CHECK_EQUAL(filter->GetDimension(), -1);
    FF_CHECK(progress->StoppedOnTheWay() || mark == 1.0);

    // Without the wish to stop it runs to its end.
    progress->AbortAt = 2.0;
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    FF_CHECK(filter->GetOutput()->GetNumberOfPoints() > 1000);
    FF_CHECK(errors->Messages.empty());
  }
}

/// It runs again when something changed that matters, and only then.
void testModification()
{
  const auto input = makeWeighted(randomPoints(100, 42), std::vector<double>(100, 0.0));
  vtkNew<vtkTransform> transform;
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  int runs = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&runs);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  filter->AddObserver(vtkCommand::EndEvent, counter);
  filter->SetInputData(input);
  filter->Update();
  int expected = 1;
  const auto runsAgain = [&]()
  {
    filter->Update();
    filter->Update();
    return runs == ++expected;
  };
  filter->SetProjectionPlaneModeToXYPlane();
  filter->SetTransform(nullptr);
  filter->GeneratePowerDiagramOff();
  filter->SetPowerDiagramBoxModeToPoints();
  filter->StorePowerDiagramBounds(0, 1, 0, 1);
  filter->Update();
  FF_CHECK_EQUAL(runs, expected);

  useWeights(filter);
  FF_CHECK(runsAgain());
  FF_CHECK_EQUAL(filter->GetNumberOfHiddenPoints(), 0);
  input->GetPointData()->GetArray("weights")->SetTuple1(17, -100.0);
  input->GetPointData()->GetArray("weights")->Modified();
  FF_CHECK(runsAgain());
  FF_CHECK_EQUAL(filter->GetNumberOfHiddenPoints(), 1);
  FF_CHECK((originalIds(filter->GetHiddenPointsOutput()) == std::vector<vtkIdType>{ 17 }));
  FF_CHECK(isTriangulationOf(input, "weights", filter));
  filter->SetTransform(transform);
  FF_CHECK(runsAgain());
  transform->RotateX(20.0);
  FF_CHECK(runsAgain());
  filter->SetProjectionPlaneModeToBestFittingPlane();
  FF_CHECK(runsAgain());
  filter->GeneratePowerDiagramOn();
  FF_CHECK(runsAgain());
  filter->SetPowerDiagramBoxModeToBounds();
  FF_CHECK(runsAgain());
  filter->SetPowerDiagramBounds(-1, 1, -1, 1);
  FF_CHECK(runsAgain());
  filter->SetProjectionPlaneModeToTransform();
  FF_CHECK(runsAgain()); // the use of the inverse is no change of the transform
  filter->GenerateCellMeasuresOn();
  FF_CHECK(runsAgain());

  filter->SetProjectionPlaneMode(9);
  FF_CHECK_EQUAL(
    filter->GetProjectionPlaneMode(), int(vtkFFRegularTriangulationFilter::BEST_FITTING_PLANE));
  filter->SetPowerDiagramBoxMode(-9);
  FF_CHECK_EQUAL(
    filter->GetPowerDiagramBoxMode(), int(vtkFFRegularTriangulationFilter::BOX_OF_POINTS));
}

/// The pipeline takes the filter through the blocks, on every port.
void testComposite()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, weightedPoints(300));
  blocks->SetBlock(2, weightedPoints(500));
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  useWeights(filter);
  filter->GeneratePowerDiagramOn();
  filter->SetInputData(blocks);
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  vtkIdType counts[3][2];
  for (int port = 0; port < 3; ++port)
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    for (unsigned int k = 0; k < 2; ++k)
    {
      auto* block = output ? vtkPolyData::SafeDownCast(output->GetBlock(2 * k)) : nullptr;
      FF_CHECK(block != nullptr);
      counts[port][k] = block ? block->GetNumberOfCells() : 0;
    }
  }
  filter->SetInputData(weightedPoints(300));
  filter->Update();
  for (int port = 0; port < 3; ++port)
  {
    FF_CHECK_EQUAL(filter->GetOutput(port)->GetNumberOfCells(), counts[port][0]);
    FF_CHECK(counts[port][1] > counts[port][0]);
  }
}

/// Its output has the ids of its own input, and passes for an input again.
void testChain()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkFFRegularTriangulationFilter> first;
  first->SetInputConnection(hull->GetOutputPort());
  vtkNew<vtkFFRegularTriangulationFilter> second;
  second->SetInputConnection(first->GetOutputPort());
  second->Update();
  FF_CHECK(isTriangulationOf(hull->GetOutput(), nullptr, first));
  FF_CHECK(isTriangulationOf(first->GetOutput(), nullptr, second));
  FF_CHECK_EQUAL(second->GetNumberOfHiddenPoints(), 0);
}

void testPrint()
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  std::ostringstream text;
  filter->Print(text);
  vtkNew<vtkTransform> transform;
  filter->SetTransform(transform);
  filter->Print(text);
  for (const char* name : { "Engine", "CUDAThreshold", "FacetMode", "Dimension",
         "NumberOfInputPoints", "ProjectionPlaneMode", "Transform", "WeightMode", "WeightFactor",
         "Alpha", "AlphaLines", "AlphaVerts", "GenerateAlphas", "GenerateBoundary",
         "MaximumEdgeLength", "SplitCrossingConstraints", "PolygonRule", "NumberOfSplitPoints",
         "NumberOfDroppedCells", "GeneratePowerDiagram", "GenerateCellMeasures",
         "PowerDiagramBoxMode", "PowerDiagramBounds", "NumberOfHiddenPoints" })
  {
    if (text.str().find("\n  " + std::string(name) + ": ") == std::string::npos)
    {
      std::cerr << "PrintSelf leaves out " << name << "\n";
      ++failures();
    }
  }
  FF_CHECK(text.str().find("\n  Volume: ") == std::string::npos);
  FF_CHECK(text.str().find("vtkTransform") != std::string::npos ||
    text.str().find("Matrix") != std::string::npos);
}

}

int TestFFRegularTriangulationFilterPipeline(int, char*[])
{
  testPointData();
  testProgress();
  testAbort();
  testModification();
  testComposite();
  testChain();
  testPrint();
  return result();
}
