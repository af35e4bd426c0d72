// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A filter that answers questions, as a part of a pipeline: composites, ghosts, errors in words,
// progress, abort, what makes it run again, and what makes it prepare its surface again.
#include "FFTest.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkImageData.h"
#include "vtkLongLongArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
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

using Filter = vtkFFSelectEnclosedPoints;

const double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<int> selected(vtkDataObject* data)
{
  std::vector<int> values;
  auto* set = vtkDataSet::SafeDownCast(data);
  vtkDataArray* array = set ? set->GetPointData()->GetArray("SelectedPoints") : nullptr;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(static_cast<int>(array->GetComponent(i, 0)));
  }
  return values;
}

/// The same of an update that goes well.
std::vector<int> selectedBy(Filter* filter)
{
  FF_CHECK(succeeds(filter));
  return selected(filter->GetOutput());
}

/// A composite has answers of the same structure; the blocks of a surface count together.
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
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, low);
  parts->SetPartition(2, high);
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, parts);
  vtkNew<vtkMultiBlockDataSet> surface;
  surface->SetBlock(0, makePoints(cubeCorners()));
  surface->SetBlock(1, makePoints({ { 4, 4, 4 } }, VTK_FLOAT));

  vtkNew<Filter> filters[3]; // VTK keeps a composite output for another type of composite
  const auto outputOf = [&](vtkDataObject* input, Filter* filter)
  {
    filter->SetInputData(input);
    filter->SetSurfaceData(surface);
    FF_CHECK(succeeds(filter));
    FF_CHECK_EQUAL(filter->GetDimension(), 3);
    FF_CHECK_EQUAL(filter->IsInside(0), vtkDataSet::SafeDownCast(input) ? 1 : 0);
    return filter->GetOutputDataObject(0);
  };
  auto* output = vtkMultiBlockDataSet::SafeDownCast(outputOf(blocks, filters[0]));
  FF_CHECK_EQUAL(output->GetNumberOfBlocks(), 3u);
  FF_CHECK(selected(output->GetBlock(0)) == (std::vector<int>{ 1, 1 }));
  FF_CHECK(output->GetBlock(1) == nullptr);
  auto* innerFound = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(2));
  FF_CHECK(innerFound && vtkImageData::SafeDownCast(innerFound->GetBlock(0)));
  FF_CHECK(innerFound && selected(innerFound->GetBlock(0)) == (std::vector<int>{ 1, 0 }));
  FF_CHECK_EQUAL(low->GetPointData()->GetNumberOfArrays(), 0);

  auto* found = vtkPartitionedDataSetCollection::SafeDownCast(outputOf(collection, filters[1]));
  FF_CHECK_EQUAL(found->GetNumberOfPartitions(0), 3u);
  FF_CHECK(selected(found->GetPartition(0, 0)) == (std::vector<int>{ 1, 1 }));
  FF_CHECK(selected(found->GetPartition(0, 2)) == (std::vector<int>{ 1, 0, 1 }));
  auto* alone = vtkPartitionedDataSet::SafeDownCast(outputOf(parts, filters[2]));
  FF_CHECK(selected(alone->GetPartition(2)) == (std::vector<int>{ 1, 0, 1 }));
  FF_CHECK(
    selected(outputOf(high, filters[2])) == (std::vector<int>{ 1, 0, 1 })); // back to a data set
}

/// Ghosts of the surface do not count, those of the input have answers.
void testGhosts()
{
  auto points = cubeCorners();
  points.insert(points.begin(), { 4, 4, 4 });
  const auto data = makePoints(points);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfValues(9);
  marks->Fill(0);
  marks->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  data->GetPointData()->AddArray(marks);
  vtkNew<Filter> filter;
  filter->SetInputData(data);
  filter->SetSurfaceData(data);
  FF_CHECK(selectedBy(filter) == (std::vector<int>{ 0, 1, 1, 1, 1, 1, 1, 1, 1 }));
  filter->SkipGhostPointsOff();
  FF_CHECK(selectedBy(filter) == std::vector<int>(9, 1));

  // The ids in errors count them.
  filter->SkipGhostPointsOn();
  points[3][1] = nan;
  const auto wrong = makePoints(points);
  wrong->GetPointData()->AddArray(marks);
  filter->SetSurfaceData(wrong);
  FF_CHECK(failsInPart(
    filter, vtkFFErrorCode::NonFiniteError, { "point 3 of the surface, 1 such point(s)" }));
}

