// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What a run found, as field data of its output: on request, with every documented name, of each
// data set alone, with what the input brought.
#include "FFCases.h"
#include "FFTest.h"

#include "vtkDoubleArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <flipflop/Statistics.h>

#include <algorithm>
#include <cctype>
#include <cmath>

using namespace fftest;

namespace
{

using Names = std::vector<std::string>;

/// The names of the report's arrays, and of the input's, sorted.
Names namesOf(vtkDataObject* output)
{
  Names names;
  for (int i = 0; i < output->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    names.emplace_back(output->GetFieldData()->GetArrayName(i));
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Those of each filter, its own, and the input's.
Names expectedNames(const Names& own)
{
  Names names{ "FlipFlopDimension", "FlipFlopEngine", "FlipFlopEngineReason", "FlipFlopThreads",
    "time" };
  flipflop::Statistics::eachField(
    [&](std::string name, auto)
    {
      name[0] = static_cast<char>(std::toupper(name[0]));
      names.push_back("FlipFlop" + name);
    });
  names.insert(names.end(), own.begin(), own.end());
  std::sort(names.begin(), names.end());
  return names;
}

std::string textOf(vtkDataObject* output, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() == 1 ? std::string(array->GetValue(0)) : "missing";
}

/// What all filters report is what their methods return.
void check(vtkFFAlgorithm* filter, const Names& own)
{
  vtkDataObject* const output = filter->GetOutputDataObject(0);
  FF_CHECK(namesOf(output) == expectedNames(own));
  FF_CHECK_EQUAL(reported(output, "Dimension"), filter->GetDimension());
  FF_CHECK_EQUAL(reported(output, "Points"), double(filter->GetNumberOfInputPoints()));
  FF_CHECK_EQUAL(reported(output, "NonFinite"), double(filter->GetNumberOfNonFinitePoints()));
  FF_CHECK_EQUAL(textOf(output, "FlipFlopEngine"), filter->GetEngineUsedAsString());
  FF_CHECK_EQUAL(textOf(output, "FlipFlopEngineReason"), filter->GetEngineReason());
  FF_CHECK(reported(output, "Threads") >= 1);
  FF_CHECK(reported(output, "SecondsTotal") > 0.0);
  FF_CHECK_EQUAL(reported(output, "Flips22") + reported(output, "Flips31"),
    reported(output, "FlipsV") + reported(output, "FlipsD"));
  FF_CHECK_EQUAL(output->GetFieldData()->GetArray("time")->GetTuple1(0), 4.5);
  if (auto* hull = vtkFFHullAlgorithm::SafeDownCast(filter))
  {
    FF_CHECK_EQUAL(reported(output, "Volume"), hull->GetVolume());
    FF_CHECK_EQUAL(reported(output, "Area"), hull->GetArea());
    FF_CHECK(hull->GetVolume() > 0.0 && hull->GetArea() > 0.0);
  }
  auto* const planar = vtkFFPlanarAlgorithm::SafeDownCast(filter);
  if (planar && std::count(own.begin(), own.end(), "FlipFlopHiddenPoints") > 0)
  {
    FF_CHECK_EQUAL(reported(output, "HiddenPoints"), double(planar->GetNumberOfHiddenPoints()));
    FF_CHECK(planar->GetNumberOfHiddenPoints() > 0);
  }
}

/// Points, one of them not finite and two at one position, with field data of their own.
vtkSmartPointer<vtkPolyData> makeInput(int count)
{
  auto input = randomWeighted(count, 61);
  input->GetPoints()->SetPoint(3, 0.0, NAN, 0.0);
  input->GetPoints()->SetPoint(5, input->GetPoint(4));
  vtkNew<vtkDoubleArray> time;
  time->SetName("time");
  time->InsertNextValue(4.5);
  input->GetFieldData()->AddArray(time);
  return input;
}

/// Off, on, and off again; on port 0 alone.
void testFilter(vtkFFAlgorithm* filter, vtkDataObject* input, const Names& own)
{
  const Names none{ "time" };
  FF_CHECK(!filter->GetReportAsFieldData());
  filter->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  filter->SetInputDataObject(input);
  for (const bool on : { false, true, false })
  {
    filter->SetReportAsFieldData(on);
    FF_CHECK(succeeds(filter));
    for (int port = on; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      FF_CHECK(namesOf(filter->GetOutputDataObject(port)) == none);
    }
    FF_CHECK(namesOf(input) == none);
    if (on)
    {
      check(filter, own);
    }
  }
  // A run reports itself alone.
  filter->SetReportAsFieldData(true);
  FF_CHECK(succeeds(filter));
  const std::string before = printedReport(filter);
  filter->Modified();
  FF_CHECK(succeeds(filter));
  FF_CHECK_EQUAL(printedReport(filter), before);
  FF_CHECK(reported(filter->GetOutputDataObject(0), "EdgeChecks") > 0);

  // The report of a filter upstream is not passed on.
  vtkNew<vtkFFHullFilter> second;
  second->SetInputConnection(filter->GetOutputPort());
  FF_CHECK(succeeds(second));
  FF_CHECK(namesOf(second->GetOutput()) == none);
  second->SetReportAsFieldData(true);
  FF_CHECK(succeeds(second));
  FF_CHECK(namesOf(second->GetOutput()) == expectedNames({ "FlipFlopVolume", "FlipFlopArea" }));
  FF_CHECK_EQUAL(reported(second->GetOutput(), "NonFinite"), 0);
  check(filter, own);
}

/// No result, no report; an empty one is one.
void testNone()
{
  vtkNew<vtkFFHullFilter> hull;
  hull->SetReportAsFieldData(true);
  hull->SetInputData(makeInput(50));
  FF_CHECK(fails(hull, vtkFFErrorCode::NonFiniteError, { "point 3," }));
  FF_CHECK_EQUAL(hull->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  hull->SetInputData(makePoints(std::vector<Point>{}));
  FF_CHECK(succeeds(hull));
  FF_CHECK_EQUAL(reported(hull->GetOutput(), "Dimension"), -1);
}

}

int TestFFReport(int, char*[])
{
  const auto input = makeInput(500);
  const auto ell = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  ell->GetFieldData()->PassData(input->GetFieldData());
  for (const FilterCase& of : filterCases())
  {
    testFilter(of.New(), of.TakesSurface ? ell : input, of.Report);
  }
  testNone();
  return result();
}
