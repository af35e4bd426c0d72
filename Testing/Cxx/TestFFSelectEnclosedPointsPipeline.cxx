// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A filter that answers questions, as a part of a pipeline: composites, ghosts, errors in words,
// progress, abort, and what makes it run again.
#include "FFTest.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
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

/// A composite has answers of the same structure; the blocks of a surface count together.
void testComposites()
{
  const auto low = makePoints({ { 0.5, 0.5, 0.5 }, { 2, 2, 2 } });
  const auto high = makePoints({ { 2, 2, 2 }, { 9, 9, 9 }, { 1, 1, 1 } });
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, low);
  parts->SetPartition(2, high);
  vtkNew<vtkMultiBlockDataSet> inner;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->SetOrigin(0.5, 0.5, 0.5);
  inner->SetBlock(0, image);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, low);
  blocks->SetBlock(2, inner);

  vtkNew<vtkMultiBlockDataSet> surface;
  surface->SetBlock(0, makePoints(cubeCorners()));
  surface->SetBlock(1, makePoints({ { 4, 4, 4 } }, VTK_FLOAT));

  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputData(blocks);
  filter->SetSurfaceData(surface);
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
  FF_CHECK(output != nullptr);
  if (!output)
  {
    return;
  }
  FF_CHECK_EQUAL(output->GetNumberOfBlocks(), 3u);
  FF_CHECK(selected(output->GetBlock(0)) == (std::vector<int>{ 1, 1 }));
  FF_CHECK(output->GetBlock(1) == nullptr);
  auto* innerFound = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(2));
  FF_CHECK(innerFound && vtkImageData::SafeDownCast(innerFound->GetBlock(0)));
  FF_CHECK(selected(innerFound->GetBlock(0)) == (std::vector<int>{ 1, 0 }));
  FF_CHECK(low->GetPointData()->GetNumberOfArrays() == 0);
  FF_CHECK_EQUAL(filter->IsInside(0), 0);

  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, parts);
  filter->SetInputData(collection);
  filter->Update();
  auto* found = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutput());
  FF_CHECK(found && found->GetNumberOfPartitions(0) == 3);
  FF_CHECK(selected(found->GetPartition(0, 0)) == (std::vector<int>{ 1, 1 }));
  FF_CHECK(selected(found->GetPartition(0, 2)) == (std::vector<int>{ 1, 0, 1 }));
  filter->SetInputData(parts);
  filter->Update();
  auto* alone = vtkPartitionedDataSet::SafeDownCast(filter->GetOutput());
  FF_CHECK(alone && selected(alone->GetPartition(2)) == (std::vector<int>{ 1, 0, 1 }));

  // And back to a data set.
  filter->SetInputData(high);
  filter->Update();
  FF_CHECK(selected(filter->GetOutput()) == (std::vector<int>{ 1, 0, 1 }));
  FF_CHECK_EQUAL(filter->IsInside(2), 1);
  FF_CHECK(errors->Messages.empty());
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
  filter->Update();
  FF_CHECK(selected(filter->GetOutput()) == (std::vector<int>{ 0, 1, 1, 1, 1, 1, 1, 1, 1 }));
  filter->SkipGhostPointsOff();
  filter->Update();
  FF_CHECK(selected(filter->GetOutput()) == std::vector<int>(9, 1));

  // The ids in errors count them.
  filter->SkipGhostPointsOn();
  const auto errors = ErrorObserver::Of(filter);
  points[3][1] = nan;
  const auto wrong = makePoints(points);
  wrong->GetPointData()->AddArray(marks);
  filter->SetSurfaceData(wrong);
  filter->Update();
  FF_CHECK(errors->Has("point 3 of the surface, 1 such point(s)"));
}

