// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that are asked about: in the hull of others, on it or outside; for inputs of all types, in
// all settings. TestFFQueryAlgorithm has the rest.
#include "FFTest.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSignedCharArray.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>

using namespace fftest;

namespace
{

using Filter = vtkFFSelectEnclosedPoints;

/// The tips of an octahedron.
std::vector<Point> tips(double size)
{
  return { { size, 0, 0 }, { -size, 0, 0 }, { 0, size, 0 }, { 0, -size, 0 }, { 0, 0, size },
    { 0, 0, -size } };
}

/// Points of small integers, of which many are on the octahedron; with their sides.
std::vector<Point> integerPoints(double size, std::vector<int>& sides)
{
  auto points = randomPoints(500, 61);
  for (Point& point : points)
  {
    double height = size;
    for (double& x : point)
    {
      x = std::floor(x * 1.2 * size);
      height -= std::fabs(x);
    }
    sides.push_back(height > 0 ? 1 : height < 0 ? -1 : 0);
  }
  return points;
}

/// The sides of an update that goes well, after a look at its other arrays.
std::vector<int> sidesFound(Filter* filter)
{
  FF_CHECK(succeeds(filter));
  vtkDataSet* const output = filter->GetOutput();
  vtkPointData* const data = output->GetPointData();
  auto* sides = vtkSignedCharArray::SafeDownCast(data->GetArray("FlipFlopSide"));
  auto* selected = vtkUnsignedCharArray::SafeDownCast(data->GetArray("SelectedPoints"));
  auto* distances = vtkDoubleArray::SafeDownCast(data->GetArray("FlipFlopDistance"));
  FF_CHECK(sides && selected && data->GetScalars() == selected);
  FF_CHECK_EQUAL(distances != nullptr, filter->GetGenerateDistances());
  std::vector<int> found;
  for (vtkIdType i = 0; sides && selected && i < output->GetNumberOfPoints(); ++i)
  {
    const int side = sides->GetValue(i);
    found.push_back(side);
    const bool enclosed = side > 0 || (side == 0 && filter->GetSelectPointsOnSurface());
    FF_CHECK_EQUAL(int(selected->GetValue(i)), int(enclosed != filter->GetInsideOut()));
    FF_CHECK_EQUAL(filter->IsInside(i), int(selected->GetValue(i)));
    FF_CHECK_EQUAL(filter->IsInsideSurface(output->GetPoint(i)), int(enclosed));
    const double distance = distances ? distances->GetValue(i) : -side;
    FF_CHECK_EQUAL(side, distance < 0 ? 1 : distance > 0 ? -1 : 0);
  }
  FF_CHECK_EQUAL(filter->IsInside(-1), 0);
  FF_CHECK_EQUAL(filter->IsInside(output->GetNumberOfPoints()), 0);
  return found;
}

void testSides()
{
  std::vector<int> expected;
  const auto points = integerPoints(10.0, expected);
  for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_LONG_LONG })
  {
    vtkNew<Filter> filter;
    filter->SetInputData(makePoints(points, type));
    filter->SetSurfaceData(makePoints(tips(10.0), type));
    FF_CHECK(sidesFound(filter) == expected);
    FF_CHECK_EQUAL(filter->GetDimension(), 3);
  }
}

void testSettings()
{
  std::vector<int> expected;
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints(integerPoints(4.0, expected)));
  filter->SetSurfaceData(makePoints(tips(4.0)));
  for (int settings = 0; settings < 8; ++settings)
  {
    filter->SetInsideOut((settings & 1) != 0);
    filter->SetSelectPointsOnSurface((settings & 2) != 0);
    filter->SetGenerateDistances((settings & 4) != 0);
    FF_CHECK(sidesFound(filter) == expected);
  }
  // How far from the unit cube.
  filter->SetInputData(makePoints(
    { { 0.5, 0.5, 0.5 }, { 0.5, 0.25, 0.5 }, { 0.5, 0.5, 1.0 }, { 4, 5, 0.5 }, { 1, 1, 3 } }));
  filter->SetSurfaceData(makePoints(cubeCorners()));
  const double distances[] = { -0.5, -0.25, 0.0, 5.0, 2.0 };
  sidesFound(filter);
  for (vtkIdType i = 0; i < 5; ++i)
  {
    FF_CHECK_EQUAL(
      filter->GetPolyDataOutput()->GetPointData()->GetArray("FlipFlopDistance")->GetComponent(i, 0),
      distances[i]);
  }
}

/// What the input has stays, in an output of its type.
void checkPassed(vtkDataSet* input)
{
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::FIELD })
  {
    vtkNew<vtkIntArray> own;
    own->SetName("own");
    own->SetNumberOfValues(type == vtkDataObject::FIELD ? 1 : input->GetNumberOfElements(type));
    own->Fill(7);
    input->GetAttributesAsFieldData(type)->AddArray(own);
  }
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetSurfaceData(makePoints(cubeCorners()));
  // Along x: outside, on, inside, on, outside.
  FF_CHECK(sidesFound(filter) == (std::vector<int>{ -1, 0, 1, 0, -1 }));
  FF_CHECK_EQUAL(input->GetPointData()->GetNumberOfArrays(), 1); // it is not touched
  vtkDataSet* const output = filter->GetOutput();
  output->GetPointData()->RemoveArray("FlipFlopSide");
  output->GetPointData()->RemoveArray("SelectedPoints");
  FF_CHECK(isIdentical(output, input, input->GetClassName()));
}

