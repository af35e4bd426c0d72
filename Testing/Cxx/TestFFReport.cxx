// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What a run found, as field data of its output: on request, with every documented name, of each
// block alone, beside what the input brought.
#include "FFTest.h"

#include "vtkDoubleArray.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <limits>
#include <type_traits>

using namespace fftest;

namespace
{

/// What there is of a run, and of the input.
std::vector<std::string> namesOf(vtkDataObject* output)
{
  std::vector<std::string> names;
  for (int i = 0; i < output->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    names.emplace_back(output->GetFieldData()->GetArrayName(i));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> expectedNames(const std::vector<std::string>& own)
{
  std::vector<std::string> names{ "FlipFlopDimension", "FlipFlopInputPoints",
    "FlipFlopNonFinitePoints", "FlipFlopEngine", "FlipFlopEngineReason", "FlipFlopThreads",
    "FlipFlopSeconds", "time" };
  names.insert(names.end(), own.begin(), own.end());
  std::sort(names.begin(), names.end());
  return names;
}

/// The one value of an array of the type.
template <class ArrayT>
auto valueOf(vtkDataObject* output, const char* name)
{
  auto* array = ArrayT::SafeDownCast(output->GetFieldData()->GetAbstractArray(name));
  if (!array || array->GetNumberOfValues() != 1)
  {
    std::cerr << name << " is missing, of another type, or not one value\n";
    ++failures();
    return std::decay_t<decltype(array->GetValue(0))>{};
  }
  return array->GetValue(0);
}

/// What all filters tell is what their methods tell.
void checkCommon(vtkFFAlgorithm* filter, vtkDataObject* output)
{
  FF_CHECK_EQUAL(valueOf<vtkIntArray>(output, "FlipFlopDimension"), filter->GetDimension());
  FF_CHECK_EQUAL(
    valueOf<vtkIdTypeArray>(output, "FlipFlopInputPoints"), filter->GetNumberOfInputPoints());
  FF_CHECK_EQUAL(valueOf<vtkIdTypeArray>(output, "FlipFlopNonFinitePoints"),
    filter->GetNumberOfNonFinitePoints());
  FF_CHECK(valueOf<vtkStringArray>(output, "FlipFlopEngine") ==
    std::string(filter->GetEngineUsedAsString()));
  FF_CHECK(valueOf<vtkStringArray>(output, "FlipFlopEngineReason") ==
    std::string(filter->GetEngineReason()));
  FF_CHECK_EQUAL(valueOf<vtkIntArray>(output, "FlipFlopThreads"), filter->GetNumberOfThreadsUsed());
  FF_CHECK_EQUAL(valueOf<vtkDoubleArray>(output, "FlipFlopSeconds"), filter->GetSecondsTotal());
  FF_CHECK_EQUAL(valueOf<vtkDoubleArray>(output, "time"), 4.5);
}

void checkHull(vtkFFHullAlgorithm* filter, vtkDataObject* output)
{
  FF_CHECK((namesOf(output) == expectedNames({ "FlipFlopVolume", "FlipFlopArea" })));
  checkCommon(filter, output);
  FF_CHECK_EQUAL(valueOf<vtkDoubleArray>(output, "FlipFlopVolume"), filter->GetVolume());
  FF_CHECK_EQUAL(valueOf<vtkDoubleArray>(output, "FlipFlopArea"), filter->GetArea());
  FF_CHECK(filter->GetVolume() > 0.0 && filter->GetArea() > 0.0);
}

/// Points, one of them not finite, with field data of their own.
vtkSmartPointer<vtkPolyData> makeInput(int count)
{
  auto points = randomPoints(count, 61);
  points[3][1] = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> weights;
  for (int i = 0; i < count; ++i)
  {
    weights.push_back(0.01 * (i % 5));
  }
  auto input = makeWeighted(points, weights);
  vtkNew<vtkDoubleArray> time;
  time->SetName("time");
  time->InsertNextValue(4.5);
  input->GetFieldData()->AddArray(time);
  return input;
}

/// Off, on, and off again.
template <class Check>
void checkSwitch(vtkFFAlgorithm* filter, Check&& check)
{
  const std::vector<std::string> none{ "time" };
  FF_CHECK(!filter->GetReportAsFieldData());
  filter->Update();
  FF_CHECK(namesOf(filter->GetOutputDataObject(0)) == none);
  filter->ReportAsFieldDataOn();
  filter->Update();
  check(filter->GetOutputDataObject(0));
  for (int port = 1; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    FF_CHECK(namesOf(filter->GetOutputDataObject(port)) == none);
  }
  FF_CHECK(namesOf(filter->GetInputDataObject(0, 0)) == none);
  filter->ReportAsFieldDataOff();
  filter->Update();
  FF_CHECK(namesOf(filter->GetOutputDataObject(0)) == none);
  filter->ReportAsFieldDataOn();
}

void testHull()
{
  vtkNew<vtkFFHullFilter> hull;
  hull->SetNonFinitePointsToIgnore();
  hull->SetInputData(makeInput(500));
  checkSwitch(hull, [&](vtkDataObject* output) { checkHull(hull, output); });
  hull->Update();
  FF_CHECK_EQUAL(valueOf<vtkIdTypeArray>(hull->GetOutput(), "FlipFlopInputPoints"), 500);
  FF_CHECK_EQUAL(valueOf<vtkIdTypeArray>(hull->GetOutput(), "FlipFlopNonFinitePoints"), 1);

  // The report of a hull's hull is its own.
  vtkNew<vtkFFHullFilter> second;
  second->SetInputConnection(hull->GetOutputPort());
  second->ReportAsFieldDataOn();
  second->Update();
  checkHull(second, second->GetOutput());
  FF_CHECK_EQUAL(valueOf<vtkIdTypeArray>(second->GetOutput(), "FlipFlopNonFinitePoints"), 0);
  checkHull(hull, hull->GetOutput());

  // One that does not report passes nothing of the first one's on.
  second->ReportAsFieldDataOff();
  second->Update();
  FF_CHECK(namesOf(second->GetOutput()) == std::vector<std::string>{ "time" });
  vtkNew<vtkFFRegularTriangulationFilter> triangulation;
  triangulation->SetInputConnection(hull->GetOutputPort());
  triangulation->GeneratePowerDiagramOn();
  triangulation->Update();
  for (int port = 0; port < 3; ++port)
  {
    FF_CHECK(
      namesOf(triangulation->GetOutputDataObject(port)) == std::vector<std::string>{ "time" });
  }
  triangulation->ReportAsFieldDataOn();
  triangulation->Update();
  FF_CHECK(namesOf(triangulation->GetOutput()) ==
    expectedNames({ "FlipFlopHiddenPoints", "FlipFlopDroppedCells", "FlipFlopSplitPoints" }));
  checkHull(hull, hull->GetOutput());

  // No result, no report; an empty one is one.
  const auto errors = ErrorObserver::Of(hull);
  hull->SetNonFinitePointsToError();
  hull->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK_EQUAL(hull->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  hull->SetInputData(makePoints(std::vector<Point>{}));
  hull->Update();
  FF_CHECK_EQUAL(valueOf<vtkIntArray>(hull->GetOutput(), "FlipFlopDimension"), -1);
}

void testConvexify()
{
  const auto input = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  input->GetFieldData()->PassData(makeInput(10)->GetFieldData());
  vtkNew<vtkFFConvexifyFilter> convexify;
  convexify->SetInputData(input);
  checkSwitch(convexify, [&](vtkDataObject* output) { checkHull(convexify, output); });
}

void testTriangulation()
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  filter->SetNonFinitePointsToIgnore();
  filter->GeneratePowerDiagramOn();
  useWeights(filter);
  filter->SetInputData(makeInput(500));
  checkSwitch(filter,
    [&](vtkDataObject* output)
    {
      FF_CHECK((namesOf(output) ==
        expectedNames({ "FlipFlopHiddenPoints", "FlipFlopDroppedCells", "FlipFlopSplitPoints" })));
      checkCommon(filter, output);
      FF_CHECK(filter->GetNumberOfHiddenPoints() > 0);
      FF_CHECK_EQUAL(
        valueOf<vtkIdTypeArray>(output, "FlipFlopHiddenPoints"), filter->GetNumberOfHiddenPoints());
    });
}

/// Each block tells of itself, and all blocks as one of all.
void testBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeInput(100));
  blocks->SetBlock(1, makeInput(300));
  vtkNew<vtkFFHullFilter> hull;
  hull->SetNonFinitePointsToIgnore();
  hull->ReportAsFieldDataOn();
  hull->SetInputData(blocks);
  hull->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(hull->GetOutputDataObject(0));
  FF_CHECK_EQUAL(output->GetFieldData()->GetNumberOfArrays(), 0);
  vtkNew<vtkFFHullFilter> alone;
  alone->SetNonFinitePointsToIgnore();
  alone->ReportAsFieldDataOn();
  double volumes = 0.0;
  for (unsigned int k = 0; k < 2; ++k)
  {
    alone->SetInputDataObject(blocks->GetBlock(k));
    alone->Update();
    FF_CHECK(isIdentical(output->GetBlock(k), alone->GetOutput(), "block " + std::to_string(k)));
    FF_CHECK_EQUAL(
      valueOf<vtkIdTypeArray>(output->GetBlock(k), "FlipFlopInputPoints"), k ? 300 : 100);
    volumes += valueOf<vtkDoubleArray>(output->GetBlock(k), "FlipFlopVolume");
  }
  FF_CHECK_EQUAL(volumes, hull->GetVolume());
  FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), 400);

  vtkNew<vtkFFHullFilter> second;
  second->SetInputConnection(hull->GetOutputPort());
  second->Update();
  auto* bare = vtkMultiBlockDataSet::SafeDownCast(second->GetOutputDataObject(0));
  for (unsigned int k = 0; k < 2; ++k)
  {
    FF_CHECK(namesOf(bare->GetBlock(k)) == std::vector<std::string>{ "time" });
  }

  hull->SetCompositeModeToAllBlocks();
  hull->Update();
  FF_CHECK_EQUAL(valueOf<vtkIdTypeArray>(hull->GetOutput(), "FlipFlopInputPoints"), 400);
  FF_CHECK_EQUAL(valueOf<vtkIdTypeArray>(hull->GetOutput(), "FlipFlopNonFinitePoints"), 2);
  FF_CHECK_EQUAL(valueOf<vtkDoubleArray>(hull->GetOutput(), "FlipFlopVolume"), hull->GetVolume());
}

}

int TestFFReport(int, char*[])
{
  testHull();
  testConvexify();
  testTriangulation();
  testBlocks();
  return result();
}
