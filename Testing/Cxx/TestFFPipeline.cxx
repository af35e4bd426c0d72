// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The filters as a part of a pipeline: progress, abort, errors, what makes them run again, what
// earlier runs leave (nothing), PrintSelf, subclasses.
#include "FFCases.h"
#include "FFTest.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkFFErrorCode.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <functional>
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

/// It runs again when something changed, and only then.
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

/// What a filter prints, but for addresses, times and the history of its progress.
std::string printed(vtkAlgorithm* filter)
{
  std::stringstream lines;
  filter->Print(lines);
  std::string text;
  for (std::string line; std::getline(lines, line);)
  {
    const auto has = [&](const char* part) { return line.find(part) != std::string::npos; };
    text += has("0x") || has("Time: ") || has("Count: ") || has("Progress") ? "" : line + "\n";
  }
  return text;
}

/// Runs, and adds what is said without the filter's address.
std::string run(vtkAlgorithm* filter, vtkDataObject* input)
{
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  filter->RemoveObserver(errors);
  filter->GetExecutive()->RemoveObserver(errors);
  std::string said;
  for (const std::string& message : errors->Messages)
  {
    said += message.substr(message.find("): "));
  }
  return said + printed(filter) + printedReport(filter);
}

/// Whatever a filter has been through, and wherever the caller has its progress lie, it gives what
/// a new one gives: outputs, messages, error code, report.
void testHistory(const std::function<vtkSmartPointer<vtkAlgorithm>()>& make)
{
  const auto cube = makeVoxels({ { 0, 0, 0 } });
  const auto large = makeVoxels({ { 0, 0, 0 } });
  for (vtkIdType i = 0; i < large->GetNumberOfPoints(); ++i)
  {
    double x[3];
    large->GetPoint(i, x);
    large->GetPoints()->SetPoint(i, 2 * x[0], 2 * x[1], 2 * x[2]);
  }
  const auto bad = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 } });
  bad->GetPoints()->SetPoint(3, NAN, 0, 0);
  for (vtkPolyData* data : { cube.Get(), large.Get(), bad.Get() })
  {
    const auto count = static_cast<std::size_t>(data->GetNumberOfPoints());
    data->GetPointData()->AddArray(
      makeWeighted({}, std::vector<double>(count, 0.25))->GetPointData()->GetArray(0));
  }
  vtkNew<vtkMultiBlockDataSet> none;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, large);
  blocks->SetBlock(2, bad);
  blocks->SetBlock(3, cube);
  vtkNew<vtkMultiBlockDataSet> single;
  single->SetBlock(0, bad);
  vtkDataObject* const inputs[] = { cube, large, bad, none, blocks, single };
  for (vtkDataObject* before : inputs)
  {
    for (vtkDataObject* input : inputs)
    {
      const auto fresh = make();
      const auto used = make();
      run(used, before);
      used->SetProgressShiftScale(0.5, 0.5);
      used->Modified();
      const std::string what = fresh->GetClassName() + run(fresh, input);
      FF_CHECK_EQUAL(used->GetClassName() + run(used, input), what);
      for (int port = 0; port < fresh->GetNumberOfOutputPorts(); ++port)
      {
        FF_CHECK(isIdentical(used->GetOutputDataObject(port), fresh->GetOutputDataObject(port),
          fresh->GetClassName()));
      }
    }
  }
}

void testHistories()
{
  for (const FilterCase& of : filterCases())
  {
    testHistory(of.New);
  }
  const auto second = makePoints(cubeCorners());
  testHistory(
    [&]
    {
      auto filter = vtkSmartPointer<vtkFFSelectEnclosedPoints>::New();
      filter->SetSurfaceData(second);
      return filter;
    });
  testHistory(
    [&]
    {
      auto filter = vtkSmartPointer<vtkFFPointInterpolator2D>::New();
      filter->SetSourceData(second);
      return filter;
    });
}

void testPrint(vtkFFAlgorithm* filter, std::vector<std::string> names)
{
  std::ostringstream text;
  filter->Print(text);
  names.insert(names.end(),
    { "Engine", "CUDAThreshold", "NumberOfThreads", "FacetMode", "NonFinitePoints",
      "SkipGhostPoints", "PassPointData", "ReportAsFieldData", "VBiased" });
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
  testHistories();
  testSubclass();
  return result();
}