/// One error, an empty output of the input's type, and none the worse for it afterwards.
void testErrors()
{
  const auto cube = makePoints(cubeCorners());
  vtkNew<Filter> filter;
  const auto fails =
    [&](vtkDataObject* input, vtkDataObject* surface, unsigned long code, const char* sentence)
  {
    filter->SetInputDataObject(0, input);
    filter->SetInputDataObject(1, surface);
    FF_CHECK(failsInPart(filter, code, { sentence }));
    FF_CHECK_EQUAL(filter->GetDimension(), -1);
    FF_CHECK_EQUAL(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
    FF_CHECK_EQUAL(filter->IsInside(0), 0);
  };
  constexpr unsigned long inputError = vtkFFErrorCode::InputError;
  constexpr unsigned long nonFinite = vtkFFErrorCode::NonFiniteError;
  auto corners = cubeCorners();
  corners[4][2] = nan;
  corners[6][0] = nan;
  const auto wrong = makePoints(corners);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  fails(wrong, cube, nonFinite, "infinite: first at point 4, 2 such point(s) in all. Remove them,");
  fails(cube, wrong, nonFinite, "first at point 4 of the surface, 2 such point(s) in all.");
  fails(
    image, wrong, nonFinite, "A coordinate is NaN or infinite: first at point 4 of the surface");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, cube);
  blocks->SetBlock(2, wrong);
  fails(cube, blocks, nonFinite, "first at point 4 of the block of flat index 3 of the surface, 2");
  vtkNew<vtkTable> table;
  blocks->SetBlock(0, table);
  fails(cube, blocks, inputError, "The data of the block of flat index 1 of the surface is a vtkT");

  vtkNew<vtkLongLongArray> integers;
  integers->SetNumberOfComponents(3);
  integers->SetNumberOfTuples(2);
  integers->Fill(0);
  integers->SetValue(4, (1LL << 53) + 1);
  fails(makePoints(integers), cube, inputError, "that no double holds: first at point 1.");
  fails(cube, makePoints(integers), inputError, "that no double holds: first at point 1 of the su");
  const auto flat = makePoints(integers);
  flat->GetPoints()->GetData()->SetNumberOfComponents(2);
  fails(
    cube, flat, inputError, "The points of the surface have 2 coordinates each; a point has 3.");

  // One error for each data set at fault; the others have their answers.
  filter->SetInputDataObject(0, blocks);
  filter->SetInputDataObject(1, cube);
  const auto errors = ErrorObserver::Of(filter);
  filter->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(2));
  FF_CHECK(errors->Has("The data of data set 0 of the composite is a vtkTable."));
  FF_CHECK(errors->Has("first at point 4 of data set 2 of the composite, 2 such point(s) in all."));
  FF_CHECK_EQUAL(filter->GetErrorCode(), nonFinite);
  FF_CHECK_EQUAL(filter->GetDimension(), 3);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  FF_CHECK(selected(output->GetBlock(1)) == std::vector<int>(8, 1));
  for (const unsigned int k : { 0u, 2u })
  {
    FF_CHECK_EQUAL(output->GetBlock(k)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }

  // What VTK itself says of inputs.
  errors->Clear();
  filter->SetInputDataObject(0, table);
  filter->Update();
  filter->SetInputDataObject(0, cube);
  filter->SetInputDataObject(1, table);
  filter->Update();
  filter->SetInputDataObject(1, nullptr);
  filter->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(3));
  FF_CHECK(errors->Has("is of type vtkTable, but a vtkDataSet is required"));
  FF_CHECK(errors->Has("is of type vtkTable, but a vtkCompositeDataSet is required"));
  FF_CHECK(errors->Has("Input port 1 of algorithm vtkFFSelectEnclosedPoints"));

  filter->SetNonFinitePointsToIgnore();
  filter->SetInputData(wrong);
  filter->SetSurfaceData(wrong);
  filter->GenerateDistancesOn();
  FF_CHECK(selectedBy(filter) == (std::vector<int>{ 1, 1, 1, 1, 0, 1, 0, 1 }));
  const double distance =
    filter->GetOutput()->GetPointData()->GetArray("FlipFlopDistance")->GetComponent(4, 0);
  FF_CHECK(distance != distance);
}

void testProgressAndAbort()
{
  const auto queries = makePoints(randomPoints(200000, 71));
  const auto surface = makePoints(randomPoints(100000, 72));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, queries);
  blocks->SetBlock(1, queries);
  vtkNew<Filter> filter;
  vtkNew<ProgressObserver> progress;
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  filter->GenerateDistancesOn();
  filter->SetSurfaceData(surface);
  for (vtkDataObject* input : std::vector<vtkDataObject*>{ queries, blocks })
  {
    progress->Values.clear();
    progress->Texts.clear();
    surface->Modified();
    filter->SetInputData(input);
    FF_CHECK(succeeds(filter));
    checkProgress(progress->Values);
    // The surface is prepared once, not for each data set.
    FF_CHECK_EQUAL(std::count(progress->Texts.begin(), progress->Texts.end(),
                     "Points in convex hull: growing and flipping"),
      1);
  }

  filter->SetInputData(queries);
  for (const double mark : { 0.01, 0.7 })
  {
    progress->AbortAt = mark;
    progress->Values.clear();
    surface->Modified();
    FF_CHECK(selectedBy(filter).empty());
    FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), vtkIdType(0));
    FF_CHECK(progress->StoppedOnTheWay());

    // A question outside the pipeline is not stopped.
    filter->Initialize(surface);
    FF_CHECK_EQUAL(filter->IsInsideSurface(0, 0, 0), 1);

    progress->AbortAt = 2.0;
    filter->SetAbortExecute(0);
    filter->Modified();
    FF_CHECK_EQUAL(selectedBy(filter).size(), std::size_t(200000));
  }
}