/// One error, an empty output of the input's type, and none the worse for it afterwards.
void testErrors()
{
  const auto cube = makePoints(cubeCorners());
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  const auto fails = [&](vtkDataObject* input, vtkDataObject* surface, const char* sentence)
  {
    errors->Clear();
    filter->SetInputDataObject(0, input);
    filter->SetInputDataObject(1, surface);
    filter->Update();
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
    FF_CHECK(errors->Has(sentence));
    FF_CHECK_EQUAL(errors->FailedRequests, 1);
    FF_CHECK(filter->GetErrorCode() != vtkErrorCode::NoError);
    FF_CHECK_EQUAL(filter->GetDimension(), -1);
    FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfElements(vtkDataObject::POINT), vtkIdType(0));
    FF_CHECK_EQUAL(filter->IsInside(0), 0);
  };
  /// Block 0 has its answers, the other none.
  const auto failsInPart = [&](vtkDataObject* input, const char* sentence)
  {
    errors->Clear();
    filter->SetInputDataObject(0, input);
    filter->SetInputDataObject(1, cube);
    filter->Update();
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
    FF_CHECK(errors->Has(sentence));
    FF_CHECK(errors->Has(" The block of flat index 2 has no result; the other one has its own."));
    FF_CHECK_EQUAL(errors->FailedRequests, 0);
    FF_CHECK(filter->GetErrorCode() != vtkErrorCode::NoError);
    FF_CHECK_EQUAL(filter->GetDimension(), 3);
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
    FF_CHECK(output && selected(output->GetBlock(0)) == std::vector<int>(8, 1));
    FF_CHECK(output && !output->GetBlock(1));
  };
  fails(nullptr, cube, "There is no input. Set one.");
  fails(cube, nullptr, "There is no surface. Set one.");
  vtkNew<vtkTable> table;
  fails(table, cube, "The input is a vtkTable. It must be a vtkPointSet,");
  fails(cube, table, "The surface is a vtkTable. It must be a vtkPointSet,");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cube);
  blocks->SetBlock(1, table);
  failsInPart(blocks, "The block of flat index 2 is a vtkTable.");
  fails(cube, blocks, "The block of flat index 2 of the surface is a vtkTable.");

  auto corners = cubeCorners();
  corners[4][2] = nan;
  corners[6][0] = nan;
  const auto wrong = makePoints(corners);
  fails(wrong, cube, "A coordinate is NaN or infinite: first at point 4, 2 such point(s) in all.");
  fails(cube, wrong, "first at point 4 of the surface, 2 such point(s) in all.");
  blocks->SetBlock(1, wrong);
  failsInPart(blocks, "first at point 4 of the block of flat index 2, 2 such point(s)");
  fails(cube, blocks, "first at point 4 of the block of flat index 2 of the surface, 2 such");

  vtkNew<vtkLongLongArray> integers;
  integers->SetNumberOfComponents(3);
  integers->SetNumberOfTuples(2);
  integers->Fill(0);
  integers->SetValue(4, (1LL << 53) + 1);
  fails(makePoints(integers), cube, "64-bit integer that no double holds: first at point 1.");
  fails(cube, makePoints(integers), "that no double holds: first at point 1 of the surface.");
  vtkNew<vtkLongLongArray> pairs;
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(2);
  pairs->Fill(0);
  const auto flat = makePoints(integers);
  flat->GetPoints()->GetData()->SetNumberOfComponents(2);
  fails(cube, flat, "The points of the surface have 2 coordinates each; a point has 3.");

  errors->Clear();
  filter->SetNonFinitePointsToIgnore();
  filter->SetInputData(wrong);
  filter->SetSurfaceData(wrong);
  filter->GenerateDistancesOn();
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
  FF_CHECK(selected(filter->GetOutput()) == (std::vector<int>{ 1, 1, 1, 1, 0, 1, 0, 1 }));
  const double distance =
    filter->GetPolyDataOutput()->GetPointData()->GetArray("FlipFlopDistance")->GetComponent(4, 0);
  FF_CHECK(distance != distance);
}

void testProgressAndAbort()
{
  const auto queries = makePoints(randomPoints(200000, 71));
  const auto surface = makePoints(randomPoints(100000, 72));
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  vtkNew<ProgressObserver> progress;
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  filter->GenerateDistancesOn();
  filter->SetInputData(queries);
  filter->SetSurfaceData(surface);
  filter->Update();
  checkProgress(progress->Values);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, queries);
  blocks->SetBlock(1, queries);
  progress->Values.clear();
  filter->SetInputData(blocks);
  filter->Update();
  checkProgress(progress->Values);

  filter->SetInputData(queries);
  for (const double mark : { 0.01, 0.7 })
  {
    progress->AbortAt = mark;
    progress->Values.clear();
    filter->Modified();
    filter->Update();
    FF_CHECK_EQUAL(filter->GetPolyDataOutput()->GetNumberOfPoints(), vtkIdType(0));
    FF_CHECK(errors->Messages.empty());
    FF_CHECK_EQUAL(errors->FailedRequests, 0);
    FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
    FF_CHECK(progress->StoppedOnTheWay());

    // A question outside the pipeline is not stopped.
    filter->Initialize(surface);
    FF_CHECK_EQUAL(filter->IsInsideSurface(0, 0, 0), 1);

    progress->AbortAt = 2.0;
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    FF_CHECK_EQUAL(selected(filter->GetOutput()).size(), std::size_t(200000));
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
  const auto queries = makePoints(cubeCorners());
  vtkNew<Filter> filter;
  filter->AddObserver(vtkCommand::EndEvent, counter);
  filter->SetInputData(queries);
  filter->SetSurfaceConnection(sphere->GetOutputPort());
  filter->Update();
  int expected = 1;
  const auto runsAgain = [&](bool again)
  {
    filter->Update();
    filter->Update();
    expected += again ? 1 : 0;
    return runs == expected;
  };
  filter->InsideOutOff();
  filter->SelectPointsOnSurfaceOn();
  filter->GenerateDistancesOff();
  filter->SetNumberOfThreads(0);
  filter->SetNonFinitePointsToError();
  filter->SkipGhostPointsOn();
  FF_CHECK(runsAgain(false));
  filter->InsideOutOn();
  FF_CHECK(runsAgain(true));
  filter->SelectPointsOnSurfaceOff();
  FF_CHECK(runsAgain(true));
  filter->GenerateDistancesOn();
  FF_CHECK(runsAgain(true));
  filter->SetNumberOfThreads(2);
  FF_CHECK(runsAgain(true));
  filter->SetNonFinitePointsToIgnore();
  FF_CHECK(runsAgain(true));
  filter->SkipGhostPointsOff();
  FF_CHECK(runsAgain(true));
  sphere->SetRadius(4.0);
  FF_CHECK(runsAgain(true));
  FF_CHECK(selected(filter->GetOutput()) == std::vector<int>(8, 0));

  std::ostringstream text;
  filter->Print(text);
  for (const char* name : { "InsideOut: On", "SelectPointsOnSurface: Off", "GenerateDistances: On",
         "NumberOfThreads: 2", "NonFinitePoints: Ignore", "SkipGhostPoints: Off", "Dimension: 3" })
  {
    FF_CHECK(text.str().find(std::string("\n  ") + name) != std::string::npos);
  }
}

}

int TestFFSelectEnclosedPointsPipeline(int, char*[])
{
  testComposites();
  testGhosts();
  testErrors();
  testProgressAndAbort();
  testModification();
  return result();
}
