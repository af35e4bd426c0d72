// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What the filters that answer questions share, as parts of a pipeline: composites, ghosts, errors
// in words, threads, progress, abort, what makes them run again, and what they keep.
#include "FFPieceSource.h"
#include "FFTest.h"

#include "vtkDataArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <sstream>

using namespace fftest;

namespace
{

using Answers = std::vector<int>;

const double nan = std::numeric_limits<double>::quiet_NaN();

/// A filter, and what is its own.
struct Case
{
  vtkSmartPointer<vtkFFQueryAlgorithm> Filter;
  const char* Array;  ///< 1: the point is in the hull of the others, in space or in the plane
  std::string Second; ///< the second input's name
  const char* Step;   ///< of the progress, while that is prepared
  int Dimension;      ///< of points that span all
  std::vector<std::string> Printed;
};

std::vector<Case> cases()
{
  const auto select = vtkSmartPointer<vtkFFSelectEnclosedPoints>::New();
  select->GenerateDistancesOn();
  return { { select, "SelectedPoints", "surface", "Points in convex hull: growing and flipping", 3,
             { "InsideOut: Off", "SelectPointsOnSurface: On", "GenerateDistances: On" } },
    { vtkSmartPointer<vtkFFPointInterpolator2D>::New(), "vtkValidPointMask", "source",
      "Point interpolation: inserting", 2,
      { "InterpolationMode: 0", "WeightMode: 0", "WeightFactor: 1", "NullPointsStrategy: 0",
        "NullValue: 0", "InterpolateZ: On", "ValidPointsMaskArrayName: vtkValidPointMask",
        "ZArrayName: Elevation", "ExcludedArrays: 0", "PassPointArrays: On", "PassCellArrays: On",
        "PassFieldArrays: On" } } };
}

Answers answersIn(const Case& of, vtkDataObject* data)
{
  Answers values;
  auto* set = vtkDataSet::SafeDownCast(data);
  vtkDataArray* array = set ? set->GetPointData()->GetArray(of.Array) : nullptr;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(static_cast<int>(array->GetComponent(i, 0)));
  }
  return values;
}

/// Those of an update that goes well.
Answers answersOf(const Case& of, vtkDataObject* input, vtkDataObject* second)
{
  of.Filter->SetInputDataObject(0, input);
  of.Filter->SetInputDataObject(1, second);
  FF_CHECK(succeeds(of.Filter));
  return answersIn(of, of.Filter->GetOutputDataObject(0));
}

/// Field data may be missing, of input and output, in each run.
void testWithoutFieldData()
{
  const auto points = makePoints({ { 0.5, 0.5, 0.5 } });
  points->SetFieldData(nullptr);
  for (const Case& of : cases())
  {
    for (int run = 0; run < 2; ++run)
    {
      of.Filter->Modified();
      FF_CHECK(answersOf(of, points, makePoints(cubeCorners())) == Answers{ 1 });
    }
  }
}

/// The report of a filter upstream is not passed on; other field data is.
void testFieldData()
{
  const auto points = makePoints({ { 0.5, 0.5, 0.5 } });
  for (const char* name : { "FlipFlopVolume", "time", "FlipFlopArea" })
  {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    array->InsertNextValue(1);
    points->GetFieldData()->AddArray(array);
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, points);
  for (const Case& of : cases())
  {
    answersOf(of, blocks, makePoints(cubeCorners()));
    const vtkSmartPointer<vtkMultiBlockDataSet> output =
      vtkMultiBlockDataSet::SafeDownCast(of.Filter->GetOutputDataObject(0));
    FF_CHECK(answersOf(of, points, makePoints(cubeCorners())) == Answers{ 1 });
    for (vtkDataObject* data : { of.Filter->GetOutputDataObject(0), output->GetBlock(0) })
    {
      FF_CHECK_EQUAL(data->GetFieldData()->GetNumberOfArrays(), 1);
      FF_CHECK(data->GetFieldData()->HasArray("time"));
    }
    FF_CHECK_EQUAL(points->GetFieldData()->GetNumberOfArrays(), 3);
  }
}

