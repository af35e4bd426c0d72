// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What cannot be done is an error that says what and where, with all outputs empty; the next run is
// none the worse for it. Wrong weight arrays are in the test of weights.
#include "FFTest.h"

#include "vtkErrorCode.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkNew.h"
#include "vtkTransform.h"

#include <limits>

using namespace fftest;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

/// One error, and nothing on any port.
void checkFailure(vtkFFRegularTriangulationFilter* filter, ErrorObserver* errors)
{
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK_EQUAL(errors->FailedRequests, 1);
  FF_CHECK(filter->GetErrorCode() != vtkErrorCode::NoError);
  FF_CHECK_EQUAL(filter->GetDimension(), -1);
  FF_CHECK_EQUAL(filter->GetNumberOfHiddenPoints(), 0);
  for (int port = 0; port < 3; ++port)
  {
    FF_CHECK(isEmpty(filter->GetOutput(port)));
  }
}

void checkSuccess(vtkFFRegularTriangulationFilter* filter, ErrorObserver* errors)
{
  errors->Clear();
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
  FF_CHECK(filter->GetOutput()->GetNumberOfPolys() > 0);
}

/// A coordinate, z included, or a weight: in each mode of projection.
void testNonFinite(int type)
{
  for (const double value : { nan, infinity, -infinity })
  {
    for (std::size_t axis = 0; axis < 4; ++axis)
    {
      auto points = randomPoints(1000, 31);
      std::vector<double> weights(1000, 0.0);
      if (axis < 3)
      {
        points[123][axis] = value;
      }
      else
      {
        weights[123] = value;
      }
      points[456][2] = value;
      points[999] = { value, value, value };
      weights[999] = value;
      const auto input = makeWeighted(points, weights);
      if (type == VTK_FLOAT)
      {
        input->SetPoints(makePoints(points, type)->GetPoints());
      }

      vtkNew<vtkTransform> identity;
      vtkNew<vtkFFRegularTriangulationFilter> filter;
      const auto errors = ErrorObserver::Of(filter);
      useWeights(filter);
      filter->GeneratePowerDiagramOn();
      filter->SetTransform(identity);
      filter->SetInputData(input);
      for (int mode = 0; mode < 3; ++mode)
      {
        filter->SetProjectionPlaneMode(mode);
        filter->Update();
        checkFailure(filter, errors);
        FF_CHECK(errors->Has("point 123,"));
        FF_CHECK(errors->Has("3 such point(s)"));
        FF_CHECK(errors->Has("NaN or infinite"));
        FF_CHECK_EQUAL(filter->GetNumberOfNonFinitePoints(), 3);

        // Left out, the others have their triangulation, with the ids of the whole input.
        filter->SetNonFinitePointsToIgnore();
        checkSuccess(filter, errors);
        FF_CHECK_EQUAL(filter->GetNumberOfNonFinitePoints(), 3);
        FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), 1000);
        const auto ids = originalIds(filter->GetOutput());
        FF_CHECK_EQUAL(ids.size(), std::size_t(997));
        FF_CHECK(ids.back() == 998);
        FF_CHECK_EQUAL(filter->GetNumberOfHiddenPoints(), 0);
        filter->SetNonFinitePointsToError();
      }
    }
  }
}

void testNothingButNonFinite()
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetNonFinitePointsToIgnore();
  filter->GeneratePowerDiagramOn();
  filter->SetInputData(makePoints({ { nan, 0, 0 }, { 0, infinity, 0 }, { 0, 0, nan } }));
  for (const int mode : { 0, 2 })
  {
    filter->SetProjectionPlaneMode(mode);
    filter->Update();
    FF_CHECK(errors->Messages.empty());
    FF_CHECK_EQUAL(filter->GetDimension(), -1);
    FF_CHECK_EQUAL(filter->GetNumberOfNonFinitePoints(), 3);
    FF_CHECK(isEmpty(filter->GetOutput()) && isEmpty(filter->GetPowerDiagramOutput()));
  }
}

void testSettings()
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputData(makePoints(randomPoints(50, 32)));
  checkSuccess(filter, errors);

  filter->SetProjectionPlaneModeToTransform();
  filter->Update();
  checkFailure(filter, errors);
  FF_CHECK(errors->Has("no Transform is set"));
  filter->SetProjectionPlaneModeToXYPlane();
  checkSuccess(filter, errors);

  filter->SetPowerDiagramBoxModeToBounds();
  const double boxes[4][4] = { { 1, 0, 0, 1 }, { 0, 1, 2, 2 }, { 0, infinity, 0, 1 },
    { 0, 1, nan, 1 } };
  for (const auto& box : boxes)
  {
    filter->SetPowerDiagramBounds(box);
    filter->GeneratePowerDiagramOff();
    checkSuccess(filter, errors); // nobody asked for the diagram
    filter->GeneratePowerDiagramOn();
    filter->Update();
    checkFailure(filter, errors);
    FF_CHECK(errors->Has("(xmin, xmax, ymin, ymax)"));
  }
  filter->SetPowerDiagramBounds(0, 1, 0, 1);
  checkSuccess(filter, errors);
}

/// A transform that flattens will do for a triangulation, but nothing leads back from it.
void testTransformWithoutInverse()
{
  vtkNew<vtkTransform> flatten;
  flatten->Scale(1.0, 1.0, 1.0);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(2, 2, 0.0);
  flatten->SetMatrix(matrix);
  const auto input = makePoints(randomPoints(50, 33));
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetTransform(flatten);
  filter->SetProjectionPlaneModeToTransform();
  filter->SetInputData(input);
  checkSuccess(filter, errors);
  FF_CHECK(isTriangulationOf(input, nullptr, filter));
  filter->GeneratePowerDiagramOn();
  filter->Update();
  checkFailure(filter, errors);
  FF_CHECK(errors->Has("no inverse"));
}

}

int TestFFRegularTriangulationFilterErrors(int, char*[])
{
  testNonFinite(VTK_DOUBLE);
  testNonFinite(VTK_FLOAT);
  testNothingButNonFinite();
  testSettings();
  testTransformWithoutInverse();
  return result();
}
