// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Constraints of a second input that cross are split, if that is asked for, with new points.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;
using Ids = std::vector<vtkIdType>;

vtkSmartPointer<vtkPolyData> makeSource(
  std::initializer_list<Ids> lines, std::initializer_list<Ids> polygons = {})
{
  auto source = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> cells[2];
  int k = 0;
  for (const auto& from : { lines, polygons })
  {
    for (const Ids& ids : from)
    {
      cells[k]->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    ++k;
  }
  source->SetLines(cells[0]);
  source->SetPolys(cells[1]);
  return source;
}

vtkSmartPointer<Filter> splitting(vtkDataObject* input, vtkDataObject* source)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(input);
  filter->SetSourceData(source);
  filter->SplitCrossingConstraintsOn();
  filter->ReportAsFieldDataOn();
  return filter;
}

std::array<double, 3> placeOf(vtkPolyData* output, vtkIdType id)
{
  std::array<double, 3> x;
  output->GetPoint(id, x.data());
  return x;
}

vtkIdType reported(vtkPolyData* output)
{
  auto* array =
    vtkIdTypeArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("FlipFlopSplitPoints"));
  return array ? array->GetValue(0) : -7;
}

// Lines from (0, 0) to (3, 1), and from (0, 1) to (1, 0): they cross at x = 3 / 4.
const std::vector<Point> four = { { 0, 0, 8 }, { 3, 1, 0 }, { 0, 1, 0 }, { 1, 0, 0 } };

void testPoints()
{
  const auto input = makePoints(four);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("height");
  vtkNew<vtkStringArray> names;
  names->SetName("name");
  for (const Point& p : four)
  {
    heights->InsertNextValue(p[2] + 1);
    names->InsertNextValue(std::to_string(p[2]));
  }
  input->GetPointData()->SetScalars(heights);
  input->GetPointData()->AddArray(names);
  const auto filter = splitting(input, makeSource({ { 0, 1 }, { 3, 2 } }));
  FF_CHECK(filter->GetSplitCrossingConstraints());
  filter->Update();
  vtkPolyData* const output = filter->GetOutput();
  FF_CHECK_EQUAL(filter->GetNumberOfSplitPoints(), vtkIdType(1));
  FF_CHECK_EQUAL(reported(output), vtkIdType(1));
  FF_CHECK_EQUAL(output->GetNumberOfPoints(), vtkIdType(5));
  FF_CHECK_EQUAL(output->GetNumberOfPolys(), vtkIdType(4));
  FF_CHECK(placeOf(output, 4) == (std::array<double, 3>{ 0.75, 0.25, 6 }));
  FF_CHECK((originalIds(output) == Ids{ 0, 1, 2, 3, -1 }));
  FF_CHECK(output->GetPointData()->GetScalars() != nullptr);
  FF_CHECK_EQUAL(output->GetPointData()->GetArray("height")->GetComponent(4, 0), 7.0);
  FF_CHECK_EQUAL(output->GetPointData()->GetArray("height")->GetComponent(0, 0), 9.0);
  FF_CHECK(output->GetPointData()->GetAbstractArray("name") != nullptr);

  // Along the first in the source's order.
  filter->SetSourceData(makeSource({ { 3, 2 }, { 0, 1 } }));
  filter->Update();
  FF_CHECK_EQUAL(placeOf(filter->GetOutput(), 4)[2], 0.0);

  // Without crossings, nothing is new; nor without a source.
  filter->SetSourceData(makeSource({ { 0, 1 } }));
  filter->Update();
  FF_CHECK_EQUAL(filter->GetNumberOfSplitPoints(), vtkIdType(0));
  FF_CHECK_EQUAL(reported(filter->GetOutput()), vtkIdType(0));
  FF_CHECK((originalIds(filter->GetOutput()) == Ids{ 0, 1, 2, 3 }));
  filter->SetSourceData(nullptr);
  filter->Update();
  FF_CHECK(isTriangulationOf(input, nullptr, filter));
}

/// Points of floats: the crossing is a double, so all are.
void testFloats()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (const Point& p :
    { Point{ 0, 0, 0 }, Point{ 1, 1, 0 }, Point{ 0, 1, 0 }, Point{ 0.5, 0, 0 } })
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  const auto filter = splitting(input, makeSource({ { 0, 1 }, { 2, 3 } }));
  filter->Update();
  FF_CHECK_EQUAL(filter->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  FF_CHECK(placeOf(filter->GetOutput(), 4) == (std::array<double, 3>{ 1.0 / 3, 1.0 / 3, 0 }));
}

void testPlaneAndGhosts()
{
  // Upright, laid down by a transform; the first point is a ghost.
  std::vector<Point> upright = { { 9, 9, 9 } };
  for (const Point& p : four)
  {
    upright.push_back({ p[0], 4 + p[2], p[1] });
  }
  const auto input = makePoints(upright);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  for (std::size_t i = 0; i < upright.size(); ++i)
  {
    ghosts->InsertNextValue(i == 0 ? 1 : 0);
  }
  input->GetPointData()->AddArray(ghosts);
  const auto filter = splitting(input, makeSource({ { 1, 2 }, { 3, 4 } }));
  vtkNew<vtkTransform> transform;
  transform->RotateX(-90);
  filter->SetTransform(transform);
  filter->Update();
  vtkPolyData* const output = filter->GetOutput();
  FF_CHECK((originalIds(output) == Ids{ 1, 2, 3, 4, -1 }));
  const std::array<double, 3> place = placeOf(output, 4);
  FF_CHECK(std::abs(place[0] - 0.75) < 1e-9 && std::abs(place[1] - 10) < 1e-9 &&
    std::abs(place[2] - 0.25) < 1e-9);
}

/// A line across a square: all that is inside stays, and cells have areas.
void testPolygons()
{
  const auto input = makePoints(std::vector<Point>{
    { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { -1, 1, 0 }, { 3, 1, 0 }, { 5, 5, 0 } });
  const auto filter = splitting(input, makeSource({ { 4, 5 } }, { { 0, 1, 2, 3 } }));
  filter->GenerateCellMeasuresOn();
  filter->Update();
  FF_CHECK_EQUAL(filter->GetNumberOfSplitPoints(), vtkIdType(2));
  double area = 0;
  vtkDataArray* const areas = filter->GetOutput()->GetCellData()->GetArray("Area");
  for (vtkIdType i = 0; areas && i < areas->GetNumberOfTuples(); ++i)
  {
    area += areas->GetComponent(i, 0);
  }
  FF_CHECK_EQUAL(area, 4.0);
  FF_CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), vtkIdType(4));
}

}

int TestFFCrossings(int, char*[])
{
  testPoints();
  testFloats();
  testPlaneAndGhosts();
  testPolygons();
  return result();
}
