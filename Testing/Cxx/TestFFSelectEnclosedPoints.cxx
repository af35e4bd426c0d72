// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that are asked about: in the hull of others, on it or outside, against integer brute
// force; for inputs of all types, in all settings.
#include "FFTest.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
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
#include <cstring>
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

/// The sides, by the planes of the triangles of the hull, in 64-bit integers.
std::vector<int> sidesOf(const std::vector<Point>& queries, vtkPolyData* hull)
{
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
    std::int64_t u[3], v[3];
    for (int k = 0; k < 3; ++k)
    {
      u[k] = p[1][k] - p[0][k];
      v[k] = p[2][k] - p[0][k];
    }
    for (std::size_t q = 0; q < queries.size(); ++q)
    {
      std::int64_t height = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        height +=
          (u[l] * v[m] - u[m] * v[l]) * (static_cast<std::int64_t>(queries[q][k]) - p[0][k]);
      }
      sides[q] = std::min(sides[q], height < 0 ? 1 : height > 0 ? -1 : 0);
    }
  }
  return sides;
}

vtkPolyData* hullOf(vtkFFHullFilter* hull, const std::vector<Point>& points)
{
  hull->SetInputData(makePoints(points));
  hull->Update();
  return hull->GetOutput();
}

/// The output's sides, after a look at its other arrays.
std::vector<int> sidesFound(Filter* filter, vtkDataSet* output)
{
  auto* sides = vtkSignedCharArray::SafeDownCast(output->GetPointData()->GetArray("FlipFlopSide"));
  auto* selected =
    vtkUnsignedCharArray::SafeDownCast(output->GetPointData()->GetArray("SelectedPoints"));
  auto* distances =
    vtkDoubleArray::SafeDownCast(output->GetPointData()->GetArray("FlipFlopDistance"));
  FF_CHECK(sides && selected);
  FF_CHECK_EQUAL(distances != nullptr, filter->GetGenerateDistances());
  FF_CHECK(output->GetPointData()->GetScalars() == selected);
  std::vector<int> found;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const int side = sides->GetValue(i);
    found.push_back(side);
    const bool enclosed = side > 0 || (side == 0 && filter->GetSelectPointsOnSurface());
    FF_CHECK_EQUAL(int(selected->GetValue(i)), int(enclosed != filter->GetInsideOut()));
    FF_CHECK_EQUAL(filter->IsInside(i), int(selected->GetValue(i)));
    FF_CHECK_EQUAL(filter->IsInsideSurface(output->GetPoint(i)), int(enclosed));
    if (distances)
    {
      const double distance = distances->GetValue(i);
      FF_CHECK_EQUAL(side, distance < 0 ? 1 : distance > 0 ? -1 : 0);
    }
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
    vtkNew<vtkFFHullFilter> hull;
    const auto expected = sidesOf(queries, hullOf(hull, surface));
    for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_LONG_LONG })
    {
      vtkNew<Filter> filter;
      const auto errors = ErrorObserver::Of(filter);
      filter->SetInputData(makePoints(queries, type));
      filter->SetSurfaceData(makePoints(surface, type));
      filter->Update();
      FF_CHECK(sidesFound(filter, filter->GetPolyDataOutput()) == expected);
      FF_CHECK_EQUAL(filter->GetDimension(), 3);
      FF_CHECK(errors->Messages.empty());
    }
  }
}

void testSettings()
{
  const auto surface = integerPoints(100, 63, 4.0);
  const auto queries = integerPoints(400, 64, 5.0);
  vtkNew<vtkFFHullFilter> hull;
  const auto expected = sidesOf(queries, hullOf(hull, surface));
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints(queries));
  filter->SetSurfaceData(makePoints(surface));
  for (int settings = 0; settings < 8; ++settings)
  {
    filter->SetInsideOut((settings & 1) != 0);
    filter->SetSelectPointsOnSurface((settings & 2) != 0);
    filter->SetGenerateDistances((settings & 4) != 0);
    filter->Update();
    FF_CHECK(sidesFound(filter, filter->GetPolyDataOutput()) == expected);
  }
  // How far from the unit cube.
  filter->SetInputData(makePoints(
    { { 0.5, 0.5, 0.5 }, { 0.5, 0.25, 0.5 }, { 0.5, 0.5, 1.0 }, { 4, 5, 0.5 }, { 1, 1, 3 } }));
  filter->SetSurfaceData(makePoints(cubeCorners()));
  filter->Update();
  const double distances[] = { -0.5, -0.25, 0.0, 5.0, 2.0 };
  for (vtkIdType i = 0; i < 5; ++i)
  {
    FF_CHECK_EQUAL(
      filter->GetPolyDataOutput()->GetPointData()->GetArray("FlipFlopDistance")->GetComponent(i, 0),
      distances[i]);
  }
}

