// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that vtkGhostType marks as another piece's or as hidden: left out, or counted like others.
// Ids are those of the input either way, and marks of points never become other marks of cells.
#include "FFTest.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <cmath>
#include <string>
#include <vector>

using namespace fftest;

namespace
{

using Marks = std::vector<int>;
using Ids = std::vector<vtkIdType>;

constexpr int duplicate = vtkDataSetAttributes::DUPLICATEPOINT;
constexpr int hidden = vtkDataSetAttributes::HIDDENPOINT;

void mark(vtkPointSet* data, const Marks& marks)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const int value : marks)
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(value));
  }
  data->GetPointData()->AddArray(ghosts);
}

/// A tetrahedron as ids 1, 3, 4 and 6, amid four points far outside it, each of which is marked.
vtkSmartPointer<vtkPolyData> makeAmidGhosts()
{
  auto data = makePoints({ { 9, 9, 9 }, { 0, 0, 0 }, { -9, 9, 9 }, { 1, 0, 0 }, { 0, 1, 0 },
    { 9, -9, 9 }, { 0, 0, 1 }, { 9, 9, -9 } });
  mark(data, { duplicate, 0, hidden, 0, 0, duplicate | hidden, 0, duplicate });
  return data;
}

void testHull()
{
  vtkNew<vtkFFHullFilter> hull;
  FF_CHECK(hull->GetSkipGhostPoints());
  hull->SetInputData(makeAmidGhosts());
  hull->VisiblePointIdsOn();
  hull->Update();
  FF_CHECK(originalIds(hull->GetOutput()) == (Ids{ 1, 3, 4, 6 }));
  auto* visible =
    vtkIdTypeArray::SafeDownCast(hull->GetOutput()->GetPointData()->GetArray("OriginalPointIds"));
  FF_CHECK(visible && visible->GetValue(3) == 6);
  FF_CHECK_EQUAL(hull->GetOutput()->GetNumberOfPolys(), vtkIdType(4));
  FF_CHECK_EQUAL(hull->GetOutput()->GetPoint(3)[2], 1.0);
  FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), vtkIdType(4));
  FF_CHECK_EQUAL(hull->GetDimension(), 3);

  hull->SkipGhostPointsOff();
  hull->Update();
  FF_CHECK(isHullOf(vtkPointSet::SafeDownCast(hull->GetInput()), hull->GetOutput(), 3));
  FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), vtkIdType(8));

  // Nothing else is there.
  auto ghosts = makePoints(cubeCorners());
  mark(ghosts, Marks(8, hidden));
  hull->SetInputData(ghosts);
  hull->SkipGhostPointsOn();
  hull->Update();
  FF_CHECK(isEmpty(hull->GetOutput()));
  FF_CHECK_EQUAL(hull->GetDimension(), -1);
  FF_CHECK_EQUAL(hull->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

/// VTK's own way to hide points.
void testBlankedGrid()
{
  const auto corners = makePoints(cubeCorners());
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(2, 2, 2);
  grid->SetPoints(corners->GetPoints());
  grid->BlankPoint(7);
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(grid);
  hull->Update();
  FF_CHECK(originalIds(hull->GetOutput()) == (Ids{ 0, 1, 2, 3, 4, 5, 6 }));
}

/// What is wrong with a ghost does not matter; what is wrong with another point is told by its id.
void testErrors()
{
  auto data = makeAmidGhosts();
  data->GetPoints()->SetPoint(2, NAN, 0, 0);
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  hull->SetInputData(data);
  hull->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK_EQUAL(hull->GetOutput()->GetNumberOfPoints(), vtkIdType(4));

  data->GetPoints()->SetPoint(4, 0, INFINITY, 0);
  data->Modified();
  hull->Update();
  FF_CHECK(errors->Has("first at point 4, 1 such point(s)"));
  errors->Clear();

  // Neither is a 64-bit integer that no double holds.
  const vtkTypeInt64 inexact = (vtkTypeInt64(1) << 60) + 1;
  vtkNew<vtkTypeInt64Array> integers;
  integers->SetNumberOfComponents(3);
  integers->SetNumberOfTuples(6);
  integers->Fill(0.0);
  for (int i = 0; i < 3; ++i)
  {
    integers->SetTypedComponent(i + 1, i, 1);
  }
  integers->SetTypedComponent(0, 0, inexact);
  auto wide = makePoints(integers);
  mark(wide, { hidden, 0, 0, 0, 0, 0 });
  hull->SetInputData(wide);
  hull->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK(originalIds(hull->GetOutput()) == (Ids{ 1, 2, 3, 4 }));
  integers->SetTypedComponent(5, 1, inexact);
  integers->Modified();
  wide->Modified();
  hull->Update();
  FF_CHECK(errors->Has("first at point 5."));
  errors->Clear();

  auto unmarked = makePoints(cubeCorners());
  mark(unmarked, { 0, hidden });
  hull->SetInputData(unmarked);
  hull->Update();
  FF_CHECK(errors->Has("The point array vtkGhostType has 2 value(s) for 8 point(s)"));
  FF_CHECK(isEmpty(hull->GetOutput()));
  errors->Clear();
  hull->SkipGhostPointsOff();
  hull->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK_EQUAL(hull->GetOutput()->GetNumberOfPoints(), vtkIdType(8));
}

void testComposite()
{
  vtkNew<vtkPartitionedDataSetCollection> blocks;
  blocks->SetPartition(0, 0, makeAmidGhosts());
  blocks->SetPartition(1, 0, makePoints({ { 5, 5, 5 } }));
  blocks->SetPartition(1, 1, makeAmidGhosts());

  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(blocks);
  hull->Update();
  auto* each = vtkPartitionedDataSetCollection::SafeDownCast(hull->GetOutputDataObject(0));
  const auto ids = [&](unsigned int block)
  { return originalIds(vtkPolyData::SafeDownCast(each->GetPartitionAsDataObject(block, 0))); };
  FF_CHECK(ids(0) == (Ids{ 1, 3, 4, 6 }));
  FF_CHECK(ids(1) == (Ids{ 0, 2, 4, 5, 7 }));

  hull->SetCompositeModeToAllBlocks();
  hull->Update();
  FF_CHECK(originalIds(hull->GetOutput()) == (Ids{ 1, 3, 4, 6, 8 }));
  auto* index =
    vtkUnsignedIntArray::SafeDownCast(hull->GetOutput()->GetPointData()->GetArray("BlockIndex"));
  FF_CHECK(index && index->GetValue(3) == 1 && index->GetValue(4) == 3);
}

/// A square and its centre, as ids 1 to 5; before and after them a marked point.
vtkSmartPointer<vtkPolyData> makeWeightedAmidGhosts()
{
  const double infinity = INFINITY;
  auto data = makeWeighted(
    { { 9, 9, 0 }, { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 1, 1, 0 }, { -9, 9, 0 } },
    { infinity, 0, 0, 0, 0, -2, 0 });
  mark(data, { duplicate, 0, 0, 0, 0, 0, hidden });
  return data;
}

void testTriangulation()
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  FF_CHECK(filter->GetSkipGhostPoints());
  filter->SetInputData(makeWeightedAmidGhosts());
  filter->GeneratePowerDiagramOn();
  useWeights(filter);
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK(originalIds(filter->GetOutput()) == (Ids{ 1, 2, 3, 4 }));
  FF_CHECK(originalIds(filter->GetHiddenPointsOutput()) == (Ids{ 5 }));
  auto* cells = filter->GetPowerDiagramOutput();
  auto* ids = vtkIdTypeArray::SafeDownCast(cells->GetCellData()->GetArray("vtkOriginalPointIds"));
  FF_CHECK(ids && ids->GetNumberOfValues() == 4 && ids->GetValue(0) == 1 && ids->GetValue(3) == 4);
  FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), vtkIdType(5));
  cells->RemoveGhostCells();
  FF_CHECK_EQUAL(cells->GetNumberOfCells(), vtkIdType(4));

  // Of pieces, too.
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, makeWeightedAmidGhosts());
  partitions->SetPartition(1, makeWeightedAmidGhosts());
  filter->SetInputData(partitions);
  filter->Update();
  auto* points = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  FF_CHECK(originalIds(vtkPolyData::SafeDownCast(points->GetPartitionAsDataObject(0))) ==
    (Ids{ 5, 8, 9, 10, 11, 12 }));

  // Weights are judged as they came.
  auto data = makeWeightedAmidGhosts();
  data->GetPointData()->GetArray("weights")->SetNumberOfTuples(5);
  filter->SetInputData(data);
  filter->Update();
  FF_CHECK(errors->Has("has 5 value(s) for 7 point(s)"));
  errors->Clear();
  data = makeWeightedAmidGhosts();
  data->GetPointData()->GetArray("weights")->SetComponent(5, 0, NAN);
  filter->SetInputData(data);
  filter->Update();
  FF_CHECK(errors->Has("first at point 5, 1 such point(s)"));
}

