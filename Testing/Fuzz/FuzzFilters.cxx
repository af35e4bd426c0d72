// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The filters with any data, any settings and an abort at any time, by one thread or two at once:
/// a failure is an error that is reported, with empty outputs; a success is what the engine's
/// validate takes for right; a block's result is the one that it has alone; and whatever a filter
/// has been through, its outputs, report, error code and messages are those of a new one.
#include "Bytes.h"
#include "FilterInputs.h"
#include "FilterRun.h"
#include "FilterSettings.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSetAttributes.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFPointsToImage.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkFFTerrainMeshFilter.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLogger.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPFFHullFilter.h"
#include "vtkPFFPowerDiagramFilter.h"
#include "vtkPFFRegularTriangulationFilter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>
#include <thread>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace flipflop::fuzz;

constexpr int MostPoints = 2600;

/// What nobody observes is not printed: errors are what the fuzzer asks for.
class SilentWindow : public vtkOutputWindow
{
public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
};
vtkStandardNewMacro(SilentWindow);

bool silence()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<SilentWindow> window;
  vtkOutputWindow::SetInstance(window);
  return true;
}

template <class Filter>
vtkSmartPointer<vtkAlgorithm> ofOneProcess()
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetController(nullptr);
  return filter;
}

/// By default an image has more: where sites are far out, each may take a millisecond.
vtkSmartPointer<vtkAlgorithm> withFewPixels()
{
  auto filter = vtkSmartPointer<vtkFFPointsToImage>::New();
  filter->SetDimensions(32, 32);
  return filter;
}

constexpr int Kinds = 11;

vtkSmartPointer<vtkAlgorithm> makeFilter(int kind)
{
  switch (kind)
  {
    case 1:
      return vtkSmartPointer<vtkFFRegularTriangulationFilter>::New();
    case 2:
      return vtkSmartPointer<vtkFFConvexifyFilter>::New();
    case 3:
      return ofOneProcess<vtkPFFHullFilter>();
    case 4:
      return ofOneProcess<vtkPFFRegularTriangulationFilter>();
    case 5:
      return ofOneProcess<vtkPFFRegularTriangulationFilter>();
    case 6:
      return ofOneProcess<vtkPFFPowerDiagramFilter>();
    case 7:
      return vtkSmartPointer<vtkFFSelectEnclosedPoints>::New();
    case 8:
      return vtkSmartPointer<vtkFFPointInterpolator2D>::New();
    case 9:
      return withFewPixels();
    case 10:
      return vtkSmartPointer<vtkFFTerrainMeshFilter>::New();
    default:
      return vtkSmartPointer<vtkFFHullFilter>::New();
  }
}

/// Whether all numbers of the points are finite.
bool isFinite(vtkPointSet* data)
{
  vtkDataArray* array = data->GetPoints()->GetData();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (!vtkMath::IsFinite(array->GetComponent(i, k)))
      {
        return false;
      }
    }
  }
  return true;
}

