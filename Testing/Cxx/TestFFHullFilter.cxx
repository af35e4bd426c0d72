// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The hull filter gives what the engine gives: of each dimension, in both facet modes, on any
// number of threads, and the planes of its facets. The engine's tests have the geometry.
#include "FFPlanar.h"

#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>

using namespace fftest;

namespace
{

struct Row
{
  std::vector<Point> Points;
  int Dimension;
  Ids Corners;
  vtkIdType Triangles; ///< or lines, or vertices
  vtkIdType Polygons;
  double Area;
  double Volume;
};

/// A lattice of side 2: points inside, inside facets and inside edges; then duplicates.
std::vector<Point> crowdedCube()
{
  auto points = gridOf(3, 3);
  for (std::size_t i = 0; i < 18; ++i)
  {
    points.push_back({ points[i][0], points[i][1], points[i][2] + 1.0 });
  }
  points.insert(points.end(), { { 0, 0, 0 }, { 2, 2, 2 }, { 0.5, 1.25, 0.75 } });
  return points;
}

/// The rows of the table in the documentation of vtkFFHullFilter.
void testDimensions()
{
  const Row rows[] = {
    { {}, -1, {}, 0, 0, 0, 0 },
    { { { -0.0, 0, 0 }, { 0, -0.0, 0 } }, 0, { 0 }, 1, 1, 0, 0 },
    { { { 2, 4, -6 }, { -3, -6, 9 }, { 0, 0, 0 }, { 5, 10, -15 }, { -3, -6, 9 } }, 1, { 1, 3 }, 1,
      1, 0, 0 },
    { { { 1, 7, 1 }, { 0, 7, 0 }, { 0, 7, 2 }, { 2, 7, 2 }, { 2, 7, 0 }, { 2, 7, 1 } }, 2,
      { 1, 2, 3, 4 }, 2, 1, 4, 0 },
    { crowdedCube(), 3, { 0, 2, 6, 8, 18, 20, 24, 26 }, 12, 6, 24, 8 },
    { { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 3 }, { 4, 0, 3 }, { 0, 4, 3 }, { 2, 2, 0 } },
      3, { 0, 1, 2, 3, 4, 5 }, 8, 5, 40 + 12 * std::sqrt(2.0), 24 },
  };
  for (const Row& row : rows)
  {
    const auto input = makePoints(row.Points);
    Watched<vtkFFHullFilter> hull(input);
    FF_CHECK_EQUAL(hull->GetDimension(), -1);
    for (const bool polygons : { false, true })
    {
      hull->SetFacetMode(polygons);
      vtkPolyData* const output = hull.Run();
      FF_CHECK(originalIds(output) == row.Corners);
      FF_CHECK_EQUAL(output->GetNumberOfCells(), polygons ? row.Polygons : row.Triangles);
      FF_CHECK(row.Dimension < 0 || isHullOf(input, output, row.Dimension));
      FF_CHECK_EQUAL(hull->GetDimension(), row.Dimension);
      FF_CHECK(std::fabs(hull->GetArea() - row.Area) <= 1e-14 * row.Area);
      FF_CHECK_EQUAL(hull->GetVolume(), row.Volume);
      FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), vtkIdType(row.Points.size()));
      FF_CHECK(row.Dimension != 0 || std::signbit(output->GetPoint(0)[0])); // the lowest id's bits
    }
  }
  Watched<vtkFFHullFilter> none(vtkSmartPointer<vtkPolyData>::New()); // not even a vtkPoints
  FF_CHECK(isEmpty(none.Run()) && originalIds(none->GetOutput()).empty());
  FF_CHECK_EQUAL(none.RunWith(makePoints({}, VTK_INT))->GetPoints()->GetDataType(), VTK_INT);
}