/// Marks of points mean other things for cells, so they are translated. Points that are counted all
/// the same keep theirs.
void testMarksOfCells()
{
  auto data = makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } });
  mark(data, { 0, duplicate, hidden, duplicate | hidden | 4 });
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  filter->SetInputData(data);
  filter->SkipGhostPointsOff();
  filter->GeneratePowerDiagramOn();
  filter->Update();
  auto* cells = filter->GetPowerDiagramOutput();
  auto* ofCells = vtkUnsignedCharArray::SafeDownCast(
    cells->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  auto* ofPoints = vtkUnsignedCharArray::SafeDownCast(
    filter->GetOutput()->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!ofCells || !ofPoints || ofCells->GetNumberOfValues() != 4)
  {
    FF_CHECK(!"no marks, or not one for each cell");
    return;
  }
  FF_CHECK_EQUAL(int(ofCells->GetValue(0)), 0);
  FF_CHECK_EQUAL(int(ofCells->GetValue(1)), int(vtkDataSetAttributes::DUPLICATECELL));
  FF_CHECK_EQUAL(int(ofCells->GetValue(2)), int(vtkDataSetAttributes::HIDDENCELL));
  FF_CHECK_EQUAL(int(ofCells->GetValue(3)),
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL);
  FF_CHECK_EQUAL(int(ofPoints->GetValue(2)), hidden);
  FF_CHECK_EQUAL(int(ofPoints->GetValue(3)), duplicate | hidden | 4);

  // What vtkRemoveGhosts does: the cells of duplicate points go, those of unmarked ones stay.
  cells->RemoveGhostCells();
  auto* left = vtkIdTypeArray::SafeDownCast(cells->GetCellData()->GetArray("vtkOriginalPointIds"));
  FF_CHECK(left && left->LookupValue(0) == 0);
  FF_CHECK(left && left->LookupValue(1) < 0 && left->LookupValue(3) < 0);
}

}

int TestFFGhostPoints(int, char*[])
{
  testHull();
  testBlankedGrid();
  testErrors();
  testComposite();
  testTriangulation();
  testMarksOfCells();
  return result();
}