/// The points as the filter is to see them: where it skips ghosts, they are NaN in a copy. Null:
/// their type has no NaN, or there are not as many marks as points.
vtkSmartPointer<vtkPointSet> withoutGhosts(vtkFFAlgorithm* filter, vtkPointSet* data)
{
  vtkUnsignedCharArray* marks = data->GetPointGhostArray();
  if (!marks || !data->GetPoints() || !filter->GetSkipGhostPoints())
  {
    return data;
  }
  vtkDataArray* array = data->GetPoints()->GetData();
  const vtkIdType count = data->GetNumberOfPoints();
  if (marks->GetNumberOfValues() != count ||
    (array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE))
  {
    return nullptr;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(array->GetDataType());
  points->DeepCopy(data->GetPoints());
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (marks->GetValue(i) &
      (vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT))
    {
      const double nan = vtkMath::Nan();
      points->SetPoint(i, nan, nan, nan);
    }
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(points);
  return copy;
}

/// Points that every hull filter has an answer for.
bool mustHaveHull(vtkFFHullFilter* filter, vtkPointSet* data)
{
  if (data->GetPointData()->HasArray(vtkDataSetAttributes::GhostArrayName()) ||
    filter->GetEngine() == vtkFFAlgorithm::ENGINE_CUDA || !data->GetPoints())
  {
    return false;
  }
  const int type = data->GetPoints()->GetDataType();
  const bool plain = type == VTK_DOUBLE || type == VTK_FLOAT || type == VTK_INT ||
    type == VTK_SHORT || type == VTK_UNSIGNED_CHAR;
  return plain &&
    (filter->GetNonFinitePoints() == vtkFFAlgorithm::NON_FINITE_IGNORE || isFinite(data));
}

void demandFull(vtkDataSet* output, const std::string& name)
{
  vtkAbstractArray* array = output->GetPointData()->GetAbstractArray(name.c_str());
  demand(array && array->GetNumberOfTuples() == output->GetNumberOfPoints(),
    "not a value for each point: " + name);
}

/// The pixels are what another filter gives at these points.
void demandPixels(vtkFFPointsToImage* filter, vtkPointSet* data)
{
  vtkImageData* const output = filter->GetOutput();
  demand(output != nullptr, "the output is no vtkImageData");
  if (output->GetNumberOfPoints() == 0)
  {
    demand(filter->GetDimension() < 0, "no pixel of points");
    return;
  }
  if (filter->GetNullPointsStrategy() == vtkFFPointsToImage::MASK_POINTS)
  {
    demandFull(output, filter->GetValidPointsMaskArrayName());
  }
  if (filter->GetSource() || !filter->GetPassPointData() ||
    filter->GetProjectionPlaneMode() != vtkFFPointsToImage::XY_PLANE ||
    filter->GetInformation()->Has(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS()))
  {
    return;
  }
  vtkNew<vtkImageData> expected;
  expected->CopyStructure(output);
  vtkNew<vtkFFPointInterpolator2D> points;
  points->SetInputData(expected);
  points->SetSourceData(data);
  points->SetInterpolationMode(filter->GetInterpolationMode());
  points->SetNullPointsStrategy(filter->GetNullPointsStrategy());
  points->SetNullValue(1.0); // -0 is the default, 0, to the setter
  points->SetNullValue(filter->GetNullValue());
  points->SetValidPointsMaskArrayName(filter->GetValidPointsMaskArrayName());
  points->SetInterpolateZ(filter->GetInterpolateZ());
  points->SetZArrayName(filter->GetZArrayName());
  points->SetSkipGhostPoints(filter->GetSkipGhostPoints());
  points->SetNonFinitePoints(vtkFFQueryAlgorithm::NON_FINITE_IGNORE); // z counts only for images
  points->Update();
  expected->GetPointData()->ShallowCopy(output->GetPointData());
  demand(filter->GetNumberOfNonFinitePoints() > 0 ||
      fftest::isIdentical(points->GetOutput(), expected, "pixels"),
    "a pixel is not what its point has");
}

/// What a filter that ran without an error gave for one data set.
void demandResult(vtkFFAlgorithm* filter, vtkPointSet* data)
{
  const auto input = withoutGhosts(filter, data);
  if (!input)
  {
    return;
  }
  if (auto* image = vtkFFPointsToImage::SafeDownCast(filter))
  {
    demandPixels(image, data);
    return;
  }
  vtkPolyData* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  demand(output != nullptr, "the output is no vtkPolyData");
  if (filter->GetDimension() < 0)
  {
    demand(isNothing(output), "something of dimension -1");
    return;
  }
  if (vtkFFHullFilter::SafeDownCast(filter))
  {
    demand(fftest::isHullOf(input, output, filter->GetDimension()), "not the hull");
  }
  auto* triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(filter);
  if (triangulation && !triangulation->GetSource() &&
    triangulation->GetNumberOfDroppedCells() == 0 &&
    triangulation->GetProjectionPlaneMode() == vtkFFRegularTriangulationFilter::XY_PLANE &&
    !triangulation->GetInformation()->Has(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS()))
  {
    demand(fftest::isTriangulationOf(input, nullptr, triangulation, filter->GetDimension()),
      "not the triangulation");
  }
  demand(fftest::failures() == 0, "the output lacks its ids");
}

/// The sides of a run are those of single points.
void demandSides(vtkFFSelectEnclosedPoints* filter, vtkDataSet* output)
{
  constexpr vtkIdType Some = 60;
  demandFull(output, "SelectedPoints");
  demandFull(output, "FlipFlopSide");
  vtkDataArray* sides = output->GetPointData()->GetArray("FlipFlopSide");
  for (vtkIdType i = 0; i < std::min(Some, output->GetNumberOfPoints()); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    if (vtkMath::IsFinite(x[0]) && vtkMath::IsFinite(x[1]) && vtkMath::IsFinite(x[2]))
    {
      const double side = sides->GetComponent(i, 0);
      const bool enclosed = side > 0 || (side == 0 && filter->GetSelectPointsOnSurface());
      demand(filter->IsInsideSurface(x) == int(enclosed), "a point alone has another side");
      demand(filter->IsInside(i) == int(enclosed != filter->GetInsideOut()), "another selection");
    }
  }
}

/// What was said, without the filter's address.
std::vector<std::string> wordsOf(const fftest::ErrorObserver* errors)
{
  std::vector<std::string> words;
  for (const std::string& message : errors->Messages)
  {
    words.push_back(message.substr(std::min(message.find("): "), message.size())));
  }
  return words;
}

/// A filter in use: settings, data and runs.
class Session
{
public:
  explicit Session(Bytes& bytes)
    : Kind(bytes.below(Kinds))
    , Filter(makeFilter(this->Kind))
    , Errors(fftest::ErrorObserver::Of(this->Filter))
  {
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this->Abort);
  }

  /// One run after some changes.
  /// @param given data to run with; null: some is drawn
  void run(Bytes& bytes, vtkDataObject* given)
  {
    this->Runs.emplace_back(bytes);
    drawSettings(bytes, this->Filter);
    this->Abort->draw(bytes);
    for (int port = 0; port < this->inputCount(); ++port)
    {
      if (!this->Input[port] || bytes.flag())
      {
        this->Input[port] = given && bytes.flag() ? given : drawDataObject(bytes, MostPoints).Get();
      }
      this->Filter->SetInputDataObject(port, this->Input[port]);
      this->Runs.back().Input[port] = this->Input[port];
    }
    this->Errors->Clear();
    this->Filter->Modified(); // else a run that failed would not be run again, nor fail again
    this->Filter->Update();
    this->check();
  }

private:
  bool isQuery() const { return this->Kind == 7 || this->Kind == 8; }
  int inputCount() const { return this->isQuery() ? 2 : 1; }

  /// Another filter of the same settings and data, some of which go by the data before.
  vtkSmartPointer<vtkAlgorithm> another() const
  {
    const auto filter = makeFilter(this->Kind);
    for (const RunType& run : this->Runs)
    {
      Bytes settings = run.Settings;
      drawSettings(settings, filter);
      for (int port = 0; port < this->inputCount(); ++port)
      {
        filter->SetInputDataObject(port, run.Input[port]);
      }
    }
    return filter;
  }

  void check()
  {
    const bool failed = demandTold(this->Filter, this->Input[0], this->Errors);
    auto* points = vtkPointSet::SafeDownCast(this->Input[0]);
    auto* hull = vtkFFHullFilter::SafeDownCast(this->Filter);
    demand(!failed || !points || !hull || !mustHaveHull(hull, points),
      "no hull: " + (failed ? this->Errors->Messages.front() : ""));
    // An abort may come too late: after the last word of the run.
    if (isCutShort(this->Abort, this->Filter->GetOutputDataObject(0)))
    {
      return;
    }
    this->checkFresh();
    if (failed && (points || this->isQuery()))
    {
      return;
    }
    if (this->isQuery())
    {
      this->checkQuery();
    }
    else if (!points)
    {
      this->checkBlocks();
    }
    else
    {
      demandResult(vtkFFAlgorithm::SafeDownCast(this->Filter), points);
    }
  }

  /// A new filter does the same.
  void checkFresh()
  {
    const auto fresh = this->another();
    const auto errors = fftest::ErrorObserver::Of(fresh);
    fresh->Update();
    const auto all = [](const std::vector<std::string>& words)
    { return std::accumulate(words.begin(), words.end(), std::string()); };
    demand(wordsOf(errors) == wordsOf(this->Errors),
      all(wordsOf(this->Errors)) + ", and of a new filter: " + all(wordsOf(errors)));
    demand(
      fresh->GetErrorCode() == this->Filter->GetErrorCode(), "another code than a new filter's");
    demand(fftest::printedReport(fresh) == fftest::printedReport(this->Filter),
      "another report than a new filter's");
    for (int port = 0; port < fresh->GetNumberOfOutputPorts(); ++port)
    {
      demand(fftest::isIdentical(this->Filter->GetOutputDataObject(port),
               fresh->GetOutputDataObject(port), "a new filter"),
        "another output than a new filter's");
    }
  }

  /// The same on other threads, and for single points.
  void checkQuery()
  {
    auto* const filter = vtkFFQueryAlgorithm::SafeDownCast(this->Filter);
    const auto made = this->another();
    auto* const again = vtkFFQueryAlgorithm::SafeDownCast(made);
    const auto errors = fftest::ErrorObserver::Of(again);
    again->SetNumberOfThreads(filter->GetNumberOfThreads() == 1 ? 2 : 1);
    again->Update();
    vtkDataObject* const output = filter->GetOutputDataObject(0);
    demand(errors->Messages.size() == this->Errors->Messages.size(),
      "another filter of the same settings fails");
    demand(again->GetDimension() == filter->GetDimension(), "of another dimension");
    demand(fftest::isIdentical(again->GetOutputDataObject(0), output, "on other threads"),
      "the output is not the same on other threads");
    auto* const data = vtkDataSet::SafeDownCast(output);
    auto* const enclosed = vtkFFSelectEnclosedPoints::SafeDownCast(filter);
    if (data && enclosed)
    {
      demandSides(enclosed, data);
    }
    auto* const interpolator = vtkFFPointInterpolator2D::SafeDownCast(filter);
    if (data && interpolator &&
      interpolator->GetNullPointsStrategy() == vtkFFPointInterpolator2D::MASK_POINTS)
    {
      demandFull(data, interpolator->GetValidPointsMaskArrayName());
    }
    demand(fftest::failures() == 0, "a check of the tests' own fails");
  }

  /// Each block's result is what the block gives alone: nothing, if it fails alone.
  void checkBlocks()
  {
    auto* input = vtkDataObjectTree::SafeDownCast(this->Input[0]);
    auto* output = vtkDataObjectTree::SafeDownCast(this->Filter->GetOutputDataObject(0));
    auto* constrained = vtkFFRegularTriangulationFilter::SafeDownCast(this->Filter);
    auto* image = vtkFFPointsToImage::SafeDownCast(this->Filter);
    const bool hasSource =
      (constrained && constrained->GetSource()) || (image && image->GetSource());
    if (!input || !output || hasSource) // for one data set alone
    {
      return;
    }
    if (!output->IsA(input->GetClassName())) // VTK 9.1 has kept the one of an earlier run
    {
      return;
    }
    vtkSmartPointer<vtkCompositeDataIterator> leaves;
    leaves.TakeReference(input->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      auto* leaf = vtkPointSet::SafeDownCast(leaves->GetCurrentDataObject());
      if (!leaf)
      {
        continue;
      }
      const auto alone = this->another();
      const auto errors = fftest::ErrorObserver::Of(alone);
      alone->SetInputDataObject(leaf);
      alone->Update();
      vtkDataObject* const result = output->GetDataSet(leaves);
      if (demandTold(alone, leaf, errors))
      {
        demand(isNothing(result), "a block fails alone, and not with others");
        continue;
      }
      demand(fftest::isIdentical(result, alone->GetOutputDataObject(0), "block"),
        "a block's result depends on the others");
      demandResult(vtkFFAlgorithm::SafeDownCast(alone), leaf);
    }
  }

  /// What was changed before a run.
  struct RunType
  {
    explicit RunType(const Bytes& settings)
      : Settings(settings)
    {
    }
    Bytes Settings; // where its settings begin
    vtkSmartPointer<vtkDataObject> Input[2];
  };

  int Kind;
  vtkSmartPointer<vtkAlgorithm> Filter;
  vtkSmartPointer<fftest::ErrorObserver> Errors;
  vtkNew<Aborter> Abort;
  vtkSmartPointer<vtkDataObject> Input[2];
  std::vector<RunType> Runs;
};

void oneSession(Bytes bytes, vtkDataObject* given)
{
  Session session(bytes);
  for (int runs = 1 + bytes.below(3); runs > 0; --runs)
  {
    session.run(bytes, given);
  }
}

}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const bool silent = silence();
  demand(silent, "never");
  Bytes bytes(data, size);
  if (!bytes.oneOf(8))
  {
    oneSession(bytes, nullptr);
    return 0;
  }
  // Two at once: of data of their own, or of arrays that they share.
  vtkSmartPointer<vtkDataObject> shared;
  vtkSmartPointer<vtkDataObject> copy;
  if (bytes.flag())
  {
    shared = drawDataObject(bytes, MostPoints);
    copy.TakeReference(shared->NewInstance());
    copy->ShallowCopy(shared);
  }
  std::thread other(oneSession, bytes, copy.Get());
  oneSession(bytes, shared);
  other.join();
  return 0;
}
