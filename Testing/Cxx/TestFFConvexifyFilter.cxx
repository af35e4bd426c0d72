// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Star-shaped surfaces become their hulls: the same, bit for bit, as the hull filter's of their
// points.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"

#include <array>
#include <cmath>

using namespace fftest;

namespace
{

/// A sphere's triangles with radii between 0.2 and 1, moved away from the origin.
vtkSmartPointer<vtkPolyData> makeStar(int resolution, unsigned int seed, int type)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  vtkPolyData* source = sphere->GetOutput();
  const auto noise = randomPoints(static_cast<int>(source->GetNumberOfPoints()), seed);
  std::vector<Point> points;
  for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
  {
    Point p;
    source->GetPoint(i, p.data());
    const double radius = 0.6 + 0.4 * noise[static_cast<std::size_t>(i)][0];
    points.push_back({ 5.0 + radius * p[0], -3.0 + radius * p[1], 2.0 + radius * p[2] });
  }
  auto star = makePoints(points, type);
  star->SetPolys(source->GetPolys());
  return star;
}

/// The reversed cells.
vtkSmartPointer<vtkPolyData> reverse(vtkPolyData* surface)
{
  auto reversed = vtkSmartPointer<vtkPolyData>::New();
  reversed->DeepCopy(surface);
  for (vtkIdType i = 0; i < reversed->GetNumberOfCells(); ++i)
  {
    reversed->ReverseCell(i);
  }
  return reversed;
}

/// The surface becomes the hull of its points, in both facet modes, whatever the threads and the
/// variant. Returns the flips by the V-criterion, without it and with.
std::array<double, 2> checkHull(vtkPolyData* surface, const double* kernel = nullptr)
{
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(surface);
  vtkNew<vtkFFConvexifyFilter> convexify;
  convexify->SetInputData(surface);
  convexify->SetReportAsFieldData(true);
  if (kernel)
  {
    convexify->SetKernelPoint(kernel);
  }
  std::array<double, 2> flips{};
  for (const int mode : { 0, 1 })
  {
    hull->SetFacetMode(mode);
    convexify->SetFacetMode(mode);
    convexify->SetVBiased(mode);
    convexify->SetNumberOfThreads(mode ? 1 : 3);
    FF_CHECK(succeeds(hull));
    FF_CHECK(succeeds(convexify));
    FF_CHECK(isSame(convexify->GetOutput(), hull->GetOutput()));
    FF_CHECK_EQUAL(convexify->GetDimension(), 3);
    FF_CHECK(std::fabs(convexify->GetVolume() - hull->GetVolume()) <= 1e-12 * hull->GetVolume());
    flips[static_cast<std::size_t>(mode)] = reported(convexify->GetOutput(), "FlipsV");
  }
  return flips;
}

void testAgainstHull()
{
  const double kernel[3] = { 5.0, -3.0, 2.0 };
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    const auto star = makeStar(40, 5, type);
    const auto flips = checkHull(star);
    FF_CHECK(flips[0] > 0 && flips[1] > 0 && flips[0] != flips[1]); // another way
    checkHull(star, kernel);
  }
}

/// An L of three cubes: its hull is known. Turned inside out it is the same.
void testVoxels()
{
  const auto ell = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  const auto reversed = reverse(ell);
  vtkNew<vtkPolyData> narrow; // 32-bit cells
  narrow->DeepCopy(ell);
  narrow->GetPolys()->ConvertTo32BitStorage();
  for (vtkPolyData* surface : { ell.Get(), reversed.Get(), narrow.Get() })
  {
    vtkNew<vtkFFConvexifyFilter> convexify;
    convexify->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
    convexify->SetInputData(surface);
    FF_CHECK(succeeds(convexify));
    FF_CHECK(isHullOf(surface, convexify->GetOutput(), 3));
    FF_CHECK_EQUAL(convexify->GetVolume(), 3.5);
    FF_CHECK_EQUAL(convexify->GetOutput()->GetNumberOfPoints(), 10);
    FF_CHECK_EQUAL(convexify->GetOutput()->GetNumberOfPolys(), 7);
  }
}

/// Points that no triangle uses do not count, whatever they are; ids are the input's.
void testUnusedPoints()
{
  auto points = cubeCorners();
  points.insert(points.begin(), { { 100, 100, 100 }, { std::nan(""), 0, 0 } });
  vtkNew<vtkFFConvexifyFilter> convexify;
  convexify->SetInputData(makeSurface(points,
    { { 2, 4, 5, 3 }, { 6, 7, 9, 8 }, { 2, 3, 7, 6 }, { 4, 8, 9, 5 }, { 2, 6, 8, 4 },
      { 3, 5, 9, 7 } }));
  FF_CHECK(succeeds(convexify));
  FF_CHECK(
    (originalIds(convexify->GetOutput()) == std::vector<vtkIdType>{ 2, 3, 4, 5, 6, 7, 8, 9 }));
  FF_CHECK_EQUAL(convexify->GetVolume(), 1.0);
}

/// A box with a ditch along its top: its ends are concave polygons with a corner on a straight
/// stretch, all else is squares.
vtkSmartPointer<vtkPolyData> makeDitch()
{
  const std::vector<std::array<double, 2>> profile{ { 0, 0 }, { 2, 0 }, { 4, 0 }, { 4, 3 },
    { 3, 3 }, { 2, 2 }, { 1, 3 }, { 0, 3 } };
  std::vector<Point> points;
  std::vector<std::vector<vtkIdType>> cells(2);
  const auto count = static_cast<vtkIdType>(profile.size());
  for (const double y : { 0.0, 2.0 })
  {
    for (const auto& p : profile)
    {
      points.push_back({ p[0], y, p[1] });
    }
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType next = (i + 1) % count;
    cells[0].push_back(i);
    cells[1].push_back(2 * count - 1 - i);
    cells.push_back({ i, i + count, next + count, next });
  }
  return makeSurface(points, cells);
}

/// From polygons, strips, and triangles of any kind.
void testPolygons()
{
  const auto ditch = makeDitch();
  checkHull(ditch);
  checkHull(reverse(ditch));
  ditch->GetPolys()->ConvertTo32BitStorage();
  checkHull(ditch);

  // Of a cube, squares and strips; the strip around it goes over four sides.
  const auto cube = makeSurface(cubeCorners(), { { 0, 2, 3, 1 }, { 4, 5, 7, 6 } });
  vtkNew<vtkCellArray> strips;
  const vtkIdType around[10] = { 4, 0, 5, 1, 7, 3, 6, 2, 4, 0 };
  strips->InsertNextCell(10, around);
  cube->SetStrips(strips);
  checkHull(cube);
}

void testEmpty()
{
  vtkNew<vtkFFConvexifyFilter> convexify;
  vtkNew<vtkPolyData> nothing;
  convexify->SetInputData(nothing);
  FF_CHECK(succeeds(convexify));
  FF_CHECK(isEmpty(convexify->GetOutput()));
  FF_CHECK_EQUAL(convexify->GetDimension(), -1);
}

}

int TestFFConvexifyFilter(int, char*[])
{
  testAgainstHull();
  testVoxels();
  testUnusedPoints();
  testPolygons();
  testEmpty();
  return result();
}
