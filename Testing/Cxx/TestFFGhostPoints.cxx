// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that vtkGhostType marks as another piece's or as hidden: left out, or counted like others.
// Ids are those of the input either way, and marks of points never become other marks of cells.
#include "FFCases.h"
#include "FFTest.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFFErrorCode.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace fftest;

namespace
{

using Ids = std::vector<vtkIdType>;

constexpr int duplicate = vtkDataSetAttributes::DUPLICATEPOINT;
constexpr int hidden = vtkDataSetAttributes::HIDDENPOINT;

/// A tetrahedron as ids 1, 3, 4 and 6, amid four points far outside it, each of which is marked,
/// and whose weights are too much.
vtkSmartPointer<vtkPolyData> makeAmidGhosts()
{
  auto data = makeWeighted({ { 9, 9, 9 }, { 0, 0, 0 }, { -9, 9, 9 }, { 1, 0, 0 }, { 0, 1, 0 },
                             { 9, -9, 9 }, { 0.75, 0.75, 1 }, { 9, 9, -9 } },
    { INFINITY, 0, NAN, 0, 0, NAN, 0, NAN });
  markPoints(data, { duplicate, 0, hidden, 0, 0, duplicate | hidden, 0, duplicate });
  return data;
}

/// The ids of a filter's output; a power diagram has them with its cells.
Ids idsOf(vtkFFAlgorithm* filter)
{
  if (!filter->IsA("vtkFFPowerDiagramFilter"))
  {
    return originalIds(filter->GetOutput());
  }
  auto* ids = vtkIdTypeArray::SafeDownCast(
    filter->GetOutput()->GetCellData()->GetArray("vtkOriginalPointIds"));
  return ids ? Ids(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues()) : Ids();
}

/// Of each filter.
void testFilter(const FilterCase& of)
{
  const auto filter = of.New();
  FF_CHECK(filter->GetSkipGhostPoints());
  filter->SetInputDataObject(makeAmidGhosts());
  FF_CHECK(succeeds(filter));
  FF_CHECK(of.MakesImage || idsOf(filter) == (Ids{ 1, 3, 4, 6 }));
  FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), vtkIdType(4));
  FF_CHECK_EQUAL(filter->GetNumberOfNonFinitePoints(), vtkIdType(0));

  // Off, they count. Their weights, too.
  filter->SetSkipGhostPoints(false);
  if (of.IsWeighted)
  {
    FF_CHECK(
      fails(filter, vtkFFErrorCode::NonFiniteError, { "first at point 0, 4 such point(s)" }));
  }
  else
  {
    FF_CHECK(succeeds(filter));
    FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), vtkIdType(8));
  }
  filter->SetSkipGhostPoints(true);

  // What is wrong with a ghost does not matter; other points are named by their ids.
  auto data = makeAmidGhosts();
  data->GetPoints()->SetPoint(2, NAN, 0, 0);
  filter->SetInputDataObject(data);
  FF_CHECK(succeeds(filter));
  FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), vtkIdType(4));
  data = makeAmidGhosts();
  data->GetPoints()->SetPoint(4, 0, INFINITY, 0);
  filter->SetInputDataObject(data);
  FF_CHECK(fails(filter, vtkFFErrorCode::NonFiniteError, { "first at point 4, 1 such point(s)" }));
  if (of.IsWeighted) // weights are as many as all points
  {
    data = makeAmidGhosts();
    data->GetPointData()->GetArray("weights")->SetNumberOfTuples(5);
    filter->SetInputDataObject(data);
    FF_CHECK(fails(filter, vtkFFErrorCode::InputError, { "has 5 value(s) for 8 point(s)" }));
  }

  // Nothing else is there.
  data = makeWeighted(cubeCorners(), std::vector<double>(8, 0.0));
  markPoints(data, { hidden });
  filter->SetInputDataObject(data);
  FF_CHECK(succeeds(filter));
  FF_CHECK(isEmpty(filter->GetOutputDataObject(0)));
  FF_CHECK_EQUAL(filter->GetDimension(), -1);

  // Not a mark for each point.
  markPoints(data, { 0, hidden }, false);
  data->Modified();
  FF_CHECK(fails(filter, vtkFFErrorCode::InputError,
    { "The point array vtkGhostType has 2 value(s) for 8 point(s)" }));
  filter->SetSkipGhostPoints(false);
  FF_CHECK(succeeds(filter));
  FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), vtkIdType(8));

  // VTK's own way to hide points.
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(2, 2, 2);
  grid->SetPoints(data->GetPoints());
  grid->BlankPoint(7);
  grid->GetPointData()->AddArray(data->GetPointData()->GetArray("weights"));
  filter->SetInputDataObject(grid);
  filter->SetSkipGhostPoints(true);
  FF_CHECK(succeeds(filter));
  FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), vtkIdType(7));
}

