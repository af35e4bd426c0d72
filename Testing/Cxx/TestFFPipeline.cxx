// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The filters as a part of a pipeline: progress, abort, errors, what makes them run again,
// PrintSelf, subclasses.
#include "FFCases.h"
#include "FFTest.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkFFErrorCode.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
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

/// The progress goes from 0 to 1, and its texts are of these steps, in this order. An abort on the
/// way leaves nothing, and is no error.
void testProgress(vtkFFAlgorithm* filter, vtkDataObject* input, const std::string& title,
  const std::vector<std::string>& steps)
{
  vtkNew<ProgressObserver> progress;
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  filter->SetInputDataObject(input);
  for (int again = 0; again < 2; ++again)
  {
    progress->Values.clear();
    progress->Texts.clear();
    input->Modified();
    FF_CHECK(succeeds(filter));
    checkProgress(progress->Values);
    FF_CHECK(progress->Texts[0].compare(0, title.size(), title) == 0);
    auto text = progress->Texts.begin();
    for (const std::string& step : steps)
    {
      text = std::find(text, progress->Texts.end(), step);
      FF_CHECK_EQUAL(text == progress->Texts.end() ? "no step" : *text, step);
    }
  }
  for (const double mark : { 0.01, 0.5 })
  {
    progress->AbortAt = mark;
    input->Modified();
    FF_CHECK(succeeds(filter));
    FF_CHECK(hasForgotten(filter));
    FF_CHECK(progress->StoppedOnTheWay());
    progress->AbortAt = 2.0;
    filter->SetAbortExecute(0);
    input->Modified();
    FF_CHECK(succeeds(filter));
    FF_CHECK_EQUAL(
      filter->GetNumberOfInputPoints(), input->GetNumberOfElements(vtkDataObject::POINT));
  }
}

/// After an error, the executive adds none, and what is behind runs with nothing. The next run has
/// no error.
void testError()
{
  auto points = cubeCorners();
  points.push_back({ 0, 0, NAN });
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(makePoints(points));
  vtkNew<vtkFFConvexifyFilter> behind;
  behind->SetInputConnection(hull->GetOutputPort());
  const auto errorsBehind = ErrorObserver::Of(behind);
  const auto errors = ErrorObserver::Of(hull);
  FF_CHECK_EQUAL(behind->GetExecutive()->Update(), 1);
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK_EQUAL(hull->GetErrorCode(), static_cast<unsigned long>(vtkFFErrorCode::NonFiniteError));
  FF_CHECK(errorsBehind->Messages.empty());
  FF_CHECK(isEmpty(behind->GetOutput()));
  hull->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  FF_CHECK_EQUAL(behind->GetExecutive()->Update(), 1);
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK_EQUAL(hull->GetErrorCode(), static_cast<unsigned long>(vtkFFErrorCode::NoError));
  FF_CHECK_EQUAL(behind->GetVolume(), 1.0);
}

/// It runs again when something changed, and only then. (What is computed again, see TestFFKept.)
void testModification()
{
  const auto input = makePoints(cubeCorners());
  vtkNew<vtkFFHullFilter> hull;
  const Counter runs(hull, vtkCommand::EndEvent);
  hull->SetInputData(input);
  hull->Update();
  hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_TRIANGLES);
  hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_EACH_BLOCK);
  hull->SetNumberOfStreamDivisions(1);
  hull->Update();
  FF_CHECK_EQUAL(runs.Count, 1);
  // The output is its own: it must not change with the input afterwards.
  input->GetPoints()->SetPoint(0, -5.0, -5.0, -5.0);
  FF_CHECK_EQUAL(hull->GetOutput()->GetPoint(0)[0], 0.0);
  input->Modified();
  hull->Update();
  FF_CHECK_EQUAL(runs.Count, 2);
  FF_CHECK(isHullOf(input, hull->GetOutput(), 3));
  // Values out of range end at the range's ends.
  hull->SetFacetMode(7);
  FF_CHECK_EQUAL(hull->GetFacetMode(), int(vtkFFAlgorithm::FACETS_AS_POLYGONS));
  hull->SetNonFinitePoints(7);
  FF_CHECK_EQUAL(hull->GetNonFinitePoints(), int(vtkFFAlgorithm::NON_FINITE_IGNORE));
}

void testPrint(vtkFFAlgorithm* filter, std::vector<std::string> names)
{
  std::ostringstream text;
  filter->Print(text);
  names.insert(names.end(),
    { "Engine", "CUDAThreshold", "NumberOfThreads", "FacetMode", "NonFinitePoints",
      "SkipGhostPoints", "PassPointData", "ReportAsFieldData", "VBiased", "EngineUsed",
      "EngineReason", "Dimension", "NumberOfInputPoints", "NumberOfNonFinitePoints" });
  for (const std::string& name : names)
  {
    const bool has = text.str().find("\n  " + name + ": ") != std::string::npos;
    FF_CHECK_EQUAL(has ? name : "", name);
  }
}

/// Whoever has the headers can write a filter with these settings.
class My : public vtkFFAlgorithm
{
public:
  static My* New();
  vtkTypeMacro(My, vtkFFAlgorithm);

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkPolyData::GetData(outputs)->ShallowCopy(vtkPolyData::GetData(inputs[0]));
    return 1;
  }
};
vtkStandardNewMacro(My);

void testSubclass()
{
  vtkNew<My> my;
  testPrint(my, {});
  my->SetInputData(makePoints(cubeCorners()));
  FF_CHECK(succeeds(my));
  FF_CHECK_EQUAL(my->GetOutput()->GetNumberOfPoints(), 8);
  FF_CHECK_EQUAL(my->GetEngineUsed(), int(vtkFFAlgorithm::ENGINE_NONE));
}

}

int TestFFPipeline(int, char*[])
{
  const auto points = makeWeighted(spherePoints(100000, 41), std::vector<double>(100000, 0.0));
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(points);
  hull->Update();
  for (const FilterCase& of : filterCases())
  {
    const auto filter = of.New();
    testPrint(filter, of.Settings);
    testProgress(filter, of.TakesSurface ? hull->GetOutput() : points.Get(), of.Title, of.Steps);
  }
  testError();
  testModification();
  testSubclass();
  return result();
}
