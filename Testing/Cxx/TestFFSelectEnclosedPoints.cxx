// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that are asked about: in the hull of others, on it or outside, against integer brute
// force; for inputs of all types, in all settings.
#include "FFTest.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSignedCharArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdint>
#include <limits>

using namespace fftest;

namespace
{

using Filter = vtkFFSelectEnclosedPoints;

/// Points of small integers, so that many are on the surface.
std::vector<Point> integerPoints(int count, unsigned int seed, double size)
{
  auto points = randomPoints(count, seed);
  for (Point& point : points)
  {
    for (double& x : point)
    {
      x = std::floor(x * size);
    }
  }
  return points;
}

/// The sides, by the planes of the triangles of the points' hull, in 64-bit integers.
std::vector<int> sidesOf(const std::vector<Point>& queries, const std::vector<Point>& surface)
{
  vtkNew<vtkFFHullFilter> filter;
  filter->SetInputData(makePoints(surface));
  filter->Update();
  vtkPolyData* const hull = filter->GetOutput();
  std::vector<int> sides(queries.size(), 1);
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < hull->GetNumberOfCells(); ++i)
  {
    hull->GetCellPoints(i, corners);
    std::int64_t p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      const double* x = hull->GetPoint(corners->GetId(k));
      std::copy(x, x + 3, p[k]);
    }
    for (std::size_t q = 0; q < queries.size(); ++q)
    {
      std::int64_t height = 0;
      for (int k = 0; k < 3; ++k)
      {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        height +=
          ((p[1][l] - p[0][l]) * (p[2][m] - p[0][m]) - (p[1][m] - p[0][m]) * (p[2][l] - p[0][l])) *
          (static_cast<std::int64_t>(queries[q][static_cast<std::size_t>(k)]) - p[0][k]);
      }
      sides[q] = std::min(sides[q], height < 0 ? 1 : height > 0 ? -1 : 0);
    }
  }
  return sides;
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

void testBruteForce()
{
  for (const double size : { 3.0, 10.0, 1000.0 })
  {
    const auto surface = integerPoints(200, 61, size);
    auto queries = integerPoints(300, 62, 1.2 * size);
    queries.insert(queries.end(), surface.begin(), surface.end());
    const auto expected = sidesOf(queries, surface);
    for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_LONG_LONG })
    {
      vtkNew<Filter> filter;
      filter->SetInputData(makePoints(queries, type));
      filter->SetSurfaceData(makePoints(surface, type));
      FF_CHECK(sidesFound(filter) == expected);
      FF_CHECK_EQUAL(filter->GetDimension(), 3);
    }
  }
}

void testSettings()
{
  const auto surface = integerPoints(100, 63, 4.0);
  const auto queries = integerPoints(400, 64, 5.0);
  const auto expected = sidesOf(queries, surface);
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints(queries));
  filter->SetSurfaceData(makePoints(surface));
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
  vtkNew<vtkIntArray> own;
  own->SetName("own");
  own->SetNumberOfValues(5);
  own->Fill(7);
  input->GetPointData()->SetScalars(own);
  vtkNew<vtkIntArray> ofCells;
  ofCells->SetName("ofCells");
  ofCells->SetNumberOfValues(input->GetNumberOfCells());
  ofCells->Fill(8);
  input->GetCellData()->AddArray(ofCells);
  vtkNew<vtkIntArray> ofField;
  ofField->SetName("ofField");
  input->GetFieldData()->AddArray(ofField);

  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetSurfaceData(makePoints(cubeCorners()));
  // Along x: outside, on, inside, on, outside.
  FF_CHECK(sidesFound(filter) == (std::vector<int>{ -1, 0, 1, 0, -1 }));
  vtkDataSet* const output = filter->GetOutput();
  FF_CHECK_EQUAL(std::string(output->GetClassName()), input->GetClassName());
  for (const char* name : { "FlipFlopSide", "SelectedPoints" })
  {
    output->GetPointData()->RemoveArray(name);
  }
  output->GetPointData()->SetScalars(own);
  FF_CHECK(isIdentical(output, input, input->GetClassName()));
  FF_CHECK_EQUAL(input->GetPointData()->GetNumberOfArrays(), 1); // it is not touched
}

void testTypes()
{
  std::vector<Point> line;
  vtkNew<vtkDoubleArray> x, y, z;
  for (int i = -1; i < 4; ++i)
  {
    line.push_back({ 0.5 * i, 0.5, 0.25 });
    x->InsertNextValue(0.5 * i);
  }
  y->InsertNextValue(0.5);
  z->InsertNextValue(0.25);
  const auto points = makePoints(line);
  checkPassed(points);

  vtkNew<vtkUnstructuredGrid> cells;
  cells->SetPoints(points->GetPoints());
  const vtkIdType ends[2] = { 0, 1 };
  cells->InsertNextCell(VTK_LINE, 2, ends);
  checkPassed(cells);

  vtkNew<vtkStructuredGrid> curved;
  curved->SetDimensions(5, 1, 1);
  curved->SetPoints(points->GetPoints());
  checkPassed(curved);

  vtkNew<vtkImageData> image;
  image->SetExtent(-1, 3, 2, 2, 1, 1);
  image->SetSpacing(0.5, 0.25, 0.25);
  checkPassed(image);

  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(5, 1, 1);
  grid->SetXCoordinates(x);
  grid->SetYCoordinates(y);
  grid->SetZCoordinates(z);
  checkPassed(grid);
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

  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(makePoints(cubeCorners()));
  filter->SetSurfaceConnection(hull->GetOutputPort());
  FF_CHECK(sidesFound(filter) == (std::vector<int>{ 0, 0, -1 }));

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
  auto* distances = filter->GetPolyDataOutput()->GetPointData()->GetArray("FlipFlopDistance");
  FF_CHECK_EQUAL(distances->GetComponent(0, 0), std::numeric_limits<double>::infinity());

  // No point to ask about.
  vtkNew<vtkPolyData> none;
  filter->SetInputData(none);
  filter->SetSurfaceData(makePoints(cubeCorners()));
  FF_CHECK(sidesFound(filter).empty());
}

void testSinglePoints()
{
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  FF_CHECK_EQUAL(filter->IsInsideSurface(0.5, 0.5, 0.5), 0);
  FF_CHECK(
    errors->Has("There is no surface to ask about: call Initialize() or update the filter first."));
  errors->Clear();
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
  testBruteForce();
  testSettings();
  testTypes();
  testSurfaces();
  testSinglePoints();
  return result();
}