/// Ids of one hull count the ghosts of all blocks.
void testAllBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeAmidGhosts());
  blocks->SetBlock(1, makePoints({ { 5, 5, 5 } }));
  blocks->SetBlock(2, makeAmidGhosts());
  vtkNew<vtkFFHullFilter> hull;
  hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  hull->SetVisiblePointIds(true);
  hull->SetInputData(blocks);
  FF_CHECK(succeeds(hull));
  const Ids ids = originalIds(hull->GetOutput());
  FF_CHECK((ids == Ids{ 1, 3, 4, 6, 8 }));
  vtkDataArray* const index = hull->GetOutput()->GetPointData()->GetArray("BlockIndex");
  vtkDataArray* const visible = hull->GetOutput()->GetPointData()->GetArray("OriginalPointIds");
  const vtkIdType last = vtkIdType(ids.size()) - 1;
  FF_CHECK(index && index->GetTuple1(last - 1) == 1 && index->GetTuple1(last) == 2);
  FF_CHECK(visible && visible->GetTuple1(last) == 8);

  // One without a mark for each point is named.
  markPoints(vtkDataSet::SafeDownCast(blocks->GetBlock(1)), { 0, hidden }, false);
  FF_CHECK(failsInPart((hull->Modified(), hull), vtkFFErrorCode::InputError,
    { "The point array vtkGhostType of the block of flat index 2 has 2 value(s) for 1 "
      "point(s)." }));
  hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_EACH_BLOCK);
  FF_CHECK(failsInPart(hull, vtkFFErrorCode::InputError,
    { "The point array vtkGhostType of data set 1 of the composite has 2 value(s)" }));
  vtkNew<vtkFFSelectEnclosedPoints> queries;
  queries->SetInputData(makePoints(cubeCorners()));
  queries->SetSurfaceData(blocks->GetBlock(1));
  FF_CHECK(failsInPart(queries, vtkFFErrorCode::InputError,
    { "The point array vtkGhostType of the surface has 2 value(s) for 1 point(s)." }));
}

/// Marks of points mean other things for cells, so they are translated. Points that are counted all
/// the same keep theirs.
void testMarksOfCells()
{
  auto data = makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } });
  const std::vector<int> marks{ 0, duplicate, hidden, duplicate | hidden | 4 };
  markPoints(data, marks);
  const int ofCells[4] = { 0, vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL,
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL };
  vtkNew<vtkFFPowerDiagramFilter> diagram;
  vtkNew<vtkFFRegularTriangulationFilter> triangulation;
  for (vtkFFAlgorithm* filter :
    { static_cast<vtkFFAlgorithm*>(diagram), static_cast<vtkFFAlgorithm*>(triangulation) })
  {
    filter->SetInputDataObject(data);
    filter->SetSkipGhostPoints(false);
    FF_CHECK(succeeds(filter));
  }
  const char* const name = vtkDataSetAttributes::GhostArrayName();
  vtkPolyData* const cells = diagram->GetOutput();
  vtkDataArray* const found = cells->GetCellData()->GetArray(name);
  vtkDataArray* const kept = triangulation->GetOutput()->GetPointData()->GetArray(name);
  FF_CHECK(found && kept && found->GetNumberOfTuples() == 4 && kept->GetNumberOfTuples() == 4);
  for (int i = 0; found && kept && i < 4; ++i)
  {
    FF_CHECK_EQUAL(found->GetTuple1(i), ofCells[i]);
    FF_CHECK_EQUAL(kept->GetTuple1(i), marks[static_cast<std::size_t>(i)]);
  }
  // What vtkRemoveGhosts does: the cells of duplicate points go, those of unmarked ones stay.
  cells->RemoveGhostCells();
  const Ids ids = idsOf(diagram);
  FF_CHECK(!ids.empty() && ids[0] == 0);
  FF_CHECK(std::none_of(ids.begin(), ids.end(), [](vtkIdType id) { return id == 1 || id == 3; }));
}

}

int TestFFGhostPoints(int, char*[])
{
  for (const FilterCase& of : casesOfPoints())
  {
    testFilter(of);
  }
  testAllBlocks();
  testMarksOfCells();
  return result();
}