/// The same bits for any number of threads.
void testThreads()
{
  const auto surface = makePoints(randomPoints(20000, 65));
  const auto queries = makePoints(randomPoints(50000, 66));
  std::vector<double> bits;
  for (const int threads : { 1, 2, 4 })
  {
    vtkNew<Filter> filter;
    filter->SetNumberOfThreads(threads);
    filter->GenerateDistancesOn();
    filter->SetInputData(queries);
    filter->SetSurfaceData(surface);
    filter->Update();
    vtkPointData* data = filter->GetPolyDataOutput()->GetPointData();
    std::vector<double> found;
    for (const char* name : { "FlipFlopDistance", "FlipFlopSide", "SelectedPoints" })
    {
      for (vtkIdType i = 0; i < queries->GetNumberOfPoints(); ++i)
      {
        found.push_back(data->GetArray(name)->GetComponent(i, 0));
      }
    }
    bits = bits.empty() ? found : bits;
    FF_CHECK(std::memcmp(bits.data(), found.data(), bits.size() * sizeof(double)) == 0);
  }
}

/// What the input has stays, in an output of its type.
template <class Data>
void checkPassed(vtkSmartPointer<Data> input, const std::vector<int>& expected)
{
  vtkNew<vtkIntArray> own;
  own->SetName("own");
  own->SetNumberOfValues(input->GetNumberOfPoints());
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
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputData(input);
  filter->SetSurfaceData(makePoints(cubeCorners()));
  filter->Update();
  auto* output = Data::SafeDownCast(filter->GetOutput());
  FF_CHECK(output && std::strcmp(output->GetClassName(), input->GetClassName()) == 0);
  if (!output)
  {
    return;
  }
  FF_CHECK_EQUAL(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  FF_CHECK_EQUAL(output->GetNumberOfCells(), input->GetNumberOfCells());
  FF_CHECK(output->GetPointData()->GetArray("own") == own);
  FF_CHECK(output->GetCellData()->GetArray("ofCells") == ofCells);
  FF_CHECK(output->GetFieldData()->HasArray("ofField"));
  FF_CHECK(sidesFound(filter, output) == expected);
  FF_CHECK(errors->Messages.empty());
  // The input's own data is not touched.
  FF_CHECK_EQUAL(input->GetPointData()->GetNumberOfArrays(), 1);
  FF_CHECK(input->GetPointData()->GetScalars() == own);
}

void testTypes()
{
  // Along x: outside, on, inside, on, outside.
  const std::vector<int> expected{ -1, 0, 1, 0, -1 };
  std::vector<Point> line;
  for (int i = -1; i < 4; ++i)
  {
    line.push_back({ 0.5 * i, 0.5, 0.25 });
  }
  const auto points = makePoints(line);
  checkPassed(points, expected);

  auto cells = vtkSmartPointer<vtkUnstructuredGrid>::New();
  cells->SetPoints(points->GetPoints());
  const vtkIdType ends[2] = { 0, 1 };
  cells->InsertNextCell(VTK_LINE, 2, ends);
  checkPassed(cells, expected);

  auto curved = vtkSmartPointer<vtkStructuredGrid>::New();
  curved->SetDimensions(5, 1, 1);
  curved->SetPoints(points->GetPoints());
  checkPassed(curved, expected);

  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-1, 3, 2, 2, 1, 1);
  image->SetSpacing(0.5, 0.25, 0.25);
  checkPassed(image, expected);

  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(5, 1, 1);
  vtkNew<vtkDoubleArray> x, y, z;
  for (const Point& point : line)
  {
    x->InsertNextValue(point[0]);
  }
  y->InsertNextValue(0.5);
  z->InsertNextValue(0.25);
  grid->SetXCoordinates(x);
  grid->SetYCoordinates(y);
  grid->SetZCoordinates(z);
  checkPassed(grid, expected);
}

/// A surface may be anything with points.
void testSurfaces()
{
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints({ { 1, 1, 1 }, { 0, 1, 1 }, { 3, 1, 1 } }));
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  filter->SetSurfaceData(image);
  filter->Update();
  FF_CHECK(filter->GetSurface() == image);
  FF_CHECK(sidesFound(filter, filter->GetPolyDataOutput()) == (std::vector<int>{ 1, 0, -1 }));

  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(makePoints(cubeCorners()));
  filter->SetSurfaceConnection(hull->GetOutputPort());
  filter->Update();
  FF_CHECK(sidesFound(filter, filter->GetPolyDataOutput()) == (std::vector<int>{ 0, 0, -1 }));

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
    filter->Update();
    FF_CHECK(
      sidesFound(filter, filter->GetPolyDataOutput()) == expected[static_cast<std::size_t>(i)]);
    FF_CHECK_EQUAL(filter->GetDimension(), 2 - i);
  }
  auto* distances = filter->GetPolyDataOutput()->GetPointData()->GetArray("FlipFlopDistance");
  FF_CHECK_EQUAL(distances->GetComponent(0, 0), std::numeric_limits<double>::infinity());

  // No point to ask about.
  vtkNew<vtkPolyData> none;
  filter->SetInputData(none);
  filter->SetSurfaceData(makePoints(cubeCorners()));
  filter->Update();
  FF_CHECK_EQUAL(filter->GetPolyDataOutput()->GetNumberOfPoints(), 0);
  FF_CHECK(filter->GetPolyDataOutput()->GetPointData()->HasArray("SelectedPoints"));
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
}

}

int TestFFSelectEnclosedPoints(int, char*[])
{
  testBruteForce();
  testSettings();
  testThreads();
  testTypes();
  testSurfaces();
  testSinglePoints();
  return result();
}