/// A composite has answers of the same structure; the blocks of a second input count together.
void testComposites()
{
  const auto low = makePoints({ { 0.5, 0.5, 0.5 }, { 2, 2, 2 } });
  const auto high = makePoints({ { 2, 2, 2 }, { 9, 9, 9 }, { 1, 1, 1 } });
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->SetOrigin(0.5, 0.5, 0.5);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, image);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, low);
  blocks->SetBlock(2, inner);
  vtkNew<vtkMultiBlockDataSet> second;
  second->SetBlock(0, makePoints(cubeCorners()));
  second->SetBlock(1, makePoints({ { 4, 4, 4 } }, VTK_FLOAT));

  for (const Case& of : cases())
  {
    answersOf(of, blocks, second);
    FF_CHECK_EQUAL(of.Filter->GetDimension(), of.Dimension);
    auto* output = vtkMultiBlockDataSet::SafeDownCast(of.Filter->GetOutputDataObject(0));
    FF_CHECK_EQUAL(output->GetNumberOfBlocks(), 3u);
    FF_CHECK(answersIn(of, output->GetBlock(0)) == (Answers{ 1, 1 }));
    FF_CHECK(output->GetBlock(1) == nullptr);
    auto* innerFound = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(2));
    FF_CHECK(innerFound && vtkImageData::SafeDownCast(innerFound->GetBlock(0)));
    FF_CHECK(innerFound && answersIn(of, innerFound->GetBlock(0)) == (Answers{ 1, 0 }));
    FF_CHECK_EQUAL(low->GetPointData()->GetNumberOfArrays(), 0);
    // And back to a data set.
    FF_CHECK(answersOf(of, high, second) == (Answers{ 1, 0, 1 }));
  }
}

/// Ghosts of the second input do not count, those of the first have answers.
void testGhosts()
{
  auto points = cubeCorners();
  points.insert(points.begin(), { 4, 4, 4 });
  const auto data = makePoints(points);
  points[3][1] = nan;
  const auto wrong = makePoints(points);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(9);
  marks->Fill(0);
  marks->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  data->GetPointData()->AddArray(marks);
  wrong->GetPointData()->AddArray(marks);
  for (const Case& of : cases())
  {
    FF_CHECK(answersOf(of, data, data) == (Answers{ 0, 1, 1, 1, 1, 1, 1, 1, 1 }));
    of.Filter->SetSkipGhostPoints(false);
    FF_CHECK(answersOf(of, data, data) == Answers(9, 1));
    of.Filter->SetSkipGhostPoints(true);
    of.Filter->SetInputDataObject(1, wrong);
    FF_CHECK(failsInPart(of.Filter, vtkFFErrorCode::NonFiniteError, // the id counts them
      { "point 3 of the " + of.Second + ", 1 such point(s)" }));
  }
}

/// One error, an empty output, and none the worse for it afterwards.
void testErrors(const Case& of)
{
  vtkFFQueryAlgorithm* const filter = of.Filter;
  const auto fails = [&](vtkDataObject* input, vtkDataObject* second, unsigned long code,
                       const std::string& sentence)
  {
    filter->SetInputDataObject(0, input);
    filter->SetInputDataObject(1, second);
    FF_CHECK(failsInPart(filter, code, { sentence }));
    FF_CHECK_EQUAL(filter->GetDimension(), -1);
    FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(0));
  };
  constexpr unsigned long nonFinite = vtkFFErrorCode::NonFiniteError;
  const auto cube = makePoints(cubeCorners());
  auto corners = cubeCorners();
  corners[4][1] = nan;
  corners[6][0] = nan;
  const auto wrong = makePoints(corners);
  const std::string ofSecond = " of the " + of.Second;
  const std::string first = " is NaN or infinite: first at point 4";
  const std::string all = ", 2 such point(s) in all. Remove them, or set Non Finite Points";
  fails(wrong, cube, nonFinite, "A coordinate" + first + all);
  fails(cube, wrong, nonFinite, first + ofSecond + all);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, cube);
  blocks->SetBlock(2, wrong);
  fails(cube, blocks, nonFinite, first + " of the block of flat index 3" + ofSecond + all);
  vtkNew<vtkTable> table;
  blocks->SetBlock(0, table);
  fails(cube, blocks, vtkFFErrorCode::InputError,
    "of the block of flat index 1" + ofSecond + " is a vtkTable.");

  // One error for all data sets.
  filter->SetInputDataObject(0, blocks);
  filter->SetInputDataObject(1, wrong);
  FF_CHECK(failsInPart(filter, nonFinite, { first + ofSecond + all }));
  FF_CHECK_EQUAL(
    filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), vtkIdType(0));

  // One error for each data set at fault; the others have their answers.
  filter->SetInputDataObject(0, blocks);
  filter->SetInputDataObject(1, cube);
  const auto errors = ErrorObserver::Of(filter);
  filter->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(2));
  FF_CHECK(errors->Has("The data of data set 0 of the composite is a vtkTable."));
  FF_CHECK(errors->Has("A coordinate" + first + " of data set 2 of the composite" + all));
  FF_CHECK_EQUAL(filter->GetErrorCode(), nonFinite);
  FF_CHECK_EQUAL(filter->GetDimension(), of.Dimension);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  FF_CHECK(answersIn(of, output->GetBlock(1)) == Answers(8, 1));
  for (const unsigned int k : { 0u, 2u })
  {
    FF_CHECK_EQUAL(output->GetBlock(k)->GetNumberOfElements(vtkDataObject::POINT), vtkIdType(0));
  }

  filter->SetNonFinitePoints(vtkFFQueryAlgorithm::NON_FINITE_IGNORE);
  FF_CHECK(answersOf(of, wrong, wrong) == (Answers{ 1, 1, 1, 1, 0, 1, 0, 1 }));
}

