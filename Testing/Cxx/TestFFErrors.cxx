// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What cannot be done is an error that says what and where, with all outputs empty; the next run is
// none the worse for it. Wrong weight arrays are in the test of weights.
#include "FFCases.h"
#include "FFPlanar.h"

#include "vtkMatrix4x4.h"
#include "vtkTransform.h"

using namespace fftest;

namespace
{

/// A coordinate, z included, or a weight, in each mode of projection: an error that names the first
/// and counts all; or they are left out, and the others keep their ids.
void testNonFinite(const FilterCase& of, int type)
{
  const auto filter = of.New();
  auto* const planar = vtkFFPlanarAlgorithm::SafeDownCast(filter);
  if (planar)
  {
    planar->SetTransform(vtkNew<vtkTransform>());
  }
  const double values[] = { notANumber, infinity, -infinity };
  for (std::size_t axis = 0; axis < (of.IsWeighted ? 4 : 3); ++axis)
  {
    auto points = randomPoints(1000, 31);
    std::vector<double> weights(1000, 0.0);
    (axis < 3 ? points[123][axis] : weights[123]) = values[axis % 3];
    points[456][2] = infinity;
    points[999] = { notANumber, 0.0, 0.0 };
    weights[999] = -infinity;
    const auto input = makeWeighted(points, weights);
    input->SetPoints(makePoints(points, type)->GetPoints());
    filter->SetInputDataObject(input);
    for (int mode = 0; mode < (planar ? 3 : 1); ++mode)
    {
      if (planar)
      {
        planar->SetProjectionPlaneMode(mode);
      }
      filter->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_ERROR);
      FF_CHECK(fails(filter, vtkFFErrorCode::NonFiniteError,
        { "NaN or infinite: first at point 123, 3 such point(s) in all." }));
      FF_CHECK_EQUAL(filter->GetNumberOfNonFinitePoints(), 3);
      filter->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
      FF_CHECK(succeeds(filter));
      FF_CHECK_EQUAL(filter->GetNumberOfNonFinitePoints(), 3);
      FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), 1000);
      FF_CHECK(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL) > 50);
      auto* const hull = vtkFFHullFilter::SafeDownCast(filter);
      FF_CHECK(!hull || isHullOf(input, hull->GetOutput(), 3));
    }
  }
  filter->SetInputDataObject(
    makeWeighted({ { notANumber, 0, 0 }, { 0, infinity, 0 }, { 0, 0, notANumber } }, { 0, 0, 0 }));
  FF_CHECK(succeeds(filter));
  FF_CHECK(isEmpty(filter->GetOutputDataObject(0)));
  FF_CHECK_EQUAL(filter->GetDimension(), -1);
  FF_CHECK_EQUAL(filter->GetNumberOfNonFinitePoints(), 3);
}

/// A plane by a transform that is not there; one that flattens, so that nothing leads back.
template <class FilterT>
void testTransform(bool needsInverse)
{
  Watched<FilterT> run(makePoints(randomPoints(50, 33)));
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::TRANSFORM_PLANE);
  run.Fail("no Transform is set", vtkFFErrorCode::SettingError);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(2, 2, 0.0);
  vtkNew<vtkTransform> flatten;
  flatten->SetMatrix(matrix);
  run->SetTransform(flatten);
  if (!needsInverse)
  {
    FF_CHECK(run.Run()->GetNumberOfPolys() > 0);
    run->SetGenerateCellMeasures(true);
  }
  run.Fail("no inverse", vtkFFErrorCode::InputError);
  run->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::XY_PLANE);
  FF_CHECK(run.Run()->GetNumberOfPolys() > 0);
}

void testBox()
{
  Watched<vtkFFPowerDiagramFilter> run(makePoints(randomPoints(50, 32)));
  for (const auto& box : { std::array<double, 4>{ 1, 0, 0, 1 }, { 0, 1, 2, 2 },
         { 0, infinity, 0, 1 }, { 0, 1, notANumber, 1 } })
  {
    run->SetPowerDiagramBounds(box.data());
    run.Fail("(xmin, xmax, ymin, ymax)", vtkFFErrorCode::SettingError);
    run->SetPowerDiagramBoxMode(vtkFFPowerDiagramFilter::BOX_OF_POINTS);
    FF_CHECK_EQUAL(run.Run()->GetNumberOfPolys(), 50); // the bounds are not in use
  }
  run->SetPowerDiagramBounds(0, 1, 0, 1);
  FF_CHECK(run.Run()->GetNumberOfPolys() > 0);
}

}

int TestFFErrors(int, char*[])
{
  for (const FilterCase& of : casesOfPoints())
  {
    testNonFinite(of, VTK_DOUBLE);
    testNonFinite(of, VTK_FLOAT);
  }
  testTransform<vtkFFRegularTriangulationFilter>(false);
  testTransform<vtkFFRegularTriangulationFilter>(false);
  testTransform<vtkFFPowerDiagramFilter>(true);
  testBox();
  return result();
}