void testTypes()
{
  vtkNew<vtkImageData> image;
  image->SetExtent(-1, 3, 2, 2, 1, 1);
  image->SetSpacing(0.5, 0.25, 0.25);
  std::vector<Point> line;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    line.emplace_back();
    image->GetPoint(i, line.back().data());
  }
  vtkNew<vtkUnstructuredGrid> cells;
  cells->SetPoints(makePoints(line)->GetPoints());
  const vtkIdType ends[2] = { 0, 1 };
  cells->InsertNextCell(VTK_LINE, 2, ends);
  checkPassed(cells);
  checkPassed(image);
}

/// A surface may be anything with points.
void testSurfaces()
{
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints({ { 1, 1, 1 }, { 0, 1, 1 }, { 3, 1, 1 } }));
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  filter->SetSurfaceData(image);
  FF_CHECK(filter->GetSurface() == image);
  FF_CHECK(sidesFound(filter) == (std::vector<int>{ 1, 0, -1 }));

  vtkNew<vtkSphereSource> sphere;
  filter->SetSurfaceConnection(sphere->GetOutputPort());
  FF_CHECK(sidesFound(filter) == (std::vector<int>{ -1, -1, -1 }));

  // In a plane, on a line, at a point, and none.
  const std::vector<Point> queries{ { 1, 1, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, { 0, 0, 1 } };
  const std::vector<std::vector<Point>> flat{ { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } },
    { { 0, 0, 0 }, { 4, 0, 0 } }, { { 0, 0, 0 } }, {} };
  const std::vector<std::vector<int>> expected{ { 0, 0, 0, -1 }, { -1, 0, 0, -1 },
    { -1, -1, 0, -1 }, { -1, -1, -1, -1 } };
  filter->SetInputData(makePoints(queries));
  filter->GenerateDistancesOn();
  for (int i = 0; i < 4; ++i)
  {
    filter->SetSurfaceData(makePoints(flat[static_cast<std::size_t>(i)]));
    FF_CHECK(sidesFound(filter) == expected[static_cast<std::size_t>(i)]);
    FF_CHECK_EQUAL(filter->GetDimension(), 2 - i);
  }
  const auto distance = [&](vtkIdType id) {
    return filter->GetOutput()->GetPointData()->GetArray("FlipFlopDistance")->GetComponent(id, 0);
  };
  FF_CHECK_EQUAL(distance(0), std::numeric_limits<double>::infinity());

  // A point that is not finite; none at all; a composite.
  filter->SetNonFinitePoints(vtkFFQueryAlgorithm::NON_FINITE_IGNORE);
  filter->SetInputData(makePoints({ { 0, std::nan(""), 0 } }));
  FF_CHECK(succeeds(filter) && std::isnan(distance(0)) && !filter->IsInside(0));
  vtkNew<vtkPolyData> none;
  filter->SetInputData(none);
  filter->SetSurfaceData(makePoints(cubeCorners()));
  FF_CHECK(sidesFound(filter).empty());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(queries));
  blocks->SetBlock(1, makePoints(queries));
  filter->SetInputData(blocks);
  FF_CHECK(succeeds(filter) && !filter->IsInside(0));
  // What the last run selected, the output has, as long as it is there.
  filter->SetInputData(makePoints({ { 0.5, 0.5, 0.5 } }));
  FF_CHECK(succeeds(filter) && filter->IsInside(0));
  filter->Complete();
  FF_CHECK(filter->IsInside(0));
  filter->GetOutput()->Initialize();
  FF_CHECK(!filter->IsInside(0));
}

void testSinglePoints()
{
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  const vtkMTimeType time = filter->GetMTime();
  FF_CHECK_EQUAL(filter->IsInsideSurface(0.5, 0.5, 0.5), 0);
  FF_CHECK_EQUAL(filter->GetMTime(), time);
  FF_CHECK(
    errors->Has("There is no surface to ask about: call Initialize() or update the filter first."));
  errors->Clear();
  vtkNew<ProgressObserver> progress;
  progress->AbortAt = 0.0; // stops a run, but this is none
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  filter->Initialize(makePoints(cubeCorners()));
  FF_CHECK_EQUAL(filter->IsInsideSurface(0.5, 0.5, 0.5), 1);
  FF_CHECK_EQUAL(filter->IsInsideSurface(0.5, 0.5, 1.0), 1);
  FF_CHECK_EQUAL(filter->IsInsideSurface(0.5, 0.5, 1.0 + 0x1p-52), 0);
  FF_CHECK_EQUAL(filter->IsInsideSurface(0.5, 0.5, std::nan("")), 0);
  filter->SelectPointsOnSurfaceOff();
  FF_CHECK_EQUAL(filter->IsInsideSurface(0.5, 0.5, 1.0), 0);
  FF_CHECK_EQUAL(filter->IsInsideSurface(0.5, 0.5, 1.0 - 0x1p-53), 1);
  FF_CHECK(errors->Messages.empty());
  filter->Complete();
  FF_CHECK_EQUAL(filter->IsInsideSurface(0.5, 0.5, 0.5), 0);
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  errors->Clear();
  filter->Initialize(nullptr);
  FF_CHECK(errors->Has("There is no surface. Set one."));
  FF_CHECK_EQUAL(filter->GetErrorCode(), vtkFFErrorCode::InputError);
}

}

int TestFFSelectEnclosedPoints(int, char*[])
{
  testSides();
  testSettings();
  testTypes();
  testSurfaces();
  testSinglePoints();
  return result();
}