/// The same bits for any number of threads; progress; abort.
void testRuns()
{
  const auto queries = makePoints(randomPoints(300000, 71));
  const auto second = makePoints(randomPoints(100000, 72));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, queries);
  blocks->SetBlock(1, queries);
  const auto ones = cases();
  for (const int threads : { 1, 2, 4, -1 })
  {
    const auto others = cases();
    for (std::size_t k = 0; k < ones.size(); ++k)
    {
      const Case& of = threads == 1 ? ones[k] : others[k];
      of.Filter->SetNumberOfThreads(threads);
      answersOf(of, queries, second);
      FF_CHECK(isIdentical(of.Filter->GetOutput(), ones[k].Filter->GetOutput(), of.Second));
    }
  }
  for (const Case& of : ones)
  {
    vtkNew<ProgressObserver> progress;
    of.Filter->AddObserver(vtkCommand::ProgressEvent, progress);
    for (vtkDataObject* input : std::vector<vtkDataObject*>{ blocks, queries })
    {
      progress->Values.clear();
      progress->Texts.clear();
      second->Modified();
      answersOf(of, input, second);
      checkProgress(progress->Values);
      // The second input is prepared once, not for each data set.
      FF_CHECK_EQUAL(std::count(progress->Texts.begin(), progress->Texts.end(), of.Step), 1);
    }
    for (const double mark : { 0.01, 0.7, 2.0 })
    {
      progress->AbortAt = mark;
      progress->Values.clear();
      second->Modified();
      FF_CHECK_EQUAL(answersOf(of, queries, second).size(), mark > 1.0 ? 300000u : 0u);
      FF_CHECK_EQUAL(of.Filter->GetOutput()->GetNumberOfPoints(), mark > 1.0 ? 300000 : 0);
      FF_CHECK(mark > 1.0 || progress->StoppedOnTheWay());
      of.Filter->SetAbortExecute(0);
    }
  }
}

void testPrint()
{
  for (const Case& of : cases())
  {
    of.Filter->SetNumberOfThreads(-7);
    of.Filter->SetNonFinitePoints(7);
    std::ostringstream text;
    of.Filter->Print(text);
    auto printed = of.Printed;
    printed.insert(
      printed.end(), { "NumberOfThreads: -1", "NonFinitePoints: 1", "SkipGhostPoints: On" });
    for (const std::string& line : printed)
    {
      FF_CHECK_EQUAL(text.str().find("\n  " + line) != std::string::npos ? line : "", line);
    }
  }
}