void testModification()
{
  int runs = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&runs);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  vtkNew<vtkSphereSource> sphere;
  vtkNew<Filter> filter;
  filter->AddObserver(vtkCommand::EndEvent, counter);
  filter->SetInputData(makePoints(cubeCorners()));
  filter->SetSurfaceConnection(sphere->GetOutputPort());
  filter->Update();
  const auto runsAgain = [&](int times)
  {
    runs = 0;
    filter->Update();
    filter->Update();
    return runs == times;
  };
  filter->InsideOutOff();
  filter->SelectPointsOnSurfaceOn();
  filter->GenerateDistancesOff();
  filter->SetNumberOfThreads(0);
  filter->SetNonFinitePointsToError();
  filter->SkipGhostPointsOn();
  FF_CHECK(runsAgain(0));
  const std::vector<std::function<void()>> changes{ [&] { filter->InsideOutOn(); },
    [&] { filter->SelectPointsOnSurfaceOff(); }, [&] { filter->GenerateDistancesOn(); },
    [&] { filter->SetNumberOfThreads(2); }, [&] { filter->SetNonFinitePointsToIgnore(); },
    [&] { filter->SkipGhostPointsOff(); }, [&] { sphere->SetRadius(4.0); } };
  for (const auto& change : changes)
  {
    change();
    FF_CHECK(runsAgain(1));
  }
  FF_CHECK(selectedBy(filter) == std::vector<int>(8, 0));

  std::ostringstream text;
  filter->Print(text);
  for (const char* name : { "InsideOut: On", "SelectPointsOnSurface: Off", "GenerateDistances: On",
         "NumberOfThreads: 2", "NonFinitePoints: Ignore", "SkipGhostPoints: Off", "Dimension: 3" })
  {
    FF_CHECK(text.str().find(std::string("\n  ") + name) != std::string::npos);
  }
}

/// A surface is prepared again if it or a setting of it has changed. To see that, its points move
/// here, of which nobody is told.
void testPreparation()
{
  const auto block = makePoints(cubeCorners());
  vtkNew<vtkMultiBlockDataSet> surface;
  surface->SetBlock(0, block);
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints({ { 2, 2, 2 } }));
  filter->SetSurfaceData(surface);
  FF_CHECK(selectedBy(filter) == std::vector<int>{ 0 });
  double size = 1.0;
  const auto isPreparedAgain = [&](const std::function<void()>& change)
  {
    size = 4.0 - size;
    block->GetPoints()->SetPoint(7, size, size, size);
    const int before = filter->IsInsideSurface(2, 2, 2);
    change();
    FF_CHECK(succeeds(filter));
    return filter->IsInsideSurface(2, 2, 2) != before;
  };
  // The move towards the point, and back.
  const auto neither = [&](const std::function<void()>& change)
  { return !isPreparedAgain(change) && !isPreparedAgain(change); };
  const auto both = [&](const std::function<void()>& change)
  { return isPreparedAgain(change) && isPreparedAgain(change); };
  FF_CHECK(neither([&] { filter->SetInsideOut(!filter->GetInsideOut()); }));
  FF_CHECK(neither([&] { filter->SetGenerateDistances(!filter->GetGenerateDistances()); }));
  FF_CHECK(neither([&] { filter->SetNumberOfThreads(3 - filter->GetNumberOfThreads()); }));
  FF_CHECK(neither([&] { filter->SetInputData(makePoints({ { 2, 2, 2 }, { 3, 3, 3 } })); }));
  FF_CHECK(both([&] { filter->SetNonFinitePoints(1 - filter->GetNonFinitePoints()); }));
  FF_CHECK(both([&] { filter->SetSkipGhostPoints(!filter->GetSkipGhostPoints()); }));
  FF_CHECK(both([&] { surface->Modified(); }));
  FF_CHECK(both(
    [&]
    {
      block->Modified(); // the composite itself does not know
      filter->Modified();
    }));
  FF_CHECK(both([&] { filter->Initialize(surface); }));
}

}

int TestFFSelectEnclosedPointsPipeline(int, char*[])
{
  testComposites();
  testGhosts();
  testErrors();
  testProgressAndAbort();
  testModification();
  testPreparation();
  return result();
}