/// 0 threads are as many as vtkSMPTools has, -1 all that the machine has. The output does not
/// depend on them.
void testThreads()
{
  Watched<vtkFFHullFilter> hull(makePoints(spherePoints(100000, 8)));
  const auto threadsOf = [&](int number)
  {
    hull->SetNumberOfThreads(number);
    return reported(hull.Run(), "Threads");
  };
  FF_CHECK_EQUAL(hull->GetNumberOfThreads(), 0);
  hull->SetReportAsFieldData(true);
  const std::string before = vtkSMPTools::GetBackend();
  FF_CHECK(vtkSMPTools::SetBackend("Sequential"));
  FF_CHECK_EQUAL(threadsOf(0), 1);
  const auto reference = copyOf(hull->GetOutput());
  FF_CHECK(isHullOf(vtkPolyData::SafeDownCast(hull->GetInput()), reference, 3));
  FF_CHECK(threadsOf(-3) >= std::min(2u, std::thread::hardware_concurrency()));
  FF_CHECK_EQUAL(hull->GetNumberOfThreads(), -1);
  FF_CHECK(isSame(hull->GetOutput(), reference));
  FF_CHECK(threadsOf(2) <= 2);
  FF_CHECK(isSame(hull->GetOutput(), reference));
  vtkSMPTools::SetBackend(before.c_str());
  FF_CHECK(threadsOf(0) <= vtkSMPTools::GetEstimatedNumberOfThreads());
  hull->SetVBiased(false);
  FF_CHECK(isSame(hull.Run(), reference));
}

double at(vtkPlanes* planes, double x, double y, double z)
{
  double point[3] = { x, y, z };
  return planes->EvaluateFunction(point);
}

/// The planes of the facets as an implicit function: below 0 inside.
void testPlanes()
{
  Watched<vtkFFHullFilter> hull(makePoints(cubeCorners(), VTK_LONG_LONG));
  vtkNew<vtkPlanes> planes;
  for (const bool polygons : { true, false })
  {
    hull->SetFacetMode(polygons);
    hull.Run();
    const vtkMTimeType time = hull->GetMTime();
    FF_CHECK(hull->GetPlanes(planes));
    FF_CHECK_EQUAL(hull->GetMTime(), time); // it needs no further run
    FF_CHECK(std::string(hull->GetProgressText()).find("Convex hull") == 0);
    FF_CHECK_EQUAL(planes->GetNumberOfPlanes(), polygons ? 6 : 12);
    FF_CHECK_EQUAL(planes->GetPoints()->GetDataType(), VTK_DOUBLE);
    FF_CHECK_EQUAL(at(planes, 0.5, 0.5, 0.75), -0.25);
    FF_CHECK_EQUAL(at(planes, 3, 0.5, 0.5), 2.0);
    FF_CHECK_EQUAL(at(planes, 0, 1, 0.25), 0.0);
  }
  Watched<vtkFFConvexifyFilter> again(hull->GetOutput());
  again.Run();
  FF_CHECK(again->GetPlanes(planes));
  FF_CHECK_EQUAL(at(planes, 0.5, 0.5, 0.75), -0.25);
}

/// Where there are no planes, none of an earlier hull are left.
void testNoPlanes()
{
  Watched<vtkFFHullFilter> hull(nullptr);
  vtkNew<vtkPlanes> planes;
  const auto isNone = [&](vtkDataObject* input, const char* sentence)
  {
    if (input)
    {
      hull.RunWith(input);
    }
    planes->SetBounds(0, 1, 0, 1, 0, 1);
    hull.Errors->Clear();
    const vtkMTimeType time = hull->GetMTime();
    FF_CHECK(!hull->GetPlanes(planes));
    FF_CHECK_EQUAL(hull->GetMTime(), time);
    FF_CHECK(input || !hull->GetProgressText());
    FF_CHECK_EQUAL(hull.Errors->Messages.size(), std::size_t(1));
    FF_CHECK(hull.Errors->Has(sentence));
    FF_CHECK_EQUAL(hull->GetErrorCode(), vtkFFErrorCode::InputError);
    FF_CHECK(!planes->GetPoints() && !planes->GetNormals());
  };
  const char* const flat = "There is no hull of dimension 3 that planes could bound: update the "
                           "filter first; its points must not lie in one plane.";
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(cubeCorners()));
  isNone(nullptr, flat);
  isNone(makePoints(std::vector<Point>{}), flat);
  isNone(makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }), flat);
  isNone(blocks,
    "The output is a vtkMultiBlockDataSet, which has no planes of its own. Take the hull of one "
    "block, or one hull of all blocks.");
  hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  hull.Run();
  FF_CHECK(hull->GetPlanes(planes));
  FF_CHECK(!hull->GetPlanes(nullptr));
  FF_CHECK(
    hull.Errors->Has("There is nothing to give the planes to: GetPlanes() takes a vtkPlanes."));
}

}

int TestFFHullFilter(int, char*[])
{
  testDimensions();
  testThreads();
  testPlanes();
  testNoPlanes();
  return result();
}