/// Of whatever piece of the input, all of the second input is the other side.
void testPieces()
{
  for (const Case& of : cases())
  {
    vtkNew<PieceSource> source;
    source->SetWhole(makePoints(cubeCorners()));
    of.Filter->SetInputData(makePoints({ { 0.5, 0.5, 0.5 } }));
    of.Filter->SetInputConnection(1, source->GetOutputPort());
    of.Filter->UpdatePiece(0, 2, 0);
    FF_CHECK((source->Asked == std::vector<std::pair<int, int>>{ { 0, 1 } }));
    FF_CHECK(answersIn(of, of.Filter->GetOutput()) == Answers{ 1 });
  }
}

/// A run comes after changes alone. The second input is prepared again if it or a setting has
/// changed. To see that, its points move here, of which nobody is told.
void testChanges(const Case& of)
{
  vtkFFQueryAlgorithm* const filter = of.Filter;
  const auto block = makePoints(cubeCorners());
  vtkNew<vtkMultiBlockDataSet> second;
  second->SetBlock(0, block);
  const auto point = makePoints({ { 2, 2, 2 } });
  FF_CHECK(answersOf(of, point, second) == Answers{ 0 });
  double size = 1.0;
  const auto isPreparedAgain = [&](const std::function<void()>& change)
  {
    size = 4.0 - size;
    block->GetPoints()->SetPoint(7, size, size, size);
    const Answers before = answersIn(of, filter->GetOutput());
    change();
    const vtkMTimeType time = filter->GetOutput()->GetUpdateTime();
    FF_CHECK(succeeds(filter));
    FF_CHECK(filter->GetOutput()->GetUpdateTime() > time); // it runs
    return answersIn(of, filter->GetOutput()) != before;
  };
  // The move over the point, and back.
  const auto count = [&](const std::function<void()>& change)
  { return int(isPreparedAgain(change)) + int(isPreparedAgain(change)); };
  const auto touchBlock = [&]
  {
    block->Modified(); // the composite itself does not know
    filter->Modified();
  };
  FF_CHECK_EQUAL(count([&] { point->Modified(); }), 0);
  FF_CHECK_EQUAL(count([&] { filter->SetNumberOfThreads(3 - filter->GetNumberOfThreads()); }), 2);
  FF_CHECK_EQUAL(count([&] { filter->SetNonFinitePoints(1 - filter->GetNonFinitePoints()); }), 2);
  FF_CHECK_EQUAL(count([&] { filter->SetSkipGhostPoints(!filter->GetSkipGhostPoints()); }), 2);
  FF_CHECK_EQUAL(count([&] { second->Modified(); }), 2);
  FF_CHECK_EQUAL(count(touchBlock), 2);
  FF_CHECK_EQUAL(count([&] { filter->Modified(); }), 2);

  // A block within a block, which is replaced by an older one.
  const auto older = makePoints(cubeCorners());
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, makePoints({ { 0, 0, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { 0, 0, 9 } }));
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, inner);
  FF_CHECK(answersOf(of, point, outer) == Answers{ 1 });
  inner->SetBlock(0, older);
  point->Modified();
  FF_CHECK(answersOf(of, point, outer) == Answers{ 0 });

  vtkNew<vtkSphereSource> sphere;
  filter->SetInputConnection(1, sphere->GetOutputPort());
  sphere->SetRadius(9.0);
  FF_CHECK(succeeds(filter) && answersIn(of, filter->GetOutput()) == Answers{ 1 });
  sphere->SetRadius(1.0);
  FF_CHECK(succeeds(filter) && answersIn(of, filter->GetOutput()) == Answers{ 0 });
  const vtkMTimeType time = filter->GetOutput()->GetUpdateTime();
  filter->SetNumberOfThreads(0);
  filter->SetNonFinitePoints(vtkFFQueryAlgorithm::NON_FINITE_ERROR);
  filter->SetSkipGhostPoints(true);
  filter->Update();
  FF_CHECK_EQUAL(filter->GetOutput()->GetUpdateTime(), time);
}

}

int TestFFQueryAlgorithm(int, char*[])
{
  testWithoutFieldData();
  testFieldData();
  testComposites();
  testGhosts();
  testPrint();
  testPieces();
  testRuns();
  for (const Case& of : cases())
  {
    testErrors(of);
  }
  for (const Case& of : cases())
  {
    testChanges(of);
  }
  return result();
}
