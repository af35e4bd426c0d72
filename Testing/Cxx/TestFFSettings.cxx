// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What is set is used: a transform, a box or a kernel point brings its mode along. What is stored
// leaves the mode alone, in whatever order.
#include "FFTest.h"

#include "vtkFFConvexifyFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkNew.h"
#include "vtkTransform.h"

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

/// As in vtkDelaunay2D, to set a transform is enough.
void testTransform()
{
  // Collinear in XY; the transform stands the plane upright.
  const auto input = makePoints({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 1, 0, 1 } });
  vtkNew<vtkTransform> transform;
  transform->RotateX(90.0);
  vtkNew<Filter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputData(input);
  filter->SetTransform(nullptr);
  filter->Update();
  FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), int(Filter::XY_PLANE));
  FF_CHECK_EQUAL(filter->GetDimension(), 1);

  filter->SetTransform(transform);
  filter->Update();
  FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), int(Filter::TRANSFORM_PLANE));
  FF_CHECK_EQUAL(filter->GetDimension(), 2);

  // The last word counts: a mode, and again a transform, the same one too.
  filter->SetProjectionPlaneModeToXYPlane();
  filter->Update();
  FF_CHECK_EQUAL(filter->GetDimension(), 1);
  filter->SetTransform(transform);
  filter->Update();
  FF_CHECK_EQUAL(filter->GetDimension(), 2);
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(2)); // of a vertical plane
  errors->Clear();

  // None leaves the mode, which is in want of one then.
  filter->SetTransform(nullptr);
  FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), int(Filter::TRANSFORM_PLANE));
  filter->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("no Transform is set"));

  for (const int mode : { 0, 1, 2 })
  {
    filter->SetProjectionPlaneMode(mode);
    filter->StoreTransform(transform);
    FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), mode);
    FF_CHECK(filter->GetTransform() == transform);
    filter->StoreTransform(nullptr);
    FF_CHECK_EQUAL(filter->GetProjectionPlaneMode(), mode);
    FF_CHECK(filter->GetTransform() == nullptr);
  }
}

void testBounds()
{
  const auto widthOf = [](Filter* filter)
  {
    filter->Update();
    double bounds[6];
    filter->GetPowerDiagramOutput()->GetBounds(bounds);
    return bounds[1] - bounds[0];
  };
  vtkNew<Filter> filter;
  filter->SetInputData(makePoints({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 4, 5, 0 } }));
  filter->GeneratePowerDiagramOn();
  FF_CHECK_EQUAL(widthOf(filter), 4.0);
  filter->SetPowerDiagramBounds(0, 1, 0, 1); // what they are
  FF_CHECK_EQUAL(filter->GetPowerDiagramBoxMode(), int(Filter::BOX_OF_BOUNDS));
  FF_CHECK_EQUAL(widthOf(filter), 1.0);
  filter->SetPowerDiagramBoxModeToPoints();
  FF_CHECK_EQUAL(widthOf(filter), 4.0);
  const double bounds[4] = { -8, 8, -8, 8 };
  filter->SetPowerDiagramBounds(bounds);
  FF_CHECK_EQUAL(widthOf(filter), 16.0);
  filter->SetPowerDiagramBoxModeToPoints();
  const vtkMTimeType time = filter->GetMTime();
  filter->StorePowerDiagramBounds(-8, 8, -8, 8);
  FF_CHECK_EQUAL(filter->GetMTime(), time);
  filter->StorePowerDiagramBounds(-9, 9, -8, 8);
  FF_CHECK(filter->GetMTime() > time);
  FF_CHECK_EQUAL(widthOf(filter), 4.0);
  filter->SetPowerDiagramBoxModeToBounds();
  FF_CHECK_EQUAL(widthOf(filter), 18.0);
}

void testKernelPoint()
{
  vtkNew<vtkFFConvexifyFilter> convexify;
  const auto errors = ErrorObserver::Of(convexify);
  convexify->SetInputData(makeVoxels({ { 0, 0, 0 } }));
  FF_CHECK(!convexify->GetUseKernelPoint());
  convexify->SetKernelPoint(0, 0, 0); // what it is: a corner of the cube, which sees too little
  FF_CHECK(convexify->GetUseKernelPoint());
  convexify->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("the kernel point does not see"));
  errors->Clear();
  const double inside[3] = { 0.5, 0.5, 0.25 };
  convexify->UseKernelPointOff();
  convexify->SetKernelPoint(inside);
  FF_CHECK(convexify->GetUseKernelPoint());
  convexify->Update();
  FF_CHECK_EQUAL(convexify->GetVolume(), 1.0);

  convexify->UseKernelPointOff();
  const vtkMTimeType time = convexify->GetMTime();
  convexify->StoreKernelPoint(0.5, 0.5, 0.25);
  FF_CHECK_EQUAL(convexify->GetMTime(), time);
  convexify->StoreKernelPoint(9, 9, 9);
  FF_CHECK(convexify->GetMTime() > time);
  FF_CHECK(!convexify->GetUseKernelPoint());
  convexify->Update();
  FF_CHECK(errors->Messages.empty());
  convexify->UseKernelPointOn();
  convexify->Update();
  FF_CHECK(errors->Has("the kernel point does not see"));
}

}

int TestFFSettings(int, char*[])
{
  testTransform();
  testBounds();
  testKernelPoint();
  return result();
}
