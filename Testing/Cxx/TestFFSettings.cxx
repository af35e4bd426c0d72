// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What is set is used: a transform, a box or a kernel point brings its mode along. What is stored
// leaves the mode alone, in whatever order.
#include "FFTest.h"

#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFErrorCode.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkNew.h"
#include "vtkTransform.h"

using namespace fftest;

namespace
{

using Filter = vtkFFPowerDiagramFilter;

/// As in vtkDelaunay2D, to set a transform is enough. The last word counts.
void testTransform(vtkFFPlanarAlgorithm* filter)
{
  using Planar = vtkFFPlanarAlgorithm;
  // Collinear in XY; the transform stands the plane upright.
  filter->SetInputDataObject(makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 1, 0, 1 } }));
  vtkNew<vtkTransform> transform;
  transform->RotateX(90.0);
  const auto errors = ErrorObserver::Of(filter);
  const auto dimension = [&]
  {
    filter->Update();
    return filter->GetDimension();
  };
  filter->SetTransform(nullptr);
  FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), int(Planar::XY_PLANE));
  FF_CHECK_EQUAL(dimension(), 1);
  for (int again = 0; again < 2; ++again)
  {
    filter->SetTransform(transform);
    FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), int(Planar::TRANSFORM_PLANE));
    FF_CHECK_EQUAL(dimension(), 2);
    filter->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::XY_PLANE);
    FF_CHECK_EQUAL(dimension(), 1);
  }
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(3)); // warnings of a vertical plane
  filter->RemoveObserver(errors);

  // None leaves the mode, which needs one then.
  filter->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::TRANSFORM_PLANE);
  filter->SetTransform(nullptr);
  FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), int(Planar::TRANSFORM_PLANE));
  FF_CHECK(fails(filter, vtkFFErrorCode::SettingError, { "no Transform is set" }));
  for (const int mode : { 0, 1, 2 })
  {
    filter->SetProjectionPlaneMode(mode);
    for (vtkTransform* stored : { transform.Get(), static_cast<vtkTransform*>(nullptr) })
    {
      filter->StoreTransform(stored);
      FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), mode);
      FF_CHECK(filter->GetTransform() == stored);
    }
  }
}

void testBounds()
{
  const auto widthOf = [](Filter* filter)
  {
    filter->Update();
    double bounds[6];
    filter->GetOutput()->GetBounds(bounds);
    return bounds[1] - bounds[0];
  };
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 4, 5, 0 } }));
  FF_CHECK_EQUAL(widthOf(filter), 4.0);
  filter->SetPowerDiagramBounds(0, 1, 0, 1); // what they are
  FF_CHECK_EQUAL(filter->GetPowerDiagramBoxMode(), int(Filter::BOX_OF_BOUNDS));
  FF_CHECK_EQUAL(widthOf(filter), 1.0);
  filter->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_POINTS);
  FF_CHECK_EQUAL(widthOf(filter), 4.0);
  const double bounds[4] = { -8, 8, -8, 8 };
  filter->SetPowerDiagramBounds(bounds);
  FF_CHECK_EQUAL(widthOf(filter), 16.0);
  filter->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_POINTS);
  const vtkMTimeType time = filter->GetMTime();
  filter->StorePowerDiagramBounds(-8, 8, -8, 8);
  FF_CHECK_EQUAL(filter->GetMTime(), time);
  filter->StorePowerDiagramBounds(-9, 9, -8, 8);
  FF_CHECK(filter->GetMTime() > time);
  FF_CHECK_EQUAL(widthOf(filter), 4.0);
  filter->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_BOUNDS);
  FF_CHECK_EQUAL(widthOf(filter), 18.0);
}

void testKernelPoint()
{
  vtkNew<vtkFFConvexifyFilter> convexify;
  convexify->SetInputData(makeVoxels({ { 0, 0, 0 } }));
  FF_CHECK(!convexify->GetUseKernelPoint());
  convexify->SetKernelPoint(0, 0, 0); // what it is: a corner of the cube, which sees too little
  FF_CHECK(convexify->GetUseKernelPoint());
  FF_CHECK(fails(convexify, vtkFFErrorCode::SurfaceError, { "the kernel point does not see" }));
  const double inside[3] = { 0.5, 0.5, 0.25 };
  convexify->UseKernelPointOff();
  convexify->SetKernelPoint(inside);
  FF_CHECK(convexify->GetUseKernelPoint());
  FF_CHECK(succeeds(convexify));

  convexify->UseKernelPointOff();
  const vtkMTimeType time = convexify->GetMTime();
  convexify->StoreKernelPoint(0.5, 0.5, 0.25);
  FF_CHECK_EQUAL(convexify->GetMTime(), time);
  convexify->StoreKernelPoint(9, 9, 9);
  FF_CHECK(convexify->GetMTime() > time);
  FF_CHECK(!convexify->GetUseKernelPoint());
  FF_CHECK(succeeds(convexify));
  convexify->UseKernelPointOn();
  FF_CHECK(fails(convexify, vtkFFErrorCode::SurfaceError, { "the kernel point does not see" }));
}

}

int TestFFSettings(int, char*[])
{
  testTransform(vtkNew<vtkFFRegularTriangulationFilter>());
  testTransform(vtkNew<vtkFFPowerDiagramFilter>());
  testTransform(vtkNew<vtkFFConstrainedDelaunayFilter>());
  testBounds();
  testKernelPoint();
  return result();
}
