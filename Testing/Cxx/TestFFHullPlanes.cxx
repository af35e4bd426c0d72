// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The planes of a hull's facets, as an implicit function: not above 0 at the vertices, below
// inside.
#include "FFTest.h"

#include "vtkDataArray.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"

#include <cmath>

using namespace fftest;

namespace
{

double at(vtkPlanes* planes, double x, double y, double z)
{
  double point[3] = { x, y, z };
  return planes->EvaluateFunction(point);
}

/// Of points about the origin, in any type.
void testFunction(int type, double scale)
{
  auto points = randomPoints(500, 11);
  for (Point& point : points)
  {
    for (double& x : point)
    {
      x *= scale;
    }
  }
  const auto input = makePoints(points, type);
  for (const int mode : { 0, 1 })
  {
    vtkNew<vtkFFHullFilter> hull;
    hull->SetFacetMode(mode);
    hull->SetInputData(input);
    hull->Update();
    vtkPolyData* output = hull->GetOutput();
    vtkNew<vtkPlanes> planes;
    FF_CHECK(hull->GetPlanes(planes));
    FF_CHECK_EQUAL(planes->GetNumberOfPlanes(), static_cast<int>(output->GetNumberOfPolys()));
    FF_CHECK_EQUAL(planes->GetPoints()->GetDataType(), VTK_DOUBLE);
    FF_CHECK_EQUAL(planes->GetNormals()->GetDataType(), VTK_DOUBLE);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      FF_CHECK(std::fabs(planes->EvaluateFunction(output->GetPoint(i))) <= 1e-14 * scale);
    }
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      FF_CHECK(planes->EvaluateFunction(input->GetPoint(i)) <= 1e-14 * scale);
    }
    FF_CHECK(at(planes, 0, 0, 0) < 0.0);
    FF_CHECK(at(planes, 0, 0, 2 * scale) > 0.0);
  }
}

void testCube()
{
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(makePoints(cubeCorners(), VTK_LONG_LONG));
  hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
  hull->Update();
  vtkNew<vtkPlanes> planes;
  FF_CHECK(hull->GetPlanes(planes));
  FF_CHECK_EQUAL(planes->GetNumberOfPlanes(), 6);
  FF_CHECK_EQUAL(at(planes, 0.5, 0.5, 0.5), -0.5);
  FF_CHECK_EQUAL(at(planes, 0.5, 0.5, 0.75), -0.25);
  FF_CHECK_EQUAL(at(planes, 3, 0.5, 0.5), 2.0);
  FF_CHECK_EQUAL(at(planes, 0, 1, 0.25), 0.0);
  hull->SetFacetMode(vtkFFAlgorithm::FACETS_AS_TRIANGLES);
  hull->Update();
  FF_CHECK(hull->GetPlanes(planes));
  FF_CHECK_EQUAL(planes->GetNumberOfPlanes(), 12);

  vtkNew<vtkFFConvexifyFilter> again;
  again->SetInputConnection(hull->GetOutputPort());
  again->Update();
  FF_CHECK(again->GetPlanes(planes));
  FF_CHECK_EQUAL(at(planes, 0.5, 0.5, 0.75), -0.25);
}

/// Where there are no planes, none of an earlier hull are left.
void testErrors()
{
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  vtkNew<vtkPlanes> planes;
  const auto isNone = [&](const char* sentence)
  {
    planes->SetBounds(0, 1, 0, 1, 0, 1);
    errors->Clear();
    FF_CHECK(!hull->GetPlanes(planes));
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
    FF_CHECK(errors->Has(sentence));
    FF_CHECK(hull->GetErrorCode() == vtkFFErrorCode::InputError);
    FF_CHECK(!planes->GetPoints() && !planes->GetNormals());
  };
  const char* const flat = "There is no hull of dimension 3 that planes could bound: update the "
                           "filter first; its points must not lie in one plane.";
  isNone(flat);
  hull->SetInputData(makePoints({}));
  hull->Update();
  isNone(flat);
  hull->SetInputData(makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  hull->Update();
  isNone(flat);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makePoints(cubeCorners()));
  hull->SetInputData(blocks);
  hull->Update();
  isNone(
    "The output is a vtkMultiBlockDataSet, which has no planes of its own. Take the hull of one "
    "block, or one hull of all blocks.");
  hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  hull->Update();
  errors->Clear();
  FF_CHECK(hull->GetPlanes(planes));
  FF_CHECK_EQUAL(planes->GetNumberOfPlanes(), 12);
  FF_CHECK(errors->Messages.empty());
  FF_CHECK(!hull->GetPlanes(nullptr));
  FF_CHECK(errors->Has("There is nothing to give the planes to: GetPlanes() takes a vtkPlanes."));
}

}

int TestFFHullPlanes(int, char*[])
{
  testFunction(VTK_DOUBLE, 1.0);
  testFunction(VTK_FLOAT, 1.0);
  testFunction(VTK_DOUBLE, 0x1p+300);
  testCube();
  testErrors();
  return result();
}
