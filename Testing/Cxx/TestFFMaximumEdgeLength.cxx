// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells with an edge longer than a limit are left out, and nothing else: points, hidden points and
// the power diagram stay.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <cmath>
#include <limits>
#include <set>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

std::vector<Point> latticeWithGaps()
{
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i)
  {
    const int x = i % 20;
    const int y = i / 20;
    if (x * x * 7 % 11 != y % 5)
    {
      points.push_back({ double(x), double(y), double(i * i % 13) });
    }
  }
  return points;
}

/// The square of a cell's longest edge; exact for small integers.
double longest(vtkPolyData* output, const std::vector<vtkIdType>& cell, const Point& scale)
{
  double most = 0.0;
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    double p[3];
    double q[3];
    output->GetPoint(cell[i], p);
    output->GetPoint(cell[(i + 1) % cell.size()], q);
    const double x = scale[0] * (p[0] - q[0]);
    const double y = scale[1] * (p[1] - q[1]);
    const double z = scale[2] * (p[2] - q[2]);
    most = std::max(most, x * x + y * y + z * z);
  }
  return most;
}

std::vector<std::vector<vtkIdType>> cellsOf(vtkCellArray* cells)
{
  std::vector<std::vector<vtkIdType>> found;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(i, size, corners);
    found.emplace_back(corners, corners + size);
  }
  return found;
}

/// With the filter as it is set, all cells but those with a longer edge; lengths by the scale.
void expectWithin(
  Filter* filter, double limit, const Point& scale, const std::vector<int>& threads = { 0 })
{
  filter->SetMaximumEdgeLength(0.0);
  filter->Update();
  vtkNew<vtkPolyData> all;
  vtkNew<vtkPolyData> hidden;
  vtkNew<vtkPolyData> diagram;
  all->DeepCopy(filter->GetOutput());
  hidden->DeepCopy(filter->GetHiddenPointsOutput());
  diagram->DeepCopy(filter->GetPowerDiagramOutput());
  FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), vtkIdType(0));
  std::vector<std::vector<vtkIdType>> expected;
  for (const auto& cell : cellsOf(all->GetPolys()))
  {
    if (longest(all, cell, scale) <= limit * limit)
    {
      expected.push_back(cell);
    }
  }
  const vtkIdType count = all->GetNumberOfCells();
  all->GetPolys()->Initialize();
  all->GetCellData()->Initialize();
  filter->SetMaximumEdgeLength(limit);
  for (const int number : threads)
  {
    filter->SetNumberOfThreads(number);
    filter->Update();
    FF_CHECK(cellsOf(filter->GetOutput()->GetPolys()) == expected);
    FF_CHECK_EQUAL(
      filter->GetNumberOfDroppedCells(), count - static_cast<vtkIdType>(expected.size()));
    filter->GetOutput()->GetPolys()->Initialize();
    filter->GetOutput()->GetCellData()->Initialize();
    FF_CHECK(isSame(filter->GetOutput(), all));
    FF_CHECK(isIdentical(filter->GetHiddenPointsOutput(), hidden, "hidden"));
    FF_CHECK(!filter->GetGeneratePowerDiagram() ||
      isIdentical(filter->GetPowerDiagramOutput(), diagram, "diagram"));
  }
}

void testLimits()
{
  const auto input = makePoints(latticeWithGaps());
  for (const bool polygons : { false, true })
  {
    for (const bool diagram : { false, true })
    {
      vtkNew<Filter> filter;
      const auto errors = ErrorObserver::Of(filter);
      filter->SetInputData(input);
      filter->SetFacetMode(polygons);
      filter->SetGeneratePowerDiagram(diagram);
      // At ties, sqrt(5) rounds up and sqrt(2) too: not to be longer is not to be as long.
      for (const double limit : { 1.0, std::nextafter(1.0, 0.0), std::sqrt(2.0), 2.0,
             std::sqrt(5.0), std::nextafter(std::sqrt(5.0), 0.0), 3.0, 1e300 })
      {
        expectWithin(filter, limit, { 1, 1, 0 }, { 1, 4 });
      }
      filter->SetMaximumEdgeLength(std::numeric_limits<double>::infinity());
      filter->Update();
      FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), vtkIdType(0));
      filter->SetMaximumEdgeLength(1e-300);
      filter->Update();
      FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), vtkIdType(0));
      FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), input->GetNumberOfPoints());
      FF_CHECK(filter->GetNumberOfDroppedCells() > 100);
      FF_CHECK_EQUAL(filter->GetDimension(), 2);
      FF_CHECK(errors->Messages.empty());
    }
  }
}

/// In the plane of the triangulation: after the transform, in the fitted plane.
void testPlanes()
{
  vtkNew<Filter> filter;
  std::vector<Point> points = latticeWithGaps();
  for (Point& p : points)
  {
    p[2] = 0.0;
  }
  filter->SetInputData(makePoints(points));
  filter->SetProjectionPlaneModeToBestFittingPlane();
  expectWithin(filter, 1.5, { 1, 1, 1 });
  vtkNew<vtkTransform> transform;
  transform->Scale(2.0, 0.5, 1.0);
  filter->SetTransform(transform);
  expectWithin(filter, 2.0, { 2, 0.5, 0 });
  expectWithin(filter, 2.5, { 2, 0.5, 0 });
}

/// Cells' data is of those that are left; the report counts the others, over all blocks.
void testReport()
{
  const auto points = latticeWithGaps();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(points));
  blocks->SetBlock(1, makePoints(points));
  vtkNew<Filter> filter;
  filter->GenerateCellMeasuresOn();
  filter->ReportAsFieldDataOn();
  filter->SetMaximumEdgeLength(1.5);
  filter->SetInputData(blocks);
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkIdType dropped = 0;
  for (unsigned int i = 0; i < 2; ++i)
  {
    auto* block = vtkPolyData::SafeDownCast(output->GetBlock(i));
    vtkDataArray* areas = block->GetCellData()->GetArray("Area");
    FF_CHECK_EQUAL(areas->GetNumberOfTuples(), block->GetNumberOfCells());
    FF_CHECK_EQUAL(areas->GetRange()[0], 0.5);
    FF_CHECK_EQUAL(areas->GetRange()[1], 0.5);
    dropped +=
      static_cast<vtkIdType>(block->GetFieldData()->GetArray("FlipFlopDroppedCells")->GetTuple1(0));
  }
  FF_CHECK(dropped > 0);
  FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), dropped);
  filter->SetMaximumEdgeLength(0.0);
  filter->Update();
  FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), vtkIdType(0));
}

/// Lines are cells, too; a vertex has no edge.
void testLowDimensions()
{
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetMaximumEdgeLength(2.0);
  filter->SetInputData(makePoints({ { 0, 0, 5 }, { 1, 0, 5 }, { 4, 0, 5 }, { 6, 0, 5 } }));
  filter->Update();
  FF_CHECK((cellsByOriginalIds(filter->GetOutput(), filter->GetOutput()->GetLines()) ==
    std::vector<std::vector<vtkIdType>>{ { 0, 1 }, { 2, 3 } }));
  FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), vtkIdType(1));
  filter->SetInputData(makePoints({ { 0, 0, 5 } }));
  filter->Update();
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfVerts(), vtkIdType(1));
  filter->SetInputData(makePoints(std::vector<Point>{}));
  filter->Update();
  FF_CHECK(errors->Messages.empty());
}

void testErrors()
{
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputData(makePoints(latticeWithGaps()));
  FF_CHECK_EQUAL(filter->GetMaximumEdgeLength(), 0.0);
  for (const double limit :
    { -1.0, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    errors->Clear();
    filter->SetMaximumEdgeLength(limit);
    filter->Modified();
    filter->Update();
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
    FF_CHECK(errors->Has("Maximum Edge Length is "));
    FF_CHECK(isEmpty(filter->GetOutput()));
  }
  errors->Clear();
  filter->SetMaximumEdgeLength(-0.0);
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK_EQUAL(filter->GetNumberOfDroppedCells(), vtkIdType(0));
}

}

int TestFFMaximumEdgeLength(int, char*[])
{
  testLimits();
  testPlanes();
  testReport();
  testLowDimensions();
  testErrors();
  return result();
}
